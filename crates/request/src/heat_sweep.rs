//! Sweeps: balances of heat for some values of a temperature, a flux or an emissivity, by transfers found once.

use std::collections::BTreeMap;
use std::mem::replace;
use std::str::FromStr;

use radiosity_audit::HeatFault;
use radiosity_heat::{Heat, HeatError, HeatModel, SurfaceHeat};
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

/// The balances of a sweep, of which `K` is kept.
#[derive(Debug)]
pub struct SweptHeat<K> {
    /// The balance of the largest flows, which alone a referee checked.
    pub largest: Heat,
    /// The number of its value.
    pub point: usize,
    /// Its scene.
    pub scene: Scene,
    /// Why no referee could read it, where none could.
    pub unchecked: Option<HeatFault>,
    /// The others, by the numbers of their values.
    others: BTreeMap<usize, K>,
}

/// Why a sweep has no balances.
#[derive(Debug, thiserror::Error)]
pub enum SweepError {
    /// A name or a value that does not fit the scene.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A value at which there is no balance.
    #[error(transparent)]
    Heat(#[from] HeatError),
}

/// A balance at one of the values.
struct SweptPoint {
    point: usize,
    heat: Heat,
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

    /// The balances of `scene` at all values, of which there is one at least. A referee checks the one of the largest
    /// flows: where nothing flows, none can be seen to be off. Errors of the others grow as its errors do.
    ///
    /// # Errors
    /// A name, a key or a value that does not fit the scene, before the work; as [`Heat::of`], of any of them.
    pub fn balances<K: From<Heat> + AsMut<[SurfaceHeat]>>(
        &self,
        scene: &Scene,
        options: &Options,
        check: &CheckRequest,
        work: &Work<'_>,
    ) -> Result<SweptHeat<K>, SweepError> {
        let at = |point: usize| scene.with_heat(&self.setting, self.values[point]);
        let [least, greatest] = self.ends();
        at(least)?;
        at(greatest)?;
        let first = if self.setting.is_of_emissivity() { least } else { 0 };
        let (mut model, heat) = HeatModel::of(&at(first)?, options, work)?;
        let mut largest = SweptPoint { point: first, heat };
        let mut others = BTreeMap::new();
        let count = self.values.len();
        for (made, point) in self.spread_from(first).into_iter().skip(1).enumerate() {
            work.report_done(Stage::Runs, made + 1, count);
            let own = SweptPoint { point, heat: model.balance(&at(point)?, work)? };
            let is_larger = own.heat.flows() > largest.heat.flows();
            let smaller = if is_larger { replace(&mut largest, own) } else { own };
            others.insert(smaller.point, K::from(smaller.heat));
        }
        work.report_done(Stage::Runs, count, count);
        let SweptPoint { point, heat: mut largest } = largest;
        let scene = at(point)?;
        let checking = || check.check_heat(&mut largest, &scene, options.shadows, work);
        let unchecked = options.in_threads(work.ranks, checking).map_err(HeatError::from)?.err();
        others.values_mut().for_each(|own| largest.check_others(own.as_mut()));
        Ok(SweptHeat { largest, point, scene, unchecked, others })
    }

    /// The numbers of the values from this one on, each as far as can be from those before it: light of what lies
    /// between them follows from theirs.
    fn spread_from(&self, first: usize) -> Vec<usize> {
        let mut distances = vec![f64::INFINITY; self.values.len()];
        let mut order = vec![first];
        while let Some(last) = order.last().copied().filter(|_| order.len() < self.values.len()) {
            let from_last = self.values.iter().map(|value| (value - self.values[last]).abs());
            distances.iter_mut().zip(from_last).for_each(|(own, other)| *own = own.min(other));
            // Equal values are 0 apart, and none comes twice.
            distances[last] = f64::NEG_INFINITY;
            order.extend((0..distances.len()).max_by(|a, b| distances[*a].total_cmp(&distances[*b])));
        }
        order
    }

    /// The numbers of the least and the greatest value: all others fit a scene where these do.
    fn ends(&self) -> [usize; 2] {
        let order = |a: &usize, b: &usize| self.values[*a].total_cmp(&self.values[*b]);
        let all = || 0..self.values.len();
        [all().min_by(order), all().max_by(order)].map(|end| end.unwrap_or(0))
    }
}

impl<K: From<Heat>> SweptHeat<K> {
    /// All balances in the order of the values.
    pub fn into_balances(mut self) -> Vec<K> {
        self.others.insert(self.point, K::from(self.largest));
        self.others.into_values().collect()
    }
}

/// Decimal places of the least number that is not 0.
const MOST_PLACES: f64 = 324.0;

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
        if to.trim().starts_with('.') {
            let digits = to.trim().trim_start_matches('.');
            return Err(format!(
                "more than two points stand there: write {from}..{digits}, or {from}..0.{digits}"
            ));
        }
        let number = |text: &str| text.trim().parse().ok().filter(|own: &f64| own.is_finite());
        let (Some(from), Some(to)) = (number(from), number(to)) else { return Err(expected()) };
        let count = count.trim().parse::<Points>()?.count();
        Ok(Self::new(setting(name.trim())?, spread(from, to, count)))
    }
}

/// So many values from one to another, two at the least.
fn spread(from: f64, to: f64, count: usize) -> Vec<f64> {
    let last = (count - 1) as f64;
    let scale = from.abs().max(to.abs());
    let value = |point: usize| match point as f64 {
        0.0 => from,
        own if own == last => to,
        own => short(from + (to - from) * own / last, scale),
    };
    (0..count).map(value).collect()
}

/// The decimal of 15 digits of `scale` that a number is but for its rounding, such as 0.3 for 0.30000000000000004; or
/// the number.
fn short(number: f64, scale: f64) -> f64 {
    let places = (14.0 - scale.log10().floor()).clamp(0.0, MOST_PLACES) as usize;
    let decimal = format!("{number:.places$}").parse().unwrap_or(number) + 0.0;
    if (decimal - number).abs() <= 2.0 * f64::EPSILON * scale { decimal } else { number }
}
