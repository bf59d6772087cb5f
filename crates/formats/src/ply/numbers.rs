//! The numbers behind the header of a PLY, as words or as bits.

use radiosity_photometry::error::Refusal;
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::text::short;

use crate::scalar::Scalar;

/// Numbers one after another.
pub(super) trait Numbers {
    /// Place of the next number in the file.
    fn place(&mut self) -> FilePlace;

    /// The next number, finite or not.
    ///
    /// # Errors
    /// The end of the file, a word that is no number.
    fn number(&mut self, scalar: Scalar) -> Result<f64, Refusal>;

    /// Leaves `count` numbers out.
    ///
    /// # Errors
    /// The end of the file.
    fn skip(&mut self, scalar: Scalar, count: usize) -> Result<(), Refusal>;

    /// Greatest number of rows that may still follow, each of at least so many bytes (binary) or so many
    /// words (text).
    fn most_rows(&self, bytes: usize, words: usize) -> usize;
}

/// Refusal of a file that ends early.
fn end(place: FilePlace) -> Refusal {
    Refusal::new("the file ends early", "export it again, or correct the counts in its header").at(place)
}

/// Numbers of a text, as words.
pub(super) struct Words<'a> {
    lines: std::iter::Enumerate<std::str::Lines<'a>>,
    words: std::iter::Peekable<std::str::SplitWhitespace<'a>>,
    /// Lines before the first, and the line of the next word.
    before: usize,
    line: usize,
    /// Length of the text (bytes).
    length: usize,
}

impl<'a> Words<'a> {
    /// The words of a text behind so many lines.
    pub(super) fn of(text: &'a str, before: usize) -> Self {
        let words = "".split_whitespace().peekable();
        Words { lines: text.lines().enumerate(), words, before, line: before, length: text.len() }
    }

    fn word(&mut self) -> Result<&'a str, Refusal> {
        let place = self.place();
        self.words.next().ok_or_else(|| end(place))
    }
}

impl Numbers for Words<'_> {
    fn place(&mut self) -> FilePlace {
        while self.words.peek().is_none() {
            let Some((index, line)) = self.lines.next() else { break };
            self.line = self.before + index + 1;
            self.words = line.split_whitespace().peekable();
        }
        FilePlace::Line(self.line)
    }

    fn number(&mut self, _scalar: Scalar) -> Result<f64, Refusal> {
        let word = self.word()?;
        word.parse().map_err(|_| {
            Refusal::new(format!("'{}' is no number", short(word)), "write a number")
                .at(FilePlace::Line(self.line))
        })
    }

    fn skip(&mut self, _scalar: Scalar, count: usize) -> Result<(), Refusal> {
        for _ in 0..count {
            self.word()?;
        }
        Ok(())
    }

    fn most_rows(&self, _bytes: usize, words: usize) -> usize {
        // A word takes a blank before it.
        (self.length + 1) / (2 * words.max(1))
    }
}

/// Numbers of a binary file, as bits.
pub(super) struct Bits<'a> {
    bytes: &'a [u8],
    at: usize,
    is_big: bool,
}

impl<'a> Bits<'a> {
    /// The numbers from byte `at` on.
    pub(super) fn of(bytes: &'a [u8], at: usize, is_big: bool) -> Self {
        Bits { bytes, at, is_big }
    }

    /// The next bytes, the most significant one last.
    fn word(&mut self, size: usize) -> Result<[u8; 8], Refusal> {
        let found = self.bytes.get(self.at..).and_then(|rest| rest.get(..size));
        let Some(found) = found else { return Err(end(FilePlace::Byte(self.bytes.len()))) };
        let mut word = [0; 8];
        word[..size].copy_from_slice(found);
        if self.is_big {
            word[..size].reverse();
        }
        self.at += size;
        Ok(word)
    }
}

impl Numbers for Bits<'_> {
    fn place(&mut self) -> FilePlace {
        FilePlace::Byte(self.at)
    }

    fn number(&mut self, scalar: Scalar) -> Result<f64, Refusal> {
        let word = self.word(scalar.size())?;
        Ok(scalar.read(&word).unwrap_or(f64::NAN))
    }

    fn skip(&mut self, scalar: Scalar, count: usize) -> Result<(), Refusal> {
        let end_at = scalar.size().checked_mul(count).and_then(|size| self.at.checked_add(size));
        let is_there = |end_at: &usize| *end_at <= self.bytes.len();
        self.at = end_at.filter(is_there).ok_or_else(|| end(FilePlace::Byte(self.bytes.len())))?;
        Ok(())
    }

    fn most_rows(&self, bytes: usize, _words: usize) -> usize {
        (self.bytes.len() - self.at) / bytes.max(1)
    }
}
