//! Readers of MGF and of Radiance scenes, and the writer of MGF.

mod mgf;
mod written;
mod rad;
mod mutations;
mod rooms;

use radiosity_formats::model::Model;
use radiosity_photometry::error::Refusal;
use radiosity_photometry::file_place::FilePlace;

/// Asserts that a refusal names file and line and says cause and cure with these words.
#[track_caller]
fn assert_refused(found: Result<Model, Refusal>, file: &str, line: usize, [cause, cure]: [&str; 2]) {
    let refusal = found.expect_err(cause);
    assert_eq!((refusal.file.as_str(), refusal.place), (file, Some(FilePlace::Line(line))), "{refusal:?}");
    assert!(refusal.cause.contains(cause), "{cause}: {refusal:?}");
    assert!(refusal.cure.contains(cure) && !refusal.cure.is_empty(), "{cure}: {refusal:?}");
}
