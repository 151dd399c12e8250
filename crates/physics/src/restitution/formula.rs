//! A formula in one variable, read from text: numbers, `v`, `+ - * / ^`, parentheses and a few functions.
//!
//! Recursive descent into postfix code. Text length, nesting and the number of operations are bounded, so that any input is
//! read in bounded time and memory. Evaluation uses `libm` only: the same bits on every machine.

use super::profile::ProfileError;

/// Longest text [bytes].
const LONGEST: usize = 1000;
/// Bytes of a long text that an error shows.
const SHOWN: usize = 80;
/// Deepest nesting of parentheses, functions, signs and powers.
const DEEPEST: usize = 50;

#[derive(Clone, Copy, Debug, PartialEq)]
enum Operation {
    Number(f64),
    Variable,
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Negate,
    Exp,
    Ln,
    Sqrt,
    Abs,
    Min,
    Max,
}

const FUNCTIONS: [(&str, Operation); 6] = [
    ("exp", Operation::Exp),
    ("ln", Operation::Ln),
    ("sqrt", Operation::Sqrt),
    ("abs", Operation::Abs),
    ("min", Operation::Min),
    ("max", Operation::Max),
];

/// A formula in `v`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Formula {
    text: String,
    postfix: Vec<Operation>,
}

impl Formula {
    pub(super) fn parse(text: &str) -> Result<Self, ProfileError> {
        let mut parser = Parser {
            text: text.as_bytes(),
            at: 0,
            postfix: Vec::new(),
        };
        if text.len() > LONGEST {
            return Err(parser.wrong(format!(
                "the formula is {} characters long, at most {LONGEST} are read",
                text.len()
            )));
        }
        parser.sum(0)?;
        if parser.peek().is_some() {
            return Err(parser.unexpected("an operator or the end"));
        }
        Ok(Self {
            text: text.to_string(),
            postfix: parser.postfix,
        })
    }

    pub(super) fn text(&self) -> &str {
        &self.text
    }

    /// The value at `v`; not finite where the formula has none.
    pub(super) fn at(&self, v: f64) -> f64 {
        // an operand waits at every level of nesting and at most twice per level (a + b * c)
        let mut stack = [0.0; 4 * (DEEPEST + 2)];
        let mut top = 0;
        for operation in &self.postfix {
            let (taken, value) = match *operation {
                Operation::Number(number) => (0, number),
                Operation::Variable => (0, v),
                unary @ (Operation::Negate | Operation::Exp | Operation::Ln | Operation::Sqrt | Operation::Abs) => {
                    (1, unary.of_one(stack[top - 1]))
                }
                binary => (2, binary.of_two(stack[top - 2], stack[top - 1])),
            };
            top -= taken;
            stack[top] = value;
            top += 1;
        }
        stack[0]
    }
}

impl Operation {
    fn of_one(self, a: f64) -> f64 {
        match self {
            Operation::Negate => -a,
            Operation::Exp => libm::exp(a),
            Operation::Ln => libm::log(a),
            Operation::Sqrt => a.sqrt(),
            _ => a.abs(),
        }
    }

    fn of_two(self, a: f64, b: f64) -> f64 {
        match self {
            Operation::Add => a + b,
            Operation::Subtract => a - b,
            Operation::Multiply => a * b,
            Operation::Divide => a / b,
            Operation::Power => libm::pow(a, b),
            // not f64::min and max, which would drop a NaN
            Operation::Min if a.is_nan() || a < b => a,
            Operation::Max if a.is_nan() || a > b => a,
            _ => b,
        }
    }
}

struct Parser<'a> {
    text: &'a [u8],
    at: usize,
    postfix: Vec<Operation>,
}

