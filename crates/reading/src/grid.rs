//! Means of irradiance and radiosity over cells of equal parameter size.
//!
//! For each surface and each cell of an m × n cut of [−1, 1]²,
//!
//! ```text
//! mean E = 1/A_cell ∫_{cell ∩ element} E dA ,
//! ```
//!
//! with A_cell the area of the cell within the surface's outer outline, holes included: the mean counts a
//! hole, where something else stands, as dark. Integrals of polynomials are exact on flat surfaces.
//! Recomputed light is integrated by Gauss rules over the pieces of the cell; direct light, cheap but with
//! shadow edges, gets more points than gathered light.

use std::collections::BTreeSet;
use std::sync::atomic::{AtomicUsize, Ordering};

use radiosity_elements::cells::cells_of;
use radiosity_elements::clip_to_cell;
use radiosity_elements::coating::Means;
use radiosity_elements::patch::{Node, Patch};
use radiosity_elements::rule::UnitRule;
use radiosity_geom::{DVec3, PlanarRegion, Rect, Surface, polygon_area};
use radiosity_light::direct::DirectLight;
use radiosity_light::occluders::Site;
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_light::reflected::Reflection;
use radiosity_solve::gather::gather_method::GatheredBy;
use radiosity_solve::gather::read_irradiance::{Deviation, ReadIrradiance, Uncertainty};
use radiosity_solve::gather::receiver::Receiver;
use radiosity_solve::solution::SurfacePlace;
use radiosity_work::ranks::{PartName, vector};
use radiosity_work::{Stage, Work};
use serde::{Deserialize, Serialize};

use crate::cell_counts::CellCounts;
use crate::reader::{Reader, RecomputedLight};

/// Means over one cell of one surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cell {
    /// Index of the surface.
    pub surface: usize,
    /// Place of the cell along u and v.
    pub index: [usize; 2],
    /// Mean irradiance per band (W m⁻²).
    pub irradiance: Vec<f64>,
    /// Mean radiosity per band (W m⁻²).
    pub radiosity: Vec<f64>,
    /// Mean absorbed flux per band (W m⁻²): (1 − ρ − τ) E.
    pub absorbed: Vec<f64>,
    /// The error of the irradiance, as far as it is known.
    pub uncertainty: Uncertainty,
    /// Area of the cell within the outer outline (scene length²).
    pub area: f64,
    /// Area of its elements: without holes, and without footprints that are cut out of them (scene length²).
    pub exposed: f64,
    /// The point in the middle of the cell's parameters, in the coordinates that the scene is computed in:
    /// less [`Scene::middle`](radiosity_scene::Scene::middle).
    #[serde(with = "vector")]
    pub position: DVec3,
}

/// Points along each side of a cell for recomputed light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rates {
    /// Points for direct light.
    pub direct: usize,
    /// Points for gathered light.
    pub indirect: usize,
}

impl Default for Rates {
    /// 4 and 2: on the Cornell box more points change little.
    fn default() -> Self {
        Self { direct: 4, indirect: 2 }
    }
}

/// Most cells that a thread gets at once: cells in shadow take many times as long as others, and the last
/// ones to be done must not wait for one thread.
const AT_ONCE: usize = 8;

/// A cell that is to be read.
struct CellPlace {
    surface: usize,
    index: [usize; 2],
    rect: Rect,
}

