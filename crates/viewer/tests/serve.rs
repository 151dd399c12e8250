//! The server as a browser, and as somebody who is up to something, meets it.

mod run;

use run::{Answer, TestRun, ask, get, path_of};
use serde_json::Value;
use std::fs;
use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

#[test]
fn the_page_comes_with_its_guards() {
    let run = TestRun::new();
    let page = run.get("/");
    assert_eq!(page.status, 200);
    assert!(page.text().contains("<script src=\"viewer.js\">"));
    let policy = page.header("content-security-policy");
    for part in [
        "default-src 'none'",
        "script-src 'sha256-",
        "connect-src 'self'",
        "frame-ancestors 'none'",
    ] {
        assert!(policy.contains(part), "{policy}");
    }
    assert!(!policy.contains("unsafe"), "{policy}");
    for (path, kind) in [
        ("/viewer.js", "text/javascript"),
        ("/viewer.css", "text/css"),
        ("/licences.txt", "text/plain"),
    ] {
        let answer = run.get(path);
        assert_eq!(
            (answer.status, answer.header("x-content-type-options")),
            (200, "nosniff".to_string())
        );
        assert!(answer.header("content-type").starts_with(kind) && !answer.body.is_empty());
        assert_eq!(answer.header("cross-origin-resource-policy"), "same-origin");
    }
    assert!(run.url.starts_with("http://127.0.0.1:"));
}

#[test]
fn who_does_not_know_the_key_learns_nothing() {
    let run = TestRun::new();
    let other = TestRun::new();
    assert_ne!(run.key, other.key);
    assert!(run.key.len() > 32, "{}", run.key);
    let refused = |path: &str| {
        let answer = get(run.port, path);
        assert_eq!(answer.status, 403, "{path}");
        assert_eq!(answer.header("location"), "");
        answer.text()
    };
    let told = refused("/");
    assert!(told.contains("the whole address that `demeter view` tells"), "{told}");
    for path in [
        "/viewer.js",
        "/api/state?moments=0",
        "/api/frame/10",
        "/api/frame/11",
        "/nothing",
        "/licences.txt",
    ] {
        assert_eq!(refused(path), told, "{path}");
        assert_eq!(refused(&format!("{}{path}", other.key)), told, "{path}");
        let wrong = format!("{}0{path}", &run.key[..run.key.len() - 1]);
        if wrong != format!("{}{path}", run.key) {
            assert_eq!(refused(&wrong), told, "{path}");
        }
        assert_eq!(
            refused(&format!("{path}&key={}", run.key.trim_start_matches('/'))),
            told
        );
    }
    assert_eq!(run.get("/api/state?moments=0").status, 200);
    // what the page answers does not tell it
    assert!(!run.get("/api/state?moments=0").text().contains(&run.key));
}

#[test]
fn a_browser_is_led_to_the_page_once() {
    let run = TestRun::new();
    let once = path_of(&run.url_once, run.port);
    assert!(!run.url_once.contains(&run.key));
    assert_eq!(get(run.port, &format!("{once}api/state?moments=0")).status, 403);
    let led = get(run.port, &once);
    assert_eq!((led.status, led.header("location")), (303, format!("{}/", run.key)));
    assert_eq!(
        get(run.port, &once).status,
        403,
        "who reads it in the list of processes comes too late"
    );
    // without the last stroke
    let bare = get(run.port, &run.key);
    assert_eq!((bare.status, bare.header("location")), (303, format!("{}/", run.key)));
}

