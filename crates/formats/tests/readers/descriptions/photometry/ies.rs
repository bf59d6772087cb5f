//! LM-63 files, odd and broken.

use radiosity_photometry::Photometry;
use radiosity_photometry::error::Refusal;
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::ies;
use radiosity_photometry::opening::Form;
use radiosity_photometry::symmetry::Symmetry;

fn read(text: &str) -> Result<Photometry, Refusal> {
    ies::read("lamp.ies", text.as_bytes())
}

/// A downlight whose lines and numbers are all on lines of their own.
const RIGHT: &str = "IESNA:LM-63-2002\n[TEST] 7\n[LUMINAIRE] Downlight\n[MORE] 20 W\nTILT=NONE\n1 2000 1.0\n3 2\n1 1\n\
                     -0.5 -0.5 0\n1.0 1.0 20\n0 45 90\n0 90\n500 300 0\n500 350 0\n";

#[test]
fn a_downlight_says_what_it_is() {
    let lamp = read(RIGHT).expect("it is right");
    assert_eq!(lamp.name, "Downlight 20 W");
    assert_eq!(lamp.lamp_flux, Some(2000.0));
    assert_eq!(lamp.web.symmetry(), Symmetry::Quadrant);
    assert_eq!(
        (lamp.web.planes(), lamp.web.gammas()),
        (&[0.0, 90.0, 180.0, 270.0][..], &[0.0, 45.0, 90.0][..])
    );
    assert_eq!(lamp.web.candelas(3), [500.0, 350.0, 0.0]);
    // Half a foot.
    assert_eq!((lamp.opening.form, lamp.opening.extent), (Form::Upright, [0.1524, 0.1524, 0.0]));
}

/// Ends of lines, marks, bytes of other systems, commas and lines anywhere: the same luminaire.
#[test]
fn odd_ways_to_write_are_read_alike() {
    let right = read(RIGHT).expect("it is right");
    let crowded =
        RIGHT.replace("\n3 2\n1 1\n", " 3,2, 1,1 ").replace("\n0 90\n500 300 0\n", " 0\n90 500\n300,0 ");
    let tilted = RIGHT.replace("TILT=NONE", "TILT=INCLUDE\n1\n3\n0 90 180\n1.0 0.9\n0.8");
    for text in [
        RIGHT.replace('\n', "\r\n"),
        RIGHT.replace('\n', "\r"),
        format!("\u{feff}{RIGHT}"),
        format!("{RIGHT}\n\u{1a}\n"),
        crowded,
    ] {
        assert_eq!(read(&text).as_ref(), Ok(&right), "{text}");
    }
    let tilted = read(&tilted).expect("factors by tilt are right");
    assert_eq!(tilted.web, right.web);
    assert!(tilted.notes[0].text.contains("tilt"), "{:?}", tilted.notes);
    let latin =
        [&b"IESNA91\n[LUMINAIRE] Stra\xdfenleuchte\n"[..], &RIGHT.as_bytes()[RIGHT.find("TILT").unwrap()..]];
    assert_eq!(ies::read("lamp.ies", &latin.concat()).expect("it is right").name, "Straßenleuchte");
}

/// Odd values are noted.
#[test]
fn what_looks_wrong_is_noted() {
    let rows = "500 300 0\n500 350 0\n";
    let around = RIGHT.replace("3 2\n1 1", "3 5\n1 1").replace("\n0 90\n", "\n0 90 180 270 360\n");
    for (text, note) in [
        (RIGHT.replace("1.0 1.0 20", "1.0 0.9 20"), "future use is 0.9"),
        (RIGHT.replace("\n500 350", "\n400 350"), "at γ = 0° the planes differ, from 400 to 500 cd"),
        (RIGHT.replace("0 45 90", "0 45 85"), "the table ends at γ = 85°"),
        (around.replace(rows, &format!("{rows}{rows}500 200 0\n")), "C0 and C360 differ"),
    ] {
        let lamp = read(&text).unwrap_or_else(|refusal| panic!("{refusal}: {text}"));
        assert!(lamp.notes.iter().any(|found| found.text.contains(note)), "{note}: {:?}", lamp.notes);
    }
    let around = around.replace(rows, &format!("{rows}{rows}500 300 0\n"));
    assert!(read(&around).expect("it is right").notes.is_empty());
}

