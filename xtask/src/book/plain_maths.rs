//! Formulas as the pages of the laws write them for a terminal, `K = 4/3 E sqrt(R)`, as LaTeX.
//!
//! Names are single letters, Greek letters by name, letters with a number or with what follows `_` below them, and those that the
//! page explains. All other words are text. A quotient's numerator reaches back to the last sign.

use std::collections::BTreeSet;

const GREEK: [&str; 32] = [
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "kappa", "lambda", "mu", "nu", "xi", "pi",
    "rho", "sigma", "tau", "phi", "chi", "psi", "omega", "Gamma", "Delta", "Theta", "Lambda", "Xi", "Pi", "Sigma",
    "Phi", "Psi", "Omega", "iota",
];
const FUNCTIONS: [&str; 9] = ["sin", "cos", "tan", "ln", "log", "exp", "arccos", "arcsin", "arctan"];

/// What a page calls its quantities.
#[derive(Default)]
pub struct Names(BTreeSet<String>);

impl Names {
    /// Those that are told.
    pub fn new(told: impl IntoIterator<Item = String>) -> Self {
        Self(told.into_iter().collect())
    }

    /// A name as LaTeX; none where it is a word.
    fn latex(&self, word: &str) -> Option<String> {
        let bare = word.trim_end_matches(['\'', '*']);
        let mark = word[bare.len()..].replace('*', "^{*}");
        let (base, below) = bare.split_once('_').map_or((bare, ""), |(base, below)| (base, below));
        let letters = base.trim_end_matches(|c: char| c.is_ascii_digit());
        let digits = &base[letters.len()..];
        let below = match below {
            "" => digits.to_string(),
            below if GREEK.contains(&below) => format!("\\{below}"),
            below if below.len() == 1 => format!("{digits}{below}"),
            below if below.len() == 2 && below.starts_with(char::is_lowercase) && below != "pl" => {
                format!("{digits}{below}")
            }
            below => format!("{digits}\\mathrm{{{below}}}"),
        };
        let mut chars = letters.chars();
        let first = chars.next()?;
        let rest = chars.as_str();
        let (base, below) = match letters {
            "Delta" if !below.is_empty() => return Some(format!("\\Delta {below}{mark}")),
            _ if GREEK.contains(&letters) => (format!("\\{letters}"), below),
            _ if rest.is_empty() => (letters.to_string(), below),
            // a letter and what stands below it, as `kc`
            _ if self.0.contains(bare) && rest.chars().count() == 1 => (first.to_string(), format!("{rest}{below}")),
            _ if first == 'd' && word != "do" && (rest.chars().count() == 1 || GREEK.contains(&rest)) => {
                let name = self.latex(&bare[1..])?;
                return Some(format!("\\mathrm{{d}}{name}{mark}"));
            }
            _ => return None,
        };
        Some(match below.is_empty() {
            true => format!("{base}{mark}"),
            false => format!("{base}_{{{below}}}{mark}"),
        })
    }

    /// Whether a piece of code is a formula: it has nothing but names, numbers and signs, or the words that are told.
    pub fn makes(&self, code: &str, words: &[&str]) -> bool {
        let Ok(tokens) = tokens(code) else { return false };
        let is_single = tokens.len() == 1;
        tokens.iter().all(|token| match &token.kind {
            Kind::Word(word) => {
                let is_name = FUNCTIONS.contains(&word.as_str()) || ["sqrt", "sum"].contains(&word.as_str());
                is_name && !is_single || self.latex(word).is_some() || !is_single && words.contains(&word.as_str())
            }
            Kind::Number(_) => true,
            Kind::Sign(sign) => !["\"", ":"].contains(&sign.as_str()),
        })
    }
}

#[derive(Clone, Debug, PartialEq)]
enum Kind {
    Word(String),
    Number(String),
    Sign(String),
}

#[derive(Clone, Debug)]
struct Token {
    kind: Kind,
    /// Whether a space stands before it.
    spaced: bool,
}

