//! Two flat elements of which one is translated.

use radiosity_elements::Element;
use radiosity_geom::DVec3;
use radiosity_kernel::terms::displaced_distance;

use super::error::SeriesError;

/// Two flat elements of which one is translated relative to the other.
#[derive(Clone, Copy, Debug)]
pub struct TranslatedPair<'a> {
    pub(crate) receiver: &'a Element,
    pub(crate) emitter: &'a Element,
    pub(crate) direction: DVec3,
    /// Displacement of the emitter at p = 0 (scene length).
    pub(crate) offset: DVec3,
}

impl<'a> TranslatedPair<'a> {
    /// `direction` is the displacement of the emitter relative to the receiver per unit of p (scene length).
    /// Where the receiver moves it is the opposite of the receiver's; where both move, the difference.
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
            None => Ok(Self { receiver, emitter, direction, offset: DVec3::ZERO }),
        }
    }

    /// This pair with the emitter displaced by `offset` (scene length) at p = 0.
    #[must_use]
    pub(crate) fn displaced(self, offset: DVec3) -> Self {
        Self { offset, ..self }
    }

    /// Least distance of the elements at p = 0 (scene length).
    pub(crate) fn distance(&self) -> f64 {
        let pairs =
            self.receiver.patches.iter().flat_map(|p| self.emitter.patches.iter().map(move |q| (p, q)));
        pairs.map(|(p, q)| displaced_distance(p, q, self.offset)).fold(f64::INFINITY, f64::min)
    }

    /// The surfaces of receiver and emitter.
    pub(crate) fn surfaces(&self) -> [usize; 2] {
        [self.receiver.surface, self.emitter.surface]
    }
}
