//! The range of frames `--frames A..B`.

use std::ops::RangeInclusive;
use std::str::FromStr;

use radiosity_scene::Scene;

use crate::error::CliError;

/// First and last frame as typed, both included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct FrameRange {
    first: usize,
    last: usize,
}

impl FromStr for FrameRange {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |part: &str| part.trim().parse::<usize>().ok();
        let ends = match text.split_once("..") {
            Some((first, last)) => number(first).zip(number(last)),
            None => number(text).map(|only| (only, only)),
        };
        match ends {
            Some((first, last)) if first > last => Err(format!(
                "frame {first} comes after frame {last}, and frames are made forwards: write {last}..{first}"
            )),
            Some((first, last)) => Ok(Self { first, last }),
            None => {
                Err("expected the first and the last frame with .. between, such as 0..99, or one number"
                    .to_owned())
            }
        }
    }
}

impl FrameRange {
    /// The frames that were asked for, or all of a scene.
    ///
    /// # Errors
    /// A scene in which nothing moves, or that has fewer frames.
    pub(super) fn within(asked: Option<Self>, scene: &Scene) -> Result<Self, CliError> {
        if scene.animation.is_none() {
            return Err(CliError::refused(
                format!("{}: nothing moves in this scene", scene.origin),
                still(scene),
            ));
        }
        // Refuses frames that do not exist.
        scene.movers_at(asked.map_or(0, |asked| asked.last))?;
        Ok(asked.unwrap_or(Self { first: 0, last: scene.frames() - 1 }))
    }

    /// Numbers of the first and the last frame.
    pub(super) fn ends(&self) -> [usize; 2] {
        [self.first, self.last]
    }

    /// Numbers of all frames, in order.
    pub(super) fn numbers(&self) -> RangeInclusive<usize> {
        self.first..=self.last
    }

    /// First and last frames of stretches of so many steps, of which each begins where the one before ends; of single
    /// frames where that is 0.
    pub(super) fn stretches(&self, steps: usize) -> Vec<[usize; 2]> {
        if steps == 0 || self.count() == 1 {
            return (self.first..=self.last).map(|frame| [frame; 2]).collect();
        }
        let starts = (self.first..self.last).step_by(steps);
        starts.map(|first| [first, (first + steps).min(self.last)]).collect()
    }

    /// Number of frames.
    pub(super) fn count(&self) -> usize {
        self.last - self.first + 1
    }
}

/// Advice on a scene in which nothing moves: the files that can be typed, not the text that was made of them.
fn still(scene: &Scene) -> String {
    let typed = scene.imported().map_or(scene.origin.as_str(), |imported| &imported.file);
    let typed = if typed == "<stdin>" { "-" } else { typed };
    let picture = format!("or take one picture: radiosity render {typed}");
    match scene.imported() {
        None => format!("add frames = 50 and [[motion]] to it, docs/scene.md, {picture}"),
        Some(_) => format!(
            "make it a scene, radiosity convert {typed} moving.toml, and add frames = 50 and [[motion]] to that, \
             docs/scene.md, {picture}"
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stretches_hold_all_frames() {
        let range = FrameRange { first: 3, last: 12 };
        assert_eq!(range.stretches(4), [[3, 7], [7, 11], [11, 12]]);
        assert_eq!(range.stretches(0).len(), 10);
        assert_eq!(FrameRange { first: 3, last: 3 }.stretches(4), [[3, 3]]);
        assert_eq!(FrameRange { first: 0, last: 4 }.stretches(4), [[0, 4]]);
    }

    #[test]
    fn ranges_are_read() {
        let read = |text: &str| text.parse::<FrameRange>().map(|range| (range.ends(), range.count()));
        assert_eq!(read("3..7"), Ok(([3, 7], 5)));
        assert_eq!(read("4"), Ok(([4, 4], 1)));
        let backwards = "7..3".parse::<FrameRange>().expect_err("it runs backwards");
        assert!(backwards.ends_with("write 3..7"), "{backwards}");
        for wrong in ["", "7..3", "..", "a..b", "-1", "1...2", "1.5"] {
            assert!(read(wrong).is_err(), "{wrong}");
        }
    }
}
