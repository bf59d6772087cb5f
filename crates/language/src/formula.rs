//! Formulas in place of numbers: `width/2 - 0.1`.
//!
//! ```text
//! sum     = product { ("+" | "-") product }
//! product = factor { ("*" | "/") factor }
//! factor  = { "+" | "-" } ( number | name | name "(" sum { "," sum } ")" | "(" sum ")" )
//! ```

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use radiosity_scene::{
    Fault, FaultKind,
    place::{At, Span},
    tree::DEEPEST,
};

/// A function of one number, or of two and more, or why it has no value there.
type Function = fn(&[f64]) -> Result<f64, &'static str>;

/// Every function with the least and the largest number of its arguments.
const FUNCTIONS: [(&str, [usize; 2], Function); 7] = [
    ("sin", [1, 1], |x| Ok(sine(x[0]))),
    ("cos", [1, 1], |x| Ok(sine(x[0] + 90.0))),
    ("tan", [1, 1], |x| tangent(x[0])),
    ("sqrt", [1, 1], |x| {
        if x[0] < 0.0 { Err("takes the square root of a negative number") } else { Ok(x[0].sqrt()) }
    }),
    ("abs", [1, 1], |x| Ok(x[0].abs())),
    ("min", [1, usize::MAX], |x| Ok(x.iter().copied().fold(f64::INFINITY, f64::min))),
    ("max", [1, usize::MAX], |x| Ok(x.iter().copied().fold(f64::NEG_INFINITY, f64::max))),
];

/// The number that every formula knows.
const KNOWN: (&str, f64) = ("pi", PI);

/// Whether a formula gives the name a meaning of its own.
pub(super) fn is_reserved(name: &str) -> bool {
    name == KNOWN.0 || FUNCTIONS.iter().any(|(function, ..)| *function == name)
}

/// Whether a formula reads the text as one name.
pub(super) fn is_name(text: &str) -> bool {
    text.starts_with(is_first) && text.chars().all(is_later)
}

fn is_first(c: char) -> bool {
    c.is_alphabetic() || c == '_'
}

fn is_later(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// The value of a formula; `variable` finds the value of a name. A fault comes with its bytes in `text`.
pub(super) fn value(text: &str, variable: &dyn Fn(&str) -> Result<f64, Fault>) -> Result<f64, At<Fault>> {
    let mut reader = Reader { text, next: 0, depth: 0, variable };
    let value = reader.sum()?;
    match reader.peek() {
        None => Ok(value),
        Some(found) => Err(reader.here(format!("{found:?} stands where an operator should"))),
    }
}

/// A formula that is being read.
struct Reader<'a> {
    text: &'a str,
    /// Byte of the next character.
    next: usize,
    /// Number of open parentheses.
    depth: usize,
    variable: &'a dyn Fn(&str) -> Result<f64, Fault>,
}

impl<'a> Reader<'a> {
    fn sum(&mut self) -> Result<f64, At<Fault>> {
        let mut value = self.product()?;
        loop {
            match self.peek() {
                Some('+') => value += self.after(Self::product)?,
                Some('-' | '−') => value -= self.after(Self::product)?,
                _ => return Ok(value),
            }
        }
    }

    fn product(&mut self) -> Result<f64, At<Fault>> {
        let mut value = self.factor()?;
        loop {
            match self.peek() {
                Some('*' | '×') => value *= self.after(Self::factor)?,
                Some('/') => {
                    let start = self.next;
                    let divisor = self.after(Self::factor)?;
                    if divisor == 0.0 {
                        return Err(self.from(start, no_value("divides by zero")));
                    }
                    value /= divisor;
                }
                _ => return Ok(value),
            }
        }
    }

    fn factor(&mut self) -> Result<f64, At<Fault>> {
        let mut sign = 1.0;
        while let Some(c @ ('+' | '-' | '−')) = self.peek() {
            sign *= if c == '+' { 1.0 } else { -1.0 };
            self.skip();
        }
        let value = match self.peek() {
            Some('(') => self.after(Self::enclosed)?,
            Some(c) if is_first(c) => self.named()?,
            Some(c) if c.is_ascii_digit() || c == '.' => self.number()?,
            Some(c) => return Err(self.here(format!("{c:?} stands where a number should"))),
            None => return Err(self.here("a number is missing at the end".to_owned())),
        };
        Ok(sign * value)
    }

    /// Value of the sum behind an opening parenthesis; takes the closing one, too.
    fn enclosed(&mut self) -> Result<f64, At<Fault>> {
        let value = self.deeper()?;
        self.close()?;
        Ok(value)
    }

    fn deeper(&mut self) -> Result<f64, At<Fault>> {
        if self.depth == DEEPEST {
            return Err(self.here(format!("parentheses stand more than {DEEPEST} deep")));
        }
        self.depth += 1;
        let value = self.sum()?;
        self.depth -= 1;
        Ok(value)
    }

