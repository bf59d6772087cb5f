//! The program in a folder.

use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use radiosity_test_support::folders::names;

/// The program, to be called in `folder`.
pub(crate) fn command(folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_radiosity"));
    command.current_dir(folder).args(args);
    command
}

/// Exit status and output of the program, called in `folder`.
pub(crate) fn radiosity(folder: &Path, args: &[&str]) -> Output {
    command(folder, args).output().expect("the binary runs")
}

/// Exit status and output of the program, given a text on standard input.
pub(crate) fn fed(folder: &Path, args: &[&str], text: &str) -> Output {
    let mut command = command(folder, args);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("the binary runs");
    // A command that refuses its arguments does not wait for input.
    let _ = child.stdin.take().expect("it is piped").write_all(text.as_bytes());
    child.wait_with_output().expect("the binary ends")
}

/// Standard output and standard error of a command that succeeds.
#[track_caller]
pub(crate) fn done(folder: &Path, args: &[&str]) -> [String; 2] {
    succeeded(radiosity(folder, args))
}

/// Standard output and standard error of what succeeded.
#[track_caller]
pub(crate) fn succeeded(Output { status, stdout, stderr }: Output) -> [String; 2] {
    let texts = [stdout, stderr].map(|bytes| String::from_utf8(bytes).expect("text"));
    assert!(status.success(), "{status}: {}", texts[1]);
    texts
}

/// A command that is refused with all of these parts in its message, prints nothing and leaves the folder as
/// it is.
#[track_caller]
pub(crate) fn refused(folder: &Path, args: &[&str], parts: &[&str]) {
    let before = names(folder);
    assert_refused(&radiosity(folder, args), parts);
    assert_eq!(names(folder), before, "{args:?}");
}

/// Asserts exit code 2, nothing printed, and all of these parts in the message.
#[track_caller]
pub(crate) fn assert_refused(output: &Output, parts: &[&str]) {
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(output.stdout.is_empty(), "{}", String::from_utf8_lossy(&output.stdout));
    parts.iter().for_each(|part| assert!(message.contains(part), "{part:?} is missing in:\n{message}"));
}
