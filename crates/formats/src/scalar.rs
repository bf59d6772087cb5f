//! Numbers of binary files: integers and floating-point numbers of so many bytes.

/// A type of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    /// Size of a number (bytes).
    pub(crate) fn size(self) -> usize {
        match self {
            Scalar::I8 | Scalar::U8 => 1,
            Scalar::I16 | Scalar::U16 => 2,
            Scalar::I32 | Scalar::U32 | Scalar::F32 => 4,
            Scalar::F64 => 8,
        }
    }

    /// The number that the bytes begin with, the least significant byte first; none if they are too few.
    pub(crate) fn read(self, bytes: &[u8]) -> Option<f64> {
        Some(match self {
            Scalar::I8 => f64::from(i8::from_le_bytes(*bytes.first_chunk()?)),
            Scalar::U8 => f64::from(*bytes.first()?),
            Scalar::I16 => f64::from(i16::from_le_bytes(*bytes.first_chunk()?)),
            Scalar::U16 => f64::from(u16::from_le_bytes(*bytes.first_chunk()?)),
            Scalar::I32 => f64::from(i32::from_le_bytes(*bytes.first_chunk()?)),
            Scalar::U32 => f64::from(u32::from_le_bytes(*bytes.first_chunk()?)),
            Scalar::F32 => f64::from(f32::from_le_bytes(*bytes.first_chunk()?)),
            Scalar::F64 => f64::from_le_bytes(*bytes.first_chunk()?),
        })
    }
}
