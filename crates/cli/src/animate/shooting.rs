//! The frames of a film in turn: solved stretch by stretch, then read and shown.

use std::time::Instant;

use radiosity_reading::pictures::film::{Film, FilmError};
use radiosity_scene::Scene;
use radiosity_solve::animation::follower::Follower;
use radiosity_work::{Stage, Work};

use super::frames::FrameRange;
use super::shutter::{Shutter, SolvedFrame};
use super::time_left::TimeLeft;
use crate::error::CliError;
use crate::progress::Progress;

/// A film while it is made.
pub(super) struct Shooting<'a> {
    shutter: Shutter<'a>,
    scene: &'a Scene,
    follower: Follower<'a>,
    range: FrameRange,
    progress: &'a Progress,
    work: &'a Work<'a>,
    /// Pictures with the light that they share; None before the first frame is solved, and where none are asked for.
    film: Option<Film<'a>>,
    /// None before the first frame is solved.
    time: Option<TimeLeft>,
    begun: Instant,
    /// Numbers of the frames of which anything is wanted.
    wanted: Vec<usize>,
    /// How many of these were made.
    made: usize,
    /// Number of frames that were made when the time left was told.
    told: usize,
}

/// Time of the blocks of each other frame over what is told of those of the first. Measured in three scenes of four
/// frames: 0.6 to 1.1.
const FOLLOWING: f64 = 0.8;

/// Frames after which the time that is left is told. Chosen.
const TOLD_EACH: usize = 16;

/// A film that is made.
pub(super) struct Made<'a> {
    pub shutter: Shutter<'a>,
    pub follower: Follower<'a>,
    /// Number of frames that were made.
    pub made: usize,
    /// Error of light that frames share.
    pub error: FilmError,
}

impl<'a> Shooting<'a> {
    /// A film of the frames of a range, of which none is solved.
    pub(super) fn new(
        shutter: Shutter<'a>,
        scene: &'a Scene,
        follower: Follower<'a>,
        range: FrameRange,
        progress: &'a Progress,
        work: &'a Work<'a>,
    ) -> Self {
        let begun = Instant::now();
        let [first, _] = range.ends();
        let wanted = range.numbers().filter(|number| shutter.wants(*number, *number == first)).collect();
        Self {
            shutter,
            scene,
            follower,
            range,
            progress,
            work,
            film: None,
            time: None,
            begun,
            wanted,
            made: 0,
            told: 0,
        }
    }

    /// Solves all frames of which anything is wanted, and makes it.
    pub(super) fn shoot(mut self) -> Result<Made<'a>, CliError> {
        let [first, _] = self.range.ends();
        let mut solved = Vec::new();
        if !self.wanted.is_empty() {
            solved.push(self.solved(first)?);
            self.begin(&solved[0])?;
        }
        for [from, to] in self.range.stretches(self.film.as_ref().map_or(0, Film::stretch)) {
            let own = |number: &&usize| {
                (from..=to).contains(*number) && (**number > from || from == first || from == to)
            };
            let own: Vec<usize> = self.wanted.iter().filter(own).copied().collect();
            if own.is_empty() {
                continue;
            }
            solved.retain(|own: &SolvedFrame| (from..=to).contains(&own.number));
            for number in from..=to {
                if solved.iter().all(|own| own.number != number) {
                    solved.push(self.solved(number)?);
                }
            }
            self.take(&solved, &own, first)?;
            self.tell();
        }
        let Self { shutter, follower, film, made, .. } = self;
        let error = film.as_ref().map(Film::error).unwrap_or_default();
        Ok(Made { shutter, follower, made, error })
    }

    /// The light of a frame.
    fn solved(&mut self, number: usize) -> Result<SolvedFrame, CliError> {
        self.progress.say_whole(self.standing());
        Ok(SolvedFrame { number, frame: self.follower.frame(number, self.work)? })
    }

    /// Begins the film with the first frame, and tells about how long all takes.
    fn begin(&mut self, first: &SolvedFrame) -> Result<(), CliError> {
        let count = self.wanted.len();
        let (shutter, scene, ranks) = (&self.shutter, self.scene, self.work.ranks);
        if shutter.files.is_some() {
            let film = shutter.film(scene, &first.frame);
            let shown = shutter.shown(first, true);
            let each = shutter.asked.in_threads(ranks, || film.seconds(&shown, &Work::among(ranks)))?;
            self.progress.ledger().expect(Stage::Picture, count as f64 * each);
            self.film = Some(film);
        }
        let others = self.range.count().saturating_sub(1) as f64;
        let more = [(Stage::Direct, others), (Stage::Blocks, FOLLOWING * others)].map(|(stage, frames)| {
            let more = frames * self.progress.ledger().forecast(stage);
            self.progress.ledger().expect(stage, more);
            more
        });
        let pictures = self.progress.ledger().forecast(Stage::Picture);
        let seconds = self.progress.seconds(more.iter().sum::<f64>() + pictures);
        let time = TimeLeft::new(self.begun, count, seconds);
        self.progress.announce(&format!("{count} frames"), time.seconds(0));
        self.time = Some(time);
        Ok(())
    }

    /// Takes what is wanted of a stretch.
    fn take(&mut self, solved: &[SolvedFrame], wanted: &[usize], first: usize) -> Result<(), CliError> {
        let Self { shutter, film, progress, time, begun, work, .. } = self;
        let mut made = self.made;
        let count = self.wanted.len();
        let mut one = || {
            made += 1;
            progress.say_whole(standing(made, count, *begun, time.as_ref()));
        };
        let asked = shutter.asked;
        asked.in_threads(work.ranks, || shutter.record(solved, wanted, film.as_mut(), first, &mut one))??;
        self.made = made;
        Ok(())
    }

    /// Tells about how long the frames that are left take, every so often.
    fn tell(&mut self) {
        let count = self.wanted.len();
        let is_due = self.made >= self.told + TOLD_EACH && self.made < count;
        if let Some(time) = self.time.filter(|_| is_due) {
            let left = time.seconds(self.made);
            self.progress.announce(&format!("{} of {count} frames are made, the others", self.made), left);
            self.told = self.made;
        }
    }

    fn standing(&self) -> String {
        standing(self.made, self.wanted.len(), self.begun, self.time.as_ref())
    }
}

/// Progress of the frames in words: so many of `count` were made, and about how long the others take.
fn standing(made: usize, count: usize, begun: Instant, time: Option<&TimeLeft>) -> String {
    let rate = made as f64 / begun.elapsed().as_secs_f64();
    let rate = if made > 0 { format!(", {rate:.2} a second") } else { String::new() };
    let left = time.map(|time| format!(", {:.0} s left", time.seconds(made))).unwrap_or_default();
    format!("; {made} of {count} frames{rate}{left}")
}