#[test]
fn the_state_tells_moments_series_and_how_it_stands() {
    let run = TestRun::new();
    let state = run.get("/api/state?moments=0").json();
    assert_eq!(
        (state["title"].as_str(), state["going_on"].as_bool()),
        (Some("Three grains"), Some(false))
    );
    assert_eq!(state["moments"]["steps"], serde_json::json!([0, 10]));
    assert_eq!(state["moments"]["times"], serde_json::json!([0.0, 0.5]));
    assert_eq!(state["series"]["rows"], 2);
    assert_eq!(
        state["series"]["columns"][1],
        serde_json::json!({ "name": "time", "unit": "s", "numbers": true })
    );
    assert_eq!(state["series"]["columns"][2]["numbers"], false);
    assert_eq!(
        state["series"]["stages"][0],
        serde_json::json!({ "name": "fill", "from": 0, "to": 2 })
    );
    assert!(state["summary"].is_null());
    let text = state.to_string();
    assert!(
        !text.contains(&*run.folder.root().to_string_lossy()),
        "the page need not know where the folder lies"
    );
    fs::write(
        run.folder.summary(),
        "{ \"title\": \"T\", \"finished\": true, \"stopped_by\": \"the end\" }",
    )
    .unwrap();
    let _lock = run.folder.lock().unwrap();
    std::thread::sleep(Duration::from_millis(250));
    let state = run.get("/api/state?moments=1").json();
    assert_eq!(
        (state["going_on"].as_bool(), state["summary"]["finished"].as_bool()),
        (Some(true), Some(true))
    );
    assert_eq!(
        (state["moments"]["from"].as_u64(), state["moments"]["steps"][0].as_u64()),
        (Some(1), Some(10))
    );
}

#[test]
fn a_frame_holds_grains_contacts_and_the_key_of_its_walls() {
    let run = TestRun::new();
    let frame = run.get("/api/frame/10").pack();
    assert_eq!(
        (frame.head["step"].as_u64(), frame.head["time"].as_f64()),
        (Some(10), Some(0.5))
    );
    assert_eq!(frame.u32s("id"), [3, 1, 2]);
    assert_eq!(frame.f32s("position")[3..6], [0.0, 0.0, 1.0]);
    assert_eq!(frame.f32s("radius"), [1.0, 1.0, 2.0]);
    assert_eq!(frame.f32s("speed"), [5.0, 5.0, 5.0]);
    assert_eq!(frame.f32s("spin"), [10.0, 10.0, 10.0]);
    // grain 1 carries 2 N of grain 2 and 3 N of the wall
    assert_eq!(frame.f32s("contact force"), [0.0, 5.0, 2.0]);
    assert_eq!(frame.f32s("coordination"), [0.0, 2.0, 1.0]);
    assert_eq!(frame.head["scalars"][7]["names"], serde_json::json!(["glass", "steel"]));
    assert_eq!(
        frame.head["contacts"],
        serde_json::json!({ "count": 2, "mean_force": 2.5 })
    );
    let contacts = run.get("/api/contacts/10").pack();
    assert_eq!(contacts.f32s("normal_force"), [2.0, 3.0]);
    // from the centre of grain 1 to that of grain 2, and to the wall
    assert_eq!(
        contacts.f32s("ends"),
        [0.0, 0.0, 1.0, 0.0, 0.0, 3.75, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]
    );
    assert_eq!(run.get("/api/contacts/5").status, 404);
    let walls = run.get("/api/walls/10").pack();
    assert_eq!(walls.head["walls"], frame.head["walls"]);
    assert_eq!(
        walls.head["list"][1],
        serde_json::json!({ "name": "lid", "index": 1, "start": 1, "end": 2 })
    );
    assert_eq!(walls.f32s("triangles").len(), 18);
    assert_ne!(
        run.get("/api/frame/0").pack().head["walls"],
        frame.head["walls"],
        "the lid has moved"
    );
    assert_eq!(run.get("/api/frame/5").status, 404);
}

#[test]
fn answers_are_compressed_on_request() {
    let run = TestRun::with(true);
    let plain = run.get("/viewer.js");
    assert_eq!(plain.header("content-encoding"), "");
    let small = run.ask("/viewer.js", "Host: localhost\r\nAccept-Encoding: gzip");
    assert_eq!(small.header("content-encoding"), "gzip");
    let mut text = Vec::new();
    flate2::read::GzDecoder::new(small.body.as_slice())
        .read_to_end(&mut text)
        .unwrap();
    assert!(text == plain.body && small.body.len() < plain.body.len() / 2);
}

