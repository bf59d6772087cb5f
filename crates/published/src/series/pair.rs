//! A pair of elements of which one moves.

use radiosity_elements::Element;
use radiosity_elements::patch::Patch;
use radiosity_geom::{DVec3, Motion};
use radiosity_kernel::terms::moved_distance;

use super::error::SeriesError;
use super::motion::RelativeMotion;

/// Two flat elements of which one moves relative to the other.
#[derive(Clone, Copy, Debug)]
pub struct MovedPair<'a> {
    pub(crate) receiver: &'a Element,
    pub(crate) emitter: &'a Element,
    pub(crate) motion: RelativeMotion,
    /// Where the emitter is at p = 0.
    pub(crate) start: Motion,
}

impl<'a> MovedPair<'a> {
    /// `motion` is that of the emitter relative to the receiver. Where the receiver moves it is the opposite
    /// of the receiver's.
    ///
    /// # Errors
    /// A direction or an axis without length, or a curved element.
    pub fn new(
        receiver: &'a Element,
        emitter: &'a Element,
        motion: RelativeMotion,
    ) -> Result<Self, SeriesError> {
        let motion = motion.checked()?;
        match [receiver, emitter].iter().find(|element| element.plane.is_none()) {
            Some(curved) => Err(SeriesError::Curved { surface: curved.surface }),
            None => Ok(Self { receiver, emitter, motion, start: Motion::IDENTITY }),
        }
    }

    /// This pair with the emitter at `start` when p = 0.
    #[must_use]
    pub(crate) fn starting(self, start: Motion) -> Self {
        Self { start, ..self }
    }

    /// Where the emitter is at p.
    pub(super) fn place(&self, p: f64) -> Motion {
        self.start.then(&self.motion.place(p))
    }

    /// About the change of p to which a series about p = 0 holds, where it holds to `share` of its
    /// convergence.
    pub(crate) fn reach(&self, share: f64) -> f64 {
        let of = |[p, q]: [&Patch; 2]| {
            let emitter: Vec<DVec3> = q.polygon().iter().map(|y| self.start.point(*y)).collect();
            self.motion.convergence([&p.polygon(), &emitter], moved_distance(p, q, &self.start))
        };
        self.motion.step(share * self.patches().map(of).fold(f64::INFINITY, f64::min))
    }

    /// The pairs of patches.
    pub(super) fn patches(&self) -> impl Iterator<Item = [&'a Patch; 2]> {
        let emitter = &self.emitter.patches;
        self.receiver.patches.iter().flat_map(move |p| emitter.iter().map(move |q| [p, q]))
    }

    /// The surfaces of receiver and emitter.
    pub(crate) fn surfaces(&self) -> [usize; 2] {
        [self.receiver.surface, self.emitter.surface]
    }
}
