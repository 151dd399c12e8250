//! Lines of the chapters that stand for what is generated.

use super::laws::{self, Law};
use super::{copy, reference, said};
use crate::shell::{read, root};
use std::path::{Path, PathBuf};

/// Where the commands of the book run: one folder for all chapters, with the files of the book in it.
pub struct Workplace {
    demeter: PathBuf,
    folder: PathBuf,
    pictures: PathBuf,
    taken: usize,
}

impl Workplace {
    /// An empty one.
    pub fn new(build: &Path, demeter: &Path) -> Result<Self, String> {
        let folder = build.join("workplace");
        copy(&root().join("book/src/files"), &folder)?;
        copy(&root().join("examples"), &folder.join("examples"))?;
        let pictures = build.join("src/pictures");
        std::fs::create_dir_all(&pictures).map_err(|error| format!("cannot make {}: {error}", pictures.display()))?;
        Ok(Self {
            demeter: demeter.to_path_buf(),
            folder,
            pictures,
            taken: 0,
        })
    }

    /// The command and what it says.
    fn run(&self, command: &str) -> Result<String, String> {
        println!("==> {command}");
        let said = said(&self.demeter, &self.folder, command)?;
        Ok(format!("```console\n$ {command}\n{}\n```", said.trim_end()))
    }

    /// Takes a picture into the book; its name there.
    fn picture(&mut self, path: &str) -> Result<String, String> {
        let made = self.folder.join(path);
        let from = if made.is_file() { made } else { root().join(path) };
        self.taken += 1;
        let file = from.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let name = format!("{}-{file}", self.taken);
        std::fs::copy(&from, self.pictures.join(&name))
            .map_err(|error| format!("there is no picture {path}, neither made nor in the repository: {error}"))?;
        Ok(name)
    }
}

/// The text of a chapter with everything put in.
pub fn expand(text: &str, chapter: &Path, workplace: &mut Workplace, laws: &[Law]) -> Result<String, String> {
    let mut lines = Vec::new();
    for line in text.lines() {
        let told = line.trim().strip_prefix("{{#").and_then(|rest| rest.strip_suffix("}}"));
        let Some((name, argument)) = told.map(|told| told.split_once(' ').unwrap_or((told, ""))) else {
            lines.push(line.to_string());
            continue;
        };
        let made = match name {
            "reference" => reference::tables(&read(&root().join("crates/demeter/src/scenario").join(argument))?),
            "laws" if chapter.ends_with("SUMMARY.md") => laws::summary(laws),
            "laws" => laws::list(laws),
            "repo" => repository(argument, workplace)?,
            "run" => workplace.run(argument)?,
            "picture" => {
                let (path, text) = argument.split_once(' ').unwrap_or((argument, ""));
                format!("![{text}](pictures/{})", workplace.picture(path)?)
            }
            // a chapter that may not be written yet
            "chapter" => {
                let (path, title) = argument.split_once(' ').unwrap_or((argument, argument));
                match chapter.with_file_name(path).is_file() {
                    true => format!("- [{title}]({path})"),
                    false => continue,
                }
            }
            // those of mdBook
            "include" => line.to_string(),
            other => return Err(format!("{}: unknown line {{{{#{other}}}}}", chapter.display())),
        };
        lines.push(made);
    }
    Ok(lines.join("\n") + "\n")
}

/// A text of the repository. Its title goes, as the chapter has one; its pictures come along; links to files that are
/// not in the book become their text.
fn repository(path: &str, workplace: &mut Workplace) -> Result<String, String> {
    let text = read(&root().join(path))?;
    let folder = Path::new(path).parent().unwrap_or(Path::new(""));
    let mut lines = Vec::new();
    for line in text
        .lines()
        .skip_while(|line| line.is_empty() || line.starts_with("# "))
    {
        lines.push(relink(line, folder, workplace)?);
    }
    Ok(lines.join("\n"))
}

/// A line with its links put right.
fn relink(line: &str, folder: &Path, workplace: &mut Workplace) -> Result<String, String> {
    let mut made = String::new();
    let mut rest = line;
    while let Some(at) = rest.find("](") {
        let Some(start) = rest[..at].rfind('[') else {
            break;
        };
        let Some(length) = rest[at + 2..].find(')') else {
            break;
        };
        let (text, target) = (&rest[start + 1..at], &rest[at + 2..at + 2 + length]);
        let is_picture = rest[..start].ends_with('!');
        let before = if is_picture { &rest[..start - 1] } else { &rest[..start] };
        made.push_str(before);
        if target.starts_with("http") || target.starts_with('#') {
            made.push_str(&format!("[{text}]({target})"));
        } else if is_picture {
            let path = folder.join(target);
            made.push_str(&format!(
                "![{text}](pictures/{})",
                workplace.picture(&path.display().to_string())?
            ));
        } else if let Some(chapter) = target.rsplit_once("book/src/").map(|(_, chapter)| chapter) {
            made.push_str(&format!("[{text}]({chapter})"));
        } else {
            let shown = if text.starts_with('`') {
                text.to_string()
            } else {
                format!("{text} (`{target}`)")
            };
            made.push_str(&shown);
        }
        rest = &rest[at + 2 + length + 1..];
    }
    Ok(made + rest)
}
