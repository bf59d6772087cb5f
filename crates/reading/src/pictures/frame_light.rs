//! Light at the places of a frame: those that the pixels of a picture see, or the texels of a surface.
//!
//! Direct light is computed where it has edges, and fitted between (`direct_pass`). Other light, where it is gathered,
//! is that of the light field.

pub(crate) mod frame;
mod direct_pass;
pub(crate) mod forecast;

use radiosity_work::Work;

use super::eye::SeenPlace;
use super::light_field::fit::{Fit, weight};
use super::light_field::{AskedPlace, LightField, offset};
use super::picture_light::PictureLight;
use direct_pass::lit;
use frame::Frame;

/// The irradiance of a frame.
pub(crate) struct FrameLight<'a> {
    frame: &'a Frame,
    bands: usize,
    /// Irradiance (W m⁻²) place by place, bands fastest; 0 where nothing is seen.
    irradiance: Vec<f64>,
    /// The part of it that is no direct light.
    other: Vec<f64>,
}

impl<'a> FrameLight<'a> {
    /// The light of all places of a frame, gathered by `field` unless it is read from the polynomials.
    pub(crate) fn over(
        frame: &'a Frame,
        light: &PictureLight,
        field: Option<&mut LightField>,
        work: &Work<'_>,
    ) -> Self {
        let direct = lit(frame, light, work);
        let bands = light.solution().bands().len();
        let other = other_light(&asked(frame, &direct), light, field, work);
        let mut irradiance = other.clone();
        for (sums, direct) in irradiance.chunks_exact_mut(bands).zip(direct) {
            sums.iter_mut().zip(direct).for_each(|(sum, direct)| *sum += direct);
        }
        Self { frame, bands, irradiance, other }
    }

    /// The places.
    pub(crate) fn frame(&self) -> &'a Frame {
        self.frame
    }

    /// Irradiance per band (W m⁻²) between the places of a frame, where a point at its column and row sees `seen`, by a
    /// fit to those beside on the same smooth surface; None where there are few, or the fit leaves more than the part
    /// `even`.
    pub(crate) fn beside(&self, at: [f64; 2], seen: &SeenPlace, even: f64) -> Option<Vec<f64>> {
        self.fitted(&self.irradiance, at, seen, 0.0, even)
    }

    /// As [`FrameLight::beside`] the light that is no direct light; None where the fit leaves more than the part `even`
    /// of it and the `direct` light there (W m⁻², the sum over the bands).
    pub(crate) fn other_beside(
        &self,
        at: [f64; 2],
        seen: &SeenPlace,
        direct: f64,
        even: f64,
    ) -> Option<Vec<f64>> {
        self.fitted(&self.other, at, seen, direct, even)
    }

    /// A fit at a point to the `values` of places beside it that leaves at most the part `even` of itself and so much
    /// more light (W m⁻²).
    fn fitted(
        &self,
        values: &[f64],
        at: [f64; 2],
        seen: &SeenPlace,
        more: f64,
        even: f64,
    ) -> Option<Vec<f64>> {
        let mut fit = Fit::new();
        let [column, row] = at.map(|at| at.floor() as isize);
        for (i, j) in (-2..=2).flat_map(|j| (-2..=2).map(move |i| (column + i, row + j))) {
            let Some(pixel) = self.frame.pixel([i, j]) else { continue };
            let Some(there) = self.frame.seen(pixel).filter(|there| seen.goes_with(there)) else { continue };
            let weight = weight([at[0] - i as f64 - 0.5, at[1] - j as f64 - 0.5]);
            if weight > 0.0 {
                fit.take(offset(seen, there), weight, &values[pixel * self.bands..][..self.bands], 0.0);
            }
        }
        let found = fit.found()?;
        let all = more + found.value.iter().sum::<f64>();
        (found.left() <= even * all).then(|| fit.within(found.value))
    }

    /// Irradiance per band (W m⁻²) at a place; None where nothing is seen.
    pub(crate) fn irradiance(&self, place: usize) -> Option<&[f64]> {
        self.frame.seen(place).map(|_| &self.irradiance[place * self.bands..(place + 1) * self.bands])
    }
}

/// The places of a frame as a light field is asked for them, beside this direct light (W m⁻² per band).
fn asked(frame: &Frame, direct: &[Vec<f64>]) -> Vec<Option<AskedPlace>> {
    let one = |place: usize| {
        let seen = *frame.seen(place)?;
        let beside = direct[place].iter().sum();
        Some(AskedPlace { seen, footprint: frame.footprint(place), beside, error_factor: 1.0 })
    };
    (0..frame.len()).map(one).collect()
}

/// Irradiance per band (W m⁻²) beside direct light at all places, bands fastest: gathered by `field`, or else read
/// from the polynomials; 0 where nothing is seen.
pub(crate) fn other_light(
    places: &[Option<AskedPlace>],
    light: &PictureLight,
    field: Option<&mut LightField>,
    work: &Work<'_>,
) -> Vec<f64> {
    let Some(field) = field else {
        let nothing = || vec![0.0; light.solution().bands().len()];
        let of = |asked: &Option<AskedPlace>| {
            asked.as_ref().map_or_else(nothing, |asked| light.polynomials(&asked.seen))
        };
        return places.iter().flat_map(of).collect();
    };
    field.at(places, work)
}
