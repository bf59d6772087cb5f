//! Self-checks of a solution.
//!
//! With c the coefficients of the constant 1, the closure r = c − G c vanishes in a closed scene; a row sum
//! is Σ_j F_ij = c_i·(G c)_i / A_i. Energy: emitted power is absorbed or lost,
//!
//! ```text
//! ∫E₀ dA = ∫(1 − ρ) E dA + ⟨B, c − G c⟩ ,
//! ```
//!
//! an identity of the discrete solution whatever the quadrature, up to the solver's residual (with Gᵀ c for G
//! c where G is not symmetric). Where direct light is split off, G transports only ρS, the radiosity of the
//! light that was reflected at least once, and the lost power is
//!
//! ```text
//! Φ + ∫(E₀ − D) dA + ∫(ρD − g) dA + ⟨ρS, c − G c⟩ ,
//! ```
//!
//! with the flux Φ of the luminaires. Where luminaires shine and nothing is split off it is ⟨b, c − G
//! c⟩ + Φ − ∫ L dA, with their irradiance L.
//!
//! Light that waits to be shot is neither absorbed nor lost: B is then what was shot.
//!
//! Either way the lost power in a closed room shows how well the integrals agree.

mod balance;
mod seams;

use radiosity_core::{dot, norm};
use radiosity_elements::Element;
use radiosity_elements::coating::Coating;
use radiosity_light::first_bounce::DirectLightEntry;
use radiosity_transport::Carrier;
use radiosity_work::ranks::Ranks;
use serde::{Deserialize, Serialize};

use crate::solution::powers::Powers;
use crate::solution::{Band, Solution};

pub(crate) use balance::{Balance, BandLight};
use seams::seam_jump;
pub use seams::{JointJump, joint_jump};

/// Most power iterations: enough for nine digits where the second eigenvalue is 0.6 of the first. Elsewhere
/// the bound is wider.
const MOST_STEPS: usize = 40;

/// Residual over eigenvalue at which power iterations end, below all digits that are told.
const SETTLED: f64 = 1e-9;

/// Residual over eigenvalue at which power iterations end for G by rays, whose noise is larger.
const SETTLED_BY_RAYS: f64 = 1e-3;

/// The self-checks of a solution. Powers are summed over bands, in the unit of exitance times scene length².
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Checks {
    /// Largest ‖c_i − (G c)_i‖ / ‖c_i‖ over the elements; about 0 in a closed scene. Here and in the row sums
    /// only elements count whose blocks were all computed ([`Carrier::is_complete`]) and which nothing
    /// covers.
    pub closure_max: f64,
    /// Smallest row sum Σ_j F_ij; 0 if no element counts.
    pub row_sum_min: f64,
    /// Largest row sum.
    pub row_sum_max: f64,
    /// Power that surfaces and luminaires emit, all bands together.
    pub energy_in: f64,
    /// Power that surfaces absorb, all bands together.
    pub energy_absorbed: f64,
    /// Power that leaves the scene.
    pub energy_lost: f64,
    /// Upper estimate of the spectral radius of ρG, largest over the bands; below 1 if the quadrature is
    /// good. 0 where columns of elements that reflect were not integrated, and where nobody looked for it.
    pub spectral_bound: f64,
    /// Largest jump of B across the seams inside a surface, relative to the larger of the two values.
    pub seam_jump_max: f64,
}

impl Checks {
    /// The checks of a solution computed with `blocks`, which these ranks hold, into which direct light
    /// entered by `entry`.
    pub fn of(solution: &Solution, blocks: &dyn Carrier, entry: &DirectLightEntry, ranks: &Ranks) -> Self {
        let points = solution.emitters().points;
        let bands = solution.bands().iter().enumerate();
        let light: Vec<BandLight<'_>> = bands.map(|(index, band)| lit(band, points.flux(index))).collect();
        let powers = Balance::of(solution.elements(), blocks).powers(&light, entry);
        Self::with_powers(solution, blocks, powers, largest_bound(solution, blocks, ranks))
    }