fn tokens(text: &str) -> Result<Vec<Token>, String> {
    let mut found = Vec::new();
    let mut rest = text;
    let mut spaced = false;
    while let Some(c) = rest.chars().next() {
        if c == ' ' {
            spaced = true;
            rest = &rest[1..];
            continue;
        }
        let (kind, length) = if c.is_ascii_digit() {
            let length = number_length(rest);
            (Kind::Number(rest[..length].to_string()), length)
        } else if c.is_alphabetic() {
            let word = |c: char| c.is_alphanumeric() || c == '_';
            let mut length = rest.find(|c| !word(c)).unwrap_or(rest.len());
            length += rest[length..].len() - rest[length..].trim_start_matches('\'').len();
            let after = rest[length..].strip_prefix('*');
            length +=
                usize::from(after.is_some_and(|after| !after.starts_with(|c: char| c.is_alphanumeric() || c == '(')));
            (Kind::Word(rest[..length].to_string()), length)
        } else {
            let signs = ["...", "<=", ">=", "<<", ":=", "+="];
            let sign = signs.iter().find(|sign| rest.starts_with(**sign));
            let length = sign.map_or(c.len_utf8(), |sign| sign.len());
            (Kind::Sign(rest[..length].to_string()), length)
        };
        found.push(Token { kind, spaced });
        spaced = false;
        rest = &rest[length..];
    }
    if found.is_empty() {
        Err("there is nothing".to_string())
    } else {
        Ok(found)
    }
}

fn number_length(text: &str) -> usize {
    let digits = |text: &str| text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
    let mut length = digits(text);
    if let Some(after) = text[length..].strip_prefix('.')
        && after.starts_with(|c: char| c.is_ascii_digit())
    {
        length += 1 + digits(after);
    }
    if let Some(after) = text[length..].strip_prefix('e') {
        let signed = after.strip_prefix('-').unwrap_or(after);
        if signed.starts_with(|c: char| c.is_ascii_digit()) {
            length += 1 + (after.len() - signed.len()) + digits(signed);
        }
    }
    length
}

/// A piece of a formula, as LaTeX.
struct Piece {
    latex: String,
    /// Whether it can be part of a numerator.
    is_factor: bool,
    /// Without its brackets, where they are round and all there is.
    inside: Option<String>,
}

impl Piece {
    fn factor(latex: String) -> Self {
        Self {
            latex,
            is_factor: true,
            inside: None,
        }
    }

    fn sign(latex: &str) -> Self {
        Self {
            latex: latex.to_string(),
            is_factor: false,
            inside: None,
        }
    }
}

struct Parser<'a> {
    tokens: &'a [Token],
    at: usize,
    names: &'a Names,
    /// Whether quotients are drawn as fractions.
    fractions: bool,
}

/// A formula as LaTeX, with fractions where it stands by itself.
pub fn latex(text: &str, names: &Names, fractions: bool) -> Result<String, String> {
    let tokens = tokens(text)?;
    let mut parser = Parser {
        tokens: &tokens,
        at: 0,
        names,
        fractions,
    };
    let made = parser.sequence(None)?;
    match parser.at == tokens.len() {
        true => Ok(made),
        false => Err(format!("a bracket too many in `{text}`")),
    }
}