    fn close(&mut self) -> Result<(), At<Fault>> {
        match self.peek() {
            Some(')') => {
                self.skip();
                Ok(())
            }
            Some(found) => Err(self.here(format!("{found:?} stands where a parenthesis should close"))),
            None => Err(self.here("a closing parenthesis is missing".to_owned())),
        }
    }

    /// A variable, or a function with its arguments.
    fn named(&mut self) -> Result<f64, At<Fault>> {
        let start = self.next;
        let name = self.taken(is_later);
        if self.peek() == Some('(') {
            return self.function(name, start);
        }
        let span = start..start + name.len();
        if name == KNOWN.0 {
            return Ok(KNOWN.1);
        }
        if is_reserved(name) {
            return Err(At::new(
                syntax(format!("{name} is a function and takes a number in parentheses")),
                &span,
            ));
        }
        (self.variable)(name).map_err(|fault| At::new(fault, &span))
    }

    fn function(&mut self, name: &str, start: usize) -> Result<f64, At<Fault>> {
        let Some((_, [least, most], function)) = FUNCTIONS.iter().find(|(known, ..)| *known == name) else {
            let known: Vec<String> = FUNCTIONS.iter().map(|(name, ..)| (*name).to_owned()).collect();
            let fault = Fault::unknown(format!("there is no function {name:?}"), name, known, "functions");
            return Err(At::new(fault, &(start..start + name.len())));
        };
        self.skip();
        let mut arguments = vec![self.deeper()?];
        while self.peek() == Some(',') {
            arguments.push(self.after(Self::deeper)?);
        }
        self.close()?;
        if !(*least..=*most).contains(&arguments.len()) {
            let problem = format!("{name} takes one number, found {}", arguments.len());
            return Err(self.from(start, syntax(problem)));
        }
        function(&arguments).map_err(|problem| self.from(start, no_value(problem)))
    }

    fn number(&mut self) -> Result<f64, At<Fault>> {
        let start = self.next;
        self.taken(|c| c.is_ascii_digit() || c == '.');
        let mantissa = self.next;
        if self.text[self.next..].starts_with(['e', 'E']) {
            self.next += 1;
            if self.text[self.next..].starts_with(['+', '-']) {
                self.next += 1;
            }
            // What follows is no exponent but a name: an operator is missing before it.
            if self.taken(|c| c.is_ascii_digit()).is_empty() {
                self.next = mantissa;
            }
        }
        let digits = &self.text[start..self.next];
        digits.parse().map_err(|_| self.from(start, syntax(format!("{digits:?} is not a number"))))
    }

    /// The next character that is no blank.
    fn peek(&mut self) -> Option<char> {
        let rest = &self.text[self.next..];
        self.next += rest.len() - rest.trim_start().len();
        self.text[self.next..].chars().next()
    }

    /// Goes past the next character.
    fn skip(&mut self) {
        self.next += self.text[self.next..].chars().next().map_or(0, char::len_utf8);
    }

    /// Reads what follows the next character.
    fn after(&mut self, read: fn(&mut Self) -> Result<f64, At<Fault>>) -> Result<f64, At<Fault>> {
        self.skip();
        read(self)
    }

    /// Goes past all that is of a kind.
    fn taken(&mut self, is_of_kind: fn(char) -> bool) -> &'a str {
        let rest = &self.text[self.next..];
        let end = rest.find(|c| !is_of_kind(c)).unwrap_or(rest.len());
        self.next += end;
        &rest[..end]
    }

    /// A fault of what was read from byte `start` on.
    fn from(&self, start: usize, fault: Fault) -> At<Fault> {
        At::new(fault, &(start..self.next))
    }

    /// A fault of the next character.
    fn here(&self, problem: String) -> At<Fault> {
        let span: Span =
            self.next..self.next + self.text[self.next..].chars().next().map_or(1, char::len_utf8);
        At::new(syntax(problem), &span)
    }
}

fn syntax(problem: String) -> Fault {
    let cure = "write it such as \"=2 * (width - 0.1)\": numbers, variables, + - * /, parentheses, pi, and sin, cos, tan \
                (of degrees), sqrt, abs, min, max";
    Fault::new(FaultKind::Syntax, format!("the formula cannot be read: {problem}"), cure)
}

fn no_value(problem: &str) -> Fault {
    let cause = format!("the formula {problem}");
    Fault::new(FaultKind::NoValue, cause, "change the formula, or the variables in it")
}

