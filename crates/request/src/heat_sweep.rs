//! Sweeps: balances of heat for some values of a temperature, a flux or an emissivity, by transfers found once.

use std::str::FromStr;

use radiosity_audit::HeatFault;
use radiosity_heat::{Heat, HeatError, HeatModel};
use radiosity_scene::{Fault, HeatSetting, Scene, SceneError};
use radiosity_solve::Options;
use radiosity_work::wording::Wording;
use radiosity_work::{Stage, Work};

use super::audit::CheckRequest;
use super::ranges::Points;

/// Values of a quantity of heat, for each of which a balance is wanted.
#[derive(Clone, Debug, PartialEq)]
pub struct HeatSweep {
    setting: HeatSetting,
    values: Vec<f64>,
}

/// The balances of a sweep.
#[derive(Debug)]
pub struct SweptHeat {
    /// One for each value, in their order.
    pub balances: Vec<Heat>,
    /// The number of the one by which transfers were found, and which alone a referee checked: the one that reflects
    /// most.
    pub first: usize,
    /// Why no referee could read it, where none could.
    pub unchecked: Option<HeatFault>,
}

impl HeatSweep {
    /// A sweep over these values.
    pub fn new(setting: HeatSetting, values: Vec<f64>) -> Self {
        Self { setting, values }
    }

    /// The quantity that is swept.
    pub fn setting(&self) -> &HeatSetting {
        &self.setting
    }

    /// Its values.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The scene at each value.
    ///
    /// # Errors
    /// A name, a key or a value that does not fit the scene.
    pub fn scenes(&self, scene: &Scene) -> Result<Vec<Scene>, SceneError> {
        self.values.iter().map(|value| scene.with_heat(&self.setting, *value)).collect()
    }

    /// The balances of the scenes of the sweep.
    ///
    /// # Errors
    /// As [`Heat::of`], of any of them.
    pub fn balances(
        &self,
        scenes: &[Scene],
        options: &Options,
        check: &CheckRequest,
        work: &Work<'_>,
    ) -> Result<SweptHeat, HeatError> {
        let first = self.first();
        let (mut model, mut checked) = HeatModel::of(&scenes[first], options, work)?;
        let checking = || check.check_heat(&mut checked, &scenes[first], options.shadows, work);
        let unchecked = options.in_threads(work.ranks, checking)?.err();
        let mut balances = Vec::with_capacity(scenes.len());
        for (point, scene) in scenes.iter().enumerate().filter(|(point, _)| *point != first) {
            let mut balance = model.balance(scene, work)?;
            balance.check_like(&checked);
            balances.push(balance);
            work.report_done(Stage::Runs, point + 1, scenes.len());
        }
        balances.insert(first, checked);
        Ok(SweptHeat { balances, first, unchecked })
    }

    /// The number of the value that reflects most.
    fn first(&self) -> usize {
        let order = |a: &(usize, &f64), b: &(usize, &f64)| a.1.total_cmp(b.1);
        let least = self.values.iter().enumerate().min_by(order).filter(|_| self.setting.is_of_emissivity());
        least.map_or(0, |(point, _)| point)
    }
}

/// The setting that a text names.
///
/// # Errors
/// The fault with its cure in a sentence.
fn setting(text: &str) -> Result<HeatSetting, String> {
    let told = |fault: Fault| {
        let cure = fault.advice().as_ref().map(Wording::to_string).unwrap_or_default();
        format!("{fault}; {cure}")
    };
    HeatSetting::named(text).map_err(told)
}

impl FromStr for HeatSweep {
    type Err = String;

    /// A sweep as typed: `panel.emissivity=0.1..0.9/17`.
    fn from_str(text: &str) -> Result<Self, String> {
        let expected = || {
            "expected a name with a key, two numbers and how many values, such as panel.emissivity=0.1..0.9/17"
                .to_owned()
        };
        let (name, range) = text.rsplit_once('=').ok_or_else(expected)?;
        let (ends, count) = range.rsplit_once('/').ok_or_else(expected)?;
        let (from, to) = ends.split_once("..").ok_or_else(expected)?;
        let number = |text: &str| text.trim().parse().ok().filter(|own: &f64| own.is_finite());
        let (Some(from), Some(to)) = (number(from), number(to)) else { return Err(expected()) };
        let count = count.trim().parse::<Points>()?.count();
        let last = (count - 1) as f64;
        let value = |point: usize| match point as f64 {
            own if own == last => to,
            own => from + (to - from) * own / last,
        };
        Ok(Self::new(setting(name.trim())?, (0..count).map(value).collect()))
    }
}