impl Parser<'_> {
    fn sign(&self) -> Option<&str> {
        match &self.tokens.get(self.at)?.kind {
            Kind::Sign(sign) => Some(sign),
            _ => None,
        }
    }

    fn word(&self, at: usize) -> Option<&str> {
        match &self.tokens.get(at)?.kind {
            Kind::Word(word) => Some(word),
            _ => None,
        }
    }

    fn is_text(&self, at: usize) -> bool {
        let Some(word) = self.word(at) else { return false };
        let is_function = FUNCTIONS.contains(&word) || word == "sqrt";
        match word {
            "sum" => self.word(at + 1) == Some("of"),
            // an article, not a radius
            "a" => at > 0 && self.is_text(at - 1) && self.is_text(at + 1),
            word => !is_function && self.names.latex(word).is_none(),
        }
    }

    /// All up to a closing bracket, or to the end.
    fn sequence(&mut self, close: Option<&str>) -> Result<String, String> {
        let mut pieces: Vec<Piece> = Vec::new();
        while self.at < self.tokens.len() && self.sign().is_none_or(|sign| Some(sign) != close) {
            if self.sign() == Some("/") {
                self.at += 1;
                self.quotient(&mut pieces)?;
            } else {
                let piece = self.piece()?;
                pieces.push(piece);
            }
        }
        if close.is_some() && self.at == self.tokens.len() {
            return Err(format!("`{}` is missing", close.unwrap_or_default()));
        }
        Ok(joined(pieces))
    }

    fn quotient(&mut self, pieces: &mut Vec<Piece>) -> Result<(), String> {
        let below = self.piece()?;
        if !self.fractions {
            pieces.push(Piece::sign("/"));
            pieces.push(below);
            return Ok(());
        }
        let first = pieces
            .iter()
            .rposition(|piece| !piece.is_factor)
            .map_or(0, |last| last + 1);
        let mut above: Vec<Piece> = pieces.drain(first..).collect();
        let above = match above.pop() {
            Some(only) if above.is_empty() => only.inside.unwrap_or(only.latex),
            Some(last) => {
                above.push(last);
                joined(above)
            }
            None => return Err("a quotient has nothing above".to_string()),
        };
        let below = below.inside.unwrap_or(below.latex);
        pieces.push(Piece::factor(format!("\\frac{{{above}}}{{{below}}}")));
        Ok(())
    }

    /// One factor with its exponent, or one sign, or words.
    fn piece(&mut self) -> Result<Piece, String> {
        if self.is_text(self.at) {
            return Ok(self.text());
        }
        let mut piece = self.primary()?;
        while piece.is_factor && self.sign() == Some("^") {
            self.at += 1;
            let fractions = std::mem::replace(&mut self.fractions, false);
            let minus = self.sign() == Some("-");
            self.at += usize::from(minus);
            let above = self.primary()?;
            self.fractions = fractions;
            let above = above.inside.unwrap_or(above.latex);
            let minus = if minus { "-" } else { "" };
            piece = Piece::factor(format!("{}^{{{minus}{above}}}", grouped(&piece.latex)));
        }
        Ok(piece)
    }

    /// Words that follow each other.
    fn text(&mut self) -> Piece {
        let mut words = Vec::new();
        while self.is_text(self.at) {
            words.push(self.word(self.at).unwrap_or_default().to_string());
            self.at += 1;
        }
        Piece {
            latex: format!("\\;\\text{{{}}}\\;", words.join(" ")),
            is_factor: false,
            inside: None,
        }
    }

    fn primary(&mut self) -> Result<Piece, String> {
        let token = self.tokens.get(self.at).ok_or("a formula ends too early")?;
        self.at += 1;
        match &token.kind {
            Kind::Number(number) => Ok(Piece::factor(scientific(number))),
            Kind::Word(word) if word == "sum" => Ok(Piece::sign("\\sum ")),
            Kind::Word(word) if word == "sqrt" => {
                let of = self.primary()?;
                Ok(Piece::factor(format!("\\sqrt{{{}}}", of.inside.unwrap_or(of.latex))))
            }
            Kind::Word(word) if FUNCTIONS.contains(&word.as_str()) => {
                let of = self.primary()?;
                Ok(Piece::factor(format!("\\{word} {}", of.latex)))
            }
            Kind::Word(word) => {
                let name = self.names.latex(word).unwrap_or_else(|| format!("\\text{{{word}}}"));
                let is_called = self.sign() == Some("(") && !self.tokens[self.at].spaced;
                let of = if is_called {
                    self.primary()?.latex
                } else {
                    String::new()
                };
                Ok(Piece::factor(format!("{name}{of}")))
            }
            Kind::Sign(sign) => self.bracket_or_sign(sign),
        }
    }

    fn bracket_or_sign(&mut self, sign: &str) -> Result<Piece, String> {
        let (close, left, right) = match sign {
            "(" => (")", "(", ")"),
            "[" => ("]", "[", "]"),
            "{" => ("}", "\\{", "\\}"),
            "|" => ("|", "\\lvert", "\\rvert"),
            "\"" => return self.quoted(),
            "." if self.is_product() => return Ok(Piece::factor("\\cdot ".to_string())),
            _ => {
                let signs = [
                    ("<=", "\\le "),
                    (">=", "\\ge "),
                    ("<<", "\\ll "),
                    ("...", "\\dots "),
                    (",", ",\\; "),
                    (";", ";\\quad "),
                    (":=", "\\coloneqq "),
                    ("+=", "\\mathrel{+}= "),
                    ("*", "\\times "),
                ];
                if [")", "]", "}", "^"].contains(&sign) {
                    return Err(format!("`{sign}` stands where something else should"));
                }
                let known = signs.iter().find(|(plain, _)| *plain == sign);
                return Ok(Piece::sign(known.map_or(sign, |(_, latex)| latex)));
            }
        };
        let inside = self.sequence(Some(close))?;
        self.at += 1;
        let latex = format!("\\left{left} {inside} \\right{right}");
        let inside = (sign == "(").then_some(inside);
        Ok(Piece {
            latex,
            is_factor: true,
            inside,
        })
    }

    /// Whether the point that was just read stands between two names.
    fn is_product(&self) -> bool {
        let after = self.tokens.get(self.at);
        after.is_some_and(|token| !token.spaced && matches!(token.kind, Kind::Word(_)))
            && !self.tokens[self.at - 1].spaced
    }

    fn quoted(&mut self) -> Result<Piece, String> {
        let mut words = String::new();
        while self.sign() != Some("\"") {
            let token = self.tokens.get(self.at).ok_or("a quote does not end")?;
            let (Kind::Word(text) | Kind::Number(text) | Kind::Sign(text)) = &token.kind;
            words += if token.spaced && !words.is_empty() { " " } else { "" };
            words += text;
            self.at += 1;
        }
        self.at += 1;
        Ok(Piece::sign(&format!("\\;\\text{{\"{words}\"}}")))
    }
}

