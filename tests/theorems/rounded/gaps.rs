//! Gaps and offsets from 1e-15 to 1e-1 of a metre, two a decade: rows add up at every step, and no factor
//! jumps.

use radiosity::solve::view_factors::ViewFactors;
use radiosity_test_support::solved::usual_factors as factors;

use crate::rounded::rooms::FAMILIES;
use crate::rounded::sheet::{Sheet, scene};

/// The default accuracy of view factors.
const EPS: f64 = 1e-3;

/// Greatest true change of a factor of these rooms per metre of gap.
const SLOPE: f64 = 3.0;

/// Gap below which a corner out of its plane may count as in it (metres), and above which it is told.
const UNEVEN: f64 = 2e-5;

fn gaps() -> impl Iterator<Item = f64> {
    (0..=14).map(|k| 10f64.powi(k - 15))
}

/// View factors from each surface to each other, per whole area of the former: they do not depend on what is
/// left out of it.
fn shares(found: &ViewFactors, sheets: &[Sheet]) -> Vec<Vec<f64>> {
    let whole = |name: &str| {
        let sheet =
            sheets.iter().find(|sheet| name.trim_end_matches(":back") == sheet.name).expect("its sheet");
        radiosity_geom::polygon_area(&sheet.corners)
    };
    let row = |i: usize| {
        let share = found.areas[i] / whole(&found.names[i]);
        found.row(i).into_iter().map(|factor| factor * share).collect()
    };
    (0..found.names.len()).map(row).collect()
}

#[test]
fn rows_add_up_and_factors_do_not_jump_at_any_gap() {
    for family in &FAMILIES {
        let mut before: Option<Vec<Vec<f64>>> = None;
        let mut worst = [0.0f64; 2];
        for gap in gaps() {
            let sheets = (family.sheets)(gap);
            let scene = match scene(&sheets) {
                Ok(scene) => scene,
                // Polygons are flat: one with a corner clearly off its plane is refused.
                Err(error) if family.name.starts_with("corner") && gap > UNEVEN => {
                    assert!(error.to_string().contains("off the plane"), "{error}");
                    continue;
                }
                Err(error) => panic!("{} at {gap:e}: {error}", family.name),
            };
            let found = factors(&scene);
            let (row, shares) = (family.worst_row(&found), shares(&found, &sheets));
            assert!(row <= 3.0 * EPS, "{} at {gap:e}: a row is off by {row:e}", family.name);
            if let Some(before) = &before {
                let changes =
                    before.iter().flatten().zip(shares.iter().flatten()).map(|(a, b)| (a - b).abs());
                let change = changes.fold(0.0, f64::max);
                assert!(change <= EPS + SLOPE * gap, "{} at {gap:e}: a step of {change:e}", family.name);
                worst[1] = worst[1].max(change - SLOPE * gap);
            }
            worst[0] = worst[0].max(row);
            before = Some(shares);
        }
        println!("{:28} rows {:.1e}, steps {:.1e}", family.name, worst[0], worst[1]);
    }
}

#[test]
fn rooms_open_by_a_visible_gap_stay_open() {
    for gap in [1e-4, 1e-3, 1e-2] {
        let mut sheets = crate::rounded::sheet::room();
        let ceiling = sheets.iter_mut().find(|sheet| sheet.name == "room-top").expect("a ceiling");
        ceiling.corners.iter_mut().for_each(|x| x.z += gap);
        let scene = scene(&sheets).expect("a room");
        assert_eq!(scene.fitted.welded.corners, 0);
        // What passes the slit of a room of 4 × 3.5 × 2.8: its area over that of the walls beside it, about.
        let sums = factors(&scene).row_sums();
        assert!(sums.iter().any(|sum| *sum < 1.0 - 0.05 * gap), "{sums:?} at {gap:e}");
    }
}
