//! The referee's verdict on printed numbers.
//!
//! Of n readings Ê_i with the unbiased means M_i ± s_i, independent of Ê_i, and d_i = Ê_i − M_i,
//!
//! ```text
//! err² = Σ (d_i² − s_i²) / Σ (M_i² − s_i²)
//! ```
//!
//! is the square of their relative error in the L2 mean, numerator and denominator unbiased; it may be negative.
//! Its standard error follows from the spread of the n terms, t_i = d_i² − s_i² − err² (M_i² − s_i²),
//!
//! ```text
//! SE² = n/(n − 1) Σ t_i² / (Σ (M_i² − s_i²))² .
//! ```
//!
//! If the readings are right, d_i² − s_i² has the variance 2 σ⁴ (1 + 1/ν), where s_i² has ν = 7 degrees of
//! freedom and σ⁴ is found from s⁴ ν/(ν + 2). By this *chance* alone err² has the standard error SE₀, and an
//! error of √(3 SE₀) can be seen. Means of signed differences (`signed_mean`) see smaller
//! faults of one sign.
//!
//! By chance Σ d² / Σ s² is a ratio of F(h, 7 h), with h as `chance` has it.

use serde::Serialize;

use crate::chance::{FINDING, FREEDOM, normal_of_ratio, normal_of_student, student_of_normal, threshold};
use crate::referee::{Estimate, Mean};
use crate::signed_mean::{SignedDifferences, SignedMean};

/// Standard errors beyond which an error is taken for more than chance where it makes others larger. Chosen.
const BEYOND: f64 = 2.0;

/// Part of the mean below which no single reading is named.
const NEGLIGIBLE: f64 = 0.01;

/// A printed number of each band beside what the referee found.
#[derive(Clone, Debug)]
pub struct Judged {
    /// The printed numbers, one for each band.
    pub printed: Vec<f64>,
    /// The light of each group by itself, in the order of the estimate's; empty where it was not printed.
    pub printed_groups: Vec<Vec<f64>>,
    /// The estimate of the referee.
    pub estimate: Estimate,
    /// Size in whose proportion readings of as many walks err: of the flow of a surface what it absorbs at the
    /// irradiance 1; 1 of light at points.
    pub size: f64,
    /// Name of the class that it belongs to: a surface or a plane.
    pub class: String,
}

/// The verdict on a run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Verdict {
    /// err², which may be negative.
    pub squared: f64,
    /// Its standard error, from the spread of the readings.
    pub squared_error: f64,
    /// Its standard error SE₀ if all readings were right.
    pub by_chance: f64,
    /// Square of the relative noise of the referee, Σ s² over the denominator of err².
    pub noise_squared: f64,
    /// Number h of equal readings that tell as much.
    pub equal_readings: f64,
    /// Readings.
    pub readings: usize,
    /// Rays that were traced.
    pub rays: u64,
    /// Means of signed differences, those that exceed chance most first.
    pub signed: Vec<SignedMean>,
    /// The readings that differ most, in order of what they add to err².
    pub worst: Vec<WorstReading>,
}

/// A reading that differs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WorstReading {
    /// Its number.
    pub reading: usize,
    /// Name of its surface or plane.
    pub of: String,
    /// The band that differs most.
    pub band: usize,
    /// The printed number.
    pub printed: f64,
    /// The mean that the referee found.
    pub found: Mean,
    /// Whether it differs by more than chance, by its own error and by that of all readings together, and by a
    /// hundredth of the mean.
    pub is_outlier: bool,
}

impl Verdict {
    /// Readings that are named as the worst. Chosen: as many as a person looks at.
    pub const WORST: usize = 10;

    /// The verdict on some readings, of which `worst` are named; nothing is said of light groups.
    pub fn of(judged: &[Judged], worst: usize) -> Self {
        Self::by_groups(judged, &[], worst)
    }

    /// The verdict on some readings, with signed means of the light groups of these names too, where their
    /// light was printed.
    pub(crate) fn by_groups(judged: &[Judged], groups: &[Option<String>], worst: usize) -> Self {
        let terms: Vec<Terms> = judged.iter().map(Terms::of).collect();
        let count = terms.len() as f64;
        // Where all is dark, whatever is printed is infinitely off.
        let below = sum(&terms, |own| own.below).max(f64::MIN_POSITIVE);
        let squared = sum(&terms, |own| own.above) / below;
        let spread = sum(&terms, |own| (own.above - squared * own.below).powi(2));
        let chance = sum(&terms, |own| own.chance_squared);
        let noise = sum(&terms, |own| own.noise);
        Self {
            squared,
            squared_error: (spread * count / (count - 1.0).max(1.0)).sqrt() / below,
            by_chance: chance.sqrt() / below,
            noise_squared: noise / below,
            equal_readings: noise * noise / sum(&terms, |own| own.noise * own.noise),
            readings: judged.len(),
            rays: judged.iter().map(|own| own.estimate.rays).sum(),
            signed: signed_means(judged, groups, below),
            worst: worst_readings(judged, &terms, (below / count).max(0.0).sqrt(), worst),
        }
    }

