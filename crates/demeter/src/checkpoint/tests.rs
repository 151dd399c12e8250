use super::*;
use crate::particles::{Grains, NewGrain};
use glam::DVec3;

fn header(step: u64) -> Header {
    Header {
        engine_version: crate::VERSION.to_owned(),
        title: "Two grains".to_owned(),
        step,
        time: 0.1 * step as f64,
        grains: 2,
        contacts: 1,
    }
}

fn grains(x: f64) -> Grains {
    let mut grains = Grains::default();
    for id in 1..=2 {
        let grain = NewGrain {
            fixed: false,
            material: 0,
            radius: 0.1,
            density: 1000.0,
            position: DVec3::new(x, -0.0, 1e-300),
            velocity: DVec3::ZERO,
            angular_velocity: DVec3::splat(f64::MIN_POSITIVE),
        };
        grains.push(id, &grain);
    }
    grains
}

fn restore(folder: &Path) -> Restored<Grains> {
    read_latest(folder).unwrap()
}

#[test]
fn what_is_read_is_what_was_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.checkpoint");
    write(&path, &header(7), &grains(1.0 / 3.0)).unwrap();
    let (found, value) = read::<Grains>(&path).unwrap();
    assert_eq!(found, header(7));
    assert_eq!(value, grains(1.0 / 3.0));
    assert_eq!(value.position[0].y.to_bits(), (-0.0_f64).to_bits());
    assert_eq!(read_header(&path).unwrap(), header(7));
    assert!(looks_like_one(&path));
}

#[test]
fn the_header_is_readable_in_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.checkpoint");
    write(&path, &header(7), &grains(0.0)).unwrap();
    let text = String::from_utf8_lossy(&fs::read(&path).unwrap()).into_owned();
    assert!(text.contains("\"step\": 7") && text.contains("\"title\": \"Two grains\""));
}

#[test]
fn cut_at_any_byte_it_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.checkpoint");
    write(&path, &header(7), &grains(0.5)).unwrap();
    let bytes = fs::read(&path).unwrap();
    for length in 0..bytes.len() {
        fs::write(&path, &bytes[..length]).unwrap();
        let error = read::<Grains>(&path).unwrap_err();
        match length {
            0 => assert!(matches!(error, CheckpointError::NotACheckpoint { .. })),
            _ => assert!(matches!(error, CheckpointError::CutShort { .. }), "{length}: {error}"),
        }
        read_header(&path).unwrap_err();
    }
}

#[test]
fn any_flipped_bit_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.checkpoint");
    write(&path, &header(7), &grains(0.5)).unwrap();
    let bytes = fs::read(&path).unwrap();
    // Every bit of the fixed part, one bit of every other byte.
    let rest = (FIXED..bytes.len()).map(|byte| 8 * byte + byte % 8);
    for bit in (0..8 * FIXED).chain(rest) {
        let mut bad = bytes.clone();
        bad[bit / 8] ^= 1 << (bit % 8);
        fs::write(&path, &bad).unwrap();
        read::<Grains>(&path).unwrap_err();
    }
}

#[test]
fn lengths_that_lie_are_refused_before_memory_is_taken() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.checkpoint");
    write(&path, &header(7), &grains(0.5)).unwrap();
    let mut bytes = fs::read(&path).unwrap();
    bytes[16..24].copy_from_slice(&u64::MAX.to_le_bytes());
    fs::write(&path, &bytes).unwrap();
    assert!(matches!(
        read::<Grains>(&path).unwrap_err(),
        CheckpointError::CutShort { .. }
    ));
}

#[test]
fn a_newer_format_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.checkpoint");
    write(&path, &header(7), &grains(0.5)).unwrap();
    let mut bytes = fs::read(&path).unwrap();
    bytes[8..12].copy_from_slice(&(FORMAT + 1).to_le_bytes());
    fs::write(&path, &bytes).unwrap();
    let text = read::<Grains>(&path).unwrap_err().to_string();
    assert!(text.contains("newer than this one"), "{text}");
}

#[test]
fn another_type_in_the_payload_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.checkpoint");
    write(&path, &header(7), &grains(0.5)).unwrap();
    assert!(matches!(
        read::<u8>(&path).unwrap_err(),
        CheckpointError::Contents { .. }
    ));
    write(&path, &header(7), &[u8::MAX; 12]).unwrap();
    assert!(matches!(
        read::<Grains>(&path).unwrap_err(),
        CheckpointError::Contents { .. }
    ));
}

#[test]
fn the_previous_one_is_kept() {
    let folder = tempfile::tempdir().unwrap();
    for step in 1..=3 {
        write_latest(folder.path(), &header(step), &grains(step as f64)).unwrap();
    }
    let restored = restore(folder.path());
    assert_eq!((restored.header.step, restored.warnings.len()), (3, 0));
    assert_eq!(read_header(&folder.path().join(PREVIOUS)).unwrap().step, 2);
}

/// Every state of the folder that a kill can leave behind holds a usable checkpoint.
#[test]
fn a_kill_between_any_two_steps_of_the_write_leaves_a_usable_one() {
    let folder = tempfile::tempdir().unwrap();
    let (latest, previous) = (folder.path().join(LATEST), folder.path().join(PREVIOUS));
    write_latest(folder.path(), &header(1), &grains(1.0)).unwrap();
    write_latest(folder.path(), &header(2), &grains(2.0)).unwrap();

    // In the middle of writing the temporary file.
    let part = write_part(&latest, &header(3), &grains(3.0)).unwrap();
    let whole = fs::read(&part).unwrap();
    for length in 0..whole.len() {
        fs::write(&part, &whole[..length]).unwrap();
        let restored = restore(folder.path());
        assert_eq!((restored.header.step, restored.warnings.len()), (2, 0));
    }
    // Before the first rename.
    fs::write(&part, &whole).unwrap();
    assert_eq!(restore(folder.path()).header.step, 2);
    // Between the two renames.
    fs::rename(&latest, &previous).unwrap();
    let restored = restore(folder.path());
    assert_eq!(restored.header.step, 3);
    assert!(restored.warnings[0].contains(".part"));
    // The next write starts from there and ends well.
    write_latest(folder.path(), &header(4), &grains(4.0)).unwrap();
    assert_eq!(restore(folder.path()).header.step, 4);
    assert!(!part.exists());
}

#[test]
fn a_damaged_latest_falls_back_with_a_warning() {
    let folder = tempfile::tempdir().unwrap();
    write_latest(folder.path(), &header(1), &grains(1.0)).unwrap();
    write_latest(folder.path(), &header(2), &grains(2.0)).unwrap();
    fs::write(folder.path().join(LATEST), b"DEMETERC damaged").unwrap();
    let restored = restore(folder.path());
    assert_eq!((restored.header.step, restored.value), (1, grains(1.0)));
    assert!(restored.warnings[0].contains("cut short"), "{:?}", restored.warnings);
    assert!(restored.warnings[1].contains("checkpoint.previous"));

    fs::write(folder.path().join(PREVIOUS), b"nothing").unwrap();
    let error = read_latest::<Grains>(folder.path()).unwrap_err();
    assert!(matches!(&error, CheckpointError::NoneUsable { problems, .. } if problems.len() == 2));
}

#[test]
fn an_empty_folder_has_none() {
    let folder = tempfile::tempdir().unwrap();
    let error = read_latest::<Grains>(folder.path()).unwrap_err();
    assert!(matches!(error, CheckpointError::Missing { .. }));
}