/// Each changed text is refused: the text, its replacement, the line of the fault, a part of the cause, a
/// part of the cure.
#[test]
fn broken_files_are_refused_with_line_cause_and_cure() {
    for (from, to, line, cause, cure) in [
        ("TILT=NONE\n", "", Some(13), "ends before a line TILT=", "TILT=NONE"),
        ("TILT=NONE", "TILT=MH400.TLT", Some(5), "names the file 'MH400.TLT'", "TILT=INCLUDE"),
        (
            "TILT=NONE",
            "TILT=INCLUDE\n4",
            Some(6),
            "position of the lamp (1 upright, 2 along, 3 across) is 4",
            "1 to 3",
        ),
        ("TILT=NONE", "TILT=INCLUDE\n1\n2\n10 5", Some(8), "a tilt angle is 5 behind 10", "increase"),
        ("2002\n", "2050\n", Some(1), "edition of LM-63 is '2050'", "1986, 1991, 1995, 2002 or 2019"),
        ("1 2000", "1 -2000", Some(6), "lumens of each lamp are -2000", "-1 where"),
        ("1 2000", "0 2000", Some(6), "number of lamps is 0", "above 0"),
        ("1.0\n3", "-1.0\n3", Some(6), "multiplier is -1", "above 0"),
        ("\n3 2\n", "\n1 2\n", Some(7), "number of vertical angles is 1", "2 to 20000"),
        ("\n3 2\n", "\n3 0\n", Some(7), "number of horizontal angles is 0", "1 to 20000"),
        ("\n3 2\n", "\n3 99999999999\n", Some(7), "is 99999999999", "1 to 20000"),
        ("\n3 2\n", "\n2.5 2\n", Some(7), "is 2.5", "whole"),
        ("\n3 2\n", "\n4 2\n", Some(12), "a vertical angle is 0 behind 90", "counts"),
        ("\n3 2\n", "\n3 1\n", Some(13), "'0' is left over", "counts"),
        ("\n3 2\n", "\n3 3\n", Some(13), "horizontal angles run from 0 to 500", "0 to 360"),
        ("\n1 1\n", "\n2 1\n", Some(8), "type B", "convert"),
        ("\n1 1\n", "\n3 1\n", Some(8), "type A", "convert"),
        ("\n1 1\n", "\n1 3\n", Some(8), "unit (1 feet, 2 metres) is 3", "1 to 2"),
        ("-0.5 -0.5 0", "0.5 0.5 -1", Some(9), "no luminous opening", "-d -d 0"),
        ("1.0 1.0 20", "0 1.0 20", Some(10), "ballast factor is 0", "above 0"),
        ("0 45 90\n", "0 45 45\n", Some(11), "a vertical angle is 45 behind 45", "increase"),
        ("0 45 90\n", "45 60 90\n", Some(12), "vertical angles run from 45 to 90", "begin at 0"),
        ("0 45 90\n", "0 90 270\n", Some(12), "vertical angles run from 0 to 270", "180"),
        ("0 45 90\n0 90", "0 45 90\n0 75", Some(12), "horizontal angles run from 0 to 75", "0 to 90"),
        ("500 300", "500 -300", Some(13), "a luminous intensity (2 of 6) is -300", "at least 0"),
        ("500 300", "500 NaN", Some(13), "is NaN", "finite"),
        ("500 300", "500 1e999", Some(13), "is 1e999", "finite"),
        ("500 300", "1e300 300", Some(12), "1e300 cd", "factors"),
        ("500 300", "500 3OO", Some(13), "(2 of 6) is '3OO', which is no number", "write a number"),
        ("500 350 0\n", "500\n", Some(14), "ends before a luminous intensity (5 of 6)", "complete"),
        ("500 350 0\n", "500 350 0 1\n", Some(14), "'1' is left over", "counts"),
        (
            "500 300 0\n500 350 0",
            "0 0 0 0 0 0",
            Some(12),
            "greatest luminous intensity is 0",
            "leave the luminaire out",
        ),
    ] {
        let text = RIGHT.replacen(from, to, 1);
        assert_ne!(text, RIGHT, "{from}");
        let refusal = read(&text).expect_err(&text);
        assert_eq!(refusal.file, "lamp.ies");
        assert_eq!(refusal.place, line.map(FilePlace::Line), "{refusal}");
        assert!(refusal.cause.contains(cause), "{refusal}");
        assert!(refusal.cure.contains(cure), "{refusal}: {}", refusal.cure);
    }
    let open = "TILT=NONE\n1 -1 1 2 4 1 2 0 0 0 1 1 1\n0 90\n0 70 130 190\n1 1 1 1 1 1 1 1\n";
    let refusal = read(open).expect_err("planes end at 190");
    assert!(refusal.cause.contains("go from C = 0° to 190° without a symmetry"), "{refusal}");
    let refusal = ies::read("lamp.ies", b"TILT=NONE\n1\0").expect_err("no text");
    assert!(refusal.cause.contains("zero byte"));
}
