//! Side files of materials: broken ones are applied or refused, and those refused change nothing.

use radiosity_formats::files::NoFiles;
use radiosity_formats::{materials, mitsuba};

use crate::mutations::{break_often, is_promised};

const SIDE: &str = "[white]\nreflectance = 0.7\ntwo_sided = false\n\n[lamp]\nemission = [1.0, 2, 3e0]\n\n[wood]\n\
    reflectance = [0.1, 0.2, 0.3]\n\n[\"*\"]\nreflectance = 0.5\n\n[surfaces]\n\"box-*\" = \"wood\"\nfloor = \"white\"\n\"left\" = 'red'\n";

fn break_side_files(cases: u32) {
    let room =
        mitsuba::read("room.xml", include_bytes!("../fixtures/room.xml"), &NoFiles).expect("it is right");
    let lines = materials::apply(SIDE, "side.toml", &mut room.clone());
    assert!(lines.as_ref().is_ok_and(|lines| lines.len() == 8), "{lines:?}");
    break_often(cases, SIDE.as_bytes(), |bytes| {
        let mut model = room.clone();
        let applied = materials::apply(&String::from_utf8_lossy(bytes), "side.toml", &mut model);
        assert!(applied.is_ok() || model == room);
        is_promised(&applied.map(|_| model));
    });
}

#[test]
fn broken_side_files_are_applied_or_refused() {
    break_side_files(256);
}

#[test]
#[ignore = "a longer hunt: seconds"]
fn ten_thousand_broken_side_files_are_applied_or_refused() {
    break_side_files(10_000);
}