#[test]
fn a_grain_is_told_with_its_contacts_and_its_way() {
    let run = TestRun::new();
    let grain = run.get("/api/grain/10/2").json();
    assert_eq!(
        (grain["values"]["radius"].as_f64(), grain["values"]["material"].as_str()),
        (Some(2.0), Some("steel"))
    );
    assert_eq!(grain["values"]["velocity"], serde_json::json!([3.0, 4.0, 0.0]));
    let contact = &grain["contacts"][0];
    assert_eq!(
        (contact["partner"].as_u64(), contact["wall"].as_i64()),
        (Some(1), Some(-1))
    );
    assert_eq!(
        (contact["normal_force"].as_f64(), contact["tangential_force"].as_f64()),
        (Some(2.0), Some(0.5))
    );
    assert_eq!(
        contact["normal"],
        serde_json::json!([0.0, 0.0, 1.0]),
        "away from the partner"
    );
    assert_eq!(contact["overlap"].as_f64(), Some(0.25));
    let below = run.get("/api/grain/10/1").json();
    assert_eq!(below["contacts"].as_array().unwrap().len(), 2);
    assert_eq!(below["contacts"][1]["wall"], 0);
    assert_eq!(run.get("/api/grain/10/9").status, 404);

    let way = run.get("/api/history/2?moments=1,0,9").json();
    let moments = way["moments"].as_array().unwrap();
    assert_eq!(moments.len(), 2, "there is no moment 9");
    assert_eq!(moments[0]["position"], serde_json::json!([0.0, 0.0, 3.75]));
    let told = ["speed", "coordination"].map(|name| moments[0][name].as_f64().unwrap());
    assert_eq!(told, [5.0, 1.0]);
    for (id, force) in [(1, 5.0), (2, 2.0), (3, 0.0)] {
        let way = run.get(&format!("/api/history/{id}?moments=1")).json();
        assert_eq!(way["moments"][0]["contact_force"].as_f64(), Some(force), "grain {id}");
    }
    let none = run.get("/api/history/77?moments=1").json();
    assert_eq!(none["moments"], serde_json::json!([null]));
}

#[test]
fn a_frame_that_was_written_anew_is_read_anew() {
    let run = TestRun::new();
    let contacts = || run.get("/api/grain/10/2").json()["contacts"].as_array().map(Vec::len);
    assert_eq!(contacts(), Some(1));
    let path = run.folder.frames().join("contacts_0000000010.vtp");
    std::thread::sleep(Duration::from_millis(20));
    run.write_contacts_of(10, 1, 3);
    assert!(path.exists());
    assert_eq!(contacts(), Some(0), "grain 2 has lost its contact to grain 3");
}

#[test]
fn a_run_that_goes_on_is_followed() {
    let run = TestRun::new();
    let rows = |from| run.get(&format!("/api/series?columns=0,1&from={from}")).pack();
    assert_eq!(rows(0).f64s("1"), [0.0, 0.5]);
    let epoch = run.get("/api/state?moments=0").json()["epoch"].clone();
    run.add_row("20,1.0,fill\n30,1.");
    run.add_frame(20, 1.0);
    std::thread::sleep(Duration::from_millis(250));
    let state = run.get("/api/state?moments=2").json();
    assert_eq!(
        (&state["moments"]["steps"], &state["series"]["rows"]),
        (&serde_json::json!([20]), &serde_json::json!(3))
    );
    assert_eq!(state["epoch"], epoch);
    let more = rows(2);
    assert_eq!((more.f64s("0"), more.head["from"].as_u64()), (vec![20.0], Some(2)));
    assert_eq!(rows(100).f64s("1").len(), 0);
    assert_eq!(
        run.get("/api/series?columns=2&from=0").status,
        404,
        "words cannot be plotted"
    );
    // a restart from an earlier step takes rows and frames away
    fs::write(run.folder.series(), "step,time [s],stage\n0,0.0,fill\n").unwrap();
    run.list_frames(&[(0, 0.0)]);
    std::thread::sleep(Duration::from_millis(250));
    let state = run.get("/api/state?moments=0").json();
    assert_ne!(state["epoch"], epoch);
    assert_eq!(
        (&state["moments"]["count"], &state["series"]["rows"]),
        (&serde_json::json!(1), &serde_json::json!(1))
    );
}

