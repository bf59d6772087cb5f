//! The linear system of one band over a hierarchy.
//!
//! ```text
//! (I − S T S) y = S T E₀ ,     B = E₀ + S y ,     S = √(ρ/A)
//! ```
//!
//! The equation of `solve::system` on constants: with b = √A B it reads (I − √ρ G √ρ) y = √ρ G e, G = A^−½ T
//! A^−½. Leaves with ρ = 0 have no unknowns.

use radiosity_solvers::method::Method;
use radiosity_solvers::{Operator, Partition, Report, Settings, SolveError};
use radiosity_work::interruption::{self, Interruption, check_interrupt};

use super::network::Hierarchy;

/// I − S T S on the reflecting leaves.
#[derive(Debug)]
pub struct BandSystem<'a> {
    hierarchy: &'a Hierarchy,
    reflectance: Vec<f64>,
    exitance: Vec<f64>,
    /// Leaves with ρ > 0, ascending.
    reflecting: Vec<usize>,
    /// √(ρ/A) of each reflecting leaf.
    scale: Vec<f64>,
    /// 1 − ρ T_ii/A of each reflecting leaf.
    diagonal: Vec<f64>,
    partition: Partition,
}

impl<'a> BandSystem<'a> {
    /// The system for a reflectance ρ ∈ [0, 1) and an exitance (W m⁻²) of each surface.
    pub fn new(hierarchy: &'a Hierarchy, reflectance: &[f64], exitance: &[f64]) -> Self {
        let leaves = hierarchy.leaves();
        let of_leaf = |values: &[f64]| leaves.iter().map(|leaf| values[leaf.surface]).collect::<Vec<f64>>();
        let (reflectance, exitance) = (of_leaf(reflectance), of_leaf(exitance));
        let reflecting: Vec<usize> = (0..leaves.len()).filter(|leaf| reflectance[*leaf] > 0.0).collect();
        let own = hierarchy.own();
        let scale = |leaf: &usize| (reflectance[*leaf] / leaves[*leaf].area).sqrt();
        let scale: Vec<f64> = reflecting.iter().map(scale).collect();
        let rest = |(leaf, scale): (&usize, &f64)| 1.0 - scale * scale * own[*leaf];
        let diagonal = reflecting.iter().zip(&scale).map(rest).collect();
        let partition = Partition::points(reflecting.len());
        Self { hierarchy, reflectance, exitance, reflecting, scale, diagonal, partition }
    }

    /// S T E₀ on the reflecting leaves.
    fn right_hand_side(&self) -> Vec<f64> {
        self.received(&self.hierarchy.exchange(&self.exitance))
    }

    /// E₀ of all leaves (W m⁻²).
    pub fn exitance(&self) -> &[f64] {
        &self.exitance
    }

    /// Solves the system. Returns the radiosity of all leaves (W m⁻²), and what the solver tells.
    ///
    /// # Errors
    /// Errors of the solver.
    pub fn solve(&self, method: &Method, settings: &Settings<'_>) -> Result<(Vec<f64>, Report), SolveError> {
        let right = self.right_hand_side();
        let mut unknowns = vec![0.0; right.len()];
        let interruption = interruption::current();
        let settings = settings.clone().with_cancel(interruption.as_ref().map(Interruption::flag));
        let report = method.solver.solve(self, &right, &mut unknowns, &settings, &mut |_| check_interrupt());
        // Where it was cancelled.
        check_interrupt();
        let report = report?;
        let mut radiosity = self.exitance.clone();
        for ((leaf, scale), y) in self.reflecting.iter().zip(&self.scale).zip(&unknowns) {
            radiosity[*leaf] += scale * y;
        }
        Ok((radiosity, report))
    }

    /// ‖B − E₀ − ρ T B/A‖₂ / ‖E₀‖₂ of a radiosity, by area; 0 if nothing emits.
    pub fn residual(&self, radiosity: &[f64]) -> f64 {
        let leaves = self.hierarchy.leaves();
        let square = |values: &mut dyn Iterator<Item = f64>| -> f64 {
            values.zip(leaves).map(|(value, leaf)| leaf.area * value * value).sum()
        };
        let next = self.radiosity(&self.gather(radiosity));
        let missed = square(&mut radiosity.iter().zip(&next).map(|(own, next)| own - next));
        let emitted = square(&mut self.exitance.iter().copied());
        if emitted > 0.0 { (missed / emitted).sqrt() } else { 0.0 }
    }

    /// Radiosity of all leaves (W m⁻²) under an irradiance, B = E₀ + ρ E.
    pub(super) fn radiosity(&self, irradiance: &[f64]) -> Vec<f64> {
        let lit =
            self.reflectance.iter().zip(irradiance).map(|(reflectance, irradiance)| reflectance * irradiance);
        self.exitance.iter().zip(lit).map(|(exitance, lit)| exitance + lit).collect()
    }

    /// Irradiance T B/A of all leaves (W m⁻²) from their radiosity.
    pub(super) fn gather(&self, radiosity: &[f64]) -> Vec<f64> {
        let power = self.hierarchy.exchange(radiosity);
        self.hierarchy.leaves().iter().zip(power).map(|(leaf, power)| power / leaf.area).collect()
    }

    /// The gathering of 1991: B ← E₀ + ρ T B/A from B = E₀ on, until no radiosity changes by more than
    /// `tolerance` of the greatest one, or `most` times. Returns B (W m⁻²) and the number of gatherings.
    pub fn gathered(&self, tolerance: f64, most: usize) -> (Vec<f64>, usize) {
        let mut radiosity = self.exitance.clone();
        for count in 1..=most {
            let next = self.radiosity(&self.gather(&radiosity));
            let (mut change, mut largest) = (0.0f64, 0.0f64);
            for (next, last) in next.iter().zip(&radiosity) {
                change = change.max((next - last).abs());
                largest = largest.max(next.abs());
            }
            radiosity = next;
            if change <= tolerance * largest {
                return (radiosity, count);
            }
        }
        (radiosity, most)
    }

    /// S Φ on the reflecting leaves.
    fn received(&self, power: &[f64]) -> Vec<f64> {
        self.reflecting.iter().zip(&self.scale).map(|(leaf, scale)| scale * power[*leaf]).collect()
    }

    /// S T S x, for x on the reflecting leaves from number `first` on.
    fn reflected(&self, first: usize, x: &[f64]) -> Vec<f64> {
        let mut radiosity = vec![0.0; self.reflectance.len()];
        for (k, x) in x.iter().enumerate() {
            radiosity[self.reflecting[first + k]] = self.scale[first + k] * x;
        }
        self.received(&self.hierarchy.exchange(&radiosity))
    }
}

impl Operator for BandSystem<'_> {
    fn partition(&self) -> &Partition {
        &self.partition
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        let reflected = self.reflected(0, x);
        y.iter_mut().zip(x).zip(reflected).for_each(|((y, x), r)| *y = x - r);
    }

    fn shoot(&self, column: usize, x: &[f64], y: &mut [f64]) {
        let reflected = self.reflected(column, x);
        y.iter_mut().zip(reflected).for_each(|(y, r)| *y -= r);
        y[column] += x[0];
    }

    fn diagonal(&self, block: usize, out: &mut [f64]) {
        out[0] = self.diagonal[block];
    }

    fn symmetric(&self) -> bool {
        true
    }
}