/// The means over `cells` of every surface, v fastest.
///
/// Cells without area are left out.
pub fn grid(reader: &Reader, cells: impl Into<CellCounts>, rates: Rates, work: &Work<'_>) -> Vec<Cell> {
    let cells = cells.into();
    let surfaces = reader.solution().elements().surfaces();
    let outlines: Vec<Option<Vec<Vec<DVec3>>>> =
        (0..surfaces).map(|surface| outline(reader.solution().elements().shape(surface))).collect();
    let of_surface = |surface: usize| {
        let counts = cells.of(surface);
        let index = move |k: usize| [k / counts[1], k % counts[1]];
        cells_of(counts).enumerate().map(move |(k, rect)| CellPlace { surface, index: index(k), rect })
    };
    let places: Vec<CellPlace> = (0..surfaces).flat_map(of_surface).collect();
    reader.expect(|| places.iter().map(|place| patches_of(reader, place)).sum());
    let (total, done) = (places.len(), AtomicUsize::new(0));
    let by = CellReader { reader, rates, count: total };
    let read = |place: usize| {
        let CellPlace { surface, index, rect } = &places[place];
        let integrals = Integrals::over(&by, *surface, rect);
        work.report_done(Stage::Cells, done.fetch_add(1, Ordering::Relaxed) + 1, total);
        let shape = reader.solution().elements().shape(*surface);
        let area = outlines[*surface]
            .as_ref()
            .map(|pieces| clip_to_cell(shape, pieces, rect).iter().map(|part| polygon_area(part)).sum());
        let [u, v] = rect.center();
        integrals.cell(*surface, *index, shape.jet(u, v).position, area)
    };
    let all = work.during(Stage::Cells, || work.ranks.map_even(PartName::Cells, total, AT_ONCE, read));
    all.into_iter().filter(|cell| cell.area > 0.0).collect()
}

/// Number of patches that a cell is read on, without those of other sides.
fn patches_of(reader: &Reader, CellPlace { surface, rect, .. }: &CellPlace) -> usize {
    let elements = reader.solution().elements();
    elements.of_surface(*surface).map(|element| elements.patches_over(element, rect).len()).sum()
}

/// The reader of cells.
#[derive(Clone, Copy)]
struct CellReader<'a> {
    reader: &'a Reader<'a>,
    rates: Rates,
    /// Cells that are read.
    count: usize,
}

/// Convex pieces of the outer outline of a planar surface; None for curved ones.
fn outline(shape: &dyn Surface) -> Option<Vec<Vec<DVec3>>> {
    let region = shape.region()?;
    if region.holes().is_empty() {
        return Some(region.convex_pieces().to_vec());
    }
    PlanarRegion::new(region.outer().to_vec(), Vec::new()).ok().map(|whole| whole.convex_pieces().to_vec())
}

/// ∫ E dA, ∫ B dA and ∫ (1 − ρ − τ) E dA per band, and ∫ dA, over the part of a surface in a rectangle of its
/// parameters.
struct Integrals {
    irradiance: Vec<f64>,
    radiosity: Vec<f64>,
    absorbed: Vec<f64>,
    covered: f64,
    uncertainties: Uncertainties,
}

/// Uncertainties of integrals that are added, all bands together.
#[derive(Default)]
struct Uncertainties {
    /// Sum of the squares of the standard deviations relative to the integrals (W).
    squares: f64,
    /// Sum of the squares of the standard deviations (W).
    absolute: f64,
    is_dark: bool,
    are_rays: bool,
    /// Sum of the errors that polynomials leave (W).
    doubt: f64,
}

impl Uncertainties {
    /// Adds the uncertainty of the integral `size` (W) over an area.
    fn add(&mut self, Uncertainty { deviation, doubt }: Uncertainty, size: f64, area: f64) {
        self.doubt += doubt * area;
        let Some(deviation) = deviation else { return };
        self.squares += (deviation.relative * size).powi(2);
        self.absolute += (deviation.absolute * area).powi(2);
        self.is_dark |= deviation.is_dark;
        self.are_rays = true;
    }

    /// The uncertainty of all integrals over an `area`, which together are `size` (W).
    fn over(&self, size: f64, area: f64) -> Uncertainty {
        let part = |squares: f64, of: f64| if of > 0.0 { squares.sqrt() / of } else { 0.0 };
        let (relative, absolute) = (part(self.squares, size), part(self.absolute, area));
        let doubt = if area > 0.0 { self.doubt / area } else { 0.0 };
        let deviation = self.are_rays.then_some(Deviation { relative, absolute, is_dark: self.is_dark });
        Uncertainty { deviation, doubt }
    }
}

