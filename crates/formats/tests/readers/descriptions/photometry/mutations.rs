//! Broken copies of photometric files are read or refused, never more.

use radiosity_photometry::Photometry;
use radiosity_photometry::error::Refusal;
use radiosity_photometry::{eulumdat, ies};

use super::direction;
use super::texts::{Eulumdat, Ies, steps};
use radiosity_test_support::mutations::break_often;

/// Asserts the promises of readers: finite flux and intensities, or a refusal with a cause and a file.
fn is_promised(found: Result<Photometry, Refusal>) {
    match found {
        Ok(lamp) => {
            assert!(lamp.flux().is_finite() && lamp.flux() > 0.0, "{lamp:?}");
            assert!(lamp.opening.extent.iter().all(|size| size.is_finite() && *size >= 0.0));
            for index in 0..24 {
                let intensity = lamp.intensity(direction(f64::from(index) * 41.0, f64::from(index) * 7.5));
                assert!((0.0..=lamp.largest()).contains(&intensity), "{intensity}");
            }
        }
        Err(refusal) => assert!(!refusal.cause.is_empty() && !refusal.file.is_empty(), "{refusal:?}"),
    }
}

fn break_ies(cases: u32) {
    let right = |header, gammas, planes| Ies {
        header,
        lumens: 1000.0,
        multiplier: 1.0,
        ballast: [1.0, 1.0],
        gammas,
        planes,
        intensity: |direction| 100.0 + direction.z + direction.x * direction.x,
        divisor: 1.0,
    };
    for file in [
        right("IESNA:LM-63-2002\n[TEST] 1\nTILT=NONE", steps(0.0, 90.0, 9), steps(0.0, 90.0, 3)),
        right("A label\nTILT=INCLUDE\n1 2 0 90 1 0.9", steps(0.0, 180.0, 6), steps(0.0, 360.0, 4)),
    ] {
        break_often(cases / 2, file.text().as_bytes(), &[], |bytes| is_promised(ies::read("broken", bytes)));
    }
}

fn break_eulumdat(cases: u32) {
    let planes = steps(0.0, 315.0, 7);
    for (isym, stated) in [(3, steps(-90.0, 90.0, 4)), (0, planes.clone())] {
        let file = Eulumdat {
            isym,
            planes: planes.clone(),
            stated,
            gammas: steps(0.0, 180.0, 6),
            flux: 1000.0,
            output_ratio: 0.8,
            intensity: |direction| 100.0 + direction.z,
        };
        break_often(cases / 2, file.text().as_bytes(), &[], |bytes| {
            is_promised(eulumdat::read("broken", bytes))
        });
    }
}

#[test]
fn broken_ies_files_are_read_or_refused() {
    break_ies(1000);
}

#[test]
fn broken_eulumdat_files_are_read_or_refused() {
    break_eulumdat(1000);
}

#[test]
#[ignore = "takes seconds"]
fn ten_thousand_broken_files_of_each_format_are_read_or_refused() {
    break_ies(10_000);
    break_eulumdat(10_000);
}
