//! The form of an output: what `--format` names, else what the file ends in.

use std::path::Path;

use clap::ValueEnum;

use crate::error::CliError;

/// `--format` of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Comma-separated values with a header
    Csv,
    /// An object with the bands and a list
    Json,
}

/// The form of a picture where there is one alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum PictureFormat {
    Png,
}

/// The form that was `asked` for, or that `output` ends in; `usual` on standard output.
///
/// # Errors
/// An ending that names no form where none was asked for, or another form than was asked for.
pub(crate) fn chosen<F: ValueEnum + PartialEq>(
    asked: Option<F>,
    output: Option<&Path>,
    usual: F,
) -> Result<F, CliError> {
    let Some(path) = output else { return Ok(asked.unwrap_or(usual)) };
    match (asked, of_ending(path)) {
        (Some(asked), Some(ended)) if asked != ended => Err(CliError::refused(
            format!("{}: --format {} and the ending disagree", path.display(), name(&asked)),
            "leave out --format, or choose another ending",
        )),
        (Some(form), _) | (None, Some(form)) => Ok(form),
        (None, None) => {
            let known = known::<F>();
            let endings = known.replace("or ", "or .");
            Err(unknown(path, "format", &format!("end the name in .{endings}, or add --format {known}")))
        }
    }
}

/// The form that `output` ends in, where no option asks for one.
///
/// # Errors
/// An ending that names no form.
pub(crate) fn of_file<F: ValueEnum>(output: &Path) -> Result<F, CliError> {
    of_kind(output, "format", &format!("end the name in .{}", known::<F>().replace("or ", "or .")))
}

/// The kind of output that `path` ends in; `kind` is the word for it.
///
/// # Errors
/// An ending that names none, with this cure.
pub(crate) fn of_kind<F: ValueEnum>(path: &Path, kind: &str, cure: &str) -> Result<F, CliError> {
    of_ending(path).ok_or_else(|| unknown(path, kind, cure))
}

/// The error of a file whose ending names no output of this kind.
pub(crate) fn unknown(path: &Path, kind: &str, cure: &str) -> CliError {
    CliError::refused(format!("{}: the ending names no {kind}", path.display()), cure)
}

/// The form that `path` ends in, in capitals or not.
fn of_ending<F: ValueEnum>(path: &Path) -> Option<F> {
    F::from_str(path.extension()?.to_str()?, true).ok()
}

/// The word for a form on the command line.
pub(crate) fn name(form: &impl ValueEnum) -> String {
    form.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned())
}

/// The forms there are, such as `csv or json`.
fn known<F: ValueEnum>() -> String {
    F::value_variants().iter().map(name).collect::<Vec<_>>().join(" or ")
}
