//! `--for`: the light of which an accuracy is wanted.

use std::ffi::OsString;
use std::str::FromStr;

use radiosity_reading::probe::Probe;
use radiosity_request::aim::{at_probes, of_picture};
use radiosity_scene::Scene;
use radiosity_solve::studies::adaptation::{Aim, Goal};
use radiosity_work::ranks::Ranks;

use crate::error::CliError;
use crate::planes::plane;
use crate::points::Points;

/// Forms that are accepted.
const FORM: &str = "expected gathered, solution, picture, points FILE or plane NAME";

/// Light that is to be accurate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum AimOption {
    /// Light as sensors and pictures read it, on all surfaces.
    Gathered,
    /// The polynomials, as `--read basis` shows them.
    Solution,
    /// Light at the points of this file.
    Points(String),
    /// Light at the sensors of this plane.
    Plane(String),
    /// Light that the scene's camera sees.
    Picture,
}

impl FromStr for AimOption {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.split_once('=') {
            Some(("points", file)) if !file.is_empty() => Ok(Self::Points(file.to_owned())),
            Some(("plane", name)) if !name.is_empty() => Ok(Self::Plane(name.to_owned())),
            None if text == "gathered" => Ok(Self::Gathered),
            None if text == "solution" => Ok(Self::Solution),
            None if text == "picture" => Ok(Self::Picture),
            _ => Err(FORM.to_owned()),
        }
    }
}

impl AimOption {
    /// The aim of the accuracy.
    pub(crate) fn aim(&self) -> Aim {
        match self {
            Self::Gathered => Aim::Gathered,
            Self::Solution => Aim::Solution,
            Self::Points(_) | Self::Plane(_) => Aim::Points,
            Self::Picture => Aim::Seen,
        }
    }

    /// The goal of this accuracy in a scene.
    pub(crate) fn goal(&self, accuracy: f64, scene: &Scene, ranks: &Ranks) -> Result<Goal, CliError> {
        match self {
            Self::Gathered => Ok(Goal::new(accuracy, Aim::Gathered)),
            Self::Solution => Ok(Goal::new(accuracy, Aim::Solution)),
            Self::Points(file) => Ok(at_probes(accuracy, &Points::load(file, ranks)?.probes, scene)),
            Self::Plane(name) => {
                let sensors: Vec<Probe> = Probe::of_plane(&plane(name, 0, scene)?).collect();
                Ok(at_probes(accuracy, &sensors, scene))
            }
            Self::Picture => Ok(of_picture(accuracy, scene)?),
        }
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
        assert_eq!("points=a=b".parse(), Ok(AimOption::Points("a=b".to_owned())));
        assert_eq!("plane=desk".parse(), Ok(AimOption::Plane("desk".to_owned())));
        for wrong in ["points", "plane=", "all", "picture=x"] {
            assert!(wrong.parse::<AimOption>().is_err(), "{wrong}");
        }
    }
}