    /// The checks of a solution computed with `blocks`, whose balance of power and spectral bound are known.
    pub(crate) fn with_powers(
        solution: &Solution,
        blocks: &dyn Carrier,
        powers: Powers,
        spectral_bound: f64,
    ) -> Self {
        let list = solution.elements().list();
        let ones = solution.elements().constant();
        let transported = blocks.integrated_constant(&ones);
        let open: Vec<f64> = ones.iter().zip(&transported).map(|(c, gc)| c - gc).collect();
        // A covered element sees only what covers it, exactly, or nothing.
        let counts = |i: &usize| blocks.is_complete(*i) && list[*i].contact.is_none();
        let complete: Vec<usize> = (0..list.len()).filter(counts).collect();
        let sums = row_sums(list, &complete, blocks.starts(), &transported);
        Self {
            closure_max: closure(&complete, blocks.starts(), &ones, &open),
            row_sum_min: sums.iter().copied().reduce(f64::min).unwrap_or(0.0),
            row_sum_max: sums.iter().copied().fold(0.0, f64::max),
            energy_in: powers.emitted,
            energy_absorbed: powers.absorbed,
            energy_lost: powers.lost,
            spectral_bound,
            seam_jump_max: seam_jump(solution),
        }
    }

    /// The checks of the same light at other factors of its groups: those of geometry and reflectance stay.
    pub(crate) fn relight(&self, solution: &Solution) -> Self {
        let powers = solution.powers().unwrap_or_default();
        Self {
            energy_in: powers.emitted,
            energy_absorbed: powers.absorbed,
            energy_lost: powers.lost,
            seam_jump_max: seam_jump(solution),
            ..*self
        }
    }

    /// The balance of power.
    pub fn powers(&self) -> Powers {
        Powers { emitted: self.energy_in, absorbed: self.energy_absorbed, lost: self.energy_lost }
    }
}

fn lit(band: &Band, flux: f64) -> BandLight<'_> {
    BandLight { coating: &band.coating, flux, coefficients: &band.coefficients }
}

fn closure(which: &[usize], starts: &[usize], ones: &[f64], open: &[f64]) -> f64 {
    let ratio = |i: &usize| {
        let range = starts[*i]..starts[i + 1];
        norm(&open[range.clone()]) / norm(&ones[range])
    };
    which.iter().map(ratio).fold(0.0, f64::max)
}

fn row_sums(list: &[Element], which: &[usize], starts: &[usize], transported: &[f64]) -> Vec<f64> {
    let sum = |i: &usize| dot(&list[*i].constant, &transported[starts[*i]..starts[i + 1]]) / list[*i].area;
    which.iter().map(sum).collect()
}

/// [`Checks::spectral_bound`] of a solution computed with `blocks`, which takes up to some dozen products with them.
pub(crate) fn largest_bound(solution: &Solution, blocks: &dyn Carrier, ranks: &Ranks) -> f64 {
    let ones = solution.elements().constant();
    let bound = |band: &Band, _: &Ranks| spectral_bound(blocks, &band.coating, &ones);
    ranks.each(solution.bands(), bound).into_iter().fold(0.0, f64::max)
}

/// λ + ‖A v − λ v‖ after at most [`MOST_STEPS`] power iterations with A = S^½ G S^½ from the constant: an
/// eigenvalue lies in the interval of that radius about λ. Where surfaces let light through, A = S G is not
/// symmetric, and λ + ‖A v − λ v‖ is an estimate.
///
/// The kernel is not negative, so the eigenfunction of the largest eigenvalue is positive, and the constant
/// is near it.
fn spectral_bound(blocks: &dyn Carrier, coating: &Coating, ones: &[f64]) -> f64 {
    let starts = blocks.starts();
    if (0..starts.len() - 1).any(|i| coating.scatters(i) && !blocks.is_complete(i)) {
        return 0.0;
    }
    let step = |v: &[f64]| match coating.transmits() {
        true => coating.reflected(starts, &blocks.apply(v)),
        false => coating.halved(starts, &blocks.apply(&coating.halved(starts, v))),
    };
    let mut v = if coating.transmits() { ones.to_vec() } else { coating.halved(starts, ones) };
    let settled = if blocks.is_noisy() { SETTLED_BY_RAYS } else { SETTLED };
    let mut bound = 0.0;
    for _ in 0..MOST_STEPS {
        let size = norm(&v);
        if size == 0.0 {
            return 0.0;
        }
        v.iter_mut().for_each(|x| *x /= size);
        let next = step(&v);
        let lambda = dot(&v, &next);
        let error = v.iter().zip(&next).map(|(x, y)| (y - lambda * x).powi(2)).sum::<f64>().sqrt();
        bound = lambda + error;
        if error <= settled * lambda {
            break;
        }
        v = next;
    }
    bound
}

