//! Links of the pages: files and places in them that there are.

use crate::shell::read;
use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};

/// Links that lead nowhere, with their pages. Addresses outside the book are not followed.
pub fn broken(pages: &Path) -> Result<Vec<String>, String> {
    let mut found = Vec::new();
    html(pages, &mut found)?;
    let mut texts = BTreeMap::new();
    for page in &found {
        texts.insert(page.clone(), read(page)?);
    }
    let mut broken = Vec::new();
    for (page, text) in &texts {
        // one page for all, whose anchors are made anew
        if page.ends_with("print.html") || page.ends_with("404.html") {
            continue;
        }
        for link in links(text) {
            if !leads(page, &link, &texts) {
                broken.push(format!(
                    "{}: {link}",
                    page.strip_prefix(pages).unwrap_or(page).display()
                ));
            }
        }
    }
    broken.sort();
    broken.dedup();
    Ok(broken)
}

fn html(folder: &Path, found: &mut Vec<PathBuf>) -> Result<(), String> {
    for entry in std::fs::read_dir(folder).map_err(|error| format!("cannot read {}: {error}", folder.display()))? {
        let path = entry.map_err(|error| error.to_string())?.path();
        if path.is_dir() {
            html(&path, found)?;
        } else if path.extension().is_some_and(|extension| extension == "html") {
            found.push(path);
        }
    }
    Ok(())
}

fn links(text: &str) -> Vec<String> {
    let mut links = Vec::new();
    for start in ["href=\"", "src=\""] {
        for rest in text.split(start).skip(1) {
            let link = rest.split('"').next().unwrap_or_default();
            links.push(link.replace("&amp;", "&"));
        }
    }
    links
}

fn leads(page: &Path, link: &str, texts: &BTreeMap<PathBuf, String>) -> bool {
    let outside = ["http:", "https:", "mailto:", "data:", "javascript:"];
    if link.is_empty() || outside.iter().any(|start| link.starts_with(start)) {
        return true;
    }
    let (file, place) = link.split_once('#').unwrap_or((link, ""));
    let file = file.split('?').next().unwrap_or_default();
    let target = if file.is_empty() {
        page.to_path_buf()
    } else {
        straight(&page.parent().unwrap_or(page).join(file))
    };
    match texts.get(&target) {
        Some(text) => place.is_empty() || text.contains(&format!("id=\"{place}\"")),
        None => target.exists(),
    }
}

/// A path without `..`.
fn straight(path: &Path) -> PathBuf {
    let mut made = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => {
                made.pop();
            }
            Component::CurDir => {}
            part => made.push(part),
        }
    }
    made
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_link_to_nothing_is_told() {
        let folder = tempfile::tempdir().unwrap();
        let page = "<h2 id=\"here\"></h2><a href=\"#here\">a</a><a href=\"#there\">b</a><a href=\"b.html#x\">c</a>\
            <img src=\"no.png\"><a href=\"https://example.org/none\">d</a><a href=\"sub/../b.html\">e</a>";
        std::fs::write(folder.path().join("a.html"), page).unwrap();
        std::fs::write(folder.path().join("b.html"), "<p>b</p>").unwrap();
        assert_eq!(
            broken(folder.path()).unwrap(),
            ["a.html: #there", "a.html: b.html#x", "a.html: no.png"]
        );
    }
}
