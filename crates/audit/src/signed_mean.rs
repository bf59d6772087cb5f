//! Means of signed differences over the readings of a surface, a plane or a light group.
//!
//! By chance that of m readings has the standard error √(Σ s²)/m: it sees a fault of one sign two to three times
//! smaller than the L2 mean does.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::chance::{FINDING, FREEDOM, normal_of_student, threshold};
use crate::referee::Mean;

/// A mean of signed differences, printed less true.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SignedMean {
    /// Name of the surface or the plane; `group NAME` of a light group.
    pub of: String,
    /// Whether it is of a light group, over all readings.
    pub is_group: bool,
    /// Readings that it is a mean of.
    pub readings: usize,
    /// The mean difference over the size of the mean of what is true.
    pub relative: f64,
    /// Its standard error, by chance alone.
    pub error: f64,
    /// Degrees of freedom of that error.
    pub freedom: f64,
    /// True light in the mean over the L2 mean of all readings, 1 at the most; 1 for a light group.
    pub brightness: f64,
    /// Whether it exceeds chance.
    pub is_finding: bool,
}

impl SignedMean {
    /// The mean over its standard error, with its sign.
    pub fn in_errors(&self) -> f64 {
        self.relative / self.error
    }

    /// Whether it is a finding that exceeds `told` by more than chance. An error that is told is one of the L2
    /// mean: of what is darker than this, the difference counts as a part of that.
    pub fn finds(&self, told: f64) -> bool {
        let above = (self.relative.abs() - told / self.brightness) / self.error;
        self.is_finding && normal_of_student(above, self.freedom) > FINDING
    }

    /// The mean over its standard error, as of a normal number that is as seldom.
    fn score(&self) -> f64 {
        normal_of_student(self.in_errors().abs(), self.freedom)
    }
}

/// Signed differences of surfaces, planes and light groups.
#[derive(Default)]
pub(crate) struct SignedDifferences<'a> {
    classes: BTreeMap<Class<'a>, Differences>,
}

impl<'a> SignedDifferences<'a> {
    /// Adds a reading of a surface or plane, all bands of it.
    pub(crate) fn add(&mut self, class: &'a str, printed: &[f64], means: &[Mean]) {
        self.classes.entry(Class::Named(class)).or_default().add(printed, means);
    }

    /// Adds a reading of the light of a group, None for that of no group.
    pub(crate) fn add_of_group(&mut self, group: Option<&'a str>, printed: &[f64], means: &[Mean]) {
        self.classes.entry(Class::Group(group)).or_default().add(printed, means);
    }

    /// Their means, those that exceed chance most first; `all` is the L2 mean of what is true of all readings.
    pub(crate) fn means(self, all: f64) -> Vec<SignedMean> {
        let means = self.classes.into_iter().filter_map(|(class, sums)| sums.mean(&class, all));
        let mut means: Vec<SignedMean> = means.collect();
        let threshold = threshold(means.len());
        means.iter_mut().for_each(|own| own.is_finding = own.score() > threshold);
        means.sort_by(|a, b| b.score().total_cmp(&a.score()).then_with(|| a.of.cmp(&b.of)));
        means
    }
}

/// Subject of a signed mean.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum Class<'a> {
    /// A surface or a plane.
    Named(&'a str),
    /// A light group, or the light of no group.
    Group(Option<&'a str>),
}

impl Class<'_> {
    fn name(&self) -> String {
        match self {
            Self::Named(name) => (*name).to_owned(),
            Self::Group(name) => format!("group {}", name.unwrap_or("(none)")),
        }
    }
}

/// Sums over the readings of a class.
#[derive(Default)]
struct Differences {
    readings: usize,
    /// Readings times bands.
    numbers: usize,
    difference: f64,
    variance: f64,
    /// Sum of squares of the readings' variances.
    fourth: f64,
    found: f64,
}

impl Differences {
    /// Adds a reading, all bands of it.
    fn add(&mut self, printed: &[f64], means: &[Mean]) {
        // Bands of one walk err together: their standard errors add up, not the squares of them.
        let error: f64 = means.iter().map(|mean| mean.error).sum();
        self.difference += printed.iter().zip(means).map(|(printed, mean)| printed - mean.value).sum::<f64>();
        self.found += means.iter().map(|mean| mean.value).sum::<f64>();
        self.variance += error * error;
        self.fourth += error.powi(4);
        self.readings += 1;
        self.numbers += means.len();
    }

    /// The mean of a class; `all` is the L2 mean of all readings.
    fn mean(self, class: &Class<'_>, all: f64) -> Option<SignedMean> {
        let found = self.found.abs();
        let is_told = found > 0.0 && self.variance > 0.0;
        let is_group = matches!(class, Class::Group(_));
        let brightness = if is_group { 1.0 } else { (found / (self.numbers as f64 * all)).min(1.0) };
        is_told.then(|| SignedMean {
            of: class.name(),
            is_group,
            readings: self.readings,
            relative: self.difference / found,
            error: self.variance.sqrt() / found,
            freedom: FREEDOM * self.variance * self.variance / self.fourth,
            brightness,
            is_finding: false,
        })
    }
}
