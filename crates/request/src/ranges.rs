//! Numbers that options take: each type holds those of its range, whichever front end reads it.

use std::fmt::{self, Display, Formatter};
use std::marker::PhantomData;
use std::str::FromStr;

use bytesize::ByteSize;
use radiosity_scene::ranges::{MAX_ORDER, MAX_PARTS, MAX_PIXELS, check_fov};
use radiosity_solve::MOST_RAYS;
use serde::de::{self, Visitor};
use serde::{Deserialize, Deserializer};

/// Number of graded layers.
pub type Layers = WholeNumber<0, 8>;

/// Degree of polynomials.
pub type Degree = WholeNumber<0, { MAX_ORDER as u64 }>;

/// Number of reflections that are counted. Chosen: all but 5e-5 of the light of a closed room of reflectance
/// 0.99.
pub type Bounces = WholeNumber<0, 1000>;

/// Number of rays of the sampled transport.
pub type Rays = WholeNumber<1, MOST_RAYS>;

/// Number of shots of a solver that shoots.
pub type ShotCount = WholeNumber<0, { u32::MAX as u64 }>;

/// Number of vectors that gmres keeps.
pub type Restart = WholeNumber<1, 10_000>;

/// Number of rays that find the visibility of a link. Chosen: with the most, shares are known to 1e-3.
pub type LinkRays = WholeNumber<1, 1_000_000>;

/// Number of iterations of a solver.
pub type Iterations = WholeNumber<1, { u32::MAX as u64 }>;

/// Number of cells along a side of a mask.
pub type MaskCells = WholeNumber<1, 1000>;

/// Number of pixels along a side of a picture, and of cells along a side of a surface, as in scenes.
pub type Pixels = WholeNumber<1, { MAX_PIXELS as u64 }>;

/// Number of cells along each parameter of a curved surface that becomes flat pieces: of fewer than three around
/// it nothing would be left of a closed one. Chosen: a million pieces of a surface are as many as a scene takes.
pub type Pieces = WholeNumber<3, 1000>;

/// Number of camera rays along a side of a pixel, or of points along a side of a cell.
pub type Samples = WholeNumber<1, 64>;

/// Number of readings that a referee judges: an error has no spread over fewer than two. Chosen: with the most,
/// their walks take a minute at the least.
pub type Readings = WholeNumber<2, 100_000>;

/// Number of values of a sweep. Chosen: the figures of a thousand balances of a thousand surfaces take some hundred
/// megabytes.
pub type Points = WholeNumber<2, 1000>;

/// Seed of draws.
pub type Seed = WholeNumber<0, { u64::MAX }>;

/// Whole number from `LEAST` to `MOST`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WholeNumber<const LEAST: u64, const MOST: u64>(u64);

impl<const LEAST: u64, const MOST: u64> WholeNumber<LEAST, MOST> {
    /// Message for a number out of the range.
    pub fn expected() -> String {
        format!("expected a whole number from {LEAST} to {MOST}")
    }

    /// The number as a count; on machines of fewer bits no range is so wide.
    pub fn count(self) -> usize {
        self.0 as usize
    }
}

impl<const LEAST: u64, const MOST: u64> TryFrom<i128> for WholeNumber<LEAST, MOST> {
    type Error = String;

    fn try_from(number: i128) -> Result<Self, String> {
        let number = u64::try_from(number).ok().filter(|number| (LEAST..=MOST).contains(number));
        number.map(Self).ok_or_else(Self::expected)
    }
}

impl<const LEAST: u64, const MOST: u64> FromStr for WholeNumber<LEAST, MOST> {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        text.parse::<i128>().map_err(|_| Self::expected())?.try_into()
    }
}

impl<const LEAST: u64, const MOST: u64> From<WholeNumber<LEAST, MOST>> for u64 {
    fn from(number: WholeNumber<LEAST, MOST>) -> Self {
        number.0
    }
}

impl<'de, const LEAST: u64, const MOST: u64> Deserialize<'de> for WholeNumber<LEAST, MOST> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        i128::deserialize(from)?.try_into().map_err(de::Error::custom)
    }
}

/// Number of threads, 1024 at the most: more would bring any machine to a standstill. Chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Threads(WholeNumber<1, 1024>);

impl Threads {
    /// The number as a count.
    pub fn count(self) -> usize {
        self.0.count()
    }
}

impl TryFrom<i128> for Threads {
    type Error = String;

    fn try_from(number: i128) -> Result<Self, String> {
        let threads = number.try_into().map(Self);
        threads.map_err(|expected: String| expected + "; leave it out for one a core")
    }
}

impl FromStr for Threads {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        // Words are as wrong as 0 is.
        text.parse::<i128>().unwrap_or(0).try_into()
    }
}

impl<'de> Deserialize<'de> for Threads {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        i128::deserialize(from)?.try_into().map_err(de::Error::custom)
    }
}

/// Range of real numbers.
pub trait Range {
    /// Message for a number out of the range.
    const EXPECTED: &'static str;

    /// Whether the range has the number `x`, which is finite.
    fn has(x: f64) -> bool;
}

/// Finite number in the range `R`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Number<R>(f64, PhantomData<R>);