#[cfg(test)]
mod tests {
    use radiosity_geom::shapes::Parallelogram;
    use radiosity_geom::{DVec3, Flipped};
    use radiosity_kernel::{Blocks, PlacedBlock};
    use radiosity_scene::{Material, SceneBuilder};
    use radiosity_transport as transport;
    use radiosity_visibility::Visibility;
    use radiosity_work::Work;

    use super::*;
    use crate::driver::{Options, solve};

    /// The checks of a unit cube whose walls have reflectance ½ and emit 1, without the walls `missing`, with
    /// the wall `turned` turned over, and with each block multiplied by `factor` of its row and column.
    fn checks(missing: &[&str], turned: &str, factor: impl Fn(usize, usize) -> f64) -> Checks {
        let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
        let walls = [
            ("floor", DVec3::ZERO, x, y),
            ("ceiling", z, y, x),
            ("west", DVec3::ZERO, y, z),
            ("east", x, z, y),
            ("south", DVec3::ZERO, z, x),
            ("north", y, x, z),
        ];
        let mut cube = SceneBuilder::new("cube", ["grey"]);
        let grey = cube.material("grey", Material::new(vec![0.5], vec![1.0]).expect("a material"));
        for (name, origin, a, b) in walls.into_iter().filter(|wall| !missing.contains(&wall.0)) {
            let wall = Parallelogram::new(origin, a, b).expect("a wall");
            if name == turned {
                cube.surface(name, Flipped::new(Box::new(wall)), &grey);
            } else {
                cube.surface(name, wall, &grey);
            }
        }
        let scene = cube.build().expect("a scene");
        let options = Options { order: 1, eps: 1e-6, ..Options::default() };
        let outcome = solve(&scene, &options, &Work::alone()).expect("a solution");
        let elements = outcome.solution.elements();
        let visibility = Visibility::open(&scene);
        let whole = transport::assemble(
            transport::Demand::all(elements, &visibility, options.accuracy()),
            None,
            &Work::alone(),
        );
        let mut blocks = Blocks::empty(elements.starts(), true, Ranks::alone());
        for PlacedBlock { row, column, values } in whole.iter() {
            let scaled: Vec<f64> = values.iter().map(|value| factor(row, column) * value).collect();
            blocks.push(row, column, &scaled);
        }
        Checks::of(&outcome.solution, &blocks, &DirectLightEntry::Carried, Ranks::alone())
    }

    #[test]
    fn a_closed_cube_passes() {
        let found = checks(&[], "", |_, _| 1.0);
        assert!(found.closure_max < 1e-5 && (found.row_sum_min - 1.0).abs() < 1e-5, "{found:?}");
        assert!(found.row_sum_max < 1.0 + 1e-5 && found.energy_lost.abs() < 1e-4, "{found:?}");
        assert!((found.spectral_bound - 0.5).abs() < 1e-4, "{found:?}");
    }

    #[test]
    fn a_missing_wall_shows() {
        let found = checks(&["north"], "", |_, _| 1.0);
        assert!(found.closure_max > 0.1 && found.row_sum_min < 0.85, "{found:?}");
        assert!(found.energy_lost > 0.1 * found.energy_in, "{found:?}");
    }

    #[test]
    fn a_wall_that_looks_away_shows() {
        let found = checks(&[], "east", |_, _| 1.0);
        assert!(found.closure_max > 0.1 && found.row_sum_min < 0.85, "{found:?}");
        assert!(found.energy_lost > 0.1 * found.energy_in, "{found:?}");
    }

    #[test]
    fn a_block_that_is_too_large_shows() {
        let found = checks(&[], "", |row, column| if (row, column) == (0, 1) { 2.0 } else { 1.0 });
        assert!(found.row_sum_max > 1.15 && found.closure_max > 0.15, "{found:?}");
        assert!(found.spectral_bound > 0.51, "{found:?}");
    }
}
