//! A small run in a folder, served; and a client that sends what it is told to.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail as tests do")]

use demeter::output::RunFolder;
use demeter::output::vtp::{Array, Cells, PolyData, Values};
use demeter_physics::DVec3;
use demeter_viewer::{Options, Viewer};
use serde_json::Value;
use std::fs;
use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::Duration;

/// Three grains: 1 stands on the wall `floor` and carries 2; 3 is alone.
pub struct TestRun {
    _place: tempfile::TempDir,
    pub folder: RunFolder,
    pub port: u16,
    pub url: String,
    /// The address that leads to the page once.
    pub url_once: String,
    /// What every path begins with.
    pub key: String,
}

impl TestRun {
    pub fn new() -> Self {
        Self::with(false)
    }

    pub fn with(compress: bool) -> Self {
        let place = tempfile::tempdir().unwrap();
        let folder = RunFolder::create(&place.path().join("three"), false).unwrap();
        fs::write(folder.scenario(), "title = \"Three grains\"\n").unwrap();
        fs::write(folder.series(), "step,time [s],stage\n0,0.0,fill\n10,0.5,fill\n").unwrap();
        write_frame(&folder, 0, 0.0);
        write_frame(&folder, 10, 0.5);
        list(&folder, &[(0, 0.0), (10, 0.5)]);
        let options = Options {
            compress,
            ..Options::default()
        };
        let viewer = Viewer::open(folder.root(), options).unwrap();
        let (port, url, url_once) = (viewer.port(), viewer.url(), viewer.url_once());
        let key = path_of(&url, port).trim_end_matches('/').to_string();
        std::thread::spawn(move || viewer.serve());
        Self {
            _place: place,
            folder,
            port,
            url,
            url_once,
            key,
        }
    }

    /// Asks for a path behind the key as the page does.
    pub fn get(&self, path: &str) -> Answer {
        get(self.port, &format!("{}{path}", self.key))
    }

    /// Asks for a path behind the key with more lines in the head.
    pub fn ask(&self, path: &str, head: &str) -> Answer {
        let key = &self.key;
        ask(
            self.port,
            &format!("GET {key}{path} HTTP/1.1\r\n{head}\r\nConnection: close\r\n\r\n"),
        )
    }

    pub fn add_row(&self, text: &str) {
        let mut file = fs::OpenOptions::new().append(true).open(self.folder.series()).unwrap();
        file.write_all(text.as_bytes()).unwrap();
    }

    pub fn add_frame(&self, step: u64, time: f64) {
        write_frame(&self.folder, step, time);
        self.list_frames(&[(0, 0.0), (10, 0.5), (step, time)]);
    }

    /// Writes the contacts of a step anew, those of grains between these.
    pub fn write_contacts_of(&self, step: u64, id_i: u32, id_j: u32) {
        let file = self.folder.frames().join(format!("contacts_{step:010}.vtp"));
        let table = contacts(step, 0.5, (id_i, id_j));
        self.folder.write(&file, &table.encode().unwrap()).unwrap();
    }

    pub fn list_frames(&self, frames: &[(u64, f64)]) {
        list(&self.folder, frames);
    }
}

fn list(folder: &RunFolder, frames: &[(u64, f64)]) {
    for kind in ["grains", "contacts", "walls"] {
        let line = |(step, time): &(u64, f64)| {
            format!("<DataSet timestep=\"{time:?}\" part=\"0\" file=\"frames/{kind}_{step:010}.vtp\"/>\n")
        };
        let text: String = frames.iter().map(line).collect();
        folder
            .write(&folder.root().join(format!("{kind}.pvd")), text.as_bytes())
            .unwrap();
    }
}

fn write_frame(folder: &RunFolder, step: u64, time: f64) {
    let file = |kind: &str| folder.frames().join(format!("{kind}_{step:010}.vtp"));
    for (kind, table) in [
        ("grains", grains(step, time)),
        ("contacts", contacts(step, time, (1, 2))),
        ("walls", walls(step, time)),
    ] {
        folder.write(&file(kind), &table.encode().unwrap()).unwrap();
    }
}

fn grains(step: u64, time: f64) -> PolyData {
    let vectors = |name, v: DVec3| Array::vectors(name, &[v; 3]);
    PolyData {
        step,
        time,
        texts: vec![("material_names".into(), vec!["glass".into(), "steel".into()])],
        fields: Vec::new(),
        points: vec![DVec3::new(9.0, 0.0, 1.0), DVec3::Z, DVec3::new(0.0, 0.0, 3.75)],
        cells: Cells::Vertices,
        point_data: vec![
            Array::new("id", 1, Values::UInt32(vec![3, 1, 2])),
            Array::new("material", 1, Values::Int32(vec![0, 0, 1])),
            Array::scalars("radius", [1.0, 1.0, 2.0]),
            vectors("velocity", DVec3::new(3.0, 4.0, 0.0)),
            vectors("angular_velocity", DVec3::new(0.0, 6.0, 8.0)),
            vectors("force", DVec3::ZERO),
            Array::new("coordination", 1, Values::UInt32(vec![0, 2, 1])),
            Array::scalars("contact_force", [0.0, 5.0, 2.0]),
            Array::scalars("mean_normal_stress", [0.0, 0.375, 0.0625]),
        ],
        cell_data: Vec::new(),
    }
}