impl Integrals {
    fn over(by: &CellReader, surface: usize, rect: &Rect) -> Self {
        let reader = by.reader;
        let bands = reader.solution().bands();
        let mut sums = Self {
            irradiance: vec![0.0; bands.len()],
            radiosity: vec![0.0; bands.len()],
            absorbed: vec![0.0; bands.len()],
            covered: 0.0,
            uncertainties: Uncertainties::default(),
        };
        let elements = reader.solution().elements();
        // Elements of the other side whose light comes through.
        let mut behind = BTreeSet::new();
        for element in elements.of_surface(surface) {
            for patch in elements.patches_over(element, rect) {
                sums.add(by, element, &patch, rect);
            }
            behind.extend(bands.iter().flat_map(|band| band.coating.all_behind(element)));
        }
        for element in behind {
            for patch in elements.patches_over(element, rect) {
                sums.add_transmitted(by, element, &patch);
            }
        }
        sums
    }

    /// Adds the light on a patch of an element.
    fn add(&mut self, by: &CellReader, element: usize, patch: &Patch, rect: &Rect) {
        let area = area(patch);
        let ReadIrradiance { irradiance, uncertainty } = over_patch(by, element, patch);
        let irradiance: Vec<f64> = irradiance.into_iter().map(|mean| mean * area).collect();
        self.covered += area;
        self.uncertainties.add(uncertainty, irradiance.iter().sum(), area);
        for (index, band) in by.reader.solution().bands().iter().enumerate() {
            let Means { exitance, reflectance } = band.coating.means_over(element, patch, rect);
            let kept = 1.0 - reflectance - band.coating.transmittance(element);
            self.irradiance[index] += irradiance[index];
            self.radiosity[index] += exitance * area + reflectance * irradiance[index];
            self.absorbed[index] += kept * irradiance[index];
        }
    }

    /// Adds the light that comes through from a patch of an element of the other side.
    fn add_transmitted(&mut self, by: &CellReader, element: usize, patch: &Patch) {
        let area = area(patch);
        let arriving = over_patch(by, element, patch).irradiance;
        for (index, band) in by.reader.solution().bands().iter().enumerate() {
            self.radiosity[index] += band.coating.transmittance(element) * area * arriving[index];
        }
    }

    /// The means; `area` is that of the cell if the surface has an outline, else the integrated area is
    /// taken.
    fn cell(self, surface: usize, index: [usize; 2], position: DVec3, area: Option<f64>) -> Cell {
        let exposed = self.covered;
        let area = area.unwrap_or(exposed);
        let mean =
            |sum: Vec<f64>| sum.into_iter().map(|sum| if area > 0.0 { sum / area } else { 0.0 }).collect();
        let uncertainty = self.uncertainties.over(self.irradiance.iter().sum(), area);
        let [irradiance, radiosity, absorbed] = [self.irradiance, self.radiosity, self.absorbed].map(mean);
        Cell { surface, index, irradiance, radiosity, absorbed, uncertainty, area, exposed, position }
    }
}

/// Gauss points along each direction for the area of a curved patch, which turns by a quarter circle at most:
/// they find it to rounding where its area element is smooth. Where the area divides out of a mean, half as
/// many do.
const AREA_POINTS: usize = 16;

/// Mean of E per band over a patch of an element.
fn over_patch(by: &CellReader, element: usize, patch: &Patch) -> ReadIrradiance {
    let read = read_over_patch(by, element, patch);
    by.reader.note_read();
    read
}

