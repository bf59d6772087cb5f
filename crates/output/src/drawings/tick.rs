//! Ticks: numbers on a scale with their texts.

/// A number with its text, as a tick of a scale or as the value of an isoline.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// The number.
    pub value: f64,
    /// Its text.
    pub text: String,
}
