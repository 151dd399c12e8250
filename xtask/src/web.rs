//! The pages for browsers: bundled by npm and esbuild into `crates/web/dist`, which is committed.

use crate::shell::{answers, root, run};

/// Where the sources and `package.json` are.
const FOLDER: &str = "crates/web";

/// Bundles the pages and tests their parts that need no browser; with `check` it changes nothing and fails where `dist` is not what the sources make.
pub fn build(check: bool) -> Result<(), String> {
    if !npm_is_there() {
        return Err("npm is not there; it comes with Node.js 20 or newer, https://nodejs.org".to_string());
    }
    npm(&["ci", "--no-audit", "--no-fund", "--loglevel=error"])?;
    npm(&["run", "--silent", "types"])?;
    npm(&["run", "--silent", "test"])?;
    npm(&["run", "--silent", if check { "check" } else { "build" }])
}

/// The check of CI: left out, with a message, where there is no npm.
pub fn check_where_possible() -> Result<(), String> {
    if npm_is_there() {
        return build(true);
    }
    println!("==> npm is not there: whether {FOLDER}/dist is what the sources make is not checked");
    Ok(())
}

fn npm_is_there() -> bool {
    answers("npm", &["--version"])
}

fn npm(arguments: &[&str]) -> Result<(), String> {
    let folder = root().join(FOLDER).display().to_string();
    run("npm", &[&["--prefix", &folder], arguments].concat(), &[])
}
