//! The choice of how light is gathered at points: by cells, by rays, or by walks.
//!
//! Cells ([`crate::gather::Gather`]) cost time in proportion to the elements and to what stands before them, once for
//! their tables and again for each point, little more where more digits are asked for; least in small rooms of flat
//! things. Rays ([`crate::gather::ray_gather`]) cost about the same whatever the scene is, and ε^(−4/3). Both take
//! what surfaces reflect from the polynomials of the solution, rays where these are trusted. Walks
//! (`super::walked_light`) take nothing from them, and cost ε⁻²: they are chosen here for points in narrow gaps
//! alone, elsewhere by who knows what else a solution would take to be as accurate. What is found in doubtful
//! places is read anew by rays (`super::doubtful_places`).

use std::cell::LazyCell;
use std::sync::Arc;

use radiosity_light::direct::DirectLight;
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_visibility::Visibility;
use radiosity_work::Pace;
use serde::{Deserialize, Serialize};

use crate::gather::Gather;
use crate::gather::cell_price::CellPrice;
use crate::gather::doubtful_places::{ANEW, DoubtfulPlaces};
use crate::gather::met_light::MetLight;
use crate::gather::narrow_gaps::NarrowGaps;
use crate::gather::ray_count::{usual_rays, usual_walks};
use crate::gather::ray_gather::{Beyond, RayGather};
use crate::gather::read_irradiance::ReadIrradiance;
use crate::gather::receiver::Receiver;
use crate::solution::Solution;

/// Seconds of a ray, and of a walk. Measured on one core: the rooms of [`CellPrice`]; the Cornell box.
const RAY: f64 = 1.2e-6;
const WALK: f64 = 4e-6;

/// Coarsest accuracy that readings are gathered to by cells: rays err by what they are asked for, cells by more in
/// dark places and far from a window, and fine cells are no dearer there. Measured beside the shadow of a table: with
/// 1e-2, 2e-3, 1.25e-3 and 3e-4 readings erred by 20, 20, 8 and .3 %, after .73, .79, .78 and .65 s; in a daylit room
/// with 1.25e-3 and 3e-4 by .6 and .24 %, in the same time.
const BY_CELLS: f64 = 3e-4;

/// Coarsest accuracy that readings are gathered to as asked for by cells under skies that are not uniform, whose cells
/// are dear: in a room with a window to a clear sky 1.25e-3 took 17 s, and 3e-4 50 s.
const BY_GRADED_CELLS: f64 = 2e-3;

/// Points that share the tables of cells where it is not known how many are read. Chosen: in rooms a dozen to a hundred
/// take less than twice the time of the better choice.
pub(crate) const SOME_POINTS: f64 = 25.0;

/// Seconds of the usual rays over those of direct light by cells, at least, where cells find it: what they spare is
/// about half of the rays, and few flat lamps take longer than forecast. Chosen.
const CHEAPER: f64 = 10.0;

/// Rays among luminaires over those without: where one shines on a surface beside it, few rays meet the peak.
/// Chosen.
const PEAKS: f64 = 30.0;

/// Rays where the sun shines in over those without: few of them meet its patches. Measured in two rooms: 6 and 30.
const PATCHES: f64 = 12.0;

/// Ways to gather light at points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "lowercase")]
pub enum GatherMethod {
    /// By what is likely to be faster.
    #[default]
    Auto,
    /// By cells of all elements, divided until their rules are exact enough.
    Cells,
    /// By rays, until their error is small enough.
    Rays,
    /// By rays that go on from surface to surface until they end: no error of the solution is left.
    Walks,
}

/// Light that is gathered in one of the ways.
#[derive(Debug)]
pub enum GatheredBy<'a> {
    /// By cells.
    Cells(Gather<'a>),
    /// By rays, or by walks.
    Rays(RayGather<'a>),
}

/// Light that is gathered in one of the ways, in places where that is doubtful by walks.
#[derive(Debug)]
pub struct Gathering<'a> {
    by: GatheredBy<'a>,
    /// None where walks gather all light.
    doubtful: Option<Box<DoubtfulPlaces<'a>>>,
}

