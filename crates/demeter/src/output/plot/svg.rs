//! A plot as SVG.

use super::canvas::{Anchor, Canvas, Label, Letters, Pen};
use super::{CIRCLE, Look};
use std::fmt::Write as _;

/// An SVG document that is being written.
pub(super) struct Svg {
    text: String,
}

impl Svg {
    /// The start of a document of this size.
    pub fn new(width: f64, height: f64) -> Self {
        Self {
            text: format!(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
                 viewBox=\"0 0 {width} {height}\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"14\" \
                 fill=\"#262c34\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
            ),
        }
    }

    /// Draws what follows shifted, until [`Self::end_shift`].
    pub fn begin_shift(&mut self, left: f64, top: f64) {
        self.put(format_args!("<g transform=\"translate({left} {top})\">"));
    }

    /// Ends what [`Self::begin_shift`] began.
    pub fn end_shift(&mut self) {
        self.put(format_args!("</g>"));
    }

    /// The document.
    pub fn finish(mut self) -> String {
        self.text.push_str("</svg>\n");
        self.text
    }

    /// Adds a line of text. Writing to a String cannot fail.
    fn put(&mut self, line: std::fmt::Arguments) {
        let _ = writeln!(self.text, "{line}");
    }

    fn path(&mut self, d: &str, pen: Pen) {
        let (colour, width, look) = (pen.colour, pen.width, dashes(pen.look));
        self.put(format_args!(
            "<path fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\" stroke-width=\"{width}\" \
             stroke=\"{colour}\"{look} d=\"{d}\"/>"
        ));
    }
}

fn dashes(look: Look) -> &'static str {
    match look {
        Look::Dashed => " stroke-dasharray=\"9 6\"",
        Look::Dotted => " stroke-dasharray=\"1 5\"",
        Look::Line | Look::Circles => "",
    }
}

impl Canvas for Svg {
    fn rule(&mut self, from: (f64, f64), to: (f64, f64), colour: &'static str) {
        let end = if from.0 == to.0 {
            format!("V{:.1}", to.1)
        } else {
            format!("H{:.1}", to.0)
        };
        self.put(format_args!(
            "<path stroke=\"{colour}\" d=\"M{:.1} {:.1}{end}\"/>",
            from.0, from.1
        ));
    }

    fn lines(&mut self, lines: &[Vec<(f64, f64)>], pen: Pen) {
        let mut path = String::new();
        for line in lines {
            for (k, (x, y)) in line.iter().enumerate() {
                // Writing to a String cannot fail.
                let _ = write!(path, "{}{x:.2} {y:.2}", if k == 0 { 'M' } else { 'L' });
            }
        }
        self.path(&path, pen);
    }

    fn circles(&mut self, centres: &[(f64, f64)], pen: Pen) {
        let mut path = String::new();
        for (x, y) in centres {
            let _ = write!(path, "M{:.2} {y:.2}", x - CIRCLE);
            for turn in [2.0 * CIRCLE, -2.0 * CIRCLE] {
                let _ = write!(path, "a{CIRCLE} {CIRCLE} 0 1 0 {turn} 0");
            }
        }
        self.path(&path, pen);
    }

    fn card(&mut self, [left, top, width, height]: [f64; 4]) {
        self.put(format_args!(
            "<rect x=\"{left:.1}\" y=\"{top:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" rx=\"3\" \
             fill=\"#ffffff\" fill-opacity=\"0.85\" stroke=\"#d5d9dd\"/>"
        ));
    }

    fn text(&mut self, (x, y): (f64, f64), label: &Label, letters: Letters) {
        let place = match letters.upwards {
            true => format!("transform=\"translate({x:.1} {y:.1}) rotate(-90)\""),
            false => format!("x=\"{x:.1}\" y=\"{y:.1}\""),
        };
        let anchor = match letters.anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        let title = if letters.title {
            " font-size=\"18\" font-weight=\"bold\""
        } else {
            ""
        };
        let power = label.power.as_ref().map_or_else(String::new, |power| {
            format!("<tspan dy=\"-6\" font-size=\"11\">{}</tspan>", escape(power))
        });
        self.put(format_args!(
            "<text {place}{anchor}{title}>{}{power}</text>",
            escape(&label.text)
        ));
    }
}

/// A text as XML.
fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            // XML knows no other control characters.
            c if c.is_control() && !matches!(c, '\t' | '\n') => out.push(' '),
            c => out.push(c),
        }
    }
    out
}
