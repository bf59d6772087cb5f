//! Random rooms rounded as files are: their rows add up to what they add up to unrounded.

use std::sync::LazyLock;

use proptest::prelude::*;
use radiosity::solve::view_factors::ViewFactors;
use radiosity_geom::{DVec3, Motion};
use radiosity_test_support::random::seeded;
use radiosity_test_support::solved::usual_factors as factors;

use crate::rounded::rooms::{FAMILIES, Family};
use crate::rounded::sheet::{Sheet, placed, scene};

/// Three times the default accuracy of view factors.
const ALLOWED: f64 = 3e-3;

/// Roundings of coordinates.
#[derive(Clone, Copy, Debug)]
enum Rounding {
    Single,
    /// A thousandth of the rounding to half precision.
    Half,
    Decimals(i32),
    /// Rounding to double precision alone, after a move by so many metres.
    Moved(f64),
    /// Rounding to single precision, after a move by so many metres.
    SingleMoved(f64),
}

impl Rounding {
    fn of(self, x: f64, offset: f64) -> f64 {
        match self {
            Self::Single => f64::from(x as f32),
            Self::Half => x + 1e-3 * (half(x) - x),
            Self::Decimals(count) => {
                let unit = 10f64.powi(count);
                (x * unit).round() / unit
            }
            Self::Moved(by) => x + by * offset,
            Self::SingleMoved(by) => f64::from((x + by * offset) as f32),
        }
    }
}

/// Rounded to the eleven bits of half precision.
fn half(x: f64) -> f64 {
    let unit = x.abs().max(1e-4).log2().floor().exp2() / 1024.0;
    (x / unit).round() * unit
}

fn roundings() -> impl Strategy<Value = Rounding> {
    prop_oneof![
        Just(Rounding::Single),
        Just(Rounding::Half),
        (6..=9i32).prop_map(Rounding::Decimals),
        (0.0..7.0f64).prop_map(|digits| Rounding::Moved(4.0 * 10f64.powf(digits))),
        (0.0..2.0f64).prop_map(|digits| Rounding::SingleMoved(4.0 * 10f64.powf(digits))),
    ]
}

fn vector() -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-1.0..1.0f64).prop_map(DVec3::from_array)
}

/// The room of a family without any gap, turned and rounded.
fn rounded(family: &Family, turn: &Motion, rounding: Rounding, offset: DVec3) -> Vec<Sheet> {
    placed((family.sheets)(0.0), |x| {
        let [x, offset] = [turn.point(x), offset].map(|x| x.to_array());
        DVec3::from_array([0, 1, 2].map(|axis| rounding.of(x[axis], offset[axis])))
    })
}

/// View factors of the rooms as they are meant, in the order of the families.
static CLEAN: LazyLock<Vec<ViewFactors>> = LazyLock::new(|| {
    let clean = |family: &Family| factors(&scene(&(family.sheets)(0.0)).expect("a clean scene"));
    FAMILIES.iter().map(clean).collect()
});

proptest! {
    #![proptest_config(seeded(96, 21))]

    /// Rows add up, and factors are those of the clean room; not those of plates in one plane, of which either
    /// may be in front.
    #[test]
    fn factors_of_rounded_rooms_are_those_of_clean_ones(
        family in 0..FAMILIES.len(), axis in vector(), angle in 0.0..6.0f64, rounding in roundings(), offset in vector(),
    ) {
        prop_assume!(axis.length() > 0.1);
        let (family, clean) = (&FAMILIES[family], &CLEAN[family]);
        let turn = Motion::new(DVec3::ZERO, axis, angle, 1.0).expect("a motion");
        let sheets = rounded(family, &turn, rounding, offset);
        let scene = scene(&sheets).map_err(|error| TestCaseError::fail(format!("{}: {error}", family.name)))?;
        let found = factors(&scene);
        let row = family.worst_row(&found);
        prop_assert!(row <= ALLOWED, "{}: a row is off by {row:e}", family.name);
        if family.name == "plates" {
            return Ok(());
        }
        for i in 0..clean.names.len() {
            for (a, b) in clean.row(i).into_iter().zip(found.row(i)) {
                prop_assert!((a - b).abs() <= ALLOWED, "{}: {} {a} {b}", family.name, clean.names[i]);
            }
        }
    }
}

/// View factors stay within 1e-12 in whatever order the surfaces are listed.
#[test]
fn the_order_of_surfaces_does_not_matter() {
    let turn = Motion::new(DVec3::ZERO, DVec3::new(0.3, 0.5, -0.2), 1.1, 1.0).expect("a motion");
    for family in &FAMILIES {
        for rounding in [Rounding::Moved(0.0), Rounding::Single, Rounding::Half] {
            let mut sheets = rounded(family, &turn, rounding, DVec3::ONE);
            let found = factors(&scene(&sheets).expect("a scene"));
            for order in 0..3 {
                match order {
                    0 => sheets.reverse(),
                    // A riffle: every third, then the rest.
                    _ => sheets = (0..3).flat_map(|k| sheets.iter().skip(k).step_by(3).cloned()).collect(),
                }
                let other = factors(&scene(&sheets).expect("a scene"));
                let place =
                    |name: &str| other.names.iter().position(|own| own == name).expect("the same names");
                for (i, own) in found.names.iter().enumerate() {
                    for (j, name) in found.names.iter().enumerate() {
                        let (a, b) = (found.factor(i, j), other.factor(place(own), place(name)));
                        assert!((a - b).abs() < 1e-12, "{} {rounding:?}: {own} {name} {a} {b}", family.name);
                    }
                }
            }
        }
    }
}