impl<'a> Gathering<'a> {
    /// The way in which light is gathered outside of doubtful places.
    pub fn by(&self) -> &GatheredBy<'a> {
        &self.by
    }

    /// As made, but readings by rays end at this pace: with the rays that were sent until then, and their error.
    pub fn paced(self, pace: &'a Pace) -> Self {
        let by = match self.by {
            GatheredBy::Rays(gather) => GatheredBy::Rays(gather.paced(pace)),
            by @ GatheredBy::Cells(_) => by,
        };
        Self { by, doubtful: self.doubtful.map(|places| Box::new(places.paced(pace))) }
    }

    /// As made, but readings by rays are to be accurate relative to the usual irradiance where less arrives: what
    /// counts in the mean of all.
    pub fn for_mean(self) -> Self {
        let by = match self.by {
            GatheredBy::Rays(gather) => GatheredBy::Rays(gather.beside_usual()),
            by @ GatheredBy::Cells(_) => by,
        };
        Self { by, doubtful: self.doubtful.map(|places| Box::new(places.beside_usual_light())) }
    }

    /// All light of a point.
    pub fn read(&self, receiver: &ReceiverPoint) -> ReadIrradiance {
        let in_gap = self.doubtful.as_ref().and_then(|places| places.in_gap(receiver));
        in_gap.unwrap_or_else(|| match &self.by {
            GatheredBy::Cells(gather) => {
                let direct = gather.direct();
                let lit = direct.irradiance(receiver, &direct.around(&receiver.site()));
                self.beside(receiver, &lit, || by_cells(gather, receiver, &lit))
            }
            GatheredBy::Rays(gather) => match gather.direct_by_cells(receiver) {
                Some(lit) => {
                    let reflected = || gather.reflected_alone(&Receiver::Point(*receiver), &lit);
                    self.beside(receiver, &lit, reflected)
                }
                None => gather.read(&Receiver::Point(*receiver)),
            },
        })
    }

    /// All light of a point, where so much is `lit` by emitters (W m⁻² per band) and so much `reflected`; read anew if
    /// the point is doubtful.
    fn beside(
        &self,
        receiver: &ReceiverPoint,
        lit: &[f64],
        reflected: impl FnOnce() -> ReadIrradiance,
    ) -> ReadIrradiance {
        match &self.doubtful {
            Some(places) => places.point(receiver, lit, reflected),
            None => reflected().with(lit),
        }
    }

    /// All light of a patch of which cells found the parts `lit` by emitters and `reflected` (W m⁻² per band): these,
    /// and where they are doubtful, what is read anew.
    pub fn settled(&self, patch: &Receiver, lit: &[f64], reflected: &[f64]) -> ReadIrradiance {
        match &self.doubtful {
            Some(places) => places.patch(patch, lit, reflected),
            None => ReadIrradiance::from(reflected.to_vec()).with(lit),
        }
    }

    /// Whether a point lies in a narrow gap between surfaces, in which light is another one than around it.
    pub fn is_in_gap(&self, receiver: &ReceiverPoint) -> bool {
        self.doubtful.as_ref().is_some_and(|places| places.is_in_gap(receiver))
    }

    /// The reflected light of a point, one of many, beside the direct light `lit` (W m⁻² per band).
    fn reflected(&self, receiver: &ReceiverPoint, lit: &[f64]) -> ReadIrradiance {
        let in_gap = self.doubtful.as_ref().and_then(|places| places.reflected_in_gap(receiver, lit));
        in_gap.unwrap_or_else(|| match &self.by {
            GatheredBy::Cells(gather) => by_cells(gather, receiver, lit),
            GatheredBy::Rays(gather) => gather.reflected(receiver, lit),
        })
    }

    /// The reflected light of a point, one of many, accurate relative to this and the light `other` (W m⁻² per band),
    /// and read anew if there is more than this `doubt`, if any, about the point over all its light, of which so much
    /// is `lit`.
    pub fn reflected_for_sure(
        &self,
        receiver: &ReceiverPoint,
        lit: &[f64],
        other: &[f64],
        doubt: Option<f64>,
    ) -> ReadIrradiance {
        let anew = doubt.and_then(|doubt| {
            let outside = self.doubtful.as_ref().filter(|places| !places.is_in_gap(receiver))?;
            outside.reflected_anew(receiver, lit, other, doubt)
        });
        anew.unwrap_or_else(|| self.reflected(receiver, other))
    }
}