/// [`over_patch`], of which the pace of the reader is not told.
fn read_over_patch(by: &CellReader, element: usize, patch: &Patch) -> ReadIrradiance {
    let CellReader { reader, rates, count } = *by;
    let owner = &reader.solution().elements().list()[element];
    let degree = owner.basis.total_degree();
    let exact = if patch.is_flat() { degree / 2 + 2 } else { degree + 4 };
    let place = |node: &Node| SurfacePlace {
        surface: owner.surface,
        parameters: node.parameters.to_array(),
        position: node.position,
    };
    let horizon = owner.plane.map(|plane| plane.normal);
    let polynomials = |node: &Node| reader.polynomials(element, &place(node));
    let indirect = |node: &Node| reader.indirect_polynomials(element, &place(node));
    match reader.light() {
        // Masks have edges, like direct light.
        RecomputedLight::Basis if reader.solution().masked().is_some() => {
            mean(patch, exact.max(rates.direct), polynomials).into()
        }
        RecomputedLight::Basis => mean(patch, exact, polynomials).into(),
        RecomputedLight::Direct(direct) => {
            sum(lit(direct, owner.surface, patch, horizon, rates.direct), &mean(patch, exact, indirect))
                .into()
        }
        RecomputedLight::Gathered(light) => {
            let origin = Receiver::over(owner.surface, patch);
            match light.by() {
                GatheredBy::Rays(gather) => gather.read_one_of(&origin, count),
                GatheredBy::Cells(gather) => {
                    let lit = lit(gather.direct(), owner.surface, patch, horizon, rates.direct);
                    let gathered =
                        gathered(gather.reflection(), owner.surface, patch, horizon, rates.indirect, &lit);
                    light.settled(&origin, &lit, &gathered)
                }
            }
        }
    }
}

/// Area of a patch, to rounding if it is flat.
fn area(patch: &Patch) -> f64 {
    let rule = UnitRule::of(if patch.is_flat() { 2 } else { AREA_POINTS });
    let weights = rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t)));
    weights.map(|((s, ws), (t, wt))| ws * wt * patch.node(s, t).area).sum()
}

/// Gauss points per direction where direct light is smooth: 2 × 2 then err by about 8e-5
/// ([`DirectLight::is_smooth`]).
const SMOOTH: usize = 2;

/// Mean of D per band over a patch.
fn lit(
    direct: &DirectLight,
    surface: usize,
    patch: &Patch,
    horizon: Option<DVec3>,
    points: usize,
) -> Vec<f64> {
    let hull = patch.hull();
    let site = Site { points: &hull, horizon, surface: Some(surface) };
    let occluders = direct.around(&site);
    let points = if direct.is_smooth(&site, &occluders) { points.min(SMOOTH) } else { points };
    let value =
        |node: &Node| direct.irradiance(&ReceiverPoint::on(surface, node.position, node.normal), &occluders);
    mean(patch, points, value)
}

/// Mean of E − D per band over a patch, where the mean of D is `lit`.
fn gathered(
    reflection: &Reflection,
    surface: usize,
    patch: &Patch,
    horizon: Option<DVec3>,
    points: usize,
    lit: &[f64],
) -> Vec<f64> {
    let occluders = reflection.around(&Site { points: &patch.hull(), horizon, surface: Some(surface) });
    mean(patch, points, |node| {
        reflection.irradiance(&ReceiverPoint::on(surface, node.position, node.normal), &occluders, lit)
    })
}

/// ∫ value dA / ∫ dA over a patch, both by the same Gauss rule, which is exact for constants with any number
/// of points.
fn mean(patch: &Patch, points: usize, value: impl Fn(&Node) -> Vec<f64>) -> Vec<f64> {
    let rule = UnitRule::of(points);
    let (mut total, mut area) = (Vec::new(), 0.0);
    for ((s, ws), (t, wt)) in rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t))) {
        let node = patch.node(s, t);
        let weight = ws * wt * node.area;
        area += weight;
        let values = value(&node);
        total.resize(values.len(), 0.0);
        total.iter_mut().zip(values).for_each(|(total, value)| *total += weight * value);
    }
    total.into_iter().map(|total| if area > 0.0 { total / area } else { 0.0 }).collect()
}

fn sum(mut a: Vec<f64>, b: &[f64]) -> Vec<f64> {
    a.iter_mut().zip(b).for_each(|(a, b)| *a += b);
    a
}
