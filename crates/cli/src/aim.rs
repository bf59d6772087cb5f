//! `--for`: the light of which an accuracy is wanted.

use std::ffi::OsString;
use std::path::Path;

use radiosity_reading::probe::Probe;
use radiosity_request::MethodRequest;
use radiosity_request::aim::AccuracyOf;
use radiosity_scene::Scene;
use radiosity_solve::studies::adaptation::Goal;
use radiosity_work::ranks::Ranks;

use crate::error::CliError;
use crate::planes::plane;
use crate::points::Points;

/// The goal of this accuracy in a scene.
pub(crate) fn goal(of: &AccuracyOf, accuracy: f64, scene: &Scene, ranks: &Ranks) -> Result<Goal, CliError> {
    of.goal(accuracy, scene, || match of {
        AccuracyOf::Points(file) => Ok(Points::load(file, ranks)?.probes),
        AccuracyOf::Plane(name) => Ok(Probe::of_plane(&plane(name, 0, scene)?).collect()),
        AccuracyOf::Gathered | AccuracyOf::Solution | AccuracyOf::Picture => Ok(Vec::new()),
    })
}

/// The accuracy that is wanted in a scene, and of what, if one is wanted.
pub(crate) fn wanted(method: &MethodRequest, scene: &Scene, ranks: &Ranks) -> Result<Option<Goal>, CliError> {
    let of = method.aim.as_ref().unwrap_or(&AccuracyOf::Gathered);
    method.wanted_accuracy().map(|accuracy| goal(of, accuracy, scene, ranks)).transpose()
}

/// The file of points where light is to be accurate, if there is one.
pub(crate) fn points_file(method: &MethodRequest) -> Option<&Path> {
    match &method.aim {
        Some(AccuracyOf::Points(file)) => Some(Path::new(file)),
        _ => None,
    }
}

/// The words that were typed, with `--for points FILE` and `--for plane NAME` written as one word after
/// `--for`.
pub(crate) fn joined(typed: impl Iterator<Item = OsString>) -> Vec<OsString> {
    let mut words: Vec<OsString> = Vec::new();
    for word in typed {
        let is_kind = |last: &OsString| last == "points" || last == "plane";
        let is_open = matches!(&words[..], [.., option, kind] if option == "--for" && is_kind(kind));
        match words.last_mut() {
            Some(kind) if is_open => {
                kind.push("=");
                kind.push(word);
            }
            _ => words.push(word),
        }
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Vec<OsString> {
        text.split(' ').map(OsString::from).collect()
    }

    #[test]
    fn names_are_joined_to_what_they_name_alone() {
        let joined = |text: &str| joined(words(text).into_iter());
        assert_eq!(joined("solve --for points a.csv room"), words("solve --for points=a.csv room"));
        assert_eq!(
            joined("probe --plane points room --for plane"),
            words("probe --plane points room --for plane")
        );
        assert_eq!(joined("--for gathered points x"), words("--for gathered points x"));
    }

    #[test]
    fn what_is_wanted_is_told_apart() {
        assert_eq!("points=a=b".parse(), Ok(AccuracyOf::Points("a=b".to_owned())));
        assert_eq!("plane=desk".parse(), Ok(AccuracyOf::Plane("desk".to_owned())));
        for wrong in ["points", "plane=", "all", "picture=x"] {
            assert!(wrong.parse::<AccuracyOf>().is_err(), "{wrong}");
        }
    }
}