    /// Σ (M² − s²) over all bands: the square of the size that relative errors are of.
    pub(crate) fn size(judged: &[Judged]) -> f64 {
        judged.iter().map(|own| Terms::of(own).below).sum::<f64>().max(f64::MIN_POSITIVE)
    }

    /// The L2 mean of what is true, over readings and bands; 0 of none.
    pub(crate) fn mean(judged: &[Judged]) -> f64 {
        let numbers: usize = judged.iter().map(|own| own.printed.len()).sum();
        if numbers == 0 { 0.0 } else { (Self::size(judged) / numbers as f64).sqrt() }
    }

    /// The readings that are off by more than chance, with the root mean square over their bands of what they are off
    /// by at least: by all of the difference where that is a hundredth of the mean as well and as seldom as a finding
    /// among all readings, elsewhere by what is beyond three standard errors of all, and beyond what exceeds its own,
    /// estimated standard error as seldom.
    pub(crate) fn off(judged: &[Judged]) -> Vec<(usize, f64)> {
        let (pooled, mean) = (pooled_error(judged), (Self::size(judged) / judged.len().max(1) as f64).sqrt());
        let few = student_of_normal(FINDING, FREEDOM);
        let of = |(number, own): (usize, &Judged)| {
            let pooled = pooled * own.size;
            let pairs = || own.printed.iter().zip(&own.estimate.bands);
            let is_off =
                |(printed, found): (&f64, &Mean)| is_outlier(*printed, found, pooled, mean, judged.len());
            let is_any_off = pairs().any(is_off);
            let chance = |found: &Mean| match is_any_off {
                true => 0.0,
                false => (few * found.error).max(FINDING * pooled),
            };
            let beyond =
                |(printed, found): (&f64, &Mean)| ((printed - found.value).abs() - chance(found)).max(0.0);
            let squares: f64 = pairs().map(|pair| beyond(pair).powi(2)).sum();
            (squares > 0.0).then(|| (number, (squares / own.printed.len() as f64).sqrt()))
        };
        judged.iter().enumerate().filter_map(of).collect()
    }

    /// The relative error in the L2 mean: √err², 0 where that is negative.
    pub fn error(&self) -> f64 {
        self.squared.max(0.0).sqrt()
    }

    /// The standard error of [`Verdict::error`]: the step to [`Verdict::bound`].
    pub fn error_sd(&self) -> f64 {
        self.bound() - self.error()
    }

    /// The least relative error that would have been seen, √(3 SE₀).
    pub fn visible(&self) -> f64 {
        (FINDING * self.by_chance).sqrt()
    }

    /// An error that the true one hardly exceeds: √(err² and its standard error).
    pub fn bound(&self) -> f64 {
        (self.squared.max(0.0) + self.squared_error.max(self.by_chance)).sqrt()
    }

    /// The factor κ ≥ 1 by which a method's own estimates of the relative error `own` in the L2 mean are too small,
    ///
    /// ```text
    /// κ² = max(1, (err² + SE) / own²)     where err² > 2 SE, else 1 .
    /// ```
    ///
    /// By chance alone that is so once in forty right runs; of one SE it was in every sixth.
    pub fn factor(&self, own: f64) -> f64 {
        let found = self.found_squared().filter(|_| own > 0.0);
        found.map_or(1.0, |found| (found.sqrt() / own).max(1.0))
    }

    /// The relative error that own estimates of `own` in the L2 mean miss, √(err² + SE − own²): 0 where κ is 1, and all
    /// that was found where they tell nothing, which no factor makes more.
    pub(crate) fn missed(&self, own: f64) -> f64 {
        self.found_squared().map_or(0.0, |found| (found - own * own).max(0.0).sqrt())
    }

    /// err² + SE, where err² > 2 SE.
    fn found_squared(&self) -> Option<f64> {
        let error = self.squared_error.max(self.by_chance);
        (self.squared > BEYOND * error).then_some(self.squared + error)
    }

    /// Whether the readings differ by more than chance from what is true and by more than `told`, the relative
    /// error that the run tells: in the L2 mean, in a signed mean, or in single readings.
    pub fn finds(&self, told: f64) -> bool {
        self.exceeds(told) || self.signed.iter().any(|own| own.finds(told))
    }

