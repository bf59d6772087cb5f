//! Light at the places of a frame: those that the pixels of a picture see, or the texels of a surface.
//!
//! Direct light is computed at every place. Other light, where it is gathered, is computed at few of them and
//! interpolated between neighbours in the frame (`smooth`).

pub(crate) mod eye;
mod fit;
pub(crate) mod frame;
pub(crate) mod pixel_count;
pub(crate) mod smooth;
pub(crate) mod picture_light;
mod direct_pass;
pub(crate) mod forecast;

use radiosity_work::Work;

use direct_pass::lit;
use eye::SeenPlace;
use frame::Frame;
use picture_light::PictureLight;
use smooth::Smooth;

/// The irradiance of a frame.
pub(crate) struct FrameLight<'a> {
    frame: &'a Frame,
    light: &'a PictureLight<'a>,
    /// Direct irradiance per place and band (W m⁻²).
    direct: Vec<Vec<f64>>,
    /// Other light; None where it is not gathered.
    smooth: Option<Smooth<'a>>,
}

impl<'a> FrameLight<'a> {
    /// The light of all places of a frame.
    pub(crate) fn over(frame: &'a Frame, light: &'a PictureLight<'a>, work: &Work<'_>) -> Self {
        let direct = lit(frame, light, work);
        let rest = |place: usize, seen: &SeenPlace| light.rest(seen, &direct[place]);
        let bands = light.solution().bands().len();
        let smooth = light.gathers().then(|| Smooth::over(frame, bands, &rest, &direct, work));
        Self { frame, light, direct, smooth }
    }

    /// The places.
    pub(crate) fn frame(&self) -> &'a Frame {
        self.frame
    }

    /// Irradiance per band (W m⁻²) at a place; None where nothing is seen.
    pub(crate) fn irradiance(&self, place: usize) -> Option<Vec<f64>> {
        let seen = self.frame.seen(place)?;
        let mut sum = self.direct[place].clone();
        let mut add = |rest: &[f64]| sum.iter_mut().zip(rest).for_each(|(sum, rest)| *sum += rest);
        match &self.smooth {
            Some(smooth) => add(smooth.at(place)),
            None => add(&self.light.rest(seen, &self.direct[place]).bands),
        }
        Some(sum)
    }

    /// Gathered light per band (W m⁻²) where a point between the places of the frame sees `seen`; None where
    /// light is not gathered, or no place around goes with it.
    pub(crate) fn between(&self, at: [f64; 2], seen: &SeenPlace) -> Option<Vec<f64>> {
        self.smooth.as_ref()?.between(at, seen)
    }
}
