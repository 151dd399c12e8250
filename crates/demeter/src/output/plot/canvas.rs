//! What a plot is drawn on: the same lines and words become SVG or pixels.

use super::Look;

/// Where a text stands with respect to its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// A text, perhaps with a power behind it that stands higher.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Label {
    pub text: String,
    pub power: Option<String>,
}

impl Label {
    pub fn plain(text: impl Into<String>) -> Self {
        Self {
            text: text.into(),
            power: None,
        }
    }
}

/// How a text looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Letters {
    pub anchor: Anchor,
    /// Whether it is the title.
    pub title: bool,
    /// Whether it runs upwards.
    pub upwards: bool,
}

impl Letters {
    pub fn new(anchor: Anchor) -> Self {
        Self {
            anchor,
            title: false,
            upwards: false,
        }
    }
}

/// How a line looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pen {
    pub colour: &'static str,
    /// Width [pixels].
    pub width: f64,
    pub look: Look,
}

/// Something to draw on; y points down.
pub(super) trait Canvas {
    /// A line along an axis, one pixel thick.
    fn rule(&mut self, from: (f64, f64), to: (f64, f64), colour: &'static str);
    /// Lines through points, all of one series.
    fn lines(&mut self, lines: &[Vec<(f64, f64)>], pen: Pen);
    /// Circles around points, all of one series.
    fn circles(&mut self, centres: &[(f64, f64)], pen: Pen);
    /// The paper of the legend: left, top, width, height.
    fn card(&mut self, place: [f64; 4]);
    /// A text.
    fn text(&mut self, at: (f64, f64), label: &Label, letters: Letters);
}