    /// The readings, at most `most`, that make it find more than `told`, in order of what they differ by in
    /// standard errors: of the classes whose signed means exceed it, or all where the L2 mean or the mean of a
    /// light group does.
    pub(crate) fn standing_out(&self, judged: &[Judged], told: f64, most: usize) -> Vec<usize> {
        let found: Vec<&SignedMean> = self.signed.iter().filter(|own| own.finds(told)).collect();
        let is_of_all = self.exceeds(told) || found.iter().any(|own| own.is_group);
        let is_meant = |own: &Judged| is_of_all || found.iter().any(|class| class.of == own.class);
        let scored = judged.iter().enumerate().filter(|(_, own)| is_meant(own));
        let mut order: Vec<(usize, f64)> = scored.map(|(reading, own)| (reading, own.score())).collect();
        order.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
        order.into_iter().take(most).map(|(reading, _)| reading).collect()
    }

    /// Whether the error in the L2 mean exceeds `told` by more than chance: by that of the walks, and, where an
    /// error is told, by that of the choice of the readings.
    pub fn exceeds(&self, told: f64) -> bool {
        let above = self.squared - told * told;
        if told > 0.0 && above < self.squared_error {
            return false;
        }
        if self.noise_squared <= 0.0 {
            return above > 0.0;
        }
        let ratio = 1.0 + above / self.noise_squared;
        normal_of_ratio(ratio, self.equal_readings, FREEDOM * self.equal_readings) > FINDING
    }
}

impl Judged {
    /// A single number, printed and found by so many rays.
    pub fn of_number(class: &str, printed: f64, found: Mean, rays: u64) -> Self {
        Self {
            printed: vec![printed],
            printed_groups: Vec::new(),
            estimate: Estimate { bands: vec![found], groups: Vec::new(), rays },
            size: 1.0,
            class: class.to_owned(),
        }
    }

    /// The found number, all bands together.
    pub fn found(&self) -> f64 {
        self.estimate.bands.iter().map(|mean| mean.value).sum()
    }

    /// Printed less found, all bands together.
    pub fn difference(&self) -> f64 {
        self.printed.iter().sum::<f64>() - self.found()
    }

    /// Printed less found over the size of what was found, all bands together.
    pub fn relative(&self) -> f64 {
        self.difference() / self.found().abs()
    }

    /// Printed less found in standard errors, all bands together: bands of one walk err together.
    pub fn in_errors(&self) -> f64 {
        let difference = self.difference();
        let error: f64 = self.estimate.bands.iter().map(|mean| mean.error).sum();
        if difference == 0.0 { 0.0 } else { difference / error }
    }

    /// The largest difference of its bands over its standard error.
    fn score(&self) -> f64 {
        let pairs = self.printed.iter().zip(&self.estimate.bands);
        let scores = pairs.map(|(printed, mean)| {
            let difference = (printed - mean.value).abs();
            if difference > 0.0 { difference / mean.error } else { 0.0 }
        });
        scores.fold(0.0, f64::max)
    }
}

/// Parts of a reading in sums over readings, all bands together.
struct Terms {
    above: f64,
    below: f64,
    /// s², bands added as they err.
    noise: f64,
    chance_squared: f64,
}

impl Terms {
    fn of(judged: &Judged) -> Self {
        let mut terms = Self { above: 0.0, below: 0.0, noise: 0.0, chance_squared: 0.0 };
        for (printed, mean) in judged.printed.iter().zip(&judged.estimate.bands) {
            let variance = mean.error * mean.error;
            terms.above += (printed - mean.value).powi(2) - variance;
            terms.below += mean.value * mean.value - variance;
            terms.noise += variance;
            let fourth = variance * variance * FREEDOM / (FREEDOM + 2.0);
            // Bands of one walk err together: their standard deviations add up, not their variances.
            terms.chance_squared += (2.0 * (1.0 + 1.0 / FREEDOM) * fourth).sqrt();
        }
        terms.chance_squared *= terms.chance_squared;
        terms
    }
}

fn sum(terms: &[Terms], value: impl Fn(&Terms) -> f64) -> f64 {
    terms.iter().map(value).sum()
}

/// Means of signed differences by class and by light group; `squares` is the sum of the squares of what is true.
fn signed_means(judged: &[Judged], groups: &[Option<String>], squares: f64) -> Vec<SignedMean> {
    let numbers: usize = judged.iter().map(|own| own.printed.len()).sum();
    let mut all = SignedDifferences::default();
    for own in judged {
        all.add(&own.class, &own.printed, &own.estimate.bands);
        for ((group, printed), means) in groups.iter().zip(&own.printed_groups).zip(&own.estimate.groups) {
            all.add_of_group(group.as_deref(), printed, means);
        }
    }
    all.means((squares.max(0.0) / numbers as f64).sqrt())
}