/// A contact between two grains, and one of grain 1 with the floor.
fn contacts(step: u64, time: f64, (id_i, id_j): (u32, u32)) -> PolyData {
    // grain 1 is the first of both; the normal points towards it
    let normal = [-DVec3::Z, DVec3::Z];
    let force = [-2.0 * DVec3::Z, 3.0 * DVec3::Z];
    PolyData {
        step,
        time,
        texts: Vec::new(),
        fields: vec![Array::scalars("mean_normal_force", [2.5])],
        points: vec![DVec3::new(0.0, 0.0, 1.875), DVec3::ZERO],
        cells: Cells::Vertices,
        point_data: vec![
            Array::new("id_i", 1, Values::UInt32(vec![id_i, 1])),
            Array::new("id_j", 1, Values::UInt32(vec![id_j, 0])),
            Array::new("wall", 1, Values::Int32(vec![-1, 0])),
            Array::new("element", 1, Values::UInt32(vec![0, 0])),
            Array::vectors("normal", &normal),
            Array::scalars("overlap", [0.25, 0.0]),
            Array::vectors("normal_force", &force),
            Array::vectors("tangential_force", &[0.5 * DVec3::X, DVec3::ZERO]),
            Array::scalars("normal_force_magnitude", [2.0, 3.0]),
            Array::scalars("force_magnitude", [4.25_f64.sqrt(), 3.0]),
        ],
        cell_data: Vec::new(),
    }
}

fn walls(step: u64, time: f64) -> PolyData {
    let triangle = |z: f64| {
        [
            DVec3::new(0.0, 0.0, z),
            DVec3::new(1.0, 0.0, z),
            DVec3::new(0.0, 1.0, z),
        ]
    };
    PolyData {
        step,
        time,
        texts: vec![("wall_names".into(), vec!["floor".into(), "lid".into()])],
        fields: Vec::new(),
        points: [triangle(0.0), triangle(9.0 - time)].concat(),
        cells: Cells::Triangles,
        point_data: Vec::new(),
        cell_data: vec![Array::new("wall", 1, Values::Int32(vec![0, 1]))],
    }
}

/// What the server said.
pub struct Answer {
    pub status: u16,
    head: String,
    pub body: Vec<u8>,
}

impl Answer {
    /// Reads one answer; status 0 when the connection was closed without one.
    pub fn read(stream: &mut TcpStream) -> Self {
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        let mut bytes = Vec::new();
        let mut piece = [0; 1 << 16];
        loop {
            if let Some(answer) = Self::parse(&bytes) {
                return answer;
            }
            match stream.read(&mut piece) {
                Ok(0) | Err(_) => {
                    return Self {
                        status: 0,
                        head: String::new(),
                        body: Vec::new(),
                    };
                }
                Ok(length) => bytes.extend_from_slice(&piece[..length]),
            }
        }
    }

    fn parse(bytes: &[u8]) -> Option<Self> {
        let end = bytes.windows(4).position(|w| w == b"\r\n\r\n")?;
        let head = String::from_utf8(bytes[..end].to_vec()).unwrap().to_lowercase();
        let mut answer = Self {
            status: head.split(' ').nth(1)?.parse().ok()?,
            head,
            body: bytes[end + 4..].to_vec(),
        };
        let length: usize = answer.header("content-length").parse().unwrap_or(0);
        answer.body.truncate(length);
        (answer.body.len() == length).then_some(answer)
    }

    pub fn header(&self, name: &str) -> String {
        let line = self
            .head
            .lines()
            .find_map(|line| line.strip_prefix(&format!("{name}: ")));
        line.unwrap_or_default().to_string()
    }

    pub fn text(&self) -> String {
        String::from_utf8_lossy(&self.body).into_owned()
    }

    pub fn json(&self) -> Value {
        serde_json::from_slice(&self.body).unwrap()
    }

    pub fn pack(&self) -> Packed {
        assert_eq!(self.status, 200, "{}", self.text());
        let length = u32::from_le_bytes(self.body[..4].try_into().unwrap()) as usize;
        Packed {
            head: serde_json::from_slice(&self.body[4..4 + length]).unwrap(),
            data: self.body[(4 + length).next_multiple_of(8)..].to_vec(),
        }
    }
}

/// A packed answer, read.
pub struct Packed {
    pub head: Value,
    data: Vec<u8>,
}

impl Packed {
    fn array<const N: usize, T>(&self, name: &str, kind: &str, read: fn([u8; N]) -> T) -> Vec<T> {
        let arrays = self.head["arrays"].as_array().unwrap();
        let array = arrays.iter().find(|array| array["name"] == name).unwrap();
        assert_eq!(array["type"], kind);
        let [place, length] = ["place", "length"].map(|key| array[key].as_u64().unwrap() as usize);
        let bytes = &self.data[place..place + N * length];
        bytes.as_chunks().0.iter().map(|number| read(*number)).collect()
    }

    pub fn f32s(&self, name: &str) -> Vec<f32> {
        self.array(name, "f32", f32::from_le_bytes)
    }

    pub fn f64s(&self, name: &str) -> Vec<f64> {
        self.array(name, "f64", f64::from_le_bytes)
    }

    pub fn u32s(&self, name: &str) -> Vec<u32> {
        self.array(name, "u32", u32::from_le_bytes)
    }
}

/// Sends a text and reads the answer.
pub fn ask(port: u16, text: &str) -> Answer {
    let mut stream = TcpStream::connect(("127.0.0.1", port)).unwrap();
    // the server may close before all is sent
    let _ = stream.write_all(text.as_bytes());
    Answer::read(&mut stream)
}

/// The path of an address.
pub fn path_of(url: &str, port: u16) -> String {
    url.strip_prefix(&format!("http://127.0.0.1:{port}"))
        .unwrap()
        .to_string()
}

/// Asks for a path as a browser does.
pub fn get(port: u16, path: &str) -> Answer {
    ask(
        port,
        &format!("GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nConnection: close\r\n\r\n"),
    )
}