impl GatherMethod {
    /// The light of `solution` for readings of the relative accuracy `eps`, gathered `twice` or once by what this
    /// method chooses: to that by rays, to a finer one by cells.
    pub fn readings<'a>(
        self,
        solution: &'a Solution,
        visibility: &'a Visibility,
        eps: f64,
        twice: bool,
    ) -> Gathering<'a> {
        let by_cells = cells_of_readings(solution, eps);
        self.gathering(solution, visibility, by_cells, eps / by_cells, SOME_POINTS, twice)
    }

    /// The light of `solution`, gathered `twice` or once by what this method chooses: by cells to about the
    /// relative accuracy `eps`, by rays to `rougher` times that; about so many `points` are read.
    pub fn gathering<'a>(
        self,
        solution: &'a Solution,
        visibility: &'a Visibility,
        eps: f64,
        rougher: f64,
        points: f64,
        twice: bool,
    ) -> Gathering<'a> {
        let is_direct_by_cells = CHEAPER * CellPrice::of_direct(&solution.emitters(), visibility)
            <= RAY * usual_rays(rougher * eps);
        let met = LazyCell::new(|| Arc::new(MetLight::of(solution, visibility)));
        let by_rays = |beyond| {
            let rays = RayGather::of(Arc::clone(&met), rougher * eps, beyond);
            let direct = || DirectLight::within(&solution.emitters(), visibility, eps);
            GatheredBy::Rays(if is_direct_by_cells { rays.beside(direct()) } else { rays })
        };
        let by = match twice {
            _ if self == Self::Walks => by_rays(Beyond::Walked),
            _ if self.rays(solution, visibility, eps, rougher * eps, points, twice) => by_rays(match twice {
                true => Beyond::Gathered,
                false if is_direct_by_cells => Beyond::Polynomials,
                false => Beyond::Trusted,
            }),
            true => GatheredBy::Cells(Gather::twice(solution, visibility, eps)),
            false => GatheredBy::Cells(Gather::new(solution, visibility, eps)),
        };
        let places = |gaps| Box::new(DoubtfulPlaces::of(Arc::clone(&met), gaps, rougher * eps));
        Gathering { by, doubtful: self.gaps(solution, visibility).map(places) }
    }

    /// Gaps in which light is gathered in another way; None where that takes nothing from polynomials.
    fn gaps<'a>(self, solution: &'a Solution, visibility: &'a Visibility) -> Option<NarrowGaps<'a>> {
        if self == Self::Walks { None } else { NarrowGaps::of(solution, visibility) }
    }

    /// Whether rays gather light to the relative accuracy `by_rays`, where cells would to `by_cells`.
    fn rays(
        self,
        solution: &Solution,
        visibility: &Visibility,
        by_cells: f64,
        by_rays: f64,
        points: f64,
        twice: bool,
    ) -> bool {
        // Rays always meet what stands in their way, and know no masks.
        let is_plain = visibility.casts() && solution.masked().is_none();
        let is_cheaper = || {
            let cells = CellPrice::of(&solution.emitters(), visibility, by_cells, twice);
            seconds_of_rays(solution, by_rays, twice) < cells.point + cells.once / points
        };
        match self {
            Self::Cells => false,
            Self::Rays | Self::Walks => is_plain,
            Self::Auto => is_plain && is_cheaper(),
        }
    }

    /// About the seconds of one core that those of so many points take that are in narrow gaps, if as many are as there
    /// are surfaces, to the relative accuracy `eps`.
    pub fn seconds_in_gaps(self, solution: &Solution, visibility: &Visibility, eps: f64, points: f64) -> f64 {
        let gaps = self.gaps(solution, visibility);
        gaps.map_or(0.0, |gaps| points * gaps.part() * RAY * usual_rays(eps.max(ANEW)))
    }

    /// About the seconds of one core that so many points outside of narrow gaps take to the relative accuracy `eps`, of
    /// which about `together` are read together.
    pub fn seconds(
        self,
        solution: &Solution,
        visibility: &Visibility,
        eps: f64,
        points: f64,
        together: f64,
        twice: bool,
    ) -> f64 {
        self.seconds_by(solution, visibility, [eps; 2], points, together, twice)
    }

    /// About the seconds of one core that so many [`readings`](Self::readings) outside of narrow gaps take to the
    /// relative accuracy `eps`.
    pub fn seconds_of_readings(
        self,
        solution: &Solution,
        visibility: &Visibility,
        eps: f64,
        points: f64,
        twice: bool,
    ) -> f64 {
        self.seconds_by(
            solution,
            visibility,
            [cells_of_readings(solution, eps), eps],
            points,
            SOME_POINTS,
            twice,
        )
    }

    /// Seconds of points, by cells to the first of these accuracies, or by rays to the second.
    fn seconds_by(
        self,
        solution: &Solution,
        visibility: &Visibility,
        [by_cells, by_rays]: [f64; 2],
        points: f64,
        together: f64,
        twice: bool,
    ) -> f64 {
        if self == Self::Walks {
            return points * WALK * usual_walks(by_rays);
        }
        if self.rays(solution, visibility, by_cells, by_rays, together, twice) {
            return points * seconds_of_rays(solution, by_rays, twice);
        }
        let cells = CellPrice::of(&solution.emitters(), visibility, by_cells, twice);
        cells.once + points * cells.point
    }
}