impl Parser<'_> {
    /// `product (("+" | "-") product)*`
    fn sum(&mut self, depth: usize) -> Result<(), ProfileError> {
        self.product(depth)?;
        loop {
            let operation = match self.peek() {
                Some(b'+') => Operation::Add,
                Some(b'-') => Operation::Subtract,
                _ => return Ok(()),
            };
            self.at += 1;
            self.product(depth)?;
            self.postfix.push(operation);
        }
    }

    /// `signed (("*" | "/") signed)*`
    fn product(&mut self, depth: usize) -> Result<(), ProfileError> {
        self.signed(depth)?;
        loop {
            let operation = match self.peek() {
                Some(b'*') => Operation::Multiply,
                Some(b'/') => Operation::Divide,
                _ => return Ok(()),
            };
            self.at += 1;
            self.signed(depth)?;
            self.postfix.push(operation);
        }
    }

    /// `("+" | "-") signed | atom ("^" signed)?`: `-v^2` is `-(v^2)`, `v^-2` and `2^3^2 = 2^9` are read as usual.
    fn signed(&mut self, depth: usize) -> Result<(), ProfileError> {
        if depth >= DEEPEST {
            return Err(self.wrong(format!("nested deeper than {DEEPEST} levels")));
        }
        if let Some(sign @ (b'+' | b'-')) = self.peek() {
            self.at += 1;
            self.signed(depth + 1)?;
            if sign == b'-' {
                self.postfix.push(Operation::Negate);
            }
            return Ok(());
        }
        self.atom(depth)?;
        if self.peek() == Some(b'^') {
            self.at += 1;
            self.signed(depth + 1)?;
            self.postfix.push(Operation::Power);
        }
        Ok(())
    }

    /// `number | "v" | function "(" sum ("," sum)* ")" | "(" sum ")"`
    fn atom(&mut self, depth: usize) -> Result<(), ProfileError> {
        match self.peek() {
            Some(b'(') => {
                self.at += 1;
                self.sum(depth + 1)?;
                self.expect(b')', "`)`")
            }
            Some(b'0'..=b'9' | b'.') => self.number(),
            Some(c) if c.is_ascii_alphabetic() || c == b'_' => self.name(depth),
            _ => Err(self.unexpected("a number, `v`, a function or `(`")),
        }
    }

    fn number(&mut self) -> Result<(), ProfileError> {
        let start = self.at;
        while let Some(&c) = self.text.get(self.at) {
            let exponent_sign =
                matches!(c, b'+' | b'-') && matches!(self.text[self.at - 1], b'e' | b'E') && self.at > start;
            if !(c.is_ascii_digit() || matches!(c, b'.' | b'e' | b'E') || exponent_sign) {
                break;
            }
            self.at += 1;
        }
        let number = std::str::from_utf8(&self.text[start..self.at])
            .ok()
            .and_then(|text| text.parse().ok());
        match number {
            Some(number) if f64::is_finite(number) => {
                self.postfix.push(Operation::Number(number));
                Ok(())
            }
            _ => {
                let written = String::from_utf8_lossy(&self.text[start..self.at]).into_owned();
                self.at = start;
                Err(self.wrong(format!("`{written}` is not a finite number")))
            }
        }
    }

    fn name(&mut self, depth: usize) -> Result<(), ProfileError> {
        let start = self.at;
        while self
            .text
            .get(self.at)
            .is_some_and(|c| c.is_ascii_alphanumeric() || *c == b'_')
        {
            self.at += 1;
        }
        let name = String::from_utf8_lossy(&self.text[start..self.at]).into_owned();
        if name == "v" {
            self.postfix.push(Operation::Variable);
            return Ok(());
        }
        let Some((_, function)) = FUNCTIONS.into_iter().find(|(known, _)| *known == name) else {
            self.at = start;
            return Err(self.wrong(format!(
                "`{name}` is not known; there are the impact speed `v` [m/s], exp, ln, sqrt, abs, min and max"
            )));
        };
        self.expect(b'(', "`(` after the function")?;
        self.sum(depth + 1)?;
        if matches!(function, Operation::Min | Operation::Max) {
            self.expect(b',', "`,`: min and max compare two or more values")?;
            self.sum(depth + 1)?;
            self.postfix.push(function);
            while self.peek() == Some(b',') {
                self.at += 1;
                self.sum(depth + 1)?;
                self.postfix.push(function);
            }
        } else {
            self.postfix.push(function);
        }
        self.expect(b')', "`)`")
    }

    /// The next byte that is not white space.
    fn peek(&mut self) -> Option<u8> {
        while self.text.get(self.at).is_some_and(u8::is_ascii_whitespace) {
            self.at += 1;
        }
        self.text.get(self.at).copied()
    }

    fn expect(&mut self, wanted: u8, words: &str) -> Result<(), ProfileError> {
        if self.peek() == Some(wanted) {
            self.at += 1;
            Ok(())
        } else {
            Err(self.unexpected(words))
        }
    }

    fn unexpected(&self, wanted: &str) -> ProfileError {
        let rest = String::from_utf8_lossy(&self.text[self.at..]);
        let found = rest.chars().next().map_or("the end".to_string(), |c| format!("`{c}`"));
        self.wrong(format!("expected {wanted}, found {found}"))
    }

    /// The text, or what stands before the fault where it is long.
    fn excerpt(&self) -> String {
        let shown = |from: usize, to: usize| String::from_utf8_lossy(&self.text[from..to]).into_owned();
        let length = self.text.len();
        if length <= SHOWN {
            return shown(0, length);
        }
        let to = (self.at + SHOWN / 4).clamp(SHOWN, length);
        format!(
            "{}{}{}",
            if to > SHOWN { "..." } else { "" },
            shown(to - SHOWN, to),
            if to < length { "..." } else { "" }
        )
    }

    fn wrong(&self, what: String) -> ProfileError {
        ProfileError::Formula {
            text: self.excerpt(),
            column: self.at + 1,
            what,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn value(text: &str, v: f64) -> f64 {
        Formula::parse(text).unwrap().at(v)
    }

    #[test]
    fn precedence_signs_powers_and_functions() {
        for (text, expected) in [
            ("1 + 2*3 - 4/8", 6.5),
            ("2 - 3 - 4", -5.0),
            ("16/4/2", 2.0),
            ("2^3^2", 512.0),
            ("-v^2", -9.0),
            ("(-v)^2", 9.0),
            ("v^-2", 1.0 / 9.0),
            ("2*-v", -6.0),
            ("--+v", 3.0),
            ("1e-1 + 1.5E+1 + .25 + 2.", 17.35),
            ("min(v, 5, 2) + max(1, v)", 5.0),
            ("sqrt(abs(-16)) + exp(0) + ln(1)", 5.0),
            (" ( ( v ) ) ", 3.0),
            ("2e0v", f64::NAN),
        ] {
            match Formula::parse(text) {
                Ok(formula) => assert_eq!(formula.at(3.0), expected, "{text}"),
                Err(_) => assert!(expected.is_nan(), "{text}"),
            }
        }
        assert_eq!(value("exp(-0.3*v)", 2.0), libm::exp(-0.3 * 2.0));
        assert!(value("min(ln(-1), 1)", 1.0).is_nan() && value("max(1, sqrt(-1))", 1.0).is_nan());
    }

    #[test]
    fn mistakes_are_told_with_their_column() {
        for (text, column, words) in [
            ("", 1, "expected a number"),
            ("1 +", 4, "found the end"),
            ("(1 + v", 7, "`)`"),
            ("1 + w", 5, "`w` is not known"),
            ("sin(v)", 1, "`sin` is not known"),
            ("v v", 3, "an operator"),
            ("2v", 2, "an operator"),
            ("1.2.3", 1, "not a finite number"),
            ("1e999", 1, "not a finite number"),
            ("min(v)", 6, "two or more"),
            ("exp v", 5, "`(`"),
            ("1 + \u{e9}", 5, "found `\u{e9}`"),
            ("1 $ 2", 3, "found `$`"),
        ] {
            match Formula::parse(text) {
                Err(ProfileError::Formula { column: at, what, .. }) => {
                    assert_eq!(at, column, "{text}: {what}");
                    assert!(what.contains(words), "{text}: {what}");
                }
                other => panic!("{text}: {other:?}"),
            }
        }
    }

    proptest! {
        #[test]
        fn any_text_is_read_or_refused(text in "[-+*/^(),v0-9.e a-z\u{e9}]{0,80}", v in 1e-6f64..1e3) {
            if let Ok(formula) = Formula::parse(&text) {
                let value = formula.at(v);
                prop_assert_eq!(value.to_bits(), formula.clone().at(v).to_bits());
            }
        }

        #[test]
        fn a_random_formula_has_the_value_of_its_parts(a in -9f64..9.0, b in 0.1f64..9.0, v in 0.1f64..9.0) {
            let text = format!("({a} - v) * {b} ^ v / max({b}, v, -{b}) + sqrt(v)");
            let expected = (a - v) * libm::pow(b, v) / b.max(v) + f64::sqrt(v);
            prop_assert_eq!(value(&text, v), expected);
        }
    }

    #[test]
    fn bounded_in_length_and_depth() {
        let late = format!("{}x + 1", "1 + ".repeat(100));
        let told = Formula::parse(&late).unwrap_err().to_string();
        assert!(
            told.contains("...") && told.contains("+ x + 1`, column 401") && told.len() < 250,
            "{told}"
        );
        let long = format!("1{}", "+1".repeat(500));
        assert!(Formula::parse(&long).unwrap_err().to_string().contains("at most 1000"));
        assert_eq!(value(&long[..999], 0.0), 500.0);
        for (open, close) in [
            ("(", ")"),
            ("-", ""),
            ("2^", ""),
            ("exp(", ")"),
            ("max(1,1+2*", ")"),
            ("1+2/max(3-v,", ")"),
        ] {
            let nest = |depth: usize| format!("{}v{}", open.repeat(depth), close.repeat(depth));
            let deep = Formula::parse(&nest(60)).unwrap_err().to_string();
            assert!(deep.contains("deeper"), "{deep}");
            // the deepest that is read can be evaluated
            let formula = Formula::parse(&nest(DEEPEST - 1)).unwrap();
            assert!(!formula.at(0.5).is_nan());
        }
    }
}
