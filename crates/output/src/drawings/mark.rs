//! Marks: numbers on a scale with their texts.

/// A number that is told, as a tick of a scale or as the value of an isoline.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// The number.
    pub value: f64,
    /// Its text.
    pub text: String,
}
