//! The sampled transport of a scene: rays in two stages, and what is left of error.
//!
//! A pilot, spread by area, tells about how bright each element is. The rays after it are sent by area and
//! brightness:
//!
//! ```text
//! n_i ∝ A_i (1 + β B_i / B̄) ,     B̄ = Σ A_i B_i / Σ A_i ,
//! ```
//!
//! so that small lamps send enough. They go in rounds of all elements, so that the work can be stopped after
//! any of them. The scene is then solved with the rays of even and with those of odd number, too. Half of the
//! difference of these two solutions is about the error of the solution by all rays. (Rays by brightness: P.
//! Hanrahan, D. Salzman, L. Aupperle, SIGGRAPH 1991, 197-206, for links.)

use std::ops::Range;
use std::time::{Duration, Instant};

use radiosity_elements::coating::Coating;
use radiosity_elements::{Element, Elements};
use radiosity_kernel::blocks::bounded_rows::bound_rows;
use radiosity_kernel::{Accuracy, Blocks};
use radiosity_light::first_bounce::DirectLightEntry;
use radiosity_solvers::SolveError;
use radiosity_solvers::method::Method;
use radiosity_transport::{KeptBlocks, Rays, SampledTransport};
use radiosity_visibility::Visibility;
use radiosity_work::{Deadline, Progress, Work};

use crate::system::ritz::{Ritz, RitzSolution};
use crate::system::{Coefficients, System};

use super::kept_model::KeptModel;
use super::light_shares::LightShares;
use super::options::Options;
use super::pair_rays;
use super::sampling::Sampling;
use super::solve_band::{SystemsOfBand, solve_band};

/// Share of the rays that the pilot sends, one round of them at most. Between 0.05 and 0.2 errors
/// changed by less than a tenth of themselves.
const PILOT: f64 = 0.1;

/// β: weight of brightness against area. An office needs a third of its rays from its lamps; here a lamp that
/// sends all light of a scene gets β/(1 + β) of them.
const BRIGHTNESS: f64 = 0.3;

/// Fewest rays of an element in the pilot round, and in all, so that no element is without any: a row of four
/// hits is known to a half, one of sixteen to a fourth.
const FEWEST: [u64; 2] = [4, 16];

/// Accuracy of pairs that are carried exactly, in multiples of n^-½ for n rays in all: better than rays find
/// any pair that gets less than a 25th of them. With a smaller value exact pairs take longer and save no
/// error.
const EXACT: f64 = 5.0;

/// Part of the accuracy of single exact pairs that is left in mean irradiances: between a tenth and a
/// hundredth in two rooms (`cargo run --release -p radiosity-studies --bin rays -- sooner`).
const LEFT: f64 = 0.1;

/// Rays of a round: about a second's on two cores.
const ROUND: u64 = 1 << 21;

/// Part of the time left in which rays are sent at the most where it is limited, and times of the solution that tells
/// brightness that are left for what follows: two solutions that tell the error, the systems, and the self-checks.
/// Chosen.
const SENT: f64 = 0.6;
const AFTER: u32 = 5;

/// Relative residual of solutions that only tell brightness or error.
const ROUGH: f64 = 1e-4;

/// Most light groups that are solved for brightness or error. Chosen: of 2000 groups in a room all of them took half
/// of the time of the solution.
const MOST_PROBED: usize = 64;

/// Ends of rays that are sent by a deadline: of the first half of those that were planned, which go on for longer, as
/// light may grow without end by fewer rays than elements were cut for; and of all.
#[derive(Clone, Copy, Debug)]
struct RayEnds {
    of_half: Instant,
    of_all: Instant,
}

/// A scene ready for rays.
#[derive(Debug)]
pub(super) struct Subject<'a> {
    pub elements: &'a Elements,
    /// Coatings of each light group, band by band: how rays are spread, and their error, do not depend on
    /// factors.
    pub bands: &'a [Vec<&'a Coating>],
    /// The way in which the direct light of each light group enters the system.
    pub entries: &'a [DirectLightEntry],
    pub visibility: &'a Visibility,
    pub options: &'a Options,
    pub work: &'a Work<'a>,
}

