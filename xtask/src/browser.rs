//! The pages in headless Chromium.

use crate::checks::build_demeter;
use crate::shell::{answers, remove_run, root, run, target_folder};
use std::path::Path;

/// Where the tests and their `package.json` are.
const FOLDER: &str = "tests/browser";
/// Where the runs go whose pages are opened: beside what cargo builds.
const RUN: &str = "browser-run";
const RUN_ALONE: &str = "browser-run-alone";
/// A title that would run a script where it was not escaped; the test knows it.
const EVIL: &str = "title=\"</script><script>alert(1)</script><img src=x onerror=alert(1)>\"";
const BROWSERS: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];

/// Runs small scenarios and opens their pages. Fails where Node or Chromium is missing.
pub fn test() -> Result<(), String> {
    if let Some(missing) = missing() {
        return Err(format!("{missing} is not there"));
    }
    build_demeter()?;
    let whole = run_scenario(RUN, &[])?;
    let short = ["stage[0].duration=\"1 ms\"", "output.series=\"0.1 ms\"", EVIL];
    let alone = run_scenario(RUN_ALONE, &short)?;
    let folder = root().join(FOLDER).display().to_string();
    let npm = |arguments: &[&str], environment: &[(&str, &str)]| {
        run("npm", &[&["--prefix", &folder], arguments].concat(), environment)
    };
    npm(&["ci", "--no-audit", "--no-fund", "--loglevel=error"], &[])?;
    let pictures = target_folder()?.join("browser-pictures").display().to_string();
    let program = target_folder()?.join("debug/demeter").display().to_string();
    let runs = [
        ("DEMETER", program.as_str()),
        ("DEMETER_RUN", &whole),
        ("DEMETER_RUN_ALONE", &alone),
        ("DEMETER_PICTURES", &pictures),
    ];
    npm(&["run", "--silent", "test"], &runs)
}

/// The test of CI: left out, with a message, where Node or Chromium is missing.
pub fn test_where_possible() -> Result<(), String> {
    match missing() {
        None => test(),
        Some(missing) => {
            println!("==> {missing} is not there: the pages are not opened in a browser");
            Ok(())
        }
    }
}

/// What is needed and not there.
fn missing() -> Option<&'static str> {
    if !answers("npm", &["--version"]) {
        return Some("npm");
    }
    let told = std::env::var_os("DEMETER_CHROMIUM").is_some_and(|path| Path::new(&path).exists());
    let found = told || BROWSERS.iter().any(|name| answers(name, &["--version"]));
    (!found).then_some("Chromium")
}

/// Runs the small scenario of the output's tests and gives the folder.
fn run_scenario(name: &str, overrides: &[&str]) -> Result<String, String> {
    let target = target_folder()?;
    let folder = target.join(name);
    if folder.exists() {
        remove_run(&folder)?;
    }
    let folder = folder.display().to_string();
    let mut arguments = vec!["run", "tests/python/scenario.toml", "--out", &folder];
    arguments.extend(overrides.iter().flat_map(|text| ["--set", text]));
    run(&target.join("debug/demeter").display().to_string(), &arguments, &[])?;
    Ok(folder)
}
