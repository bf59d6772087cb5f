//! Two flat elements of which one is translated.

use radiosity_geom::DVec3;

use super::error::SeriesError;
use crate::elements::Element;

/// Two flat elements of which one is translated relative to the other.
#[derive(Clone, Copy, Debug)]
pub struct TranslatedPair<'a> {
    pub(crate) receiver: &'a Element,
    pub(crate) emitter: &'a Element,
    pub(crate) direction: DVec3,
}

impl<'a> TranslatedPair<'a> {
    /// `direction` is the displacement of the emitter relative to the receiver per unit of p (scene length). Where the
    /// receiver moves it is the opposite of the receiver's; where both move, the difference.
    ///
    /// # Errors
    /// A direction without length, or a curved element.
    pub fn new(receiver: &'a Element, emitter: &'a Element, direction: DVec3) -> Result<Self, SeriesError> {
        let length = direction.length();
        if !length.is_finite() || length == 0.0 {
            return Err(SeriesError::Direction);
        }
        match [receiver, emitter].iter().find(|element| element.plane.is_none()) {
            Some(curved) => Err(SeriesError::Curved { surface: curved.surface }),
            None => Ok(Self { receiver, emitter, direction }),
        }
    }

    /// The surfaces of receiver and emitter.
    pub(crate) fn surfaces(&self) -> [usize; 2] {
        [self.receiver.surface, self.emitter.surface]
    }
}
