//! The program as tests call it.

use std::path::Path;
use std::process::{Command, Output};

/// The program, to be called in `folder`.
pub(crate) fn command(folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_radiosity"));
    command.current_dir(folder).args(args);
    command
}

/// What the program leaves when it is called in `folder`.
pub(crate) fn radiosity(folder: &Path, args: &[&str]) -> Output {
    command(folder, args).output().expect("the binary runs")
}

/// Standard output and standard error of a command that succeeds.
#[track_caller]
pub(crate) fn done(folder: &Path, args: &[&str]) -> [String; 2] {
    let Output { status, stdout, stderr } = radiosity(folder, args);
    let texts = [stdout, stderr].map(|bytes| String::from_utf8(bytes).expect("text"));
    assert!(status.success(), "{args:?}: {}", texts[1]);
    texts
}

/// A command that is refused with all of these parts in its message.
#[track_caller]
pub(crate) fn refused(folder: &Path, args: &[&str], parts: &[&str]) {
    let output = radiosity(folder, args);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{args:?}: {message}");
    parts.iter().for_each(|part| assert!(message.contains(part), "{part:?} is missing in:\n{message}"));
}
