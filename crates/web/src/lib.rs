//! The pages of Demeter for browsers, bundled: scripts and styles that whoever writes or serves a page puts into it.
//!
//! The sources are in `page/` (TypeScript, with three.js for 3D and uPlot for plots); `cargo xtask web` makes `dist/` of
//! them, which is committed, so that building needs neither Node nor the network. Licences of the bundled libraries stand
//! at the beginning of every script and in [`LICENCES`].

/// Script and style of a page, with their hashes for its Content-Security-Policy.
///
/// Both may stand inside `<script>` and `<style>` as they are: they hold no closing tag.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Page {
    /// The script.
    pub script: &'static str,
    /// SHA-256 of the script, base64.
    pub script_hash: &'static str,
    /// The style sheet.
    pub style: &'static str,
    /// SHA-256 of the style sheet, base64.
    pub style_hash: &'static str,
}

macro_rules! page {
    ($name:literal) => {
        Page {
            script: include_str!(concat!("../dist/", $name, ".js")),
            script_hash: include_str!(concat!("../dist/", $name, ".js.sha256")),
            style: include_str!(concat!("../dist/", $name, ".css")),
            style_hash: include_str!(concat!("../dist/", $name, ".css.sha256")),
        }
    };
}

/// The report of a run.
pub const REPORT: Page = page!("report");

/// The viewer of `demeter view`.
pub const VIEWER: Page = page!("viewer");

/// Licences of the libraries that the pages hold.
pub const LICENCES: &str = include_str!("../dist/LICENCES.txt");
