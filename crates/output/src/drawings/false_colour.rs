//! False colours: a field through a scale, on white, with isolines.

use super::isolines::Isoline;
use super::labelled_isolines::LabelledIsolines;
use super::picture::Picture;
use super::scale::Scale;
use super::tick::Tick;
use radiosity_reading::field::Field;

/// Least difference of values, relative to the greatest, that isolines are chosen for: below it, errors of
/// gathered light would be drawn. Chosen.
const TOLD: f64 = 0.01;

/// The colours of `field` by `scale`; white where nothing is seen, mixed in pixels that are covered in part.
pub fn false_colour(field: &Field, scale: &Scale) -> Picture {
    let colour = |(value, coverage): (f64, f64)| {
        let seen = if coverage > 0.0 { scale.colour(value) } else { [255; 3] };
        seen.map(|x| (255.0 + (f64::from(x) - 255.0) * coverage).round() as u8)
    };
    let [width, height] = field.size();
    Picture::new(width, height, field.pixels().map(colour).collect())
}

/// A map from numbers to colours, with isolines.
#[derive(Clone, Debug)]
pub struct FalseColours {
    /// The colours.
    pub scale: Scale,
    /// Values of isolines; none for no isolines.
    pub isolines: Vec<Tick>,
}

impl FalseColours {
    /// These colours with isolines at round values between the ends of `range`, at most 9; without any where
    /// it has about one value.
    #[must_use]
    pub fn with_round_isolines(self, [low, high]: [f64; 2]) -> Self {
        if high - low <= TOLD * high.abs() {
            return self;
        }
        let ticks = self.scale.over([low, high]).ticks();
        Self {
            isolines: ticks.into_iter().filter(|tick| low < tick.value && tick.value < high).collect(),
            ..self
        }
    }

    /// Draws the isolines of `field` on a picture of its size; `parts` names, pixel by pixel, the part of the
    /// picture that a pixel belongs to wholly.
    pub fn draw_isolines(&self, picture: &mut Picture, field: &Field, parts: &[Option<u32>]) {
        let mut lines = LabelledIsolines::default();
        for tick in &self.isolines {
            lines.add(&Isoline::all(field, parts, tick.value), &tick.text);
        }
        lines.draw(picture);
    }
}