/// Accuracy to which cells gather readings of `solution` of the relative accuracy `eps`.
fn cells_of_readings(solution: &Solution, eps: f64) -> f64 {
    let is_dear = eps <= BY_GRADED_CELLS && solution.emitters().are_graded();
    if is_dear { eps } else { eps.min(BY_CELLS) }
}

/// The reflected light of a point by cells, beside the direct light `lit` (W m⁻² per band).
fn by_cells(gather: &Gather, receiver: &ReceiverPoint, lit: &[f64]) -> ReadIrradiance {
    let around = gather.reflection().around(&receiver.site());
    gather.reflection().irradiance(receiver, &around, lit).into()
}

/// Seconds for a point by rays.
fn seconds_of_rays(solution: &Solution, eps: f64, twice: bool) -> f64 {
    let points = solution.emitters().points;
    let unevenness = match points.ends().next() {
        Some(_) => PEAKS,
        None if points.is_empty() => 1.0,
        None => PATCHES,
    };
    let each = if twice { 3.0 } else { 1.0 };
    each * unevenness * RAY * usual_rays(eps)
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;
    use std::time::{Duration, Instant};

    use radiosity_geom::DVec3;
    use radiosity_scene::Scene;
    use radiosity_work::Work;

    use super::*;
    use crate::driver::{Options, solve};
    use crate::gather::DOUBTFUL_PIXEL;
    use crate::gather::standpoint::Standpoint;

    fn cornell_box() -> (Scene, Solution, Visibility) {
        let scene = radiosity_language::builtin("cornell-box").expect("it is built in");
        let options = Options { order: 1, ..Options::default() };
        let solution = solve(&scene, &options, &Work::alone()).expect("a solution").solution;
        let visibility = options.visibility(&scene);
        (scene, solution, visibility)
    }

    /// Readings by cells have a finer accuracy than they ask for, and take their time.
    #[test]
    fn readings_by_cells_take_the_time_of_what_reads_them() {
        let (_, solution, visibility) = cornell_box();
        let seconds = |eps| GatherMethod::Cells.seconds_of_readings(&solution, &visibility, eps, 10.0, false);
        let at = |eps| GatherMethod::Cells.seconds(&solution, &visibility, eps, 10.0, SOME_POINTS, false);
        assert!(at(BY_CELLS) > 2.0 * at(5e-3));
        assert_eq!([seconds(5e-3), seconds(1e-4)], [at(BY_CELLS), at(1e-4)]);
    }

    /// A reading whose time is up keeps the rays that it has, and tells their error.
    #[test]
    fn readings_end_when_their_time_is_up() {
        let (scene, solution, visibility) = cornell_box();
        let gathering = || GatherMethod::Rays.readings(&solution, &visibility, 1e-3, false);
        let floor = scene.surface_named("floor").expect("it is there");
        let jet = scene.surfaces[floor].shape.jet(0.1, 0.85);
        let receiver = ReceiverPoint::on(floor, jet.position, jet.normal);
        let read = |pace: &Pace| {
            let found = gathering().paced(pace).read(&receiver);
            (found.irradiance, found.uncertainty.deviation.expect("rays have one"))
        };
        let [ended, unhurried] =
            [0, 1000].map(|seconds| Pace::of(1, 1, Instant::now() + Duration::from_secs(seconds)));
        let [(rough, told), (fine, least)] = [&ended, &unhurried].map(read);
        assert_eq!([&ended, &unhurried].map(Pace::has_cut_short), [true, false]);
        assert!(told.relative > 2.0 * least.relative, "{told:?} {least:?}");
        let off = rough.iter().zip(&fine).map(|(rough, fine)| (rough / fine - 1.0).abs()).fold(0.0, f64::max);
        assert!(off < 4.0 * told.relative && off > 0.0, "{off} {told:?}");
    }

    /// Before the feet of blocks, where polynomials of what is near are far off, pixels come near what is read anew.
    #[test]
    fn dark_places_of_pictures_are_read_anew() {
        let (scene, solution, visibility) = cornell_box();
        let gathering = GatherMethod::Rays.gathering(&solution, &visibility, 1e-2, 1.0, 1.0, false);
        let floor = scene.surface_named("floor").expect("it is there");
        let lit = vec![0.0; solution.bands().len()];
        let mut off = [0.0; 2];
        let normal = scene.surfaces[floor].shape.jet(0.0, 0.0).normal;
        // The front of the short block meets the floor from (130, 65) to (290, 114) in x and z.
        for [part, away] in (0..48).map(|k| [f64::from(k / 3) / 15.0, f64::from(k % 3)]) {
            let foot = DVec3::new(130.0 + 160.0 * part, 0.0, 65.0 + 49.0 * part);
            let position = foot + (0.5 + 2.0 * away) * DVec3::new(0.293, 0.0, -0.956) - scene.middle;
            let receiver =
                Standpoint::find(solution.elements(), &visibility, position, normal).receiver_point(normal);
            let by = |doubt: Option<f64>| -> f64 {
                gathering.reflected_for_sure(&receiver, &lit, &lit, doubt).irradiance.iter().sum()
            };
            let [anew, pixel, plain] = [Some(0.0), Some(DOUBTFUL_PIXEL), None].map(by);
            let misses = |light: f64| (light / anew - 1.0).abs() > 0.2;
            off[0] += f64::from(u8::from(misses(pixel)));
            off[1] += f64::from(u8::from(misses(plain)));
        }
        assert!(off[1] > 30.0 && off[0] < 0.75 * off[1], "{off:?}");
    }

    /// Points on the floor of the Cornell box: what is doubtful is read anew alone, the rest as it is gathered.
    #[test]
    fn reflected_light_of_each_point_is_gathered_in_one_way() {
        let (scene, solution, visibility) = cornell_box();
        let gathering = GatherMethod::Cells.readings(&solution, &visibility, 1e-2, false);
        let floor = scene.surface_named("floor").expect("it is there");
        let mut doubtful = 0;
        for [u, v] in (0..25).map(|k| [k / 5, k % 5].map(|x| -0.9 + 0.45 * f64::from(x))) {
            let jet = scene.surfaces[floor].shape.jet(u, v);
            let receiver = Standpoint::find(solution.elements(), &visibility, jet.position, jet.normal)
                .receiver_point(jet.normal);
            let gathered = Cell::new(0);
            let lit = vec![0.0; solution.bands().len()];
            let found = gathering.beside(&receiver, &lit, || {
                gathered.set(gathered.get() + 1);
                lit.clone().into()
            });
            let is_anew = found.uncertainty.deviation.is_some();
            doubtful += usize::from(is_anew);
            assert_eq!(gathered.get(), usize::from(!is_anew));
            assert!(is_anew || found.irradiance == lit);
        }
        assert!(doubtful > 0 && doubtful < 25, "{doubtful}");
    }

    /// Six points near the foot of the short block of the Cornell box, in its shadow, where of 262 there readings are
    /// off by the most times what is told: walks find how far, with the doubt and without it.
    #[test]
    fn readings_beside_a_block_tell_what_polynomials_miss() {
        let scene = radiosity_language::builtin("cornell-box").expect("it is built in");
        let options = Options { order: 3, ..Options::default() };
        let solution = solve(&scene, &options, &Work::alone()).expect("a solution").solution;
        let visibility = options.visibility(&scene);
        let reading = |by: GatherMethod, eps| by.readings(&solution, &visibility, eps, false);
        let [cells, walks] = [reading(GatherMethod::Cells, 1.25e-3), reading(GatherMethod::Walks, 3e-3)];
        let size = |squares: f64| (squares / solution.bands().len() as f64).sqrt();
        let mut most = [0.0_f64; 2];
        for [x, z] in
            [[91.4, 190.2], [93.7, 181.8], [85.2, 200.9], [82.1, 216.3], [85.1, 195.3], [86.4, 184.0]]
        {
            let position = DVec3::new(x, 0.0, z) - scene.middle;
            let receiver = Standpoint::find(solution.elements(), &visibility, position, DVec3::Y)
                .receiver_point(DVec3::Y);
            let [found, right] = [&cells, &walks].map(|gathering| gathering.read(&receiver));
            let bands = found.irradiance.iter().zip(&right.irradiance);
            let off = size(bands.map(|(one, other)| (one - other).powi(2)).sum());
            let noise = right.uncertainty.deviation.expect("walks have one").absolute;
            let known = found
                .uncertainty
                .deviation
                .map_or(1.25e-3 * size(found.irradiance.iter().map(|e| e * e).sum()), |own| own.absolute);
            for (most, told) in most.iter_mut().zip([known, known.hypot(found.uncertainty.doubt)]) {
                *most = most.max(off / told.hypot(noise));
            }
        }
        assert!(most[0] > 9.0 && most[1] < 5.0, "{most:?}");
    }
}
