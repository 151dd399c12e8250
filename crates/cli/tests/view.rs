//! `demeter view`.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail as tests do")]

mod demeter;

use demeter::{Place, signal};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Command, Stdio};

#[test]
fn a_folder_that_is_no_run_is_refused() {
    let place = Place::new();
    let said = place.expect(2, &["view", "nothing", "--no-browser"]);
    assert!(
        said.err.contains("`nothing` is not the folder of a Demeter run"),
        "{}",
        said.err
    );
    assert!(said.out.is_empty());
}

#[cfg(unix)]
#[test]
fn a_run_is_served_until_ctrl_c() {
    let place = Place::new();
    std::fs::create_dir(place.path("run")).unwrap();
    std::fs::write(place.path("run/run.json"), "{}").unwrap();
    let mut viewer = Command::new(env!("CARGO_BIN_EXE_demeter"))
        .args(["view", "--no-browser"])
        .arg(place.path("run"))
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let mut line = String::new();
    BufReader::new(viewer.stdout.as_mut().unwrap())
        .read_line(&mut line)
        .unwrap();
    let url = line.trim().strip_prefix("http://").unwrap();
    let (address, key) = url.split_once('/').unwrap();
    assert!(address.starts_with("127.0.0.1:"), "{line}");
    assert!(key.len() > 32 && key.ends_with('/'), "{line}");
    let ask = |path: &str| {
        let mut stream = TcpStream::connect(address).unwrap();
        let request = format!("GET /{path} HTTP/1.1\r\nHost: {address}\r\nConnection: close\r\n\r\n");
        stream.write_all(request.as_bytes()).unwrap();
        let mut answer = String::new();
        stream.read_to_string(&mut answer).unwrap();
        answer
    };
    let answer = ask(&format!("{key}api/state?moments=0"));
    assert!(
        answer.starts_with("HTTP/1.1 200") && answer.contains("\"count\":0"),
        "{answer}"
    );
    assert!(ask("api/state?moments=0").starts_with("HTTP/1.1 403"));
    assert_eq!(signal(&mut viewer, "INT").code(), Some(0));
}
