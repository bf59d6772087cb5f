//! False colours: a field through a scale, on white.

use super::field::Field;
use super::picture::Picture;
use super::scale::Scale;

/// The colours of `field` by `scale`; white where nothing is seen, mixed in pixels that are covered in part.
pub fn false_colour(field: &Field, scale: &Scale) -> Picture {
    let colour = |(value, coverage): (f64, f64)| {
        let seen = if coverage > 0.0 { scale.colour(value) } else { [255; 3] };
        seen.map(|x| (255.0 + (f64::from(x) - 255.0) * coverage).round() as u8)
    };
    let [width, height] = field.size();
    Picture::new(width, height, field.pixels().map(colour).collect())
}