impl Subject<'_> {
    /// The blocks by `rays` rays after the pilot, and what they are worth; what `kept` holds is not found
    /// again.
    pub(super) fn sample(&self, rays: u64, mut kept: Option<&mut KeptModel>) -> (Blocks, Sampling) {
        let _guard = self.work.deadline.map(Deadline::accept_wishes);
        if let Some(found) = kept.as_deref_mut().and_then(|kept| self.follow(rays, kept)) {
            return found;
        }
        let (transport, planned) = self.sent(rays, kept.as_deref_mut().map(|kept| &mut kept.blocks));
        // The halves first: their blocks are gone when the whole ones are made.
        let sampling = self.worth(&transport, rays, planned);
        let blocks = transport.blocks(Rays::All);
        match kept {
            Some(KeptModel { blocks, standing: Some(standing), .. }) => {
                transport.keep_standing(&mut standing.rays, blocks);
                standing.tell(sampling, self.shares());
                standing.note_spread();
            }
            kept => transport.keep_rays(kept.map(|kept| &mut kept.blocks)),
        }
        (blocks, sampling)
    }

    /// The blocks by rays of each pair, and what they are worth; None where elements are few, bent or of
    /// polynomials, or that is not asked for.
    pub(super) fn sample_pairs(&self) -> Option<(Blocks, Sampling)> {
        let Self { elements, visibility, options, work, .. } = *self;
        let found = pair_rays::transport(elements, visibility, options, work)?.exchanges(&|_, _| true);
        let halves = |rays: Rays| {
            let part = match rays {
                Rays::Even => 1.0,
                Rays::Odd => -1.0,
                Rays::All => 0.0,
            };
            found.blocks(elements, part, work.ranks)
        };
        // What errs may sum to more than is sent, which has no light.
        let bounded = |rays: Rays| {
            let mut blocks = halves(rays);
            bound_rows(&mut blocks, &elements.constant());
            blocks
        };
        let error = self.error(&bounded).ok();
        let (rays, exact_pairs) = (found.segments, found.exact);
        let blocks = halves(Rays::All);
        // The bound hides a part of what halves differ by.
        let error = error.map(|error| error.hypot(self.excess(&blocks)));
        Some((blocks, Sampling { rays, planned: rays, exact_pairs, error }))
    }

    /// Root of the mean square over the area of what row sums of blocks between constants are above 1.
    fn excess(&self, blocks: &Blocks) -> f64 {
        let ones = self.elements.constant();
        let above = blocks.apply(&ones).into_iter().zip(&ones).map(|(arrived, one)| (arrived - one).max(0.0));
        // c² is the area.
        (above.map(|above| above * above).sum::<f64>() / self.area()).sqrt()
    }

    /// Shares of the elements in the light that rays are spread for.
    pub(super) fn shares(&self) -> LightShares {
        let list = self.elements.list();
        let powers = |band: usize, coating: &Coating, entry: &DirectLightEntry| -> Vec<f64> {
            let lit = match entry {
                DirectLightEntry::Lit(lit) | DirectLightEntry::Arrived(lit) => {
                    self.elements.means(&lit[band])
                }
                _ => vec![0.0; list.len()],
            };
            let is_carried = !matches!(entry, DirectLightEntry::Arrived(_));
            let sent = list.iter().zip(lit).enumerate();
            sent.map(|(index, (element, lit))| {
                let reflected = coating.reflectance[index] * lit.max(0.0);
                element.area * (if is_carried { coating.exitance[index] } else { 0.0 } + reflected)
            })
            .collect()
        };
        let bands = self.bands.iter().enumerate().flat_map(|(band, coatings)| {
            coatings.iter().zip(self.entries).map(move |(coating, entry)| (band, *coating, entry))
        });
        LightShares::of(bands.map(|(band, coating, entry)| powers(band, coating, entry)).collect())
    }

    /// The blocks by the rays of the scene before, where these stand and were spread for light like this.
    fn follow(&self, rays: u64, kept: &mut KeptModel) -> Option<(Blocks, Sampling)> {
        let Self { elements, visibility, work, .. } = *self;
        let KeptModel { blocks: kept, standing, .. } = kept;
        let shares = self.shares();
        let standing = standing.as_mut().filter(|standing| standing.fit(&shares))?;
        let accuracy = self.accuracy(rays);
        let transport =
            SampledTransport::standing(elements, visibility, accuracy, &mut standing.rays, kept, work)?;
        let planned = transport.sent().iter().sum();
        let told = standing.told(&shares);
        let sampling = told.unwrap_or_else(|| self.worth(&transport, rays, planned));
        if told.is_none() && !standing.tell(sampling, shares) {
            return None;
        }
        let blocks = transport.blocks(Rays::All);
        transport.keep_standing(&mut standing.rays, kept);
        Some((blocks, sampling))
    }

    /// The transport by `rays` rays after the pilot, and how many were to be sent in all.
    fn sent(&self, rays: u64, mut kept: Option<&mut KeptBlocks>) -> (SampledTransport<'_>, u64) {
        let Self { elements, visibility, work, .. } = *self;
        let mut transport = SampledTransport::keeping(elements, visibility, kept.as_deref_mut(), work.ranks);
        let pilot = (PILOT * rays as f64).min(ROUND as f64);
        transport.send(&self.by_area(pilot), &mut |done| {
            self.goes_on(Progress::Rays { done, of: rays, error: None }, None)
        });
        let sent = Instant::now();
        // Where the pilot tells nothing, all elements count as equally bright.
        let bright = self
            .brightness(&transport.blocks(Rays::All))
            .unwrap_or_else(|_| vec![1.0; self.elements.list().len()]);
        let planned = self.by_brightness(rays as f64, &bright);
        let total = transport.sent().iter().sum::<u64>() + planned.iter().sum::<u64>();
        let until = self.ends_of_rays(sent.elapsed());
        if !work.is_ended() {
            transport.settle_again(&planned, self.accuracy(rays), kept, work);
            self.send_in_rounds(&mut transport, &planned, until);
        }
        (transport, total)
    }

    /// The worth of the rays that were sent, of so many that were `planned`.
    fn worth(&self, transport: &SampledTransport<'_>, rays: u64, planned: u64) -> Sampling {
        // Both halves share the exact pairs, and what these are off.
        let of_exact = match transport.exact_pairs() {
            0 => 0.0,
            _ => LEFT * self.accuracy(rays).eps.max(transport.exact_accuracy()),
        };
        Sampling {
            rays: transport.sent().iter().sum(),
            planned,
            exact_pairs: transport.exact_pairs(),
            error: self.error(&|rays| transport.blocks(rays)).ok().map(|error| error.hypot(of_exact)),
        }
    }

    /// Tells how far the work is; returns whether rays go on, `until` an instant if there is one.
    fn goes_on(&self, progress: Progress, until: Option<Instant>) -> bool {
        self.work.report(progress);
        !self.is_ended(until)
    }

    /// Whether rays are no longer wanted, or it is later than `until`.
    fn is_ended(&self, until: Option<Instant>) -> bool {
        self.work.is_ended() || until.is_some_and(|until| Instant::now() >= until)
    }

    /// The ends of rays that begin now, where time is limited and a solution took so long.
    fn ends_of_rays(&self, solution: Duration) -> Option<RayEnds> {
        let left = self.work.left()?;
        let (now, before) = (Instant::now(), left.saturating_sub(AFTER * solution));
        Some(RayEnds { of_half: now + before, of_all: now + left.mul_f64(SENT).min(before) })
    }

    /// Sends the planned rays, unless the work is stopped or time is limited and up. Elsewhere the error so far is told
    /// after rounds 1, 2, 4, 8, …: what this costs is a part of what the rays do.
    fn send_in_rounds(&self, transport: &mut SampledTransport, planned: &[u64], until: Option<RayEnds>) {
        let before: u64 = transport.sent().iter().sum();
        let total = before + planned.iter().sum::<u64>();
        let rounds = (total - before).div_ceil(ROUND);
        let (mut done, mut error) = (before, None);
        for round in 1..=rounds {
            let up_to =
                |round: u64, count: u64| (u128::from(count) * u128::from(round) / u128::from(rounds)) as u64;
            let now: Vec<u64> =
                planned.iter().map(|count| up_to(round, *count) - up_to(round - 1, *count)).collect();
            let end =
                |done: u64| until.map(|ends| if 2 * done >= total { ends.of_all } else { ends.of_half });
            transport.send(&now, &mut |more| {
                let done = done + more;
                self.goes_on(Progress::Rays { done, of: total, error }, end(done))
            });
            if self.is_ended(end(transport.sent().iter().sum())) {
                return;
            }
            done += now.iter().sum::<u64>();
            if round.is_power_of_two() && round < rounds && until.is_none() {
                error = self.error(&|rays| transport.blocks(rays)).ok();
            }
        }
    }

    /// Accuracy of the pairs that are carried exactly: better than that of most others.
    fn accuracy(&self, rays: u64) -> Accuracy {
        let Accuracy { eps, shadow_eps } = self.options.accuracy();
        let noise = EXACT / (rays as f64).sqrt();
        Accuracy { eps: eps.min(noise), shadow_eps: shadow_eps.min(noise) }
    }

    fn area(&self) -> f64 {
        self.elements.list().iter().map(|element| element.area).sum()
    }

    fn by_area(&self, rays: f64) -> Vec<u64> {
        let area = self.area();
        self.planned(&|index| rays * self.elements.list()[index].area / area, FEWEST[0])
    }

    /// Number of rays of each element, `fewest` at least; none of those that others cover.
    fn planned(&self, share: &dyn Fn(usize) -> f64, fewest: u64) -> Vec<u64> {
        let list = self.elements.list().iter().enumerate();
        let own = |(index, element): (usize, &Element)| match element.contact {
            Some(_) => 0,
            None => (share(index).ceil() as u64).max(fewest),
        };
        list.map(own).collect()
    }

    /// n_i for relative brightnesses B_i / B̄.
    fn by_brightness(&self, rays: f64, bright: &[f64]) -> Vec<u64> {
        let weights = self.elements.list().iter().zip(bright);
        let weights: Vec<f64> = weights.map(|(element, b)| element.area * (1.0 + BRIGHTNESS * b)).collect();
        let all: f64 = weights.iter().sum();
        self.planned(&|index| rays * weights[index] / all, FEWEST[1])
    }

    /// Light groups of which brightness and error are found: all, or so many of them evenly in the order of the areas
    /// that emit. The smallest is one: of its light fewest rays tell.
    fn probed_groups(&self) -> Vec<usize> {
        let count = self.entries.len();
        let emitting = |group: &usize| -> f64 {
            let shines = |element: &usize| self.bands.iter().any(|own| own[*group].exitance[*element] > 0.0);
            let list = self.elements.list();
            (0..list.len()).filter(shines).map(|element| list[element].area).sum()
        };
        let mut groups: Vec<(f64, usize)> = (0..count).map(|group| (emitting(&group), group)).collect();
        groups.sort_by(|one, other| one.0.total_cmp(&other.0));
        let probed = MOST_PROBED.min(count);
        (0..probed).map(|place| groups[place * count / probed].1).collect()
    }

    /// B_i / B̄ of each element, the mean of the bands and probed light groups that emit. Of the other groups it
    /// has what they emit; what is reflected of their light is taken to be like that of the probed ones.
    fn brightness(&self, blocks: &Blocks) -> Result<Vec<f64>, SolveError> {
        let probed = self.probed_groups();
        let lit = self.solved(blocks, &probed, &|solved| self.elements.means(&solved.radiosity))?;
        let mut bright = self.mean_brightness(lit.iter().map(Vec::as_slice));
        if probed.len() < self.entries.len() {
            let all: Vec<usize> = (0..self.entries.len()).collect();
            let power: f64 = lit.iter().map(|own| self.power(own)).sum();
            let emitted: f64 = self.exitances(&probed).map(|own| self.power(own)).sum();
            let share = if power > 0.0 { emitted / power } else { 0.0 };
            let of_probed = self.mean_brightness(self.exitances(&probed));
            let of_all = self.mean_brightness(self.exitances(&all));
            for ((bright, all), probed) in bright.iter_mut().zip(of_all).zip(of_probed) {
                *bright = (*bright + share * (all - probed)).max(0.0);
            }
        }
        Ok(bright)
    }

    /// Exitances of the elements, band by band and group by group (W m⁻²).
    fn exitances<'g>(&'g self, groups: &'g [usize]) -> impl Iterator<Item = &'g [f64]> {
        let of_band =
            move |own: &'g Vec<&Coating>| groups.iter().map(|group| own[*group].exitance.as_slice());
        self.bands.iter().flat_map(of_band)
    }

    /// Mean of B_i / B̄ over those of some radiosities B (W m⁻²) that shine, each by the means of the elements.
    fn mean_brightness<'b>(&self, all: impl Iterator<Item = &'b [f64]>) -> Vec<f64> {
        let area = self.area();
        let mut bright = vec![0.0; self.elements.list().len()];
        let mut shining = 0.0;
        for radiosity in all {
            let power = self.power(radiosity);
            if power > 0.0 {
                shining += 1.0;
                bright.iter_mut().zip(radiosity).for_each(|(sum, b)| *sum += b.max(0.0) * area / power);
            }
        }
        bright.iter_mut().for_each(|sum| *sum /= f64::max(shining, 1.0));
        bright
    }

    /// Power of a radiosity ≥ 0 by the means of the elements.
    fn power(&self, radiosity: &[f64]) -> f64 {
        radiosity.iter().zip(self.elements.list()).map(|(b, element)| b.max(0.0) * element.area).sum()
    }

    /// Relative L2 of half the difference of the solutions by either half of the rays, largest of the bands and light
    /// groups. Where some groups are probed alone, the largest of the n others is taken to be
    ///
    /// ```text
    /// m + s √(2 ln n)
    /// ```
    ///
    /// as of so many normal numbers of the mean m and the deviation s of the probed ones.
    fn error(&self, by: &dyn Fn(Rays) -> Blocks) -> Result<f64, SolveError> {
        let even = self.mean_irradiances(&by(Rays::Even))?;
        let odd = self.mean_irradiances(&by(Rays::Odd))?;
        let errors: Vec<f64> =
            even.iter().zip(&odd).map(|(even, odd)| self.half_difference(even, odd)).collect();
        let worst = errors.iter().copied().fold(0.0, f64::max);
        let others = self.entries.len().saturating_sub(MOST_PROBED);
        if others == 0 {
            return Ok(worst);
        }
        let mean = errors.iter().sum::<f64>() / errors.len() as f64;
        let variance = errors.iter().map(|error| (error - mean).powi(2)).sum::<f64>() / errors.len() as f64;
        Ok(worst.max(mean + (2.0 * (others as f64).ln() * variance).sqrt()))
    }

    /// Relative L2 of half the difference of the mean irradiances of the elements by either half of the rays.
    fn half_difference(&self, even: &[f64], odd: &[f64]) -> f64 {
        let (mut difference, mut sum) = (0.0, 0.0);
        for ((even, odd), element) in even.iter().zip(odd).zip(self.elements.list()) {
            difference += element.area * (even - odd).powi(2);
            sum += element.area * (even + odd).powi(2);
        }
        if sum > 0.0 { (difference / sum).sqrt() } else { 0.0 }
    }

    /// Mean irradiance of each element, band by band and probed group by group.
    fn mean_irradiances(&self, blocks: &Blocks) -> Result<Vec<Vec<f64>>, SolveError> {
        self.solved(blocks, &self.probed_groups(), &|solved| self.elements.means(&solved.irradiance))
    }

    /// The figures `of` rough solutions, band by band and group by group.
    fn solved(
        &self,
        blocks: &Blocks,
        groups: &[usize],
        of: &dyn Fn(Coefficients) -> Vec<f64>,
    ) -> Result<Vec<Vec<f64>>, SolveError> {
        let method = &Method::AUTO;
        let tolerance = ROUGH.max(self.options.tolerance);
        let rough = Options { tolerance, solver: method, keep_partial: false, ..*self.options };
        let list = self.elements.list();
        let mut all = Vec::new();
        for (band, coatings) in self.bands.iter().enumerate() {
            let groups: Vec<(&Coating, &DirectLightEntry)> =
                groups.iter().map(|group| (coatings[*group], &self.entries[*group])).collect();
            let systems = |range: Range<usize>| {
                let systems = System::entered(list, blocks, band, &groups[range]).into_iter();
                systems.map(|system| Ritz::new(system, None)).collect()
            };
            let systems = SystemsOfBand { count: groups.len(), of: &systems };
            let mut take = |found: RitzSolution| all.push(of(found.coefficients));
            solve_band(&systems, &rough, None, self.work, &mut |_| (), &mut take)?;
        }
        Ok(all)
    }
}