#[test]
fn what_is_damaged_is_told_and_the_rest_is_shown() {
    let run = TestRun::new();
    let path = run.folder.frames().join("contacts_0000000010.vtp");
    let bytes = fs::read(&path).unwrap();
    fs::write(&path, &bytes[..bytes.len() / 2]).unwrap();
    let answer = run.get("/api/frame/10");
    assert_eq!(answer.status, 500);
    let problem = answer.json()["error"].as_str().unwrap().to_string();
    assert!(
        problem.contains("contacts_0000000010.vtp") && problem.contains("damaged"),
        "{problem}"
    );
    assert!(!problem.contains(&*run.folder.root().to_string_lossy()), "{problem}");
    assert_eq!(run.get("/api/frame/0").status, 200);
    // its grains are whole
    assert!(run.get("/api/history/1?moments=1").json()["moments"][0]["contact_force"].is_number());
    run.add_row("soon,1.0,fill\n");
    std::thread::sleep(Duration::from_millis(250));
    let state = run.get("/api/state?moments=0").json();
    assert!(state["fault"].as_str().unwrap().contains("line 4"), "{state}");
    assert_eq!(state["series"]["rows"], 2);
}

#[test]
fn no_path_of_the_system_can_be_asked_for() {
    let run = TestRun::new();
    fs::write(run.folder.root().join("notes.txt"), "mine").unwrap();
    for path in [
        "/notes.txt",
        "/run.json",
        "/series.csv",
        "/frames/grains_0000000010.vtp",
        "/../../../../etc/passwd",
        "/..%2f..%2f..%2fetc%2fpasswd",
        "/%2e%2e/%2e%2e/etc/passwd",
        "/api/frame/../../run.json",
        "/api/frame/10/../../../run.json",
        "/api/frame/%2e%2e%2frun.json",
        "/api/frame/..\\..\\run.json",
        "//etc/passwd",
        "/api/frame//etc/passwd",
        "/api/frame/10%00",
        "file:///etc/passwd",
        "http://localhost/../etc/passwd",
    ] {
        let inside = run.ask(path, "Host: localhost");
        // what does not begin with a stroke makes another word of the key
        let refused = if path.starts_with('/') { 404 } else { 403 };
        assert!([400, refused].contains(&inside.status), "{path}: {}", inside.status);
        let outside = ask(
            run.port,
            &format!("GET {path} HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n"),
        );
        assert!([400, 403].contains(&outside.status), "{path}: {}", outside.status);
        for answer in [inside, outside] {
            assert!(
                !answer.text().contains("root:") && !answer.text().contains("mine"),
                "{path}"
            );
        }
    }
}

#[cfg(unix)]
#[test]
fn links_lead_nowhere() {
    use std::os::unix::fs::symlink;
    let run = TestRun::new();
    let outside = run.folder.root().with_file_name("outside");
    fs::create_dir(&outside).unwrap();
    let frame = run.folder.frames().join("grains_0000000010.vtp");
    // a file that could be read, were it inside
    fs::rename(&frame, outside.join("grains.vtp")).unwrap();
    symlink(outside.join("grains.vtp"), &frame).unwrap();
    for path in ["/api/frame/10", "/api/grain/10/1"] {
        assert_eq!(run.get(path).status, 403, "{path}");
    }
    assert!(run.get("/api/history/1?moments=1").json()["moments"][0].is_null());
    fs::write(outside.join("series.csv"), "step,time [s],stage\n0,0.0,secret\n").unwrap();
    fs::remove_file(run.folder.series()).unwrap();
    symlink(outside.join("series.csv"), run.folder.series()).unwrap();
    fs::write(outside.join("summary.json"), "{ \"title\": \"secret\" }").unwrap();
    symlink(outside.join("summary.json"), run.folder.summary()).unwrap();
    fs::rename(run.folder.scenario(), outside.join("scenario.toml")).unwrap();
    symlink(outside.join("scenario.toml"), run.folder.scenario()).unwrap();
    std::thread::sleep(Duration::from_millis(250));
    let state = run.get("/api/state?moments=0");
    assert!(
        !state.text().contains("secret") && !state.text().contains("Three grains"),
        "{}",
        state.text()
    );
    // the folder of the frames as a link
    fs::rename(run.folder.frames(), outside.join("frames")).unwrap();
    symlink(outside.join("frames"), run.folder.frames()).unwrap();
    assert_eq!(run.get("/api/frame/0").status, 403);
    assert_eq!(run.get("/api/walls/10").status, 403);
}

