//! EULUMDAT files, odd and broken.

use radiosity_photometry::Photometry;
use radiosity_photometry::error::Refusal;
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::luminaire;
use radiosity_photometry::opening::Form;
use radiosity_photometry::symmetry::Symmetry;

use super::texts::{Eulumdat, steps};

fn read(lines: &[String]) -> Result<Photometry, Refusal> {
    luminaire::read("lamp.LDT", lines.join("\n").as_bytes())
}

/// A file with eight planes and three angles γ, and its lines. The flux of its lamps is 2000 lm, its ratio
/// 0.8.
fn right() -> Vec<String> {
    let file = Eulumdat {
        isym: 4,
        planes: steps(0.0, 315.0, 7),
        stated: vec![0.0, 45.0, 90.0],
        gammas: vec![0.0, 45.0, 90.0],
        flux: 2000.0,
        output_ratio: 0.8,
        intensity: |direction| -500.0 * direction.z,
    };
    file.text().lines().map(str::to_owned).collect()
}

/// Lines of the sound file, line `number` changed.
fn with(number: usize, line: &str) -> Vec<String> {
    let mut lines = right();
    lines[number - 1] = line.to_owned();
    lines
}

#[test]
fn a_luminaire_says_what_it_is() {
    let lamp = read(&right()).expect("it is right");
    assert_eq!(lamp.name, "Luminaire");
    assert_eq!((lamp.lamp_flux, lamp.stated_flux), (Some(2000.0), Some(1600.0)));
    assert_eq!(lamp.web.symmetry(), Symmetry::Quadrant);
    assert_eq!(lamp.web.planes(), steps(0.0, 315.0, 7));
    assert!((lamp.web.candelas(5)[1] - 500.0 * 0.5f64.sqrt()).abs() < 1e-3);
    // The length is along the lamps, which is along y.
    assert_eq!((lamp.opening.form, lamp.opening.extent), (Form::Box, [0.27, 1.17, 0.0]));
    let round = read(&with(17, "0")).expect("it is right");
    assert_eq!((round.opening.form, round.opening.extent), (Form::Upright, [1.17, 1.17, 0.0]));
}

/// Decimal commas, blank sizes, absolute photometry, tilt, a factor, sets of lamps.
#[test]
fn odd_ways_to_write_are_read() {
    let right_lamp = read(&right()).expect("it is right");
    for (number, line) in [(23, "80,0"), (36, "0,5"), (13, ""), (20, " "), (36, ""), (3, "4.0")] {
        assert_eq!(read(&with(number, line)).as_ref(), Ok(&right_lamp), "{number}: {line}");
    }
    let absolute = read(&with(27, "-1")).expect("it is right");
    assert_eq!((absolute.web, absolute.lamp_flux), (right_lamp.web.clone(), None));
    let tilted = read(&with(25, "15")).expect("it is right");
    assert_eq!(tilted.tilt, 15.0);
    assert!(tilted.notes.iter().any(|note| note.text.contains("tilted by 15°")));
    let doubled = read(&with(24, "2")).expect("it is right");
    assert_eq!(doubled.largest(), 2.0 * right_lamp.largest());
    let mut sets = with(26, "2");
    sets.splice(32..32, ["1", "T16 54 W", "4450", "830", "1B", "60"].map(str::to_owned));
    let sets = read(&sets).expect("it is right");
    assert_eq!(sets.web, right_lamp.web);
    assert!(
        sets.notes.iter().any(|note| &*note.text == "of 2 sets of lamps the first is taken, with 2000 lm")
    );
}

/// The coarse table of `right` makes 4 % less than π · 500 lm; a file that states another flux is told so.
#[test]
fn a_flux_that_does_not_fit_is_noted() {
    let lamp = read(&with(23, "50")).expect("it is right");
    let note = lamp.notes.iter().find(|note| note.text.contains("the file states 1000 lm"));
    assert!(note.is_some(), "{:?}", lamp.notes);
}

/// Each changed line is refused: its number, the line, the place of the fault, a part of the cause, a part of
/// the cure.
#[test]
fn broken_files_are_refused_with_line_cause_and_cure() {
    for (number, line, place, cause, cure) in [
        (3, "5", 3, "symmetry Isym is 5", "0 to 4"),
        (3, "", 3, "symmetry Isym is ''", "number"),
        (3, "one", 3, "symmetry Isym is 'one'", "number"),
        (4, "0", 4, "number of planes Mc is 0", "1 to 20000"),
        (4, "99999999", 4, "is 99999999", "1 to 20000"),
        (4, "7", 51, "an angle γ is 0 behind 315", "counts"),
        (4, "9", 51, "an angle C is 0 behind 315", "counts"),
        (6, "1", 6, "number of angles Ng is 1", "2 to 20000"),
        (6, "2", 59, "left over", "counts"),
        (14, "-1", 14, "its width is -1", "at least 0"),
        (24, "0", 24, "conversion factor of the intensities is 0", "above 0"),
        (26, "0", 26, "number of lamp sets is 0", "1 to 1000"),
        (29, "0", 29, "flux of the lamps is 0", "above 0"),
        (29, "inf", 29, "is inf", "finite"),
        (45, "85", 50, "symmetry Isym = 4 ends at C = 90", ""),
        (43, "5", 50, "angles C run from 5 to 315", "begin at 0"),
        (52, "0", 52, "an angle γ is 0 behind 0", "increase"),
        (53, "190", 53, "vertical angles run from 0 to 190", "180"),
        (54, "-1", 54, "luminous intensity (1 of 9) is -1", "at least 0"),
        (54, "NaN", 54, "is NaN", "finite"),
        (54, "1.234,5", 54, "'1.234,5', which is no number", "number"),
    ] {
        let refusal = read(&with(number, line)).expect_err(&format!("{number}: {line}"));
        assert_eq!(refusal.place, Some(FilePlace::Line(place)), "{number}: {refusal}");
        assert!(refusal.cause.contains(cause), "{refusal}");
        assert!(refusal.cure.contains(cure), "{refusal}: {}", refusal.cure);
    }
    let refusal = read(&right()[..60]).expect_err("it is cut off");
    assert!(refusal.cause.contains("ends before a luminous intensity (8 of 9)"), "{refusal}");
    let refusal = luminaire::read("lamp.txt", b"").expect_err("no ending");
    assert!(refusal.cure.contains(".ies") && refusal.cure.contains(".ldt"), "{}", refusal.cure);
}