fn joined(pieces: Vec<Piece>) -> String {
    let pieces: Vec<String> = pieces.into_iter().map(|piece| piece.latex).collect();
    pieces.join(" ")
}

/// Something that may carry an exponent.
fn grouped(latex: &str) -> String {
    match latex.contains("^{") && !latex.starts_with("\\left") {
        true => format!("{{{latex}}}"),
        false => latex.to_string(),
    }
}

fn scientific(number: &str) -> String {
    match number.split_once('e') {
        Some(("1", power)) => format!("10^{{{power}}}"),
        Some((mantissa, power)) => format!("{mantissa} \\times 10^{{{power}}}"),
        None => number.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn made(text: &str) -> String {
        let names = Names::new(["kc".to_string(), "h_U".to_string()]);
        let latex = latex(text, &names, true).unwrap();
        latex.split_whitespace().collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn formulas_of_a_terminal_become_latex() {
        let cases = [
            ("K = 4/3 E sqrt(R)", r"K = \frac{4}{3} E \sqrt{R}"),
            ("K d^(3/2)", r"K d^{3 / 2}"),
            ("4 E a^3/(3 R)", r"\frac{4 E a^{3}}{3 R}"),
            (
                "-mu F_n v_t / |v_t|",
                r"- \frac{\mu F_{n} v_{t}}{\left\lvert v_{t} \right\rvert}",
            ),
            ("kc (k2 - k1)^2", r"k_{c} \left( k_{2} - k_{1} \right)^{2}"),
            ("n_k.u", r"n_{k} \cdot u"),
            ("dF_t = -k_t v_t dt", r"\mathrm{d}F_{t} = - k_{t} v_{t} \mathrm{d}t"),
            ("k2(D) (d - p)", r"k_{2}\left( D \right) \left( d - p \right)"),
            ("e < e^-2", r"e < e^{-2}"),
            ("1e-6 D*", r"10^{-6} D^{*}"),
            ("h < h_U, approaching", r"h < h_{U} ,\; \;\text{approaching}\;"),
        ];
        for (plain, latex) in cases {
            assert_eq!(made(plain), latex, "{plain}");
        }
        let slanted = latex("1/E = (1 - nu_a^2)/E_a", &Names::default(), false).unwrap();
        assert_eq!(slanted, r"1 / E = \left( 1 - \nu_{a}^{2} \right) / E_{a}");
    }

    #[test]
    fn what_is_no_formula_is_refused_or_left() {
        let names = Names::default();
        for broken in ["(a + b", "a + b)", "a^", "/b", ""] {
            assert!(latex(broken, &names, true).is_err(), "{broken}");
        }
        for code in ["work_of_adhesion", "\"lens\"", "jkr", "a::b", "cohesion sjkr", "sqrt"] {
            assert!(!names.makes(code, &[]), "{code}");
        }
        for formula in ["k_t", "alpha", "3/2 pi w R", "d << R", "sin(theta/2)"] {
            assert!(names.makes(formula, &[]), "{formula}");
        }
        assert!(names.makes("1/(1 + range)", &["range"]) && !names.makes("range", &["range"]));
    }
}
