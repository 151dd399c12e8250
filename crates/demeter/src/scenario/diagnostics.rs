//! Everything that is wrong with a scenario, with the place of each fault.

use super::document::{Document, Span};
use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use std::fmt;
use std::sync::Arc;

/// More faults than this are counted, not kept.
const MAX_FAULTS: usize = 100;

/// One fault.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Diagnostic {
    /// What is wrong and what is allowed.
    pub message: String,
    /// What to do, when something can be suggested.
    pub help: Option<String>,
    /// Path of the key, as `stage[2].motion.top.velocity`; empty when the fault is not at a key.
    pub path: String,
    /// Name of the text at fault: the file, or `--set` for an override.
    pub source: String,
    /// Line of that text, from 1; 0 when the fault has no place.
    pub line: usize,
    /// Column in characters, from 1; 0 when the fault has no place.
    pub column: usize,
    /// The bytes at fault.
    pub span: Option<Span>,
}

/// Faults of one scenario, in the order of their places.
#[derive(Clone, Debug)]
pub struct Diagnostics {
    name: String,
    document: Arc<Document>,
    list: Vec<Diagnostic>,
    left_out: usize,
}

impl Diagnostics {
    /// No faults yet, of the scenario of this name.
    pub(super) fn new(name: &str, document: Arc<Document>) -> Self {
        Self {
            name: name.to_string(),
            document,
            list: Vec::new(),
            left_out: 0,
        }
    }

    /// Adds a fault at the value of a key; at the nearest table above it when the key was not written.
    pub fn push(&mut self, path: &str, message: impl Into<String>, help: Option<String>) {
        if self.keeps_one_more() {
            let span = self.document.origin(path);
            self.push_at(span, path, message.into(), help);
        }
    }

    /// Adds a fault at a key itself.
    pub(super) fn push_key(&mut self, path: &str, message: impl Into<String>, help: Option<String>) {
        if self.keeps_one_more() {
            let span = self.document.key_origin(path);
            self.push_at(span, path, message.into(), help);
        }
    }

    /// Whether a fault that was found is kept, so that it is worth to look for its place; else it is counted here.
    fn keeps_one_more(&mut self) -> bool {
        let keeps = self.list.len() < MAX_FAULTS;
        self.left_out += usize::from(!keeps);
        keeps
    }

    /// Adds a fault at a place.
    pub(super) fn push_at(&mut self, span: Option<Span>, path: &str, message: String, help: Option<String>) {
        if !self.keeps_one_more() {
            return;
        }
        let (line, column) = span.as_ref().map_or((0, 0), |s| self.document.line_column(s));
        let source = span.as_ref().and_then(|s| self.document.sources.get(s.source));
        let place = |d: &Diagnostic| d.span.as_ref().map(|s| (s.source, s.bytes.start));
        let source = source.map_or_else(|| self.name.clone(), |s| s.name.clone());
        let diagnostic = Diagnostic {
            message,
            help,
            path: path.to_string(),
            source,
            line,
            column,
            span,
        };
        let at = self.list.partition_point(|d| place(d) <= place(&diagnostic));
        // what is read for several pairs of materials is told once
        let mut at_its_place = self.list[..at]
            .iter()
            .rev()
            .take_while(|d| place(d) == place(&diagnostic));
        if !at_its_place.any(|d| *d == diagnostic) {
            self.list.insert(at, diagnostic);
        }
    }

    /// Keeps some faults alone.
    pub(super) fn retain(&mut self, keep: impl FnMut(&Diagnostic) -> bool) {
        self.list.retain(keep);
    }

    /// How many faults were found, those among them that were not kept.
    pub fn count(&self) -> usize {
        self.list.len() + self.left_out
    }

    /// The faults, or the first that were found where there are very many.
    pub fn list(&self) -> &[Diagnostic] {
        &self.list
    }

    /// Whether nothing is wrong.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The faults drawn with the lines of the scenario and the text at fault underlined.
    pub fn render(&self, colour: bool) -> String {
        let mut drawn: Vec<String> = self.list.iter().map(|d| self.render_one(d, colour)).collect();
        if self.left_out > 0 {
            drawn.push(format!("... and {} more faults", self.left_out));
        }
        drawn.join("\n\n")
    }

    /// One of the faults, drawn.
    pub fn render_one(&self, diagnostic: &Diagnostic, colour: bool) -> String {
        let renderer = if colour { Renderer::styled() } else { Renderer::plain() };
        let mut group = match self.excerpt(diagnostic) {
            None => Level::ERROR
                .primary_title(format!("{}: {}", diagnostic.source, diagnostic.message))
                .elements(std::iter::empty::<Snippet<'_, annotate_snippets::Annotation<'_>>>()),
            Some(excerpt) => Level::ERROR.primary_title(diagnostic.message.as_str()).element(
                Snippet::source(excerpt.text)
                    .path(diagnostic.source.as_str())
                    .line_start(diagnostic.line)
                    .annotation(AnnotationKind::Primary.span(excerpt.marked)),
            ),
        };
        if let Some(help) = &diagnostic.help {
            group = group.element(Level::HELP.message(help.as_str()));
        }
        renderer.render(&[group])
    }

    /// The line of a fault and what is marked in it. A fault over several lines is marked in its first.
    fn excerpt(&self, diagnostic: &Diagnostic) -> Option<Excerpt<'_>> {
        let span = diagnostic.span.as_ref()?;
        let text = self.document.sources.get(span.source)?.text.as_str();
        let start = span.bytes.start.min(text.len());
        let line_start = text.get(..start)?.rfind('\n').map_or(0, |at| at + 1);
        let line_end = text.get(start..)?.find('\n').map_or(text.len(), |at| start + at);
        let line = text.get(line_start..line_end)?.trim_end_matches('\r');
        let marked = (start - line_start).min(line.len())..(span.bytes.end - line_start).min(line.len());
        Some(Excerpt {
            text: line,
            marked: marked.start..marked.end.max(marked.start),
        })
    }
}

struct Excerpt<'a> {
    text: &'a str,
    marked: std::ops::Range<usize>,
}

/// One line per fault: `file:line:column: message (help)`.
impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, d) in self.list.iter().enumerate() {
            if index > 0 {
                writeln!(f)?;
            }
            write!(f, "{}", d.source)?;
            if d.line > 0 {
                write!(f, ":{}:{}", d.line, d.column)?;
            }
            write!(f, ": {}", d.message)?;
            if let Some(help) = &d.help {
                write!(f, " ({help})")?;
            }
        }
        if self.left_out > 0 {
            write!(f, "\n... and {} more faults", self.left_out)?;
        }
        Ok(())
    }
}

impl std::error::Error for Diagnostics {}