#[test]
fn others_are_refused() {
    let run = TestRun::new();
    let status = |text: &str| ask(run.port, text).status;
    assert_eq!(
        status("GET / HTTP/1.1\r\nHost: evil.example\r\nConnection: close\r\n\r\n"),
        421
    );
    assert_eq!(status("GET / HTTP/1.1\r\nConnection: close\r\n\r\n"), 421);
    assert_eq!(
        status("POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 1000000000\r\nConnection: close\r\n\r\n"),
        405
    );
    assert_eq!(
        status("GET / HTTP/1.1\r\nHost: localhost\r\nOrigin: https://evil.example\r\nConnection: close\r\n\r\n"),
        403
    );
    let long = "x".repeat(100_000);
    let answer = status(&format!("GET /{long} HTTP/1.1\r\nHost: localhost\r\n\r\n"));
    assert!([0, 414, 431].contains(&answer), "{answer}");
    let answer = status(&format!("GET / HTTP/1.1\r\nHost: localhost\r\nX: {long}\r\n\r\n"));
    assert!([0, 431].contains(&answer), "{answer}");
    assert_eq!(status("nonsense\r\n\r\n"), 400);
    assert_eq!(run.get("/").status, 200);
}

#[test]
fn slow_clients_hold_up_nobody() {
    let run = TestRun::new();
    let mut slow = Vec::new();
    let whole = format!("GET {}/viewer.js HTTP/1.1\r\nHost: localhost\r\n\r\n", run.key).into_bytes();
    for k in 0..20 {
        let mut stream = TcpStream::connect(("127.0.0.1", run.port)).unwrap();
        // half of a request, or a whole one whose answer is never read
        let text: &[u8] = if k % 2 == 0 { b"GET / HT" } else { &whole };
        stream.write_all(text).unwrap();
        slow.push(stream);
    }
    let begun = Instant::now();
    for _ in 0..5 {
        assert_eq!(run.get("/api/frame/10").status, 200);
    }
    // far above what it takes, far below the times after which slow clients are given up
    assert!(begun.elapsed() < Duration::from_secs(20));
}

#[test]
fn a_folder_that_is_no_run_is_refused() {
    let place = tempfile::tempdir().unwrap();
    let error = demeter_viewer::Viewer::open(place.path(), demeter_viewer::Options::default()).unwrap_err();
    assert!(
        error.to_string().contains("is not the folder of a Demeter run"),
        "{error}"
    );
    let run = TestRun::new();
    let options = demeter_viewer::Options {
        port: run.port,
        ..Default::default()
    };
    let error = demeter_viewer::Viewer::open(run.folder.root(), options)
        .unwrap_err()
        .to_string();
    assert!(
        error.contains(&format!("127.0.0.1:{}", run.port)) && error.contains("--port"),
        "{error}"
    );
}

#[test]
fn connections_are_used_again() {
    let run = TestRun::new();
    let mut stream = TcpStream::connect(("127.0.0.1", run.port)).unwrap();
    for _ in 0..3 {
        stream
            .write_all(format!("GET {}/api/grain/10/2 HTTP/1.1\r\nHost: localhost\r\n\r\n", run.key).as_bytes())
            .unwrap();
        let answer = Answer::read(&mut stream);
        assert_eq!((answer.status, answer.json()["id"].as_u64()), (200, Some(2)));
    }
    let _: Value = run.get("/api/state?moments=0").json();
}