/// The sine of an angle in degrees, exact where it is 0, ½ or 1.
fn sine(degrees: f64) -> f64 {
    let turn = degrees.rem_euclid(360.0);
    let (half, sign) = if turn < 180.0 { (turn, 1.0) } else { (turn - 180.0, -1.0) };
    let quarter = half.min(180.0 - half);
    let value = if quarter == 30.0 {
        0.5
    } else if quarter == 45.0 {
        FRAC_1_SQRT_2
    } else if quarter > 45.0 {
        (90.0 - quarter).to_radians().cos()
    } else {
        quarter.to_radians().sin()
    };
    sign * value
}

fn tangent(degrees: f64) -> Result<f64, &'static str> {
    match sine(degrees + 90.0) {
        0.0 => Err("takes the tangent of a right angle"),
        cosine => Ok(sine(degrees) / cosine),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<f64, At<Fault>> {
        value(text, &|name| match name {
            "width" => Ok(3.0),
            "höhe_2" => Ok(2.5),
            _ => Err(Fault::unknown(
                format!("there is no variable {name:?}"),
                name,
                ["width".to_owned()],
                "variables of this scene",
            )),
        })
    }

    #[test]
    fn formulas_have_the_values_of_arithmetic() {
        for (text, expected) in [
            ("1", 1.0),
            (" .5e1 ", 5.0),
            ("2E-1", 0.2),
            ("width/2 - 0.1", 1.4),
            ("2 + 3 * 4 - 6 / 3 / 2", 13.0),
            ("(2 + 3) * 4", 20.0),
            ("10 - 4 - 3", 3.0),
            ("-width", -3.0),
            ("--+-2", -2.0),
            ("2 * -3", -6.0),
            ("2 − 3 × 4", -10.0),
            ("höhe_2*2", 5.0),
            ("sin(30) + cos(60) + tan(45)", 2.0),
            ("sin(-90) + cos(180)+sin(180)+cos(270)", -2.0),
            ("sqrt(width*width + 16)", 5.0),
            ("abs(-2) + min(3, 1, 2) + max(1,-5)", 4.0),
            ("max(min(1, 2), sqrt(9))", 3.0),
            ("pi", PI),
        ] {
            assert_eq!(read(text), Ok(expected), "{text}");
        }
    }

    #[test]
    fn sines_are_those_of_radians() {
        for degrees in (-800..800).map(|k| f64::from(k) * 0.9) {
            assert!((sine(degrees) - degrees.to_radians().sin()).abs() < 1e-14, "{degrees}");
        }
    }

    #[test]
    fn faults_are_placed_in_the_formula() {
        for (text, piece, message) in [
            ("", None, "a number is missing at the end"),
            ("2 +", None, "a number is missing at the end"),
            ("2 * (1 + 3", None, "a closing parenthesis is missing"),
            ("min(1, 2", None, "a closing parenthesis is missing"),
            ("2 ) 3", Some(")"), "')' stands where an operator should"),
            ("2 width", Some("w"), "'w' stands where an operator should"),
            ("2e width", Some("e"), "'e' stands where an operator should"),
            ("2 * /3", Some("/"), "'/' stands where a number should"),
            ("2 ^ 3", Some("^"), "'^' stands where an operator should"),
            ("1.2.3", Some("1.2.3"), "\"1.2.3\" is not a number"),
            ("(1, 2)", Some(","), "',' stands where a parenthesis should close"),
            ("1 + wdith", Some("wdith"), "there is no variable \"wdith\""),
            ("sin + 1", Some("sin"), "sin is a function"),
            ("ln(2)", Some("ln"), "there is no function \"ln\""),
            ("sin(1, 2)", Some("sin(1, 2)"), "sin takes one number, found 2"),
            ("1 / (width - 3)", Some("/ (width - 3)"), "divides by zero"),
            ("2*sqrt(-1)", Some("sqrt(-1)"), "takes the square root of a negative number"),
            ("tan(270)", Some("tan(270)"), "takes the tangent of a right angle"),
        ] {
            let At { value: fault, span } = read(text).expect_err(text);
            assert!(fault.to_string().contains(message), "{text}: {fault}");
            match piece {
                Some(piece) => assert_eq!(&text[span], piece, "{text}"),
                None => assert_eq!(span.start, text.len(), "{text}"),
            }
        }
    }

    #[test]
    fn deep_parentheses_are_refused_and_long_formulas_read() {
        let deep = |depth: usize| read(&format!("{}1{}", "(".repeat(depth), ")".repeat(depth)));
        assert_eq!(deep(DEEPEST), Ok(1.0));
        assert!(deep(DEEPEST + 1).is_err() && deep(100_000).is_err());
        assert!(read(&"abs(".repeat(100_000)).is_err());
        assert_eq!(read(&("1".to_owned() + &"+1".repeat(100_000))), Ok(100_001.0));
        assert_eq!(read(&("-".repeat(100_000) + "1")), Ok(1.0));
    }
}
