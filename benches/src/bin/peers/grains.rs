//! Grains at one moment, and the files in which engines are given them and leave them.

use demeter_physics::DVec3;
use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;

/// What goes wrong in this program is told in words.
pub type Fault = Box<dyn Error + Send + Sync>;

/// Type of a grain that never moves; all others have type 1.
pub const FIXED: u8 = 2;

/// One grain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grain {
    /// Identity, from 1.
    pub id: u32,
    /// 1, or [`FIXED`].
    pub kind: u8,
    /// Diameter [m].
    pub diameter: f64,
    /// Centre [m].
    pub position: DVec3,
    /// Velocity [m/s].
    pub velocity: DVec3,
    /// Angular velocity [1/s].
    pub spin: DVec3,
}

/// A start state: grains of one density in a box.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Lower corner of the box [m].
    pub lower: DVec3,
    /// Upper corner of the box [m].
    pub upper: DVec3,
    /// Mass density of all grains [kg/m^3].
    pub density: f64,
    /// The grains.
    pub grains: Vec<Grain>,
}

impl State {
    /// Where the highest grain ends [m].
    pub fn top(&self) -> f64 {
        let tops = self.grains.iter().map(|g| g.position.z + 0.5 * g.diameter);
        tops.fold(f64::NEG_INFINITY, f64::max)
    }

    /// Data file of LAMMPS and LIGGGHTS, which Demeter reads, too.
    pub fn data_file(&self, title: &str) -> String {
        let types = self.grains.iter().map(|g| g.kind).max().unwrap_or(1);
        let mut text = format!(
            "{title}: LAMMPS data\n\n{} atoms\n{types} atom types\n\n",
            self.grains.len()
        );
        for (axis, name) in ["x", "y", "z"].iter().enumerate() {
            let (low, high) = (self.lower[axis], self.upper[axis]);
            line(&mut text, format_args!("{low} {high} {name}lo {name}hi"));
        }
        text.push_str("\nAtoms\n\n");
        for g in &self.grains {
            let (p, d) = (g.position, g.diameter);
            line(
                &mut text,
                format_args!("{} {} {d} {} {} {} {}", g.id, g.kind, self.density, p.x, p.y, p.z),
            );
        }
        text.push_str("\nVelocities\n\n");
        for g in &self.grains {
            let (v, w) = (g.velocity, g.spin);
            line(
                &mut text,
                format_args!("{} {} {} {} {} {} {}", g.id, v.x, v.y, v.z, w.x, w.y, w.z),
            );
        }
        text
    }

    /// One line a grain, for YADE: `id type diameter density x y z vx vy vz wx wy wz`.
    pub fn lines(&self) -> String {
        let mut text = String::new();
        for g in &self.grains {
            let (p, v, w) = (g.position, g.velocity, g.spin);
            let head = format!("{} {} {} {}", g.id, g.kind, g.diameter, self.density);
            line(
                &mut text,
                format_args!(
                    "{head} {} {} {} {} {} {} {} {} {}",
                    p.x, p.y, p.z, v.x, v.y, v.z, w.x, w.y, w.z
                ),
            );
        }
        text
    }

    /// Reads a file written by [`State::data_file`].
    pub fn read(path: &Path) -> Result<Self, Fault> {
        let text = std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))?;
        Self::parse(&text).map_err(|e| format!("{}: {e}", path.display()).into())
    }

    fn parse(text: &str) -> Result<Self, Fault> {
        let (mut lower, mut upper, mut density) = (DVec3::NAN, DVec3::NAN, f64::NAN);
        let mut grains: Vec<Grain> = Vec::new();
        let (mut section, mut moving) = ("", 0);
        for (number, content) in text.lines().enumerate().skip(1) {
            let wrong = |what: &str| format!("line {}: {what}", number + 1);
            let words: Vec<&str> = content.split_whitespace().collect();
            match words.as_slice() {
                [] | [_, "atoms"] | [_, "atom", "types"] => {}
                [name] => section = name,
                [low, high, name, _] => {
                    let axis = ["xlo", "ylo", "zlo"].iter().position(|n| n == name);
                    let axis = axis.ok_or_else(|| wrong("neither a bound nor a grain"))?;
                    (lower[axis], upper[axis]) = (low.parse()?, high.parse()?);
                }
                values if values.len() == 7 && section == "Atoms" => {
                    let v = numbers(values).ok_or_else(|| wrong("not a number"))?;
                    density = v[3];
                    grains.push(Grain {
                        id: v[0] as u32,
                        kind: v[1] as u8,
                        diameter: v[2],
                        position: DVec3::new(v[4], v[5], v[6]),
                        velocity: DVec3::ZERO,
                        spin: DVec3::ZERO,
                    });
                }
                values if values.len() == 7 && section == "Velocities" => {
                    let v = numbers(values).ok_or_else(|| wrong("not a number"))?;
                    let grain = grains.get_mut(moving).filter(|g| f64::from(g.id) == v[0]);
                    let grain = grain.ok_or_else(|| wrong("velocities are not in the order of the grains"))?;
                    grain.velocity = DVec3::new(v[1], v[2], v[3]);
                    grain.spin = DVec3::new(v[4], v[5], v[6]);
                    moving += 1;
                }
                _ => return Err(wrong("not understood").into()),
            }
        }
        if grains.is_empty() || moving != grains.len() || lower.is_nan() || upper.is_nan() {
            return Err("the file is not whole".into());
        }
        Ok(Self {
            lower,
            upper,
            density,
            grains,
        })
    }
}

