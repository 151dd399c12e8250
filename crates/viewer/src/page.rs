//! The page that shows a run.

use demeter_web::VIEWER;
use hyper::header::HeaderValue;
use std::sync::LazyLock;

/// The page; script and style are read from beside it, behind the same key.
pub(crate) const HTML: &str = "<!doctype html>
<html lang=\"en\">
<head>
<meta charset=\"utf-8\">
<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">
<title>Demeter</title>
<link rel=\"icon\" href=\"data:,\">
<link rel=\"stylesheet\" href=\"viewer.css\">
</head>
<body>
<noscript>This page needs JavaScript to draw the run.</noscript>
<script src=\"viewer.js\"></script>
</body>
</html>
";

/// What the page may load: its own script and style, and what it makes itself. The script is known by its hash.
pub(crate) static POLICY: LazyLock<HeaderValue> = LazyLock::new(|| {
    let policy = format!(
        "default-src 'none'; script-src 'sha256-{}' 'self'; style-src 'self'; connect-src 'self'; img-src 'self' data: blob:; \
         media-src blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
        VIEWER.script_hash
    );
    HeaderValue::from_str(&policy).unwrap_or(HeaderValue::from_static("default-src 'none'"))
});
