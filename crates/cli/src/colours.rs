//! Options of pictures in false colours, of a camera or of a plane.

use std::str::FromStr;

use clap::Args;
use radiosity_output::drawings::false_colour::FalseColours;
use radiosity_output::drawings::nice_numbers::{round_above, round_around, round_below};
use radiosity_output::drawings::scale::{DEEPEST, Scale};
use radiosity_output::drawings::tick::Tick;
use radiosity_scene::Scene;
use radiosity_work::digits::short;

use crate::error::CliError;

/// How numbers become colours.
#[derive(Debug, Args)]
#[command(next_help_heading = "False colours")]
pub(crate) struct ColourArgs {
    /// Numbers at the ends of the legend [default: chosen for the picture, emitters left out]
    #[arg(long, value_name = "LO,HI", allow_hyphen_values = true, value_parser = range)]
    pub(crate) range: Option<[f64; 2]>,

    /// Band that is shown [default: mean of all]
    #[arg(long, value_name = "NAME")]
    pub(crate) band: Option<String>,

    /// Equal ratios between neighbouring colours and isolines instead of equal differences
    #[arg(long)]
    pub(crate) log: bool,

    /// Isolines with their values: round ones, or those given, such as 100,200,500; a SCENE stands before it
    #[arg(long, value_name = "LEVELS", num_args = 0..=1, default_missing_value = "auto")]
    pub(crate) isolines: Option<Isolines>,
}

/// `--range`: two numbers that ascend.
fn range(text: &str) -> Result<[f64; 2], &'static str> {
    let numbers = text.split_once(',').and_then(|(low, high)| Some([number(low)?, number(high)?]));
    let ascending = numbers.filter(|[low, high]| low < high);
    ascending.ok_or("expected two numbers that ascend with a comma between, such as 0,2.5")
}

/// `--isolines`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Isolines {
    /// Isolines at round values.
    Round,
    /// Isolines at these values.
    At(Vec<f64>),
}

impl FromStr for Isolines {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == "auto" {
            return Ok(Self::Round);
        }
        let numbers: Option<Vec<f64>> = text.split(',').map(number).collect();
        numbers.map(Self::At).ok_or_else(|| {
            "expected numbers with commas between, such as 100,200,500, or nothing; what follows, such as a SCENE, goes \
             before --isolines"
                .into()
        })
    }
}

fn number(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|x: &f64| x.is_finite())
}

impl ColourArgs {
    /// The options that were typed.
    pub(crate) fn typed(&self) -> Vec<&'static str> {
        let options = [
            ("--range", self.range.is_some()),
            ("--band", self.band.is_some()),
            ("--log", self.log),
            ("--isolines", self.isolines.is_some()),
        ];
        options.into_iter().filter(|(_, typed)| *typed).map(|(option, _)| option).collect()
    }

    /// Refuses options of a picture that is not drawn.
    pub(crate) fn require_picture(&self, is_drawn: bool) -> Result<(), CliError> {
        match self.typed()[..] {
            [option, ..] if !is_drawn => Err(CliError::refused(
                format!("{option} speaks of a picture"),
                "add --picture FILE.png, or leave it out",
            )),
            _ => Ok(()),
        }
    }

    /// Refuses a range that has no logarithms.
    pub(crate) fn check(&self) -> Result<(), CliError> {
        match self.range {
            Some([low, _]) if self.log && low <= 0.0 => Err(CliError::refused(
                format!("--log: there is no logarithm of {low}, the lower end of --range"),
                "choose a lower end above 0, such as --range 1,1000",
            )),
            _ => Ok(()),
        }
    }

    /// The index of the band, if one was typed.
    pub(crate) fn band(&self, scene: &Scene) -> Result<Option<usize>, CliError> {
        Ok(self.band.as_ref().map(|name| scene.band_named(name)).transpose()?)
    }

    /// The colours of values that lie in the range `usual` for the most part.
    pub(crate) fn colours(&self, usual: [f64; 2]) -> FalseColours {
        self.lined(self.scale(usual), usual)
    }

    /// The colours of values such as temperatures, of which 0 is no natural end: from the lowest to the
    /// highest.
    pub(crate) fn colours_between(&self, usual: [f64; 2]) -> FalseColours {
        let is_open = self.range.is_none() && !self.log;
        let scale = if is_open { Scale::sequential(round_around(usual)) } else { self.scale(usual) };
        self.lined(scale, usual)
    }

    fn lined(&self, scale: Scale, usual: [f64; 2]) -> FalseColours {
        let colours = FalseColours { scale, isolines: Vec::new() };
        match &self.isolines {
            None => colours,
            Some(Isolines::Round) => colours.with_round_isolines(usual),
            Some(Isolines::At(values)) => {
                let tick = |value: &f64| Tick { value: *value, text: short(*value) };
                FalseColours { isolines: values.iter().map(tick).collect(), ..colours }
            }
        }
    }

    /// The colours of a plan with values in `range`, which has round isolines where none were typed.
    pub(crate) fn of_plan(&self, range: [f64; 2]) -> FalseColours {
        let colours = self.colours(range);
        if self.isolines.is_none() { colours.with_round_isolines(range) } else { colours }
    }

    fn scale(&self, [low, high]: [f64; 2]) -> Scale {
        let highest = round_above(high);
        match self.range {
            Some(range) if self.log => Scale::logarithmic(range),
            Some(range) => Scale::sequential(range),
            None if self.log => {
                let lowest = round_below(low.max(DEEPEST * highest));
                Scale::logarithmic([if lowest < highest { lowest } else { 0.1 * highest }, highest])
            }
            None => Scale::sequential([0.0, highest]),
        }
    }
}