/// Columns of the file in which an engine leaves its grains, of which LAMMPS and LIGGGHTS write the longer head.
const END_COLUMNS: &str = "ITEM: ATOMS id type diameter x y z vx vy vz omegax omegay omegaz";

/// The grains at the end of a run, as all engines write them.
pub fn end_file(grains: &[Grain]) -> String {
    let mut text = format!("{END_COLUMNS}\n");
    for g in grains {
        let (p, v, w) = (g.position, g.velocity, g.spin);
        let head = format!("{} {} {}", g.id, g.kind, g.diameter);
        line(
            &mut text,
            format_args!(
                "{head} {} {} {} {} {} {} {} {} {}",
                p.x, p.y, p.z, v.x, v.y, v.z, w.x, w.y, w.z
            ),
        );
    }
    text
}

/// Reads the grains at the end of a run: those after the last head, sorted by id.
pub fn read_end(text: &str) -> Result<Vec<Grain>, Fault> {
    let start = text.rfind("ITEM: ATOMS").ok_or("no line `ITEM: ATOMS`")?;
    let mut lines = text[start..].lines();
    if lines.next().map(str::trim_end) != Some(END_COLUMNS) {
        return Err(format!("other columns than `{END_COLUMNS}`").into());
    }
    let mut grains = Vec::new();
    for content in lines {
        let words: Vec<&str> = content.split_whitespace().collect();
        let v = numbers(&words).filter(|v| v.len() == 12);
        let v = v.ok_or_else(|| format!("`{content}` is not a grain"))?;
        grains.push(Grain {
            id: v[0] as u32,
            kind: v[1] as u8,
            diameter: v[2],
            position: DVec3::new(v[3], v[4], v[5]),
            velocity: DVec3::new(v[6], v[7], v[8]),
            spin: DVec3::new(v[9], v[10], v[11]),
        });
    }
    grains.sort_unstable_by_key(|g| g.id);
    Ok(grains)
}

fn numbers(words: &[&str]) -> Option<Vec<f64>> {
    words.iter().map(|w| w.parse().ok()).collect()
}

fn line(text: &mut String, content: std::fmt::Arguments) {
    // writing to a string cannot fail
    let _ = text.write_fmt(content);
    text.push('\n');
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grain(id: u32, kind: u8) -> Grain {
        let x = f64::from(id);
        Grain {
            id,
            kind,
            diameter: 0.1 / x,
            position: DVec3::new(x / 3.0, -1e-7 / x, 1e3),
            velocity: DVec3::new(0.1, 0.2 * x, -0.3),
            spin: DVec3::new(1.0, 2.0, 3.0 / x),
        }
    }

    #[test]
    fn a_data_file_gives_back_the_state() {
        let state = State {
            lower: DVec3::new(0.0, -1.0, 0.5),
            upper: DVec3::new(1.0, 2.0, 1e4),
            density: 2500.0,
            grains: vec![grain(7, 1), grain(3, FIXED)],
        };
        let text = state.data_file("two");
        assert_eq!(State::parse(&text).unwrap(), state);
        assert!(text.contains("\n2 atoms\n2 atom types\n"));
        assert!(State::parse(&text.replace("Velocities", "Other")).is_err());
        assert!(State::parse(text.trim_end().rsplit_once('\n').unwrap().0).is_err());
        assert_eq!(state.lines().lines().next().unwrap().split(' ').count(), 13);
    }

    #[test]
    fn the_last_grains_of_a_dump_count_in_order_of_id() {
        let text = format!(
            "{}ITEM: TIMESTEP\n5\n{}",
            end_file(&[grain(1, 1)]),
            end_file(&[grain(9, 1), grain(4, FIXED)])
        );
        assert_eq!(read_end(&text).unwrap(), [grain(4, FIXED), grain(9, 1)]);
        assert!(read_end("ITEM: ATOMS id x y z\n1 0 0 0\n").is_err());
        assert!(read_end(&end_file(&[grain(1, 1)]).replace("0.1", "nonsense")).is_err());
        assert!(read_end("").is_err());
    }
}