/// Standard error of all readings that can err, over their sizes, its root mean square: where a few of many walks
/// bring most of the light, readings that got none of it tell too small an error.
fn pooled_error(judged: &[Judged]) -> f64 {
    let of = |own: &Judged| own.estimate.bands.iter().map(|mean| mean.error / own.size).collect::<Vec<f64>>();
    let errors = || judged.iter().filter(|own| own.size > 0.0).flat_map(of);
    (errors().map(|error| error * error).sum::<f64>() / errors().count().max(1) as f64).sqrt()
}

/// Whether a printed number is off by more than chance, by its own error and by the `pooled` one, as the largest of
/// `count` is, and by a hundredth of the `mean`.
fn is_outlier(printed: f64, found: &Mean, pooled: f64, mean: f64, count: usize) -> bool {
    let difference = (printed - found.value).abs();
    let seldom = normal_of_student(difference / found.error.max(pooled), FREEDOM) > threshold(count);
    seldom && difference > NEGLIGIBLE * mean
}

/// The readings that add most to err²; `mean` is the L2 mean of what is true.
fn worst_readings(judged: &[Judged], terms: &[Terms], mean: f64, count: usize) -> Vec<WorstReading> {
    let pooled = pooled_error(judged);
    let mut order: Vec<usize> = (0..judged.len()).collect();
    order.sort_by(|a, b| terms[*b].above.total_cmp(&terms[*a].above).then(a.cmp(b)));
    let named = |reading: &usize| {
        let own = &judged[*reading];
        let pairs = || own.printed.iter().copied().zip(own.estimate.bands.iter().copied()).enumerate();
        let off = |(_, (printed, found)): &(usize, (f64, Mean))| (printed - found.value).abs();
        let (band, (printed, found)) = pairs().max_by(|a, b| off(a).total_cmp(&off(b)))?;
        let is_outlier = is_outlier(printed, &found, pooled * own.size, mean, judged.len());
        Some(WorstReading { reading: *reading, of: own.class.clone(), band, printed, found, is_outlier })
    };
    order.iter().take(count).filter_map(named).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A reading of two bands and two light groups that was printed so, where 2 was found of each group and band.
    fn reading(class: &str, printed: [[f64; 2]; 2]) -> Judged {
        let mean = |value: f64| Mean { value, error: 0.01 * value };
        Judged {
            printed: vec![printed[0][0] + printed[1][0], printed[0][1] + printed[1][1]],
            printed_groups: printed.iter().map(|group| group.to_vec()).collect(),
            estimate: Estimate { bands: vec![mean(4.0); 2], groups: vec![vec![mean(2.0); 2]; 2], rays: 1 },
            size: 1.0,
            class: class.to_owned(),
        }
    }

    /// In one group half of the light is missing, in the other nothing.
    #[test]
    fn light_groups_have_means_of_their_own() {
        let judged: Vec<Judged> = (0..8).map(|_| reading("wall", [[2.0; 2], [1.0; 2]])).collect();
        let verdict = Verdict::by_groups(&judged, &[None, Some("lamps".to_owned())], 0);
        let of = |name: &str| verdict.signed.iter().find(|own| own.of == name).expect("it is there");
        assert!((of("wall").relative + 0.25).abs() < 1e-12);
        assert!((of("group lamps").relative + 0.5).abs() < 1e-12);
        assert_eq!(of("group (none)").relative, 0.0);
        assert_eq!(verdict.signed[0].of, "group lamps", "it exceeds chance most");
        // The bands of a reading err together, its 8 readings do not: 2 · 0.02 √8 over 8 · 2 · 2.
        assert!((of("group lamps").error - 2.0 * 0.02 * 8f64.sqrt() / 32.0).abs() < 1e-12);
        assert!(verdict.signed.iter().filter(|own| own.is_group).count() == 2);
    }

    /// A surface on which a thousandth of the mean arrives is off by its half: for a run that tells one percent of
    /// the mean that is no finding, for one that tells nothing it is.
    #[test]
    fn what_is_dark_counts_as_a_part_of_the_mean() {
        let mut judged: Vec<Judged> = (0..8).map(|_| reading("wall", [[2.0; 2]; 2])).collect();
        let mut dark = reading("dark", [[0.0; 2]; 2]);
        dark.printed = vec![0.002; 2];
        dark.printed_groups.clear();
        dark.estimate.bands = vec![Mean { value: 0.004, error: 1e-5 }; 2];
        judged.push(dark);
        let verdict = Verdict::of(&judged, 0);
        assert_eq!(verdict.signed[0].of, "dark");
        assert!(verdict.signed[0].finds(0.0) && verdict.finds(0.0));
        assert!(!verdict.finds(0.01));
    }
}
