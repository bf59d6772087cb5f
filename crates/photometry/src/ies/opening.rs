//! Luminous openings in the words of LM-63: unit, width, length and height, whose signs tell the form.
//!
//! Where editions give the same signs different forms, the file's own edition counts; otherwise those of all
//! are read, for many files state one edition and follow another.

use super::edition::Edition;
use crate::error::Refusal;
use crate::numbers::Numbers;
use crate::opening::{Form, Opening};
use crate::text::told;

const METRES_PER_FOOT: f64 = 0.3048;

pub(super) fn read(numbers: &mut Numbers, edition: Edition) -> Result<Opening, Refusal> {
    let metres = match numbers.whole("the unit (1 feet, 2 metres)", 1, 2)? {
        1 => METRES_PER_FOOT,
        _ => 1.0,
    };
    let width = numbers.next("the width of the opening")? * metres;
    let length = numbers.next("its length")? * metres;
    let height = numbers.next("its height")? * metres;
    opening(edition, length, width, height).ok_or_else(|| {
        numbers.fault(
            format!(
                "no luminous opening has width {}, length {} and height {} m",
                told(width),
                told(length),
                told(height)
            ),
            "write 0 0 0 for a point, lengths above 0 for a box, -d -d 0 for a disk",
        )
    })
}

/// The opening of these extents along x (length), y (width) and z (height) with their signs.
fn opening(edition: Edition, length: f64, width: f64, height: f64) -> Option<Opening> {
    let of = |form, extent: [f64; 3]| Some(Opening { form, extent: extent.map(f64::abs) });
    let is_old = edition < Edition::Of1995;
    match [length, width, height].map(sign) {
        [0, 0, 0] => of(Form::Point, [0.0; 3]),
        [0 | 1, 0 | 1, 0 | 1] => of(Form::Box, [length, width, height]),
        // One diameter for both, before 2002.
        [0, -1, 0 | 1] => of(Form::Upright, [width, width, height]),
        [0, -1, -1] if edition < Edition::Of2002 => of(Form::Ellipsoid, [width, width, height]),
        [0, -1, -1] => of(Form::FacingX, [0.0, width, height]),
        [1, 0, -1] => of(Form::AlongX, [length, height, height]),
        [0, 1, -1] => of(Form::AlongY, [height, width, height]),
        [1, -1, 0] | [-1, 1, 0] | [-1, -1, 0 | 1] => of(Form::Upright, [length, width, height]),
        [1, -1, 1] if is_old => of(Form::Ellipsoid, [length, width, height]),
        [1, -1, 1] | [-1, 1, 1] => of(Form::Upright, [length, width, height]),
        [-1, -1, -1] => of(Form::Ellipsoid, [length, width, height]),
        [1, -1, -1] | [-1, 1, -1] if edition == Edition::Of1995 => {
            of(Form::Ellipsoid, [length, width, height])
        }
        [1, -1, -1] => of(Form::AlongX, [length, width, height]),
        [-1, 1, -1] => of(Form::AlongY, [length, width, height]),
        _ => None,
    }
}

fn sign(x: f64) -> i8 {
    match x {
        x if x > 0.0 => 1,
        x if x < 0.0 => -1,
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_tell_the_form() {
        use Edition::{Of1986, Of1995, Of2002};
        for (edition, [width, length, height], form, extent) in [
            (Of2002, [0.0, 0.0, 0.0], Form::Point, [0.0, 0.0, 0.0]),
            (Of2002, [0.3, 1.2, 0.0], Form::Box, [1.2, 0.3, 0.0]),
            (Of2002, [-0.2, -0.2, 0.0], Form::Upright, [0.2, 0.2, 0.0]),
            (Of1995, [-0.2, 0.0, 0.0], Form::Upright, [0.2, 0.2, 0.0]),
            (Of1986, [-0.2, 0.0, 0.1], Form::Upright, [0.2, 0.2, 0.1]),
            (Of2002, [-0.2, -0.3, 0.1], Form::Upright, [0.3, 0.2, 0.1]),
            (Of2002, [-0.2, -0.2, -0.2], Form::Ellipsoid, [0.2, 0.2, 0.2]),
            (Of1995, [-0.2, 0.0, -0.2], Form::Ellipsoid, [0.2, 0.2, 0.2]),
            (Of2002, [-0.2, 0.0, -0.2], Form::FacingX, [0.0, 0.2, 0.2]),
            (Of2002, [-0.1, 1.0, -0.1], Form::AlongX, [1.0, 0.1, 0.1]),
            (Of1995, [0.0, 1.0, -0.1], Form::AlongX, [1.0, 0.1, 0.1]),
            (Of2002, [1.0, -0.1, -0.1], Form::AlongY, [0.1, 1.0, 0.1]),
            (Of1995, [-0.1, 1.0, -0.2], Form::Ellipsoid, [1.0, 0.1, 0.2]),
        ] {
            assert_eq!(opening(edition, length, width, height), Some(Opening { form, extent }));
        }
        assert_eq!(opening(Of2002, 1.0, 1.0, -1.0), None);
    }
}