impl<R: Range> TryFrom<f64> for Number<R> {
    type Error = &'static str;

    fn try_from(x: f64) -> Result<Self, &'static str> {
        if x.is_finite() && R::has(x) { Ok(Self(x, PhantomData)) } else { Err(R::EXPECTED) }
    }
}

impl<R: Range> FromStr for Number<R> {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, &'static str> {
        text.parse().unwrap_or(f64::NAN).try_into()
    }
}

impl<R> From<Number<R>> for f64 {
    fn from(number: Number<R>) -> Self {
        number.0
    }
}

impl<'de, R: Range> Deserialize<'de> for Number<R> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        f64::deserialize(from)?.try_into().map_err(de::Error::custom)
    }
}

/// Finite numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Finite {}

impl Range for Finite {
    const EXPECTED: &'static str = "expected a finite number";

    fn has(_: f64) -> bool {
        true
    }
}

/// Numbers above 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Positive {}

impl Range for Positive {
    const EXPECTED: &'static str = "expected a number above 0, such as 1e-8";

    fn has(x: f64) -> bool {
        x > 0.0
    }
}

/// Times (s) above 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Seconds {}

impl Range for Seconds {
    const EXPECTED: &'static str = "expected seconds, above 0, such as 30";

    fn has(x: f64) -> bool {
        x > 0.0
    }
}

/// Lengths that are not negative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Length {}

impl Range for Length {
    const EXPECTED: &'static str = "expected a length of 0 or more, such as 1e-6";

    fn has(x: f64) -> bool {
        x >= 0.0
    }
}

/// Numbers between 0 and 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fraction {}

impl Range for Fraction {
    const EXPECTED: &'static str = "expected a number above 0 and below 1, such as 1e-3";

    fn has(x: f64) -> bool {
        x > 0.0 && x < 1.0
    }
}

/// Factors of corrections, between 0 and 2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Relaxation {}

impl Range for Relaxation {
    const EXPECTED: &'static str = "expected a number above 0 and below 2, such as 1.2";

    fn has(x: f64) -> bool {
        x > 0.0 && x < 2.0
    }
}

/// Angles of view (degrees).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AngleOfView {}

impl Range for AngleOfView {
    const EXPECTED: &'static str = "expected degrees above 0 and below 180, such as 60";

    fn has(x: f64) -> bool {
        check_fov(x).is_ok()
    }
}

/// Relative accuracies: below 1e-14 rounding decides, and work would never end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Accuracy {}

impl Range for Accuracy {
    const EXPECTED: &'static str = "expected a number from 1e-14, near rounding, to below 1, such as 1e-3";

    fn has(x: f64) -> bool {
        (1e-14..1.0).contains(&x)
    }
}

/// Number of bytes such as `500M`, `2G` or `1.5GiB`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bytes(pub u64);

impl FromStr for Bytes {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, &'static str> {
        let bytes = text.parse::<ByteSize>().map(|size| size.as_u64()).ok().filter(|size| *size > 0);
        bytes.map(Self).ok_or("expected a number of bytes, such as 500M, 2G or 2GiB")
    }
}

/// Degree of the polynomials on elements, as `--order` states it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// The degree that the wanted accuracy needs.
    Auto,
    /// This degree; with `--accuracy`, the least degree.
    Degree(usize),
}

impl FromStr for Order {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let degree = count_or_auto::<0, { MAX_ORDER as u64 }>(text)?;
        Ok(degree.map_or(Self::Auto, Self::Degree))
    }
}

/// Elements along u and along v of each surface; None, written `auto`, is as the scene needs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Subdivide(pub Option<usize>);

impl FromStr for Subdivide {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        count_or_auto::<1, { MAX_PARTS as u64 }>(text).map(Self)
    }
}

/// A count in a range, or none where the text is `auto`.
fn count_or_auto<const LEAST: u64, const MOST: u64>(text: &str) -> Result<Option<usize>, String> {
    if text == "auto" {
        return Ok(None);
    }
    let number = text.parse::<WholeNumber<LEAST, MOST>>();
    number.map(|number| Some(number.count())).map_err(|expected| expected + ", or auto")
}

/// A value that its text says, or the written form of a number; front ends leave out options without a value.
pub(super) fn by_text<'de, D: Deserializer<'de>, T: FromStr<Err: Display>>(
    from: D,
) -> Result<Option<T>, D::Error> {
    parsed(from, str::parse)
}

/// A value that `parse` reads in a text, or in the written form of a number.
pub(super) fn parsed<'de, D: Deserializer<'de>, T, E: Display>(
    from: D,
    parse: impl FnOnce(&str) -> Result<T, E>,
) -> Result<Option<T>, D::Error> {
    parse(&from.deserialize_any(Text)?).map(Some).map_err(de::Error::custom)
}

/// Any text.
struct Text;

impl Visitor<'_> for Text {
    type Value = String;

    fn expecting(&self, to: &mut Formatter<'_>) -> fmt::Result {
        to.write_str("a text")
    }

    fn visit_str<E>(self, text: &str) -> Result<String, E> {
        Ok(text.to_owned())
    }
}
