//! The first bounce: direct light and the light that was reflected exactly once, with all shadows.
//!
//! ```text
//! D(x) = ∫ κ V E₀ dA_y ,     g(x) = ∫ κ V ρ D dA_y        W m⁻²
//! d_k = ∫ φ_k D dA ,         g_k = ∫ φ_k g dA             W m⁻² times length
//! ```
//!
//! Where direct light is split off, g_k replaces G ρ d in the right-hand side: the shadow edges of D, which
//! no polynomial follows, are then smoothed by one transport before anything is projected. Polynomials never
//! transport D itself; d serves only to read the solution from polynomials.
//!
//! The integrals over x are Gauss rules on m × m cells of each patch: many cells for D with its edges, few
//! for the smooth g, whose points are exact for φ_k times a linear function.

mod node_counts;

use std::collections::BTreeMap;

use radiosity_core::dot;
use radiosity_elements::coating::Coating;
use radiosity_elements::patch::{Direction, Node, Patch};
use radiosity_elements::rule::UnitRule;
use radiosity_elements::{Element, starts};
use radiosity_geom::{Aabb, DVec3};
use radiosity_visibility::Visibility;
use radiosity_work::interruption::check_interrupt;
use radiosity_work::ranks::{PartName, Ranks};

use crate::coats::Coats;
use crate::direct::DirectLight;
use crate::emitters::Emitters;
use crate::occluders::Site;
use crate::point_lights::PointLights;
use crate::receiver_point::ReceiverPoint;
use crate::reflected;
use crate::reflected::{IrradianceAt, Reflection};
use crate::tolerances::MOST_QUARTERINGS_AT_LUMINAIRE;
pub use node_counts::NodeCounts;

/// Halvings of a patch in each direction for D: sixteen cells, of which a shadow edge crosses a few. An
/// arbitrary choice: with fewer d is off by more where edges pass, and each further one takes four times the
/// points.
const DIRECT_HALVINGS: usize = 2;

/// Halvings of a patch in each direction for g, unless it is small: g is smooth, and each of its points
/// gathers.
const REFLECTED_HALVINGS: usize = 1;

/// Halvings for D in the light of the sun, whose patches have sharp borders, and of luminaires beside it:
/// 4096 cells, a ray for each point, so that a border is blurred over 1/64 of the patch.
const SUNNY_HALVINGS: usize = 6;

/// A cell whose radius exceeds this part of its distance from a luminaire is quartered for D. Two
/// points each way then err by about 0.02 (2 · 0.15)⁴ = 2e-4 of what the cell receives.
const PEAKED: f64 = 0.15;

/// [`PEAKED`] of emitting elements where rays find D: 0.02 (2 · 0.3)⁴ = 2.6e-3, less than their noise.
const PEAKED_BY_RAYS: f64 = 0.3;

/// A patch below this part of its element's area is small: it is not halved for g, since others sample the
/// element too.
const SMALL: f64 = 0.25;

/// Loosest relative accuracy of g at a point: errors average out in the coefficients g_k, of some tens of
/// points each. With a larger value single points would show.
pub const LOOSEST: f64 = 2e-2;

/// Accuracy of g at a point over that of D, of the light of openings and luminous areas: what lies far from
/// them has reflected light alone, and cells err to one side. Measured in a room of 6 m with a window: at its
/// end 0.7 % were missing with 1, 0.1 % are with this, in the same time.
const REFLECTED: f64 = 0.1;

/// Coefficients of the first bounce in the orthonormal bases, element by element, per band.
#[derive(Debug)]
pub struct Bounce {
    /// d, the coefficients of the direct irradiance (W m⁻² times scene length).
    pub direct: Vec<Vec<f64>>,
    /// g, the coefficients of the irradiance that was reflected exactly once (W m⁻² times scene length).
    pub reflected: Vec<Vec<f64>>,
    /// The part of g that each of some elements reflected, per band.
    pub apart: BTreeMap<usize, Vec<Vec<f64>>>,
}

/// A node of the rule for d on an element.
#[derive(Clone, Copy, Debug)]
pub struct NumberedNode<'n> {
    /// The node.
    pub node: &'n Node,
    /// Its number among those of the element, from 0 on, neighbours near each other.
    pub number: usize,
    /// Number of nodes on the element.
    pub count: usize,
}

/// Irradiance (W m⁻²) per band at a node of the rule for d on an element.
pub type IrradianceAtNode<'a> = &'a (dyn Fn(usize, &NumberedNode<'_>) -> Vec<f64> + Sync);

/// Direct light that is given at points.
#[derive(Clone, Copy)]
pub struct GivenLight<'a> {
    /// Irradiance (W m⁻²) per band at a node of an element.
    pub lit: IrradianceAt<'a>,
    /// Elements whose part of the first bounce is kept apart, each once.
    pub apart: &'a [usize],
}

/// Ways of direct light into the linear system.
#[derive(Debug)]
pub enum DirectLightEntry {
    /// All direct light enters as exitance, which is carried like all other radiosity.
    Carried,
    /// Light of surfaces enters as exitance, that of luminaires by the coefficients of its irradiance,
    /// element by element, per band (W m⁻² times scene length).
    Lit(Vec<Vec<f64>>),
    /// All direct light by the coefficients of its irradiance, element by element, per band (W m⁻² times scene
    /// length); what surfaces reflect of it is carried.
    Arrived(Vec<Vec<f64>>),
    /// Direct light and the first bounce are split off the solution.
    Split(Bounce),
}

/// Halvings of a patch in each direction for the light of luminaires and of the sun.
fn halvings_of(points: &PointLights) -> usize {
    if points.has_sun() { SUNNY_HALVINGS } else { DIRECT_HALVINGS }
}

/// Points each way of a cell for d.
fn direct_points(element: &Element, halvings: usize) -> usize {
    (element.basis.order() >> halvings) + 2
}

/// Halvings of a patch in each direction for g.
fn reflected_halvings(element: &Element, patch: &Patch) -> usize {
    if area(patch) < SMALL * element.area { 0 } else { REFLECTED_HALVINGS }
}

/// Points each way of a cell for g.
fn reflected_points(element: &Element, halvings: usize) -> usize {
    element.basis.order().div_ceil(1 << halvings) + 1
}

/// The coefficients of the irradiance from luminaires on `elements`, per band (W m⁻² times scene length).
pub fn lit_by(sources: &Emitters<'_>, visibility: &Visibility, ranks: &Ranks) -> Vec<Vec<f64>> {
    let Emitters { elements, ref coatings, points, .. } = *sources;
    let lamps: Vec<Peak> = points.ends().map(Peak::between).collect();
    let halvings = halvings_of(points);
    let lit = |index: usize, own: &NumberedNode<'_>| {
        let mut lit = vec![0.0; coatings.len()];
        let NumberedNode { node, .. } = *own;
        let receiver = ReceiverPoint::on(elements[index].surface, node.position, node.normal);
        points.add(&receiver, visibility, &mut lit);
        lit
    };
    coefficients(sources, &Peaks { lamps: &lamps, halvings, part: PEAKED }, &lit, ranks)
}

/// The coefficients of the irradiance `lit` from elements, which rays find, and of that from luminaires, per band (W
/// m⁻² times scene length).
pub fn arrived(
    sources: &Emitters<'_>,
    visibility: &Visibility,
    lit: IrradianceAtNode<'_>,
    ranks: &Ranks,
) -> Vec<Vec<f64>> {
    let emits = |index: &usize| sources.coatings.iter().any(|own| own.exitance[*index] > 0.0);
    let lamps: Vec<Peak> =
        (0..sources.elements.len()).filter(emits).map(|index| Peak::of(&sources.elements[index])).collect();
    let peaks = Peaks { lamps: &lamps, halvings: DIRECT_HALVINGS, part: PEAKED_BY_RAYS };
    let mut d = coefficients(sources, &peaks, lit, ranks);
    add_lit_by(sources, visibility, ranks, &mut d);
    d
}

/// Adds the coefficients of the irradiance from luminaires to `d`.
fn add_lit_by(sources: &Emitters<'_>, visibility: &Visibility, ranks: &Ranks, d: &mut [Vec<f64>]) {
    if !sources.points.is_empty() {
        let of_points = lit_by(sources, visibility, ranks);
        let pairs = d.iter_mut().flatten().zip(of_points.iter().flatten());
        pairs.for_each(|(sum, own)| *sum += own);
    }
}

/// The coefficients of the direct irradiance `lit` per band (W m⁻² times scene length).
fn coefficients(
    sources: &Emitters<'_>,
    peaks: &Peaks<'_>,
    lit: IrradianceAtNode<'_>,
    ranks: &Ranks,
) -> Vec<Vec<f64>> {
    let Emitters { elements, ref coatings, .. } = *sources;
    let bands = coatings.len();
    let of_element = |index: usize| of_direct(&elements[index], peaks, bands, &|node| lit(index, node));
    projected(elements.len(), bands, &of_element, ranks)
}

/// Where direct light wants small cells.
struct Peaks<'a> {
    /// Emitters before which it peaks.
    lamps: &'a [Peak],
    /// Halvings of all patches in each direction.
    halvings: usize,
    /// Largest radius of a cell, over its distance from an emitter.
    part: f64,
}

/// An emitter before which light peaks.
struct Peak {
    /// Ends of a luminaire; twice the middle of an element.
    ends: [DVec3; 2],
    /// Radius of a ball around an element (scene length), 0 of a luminaire: nearer than that light varies no
    /// faster.
    radius: f64,
}

impl Peak {
    fn between(ends: [DVec3; 2]) -> Self {
        Self { ends, radius: 0.0 }
    }

    fn of(element: &Element) -> Self {
        let bounds = Aabb::around(element.hull.iter().copied());
        Self { ends: [bounds.center(); 2], radius: 0.5 * bounds.diagonal() }
    }

    /// Whether a cell of this middle and radius, larger than `part` of its distance, is before it.
    fn is_near(&self, middle: &Node, radius: f64, part: f64) -> bool {
        let step = nearest(&self.ends, middle.position) - middle.position;
        step.dot(middle.normal) > -(radius + self.radius) && radius > part * step.length().max(self.radius)
    }
}

impl Peaks<'_> {
    /// Light from surfaces peaks nowhere.
    const NONE: Self = Self { lamps: &[], halvings: DIRECT_HALVINGS, part: PEAKED };

    /// Whether light peaks within a cell.
    fn are_near(&self, cell: &Patch) -> bool {
        let middle = cell.node(0.5, 0.5);
        let corners = cell.corners();
        let radius = corners.iter().map(|corner| corner.distance(middle.position)).fold(0.0, f64::max);
        self.lamps.iter().any(|lamp| lamp.is_near(&middle, radius, self.part))
    }
}

/// For each channel the coefficients that `project` finds, element by element.
fn projected(
    elements: usize,
    channels: usize,
    project: &(dyn Fn(usize) -> Vec<Vec<f64>> + Sync),
    ranks: &Ranks,
) -> Vec<Vec<f64>> {
    let parts = ranks.map(PartName::FirstBounce, &vec![1.0; elements], project);
    let together = |channel: usize| parts.iter().flat_map(|part| &part[channel]).copied().collect();
    (0..channels).map(together).collect()
}

/// The first bounce, apart by what reflected it.
#[derive(Debug)]
pub struct CoatedBounce {
    /// d, as in [`Bounce`].
    direct: Vec<Vec<f64>>,
    coats: Coats,
    /// The part of g from each coat, per band.
    reflected: Vec<Vec<Vec<f64>>>,
    /// Elements that have a coat of their own.
    apart: Vec<usize>,
}

impl CoatedBounce {
    /// The first bounce of exact direct light from `sources`; its relative accuracy is about the smaller of
    /// `eps` and `LOOSEST`.
    pub fn new(sources: &Emitters<'_>, visibility: &Visibility, eps: f64, ranks: &Ranks) -> Self {
        let eps = eps.min(LOOSEST);
        let direct = DirectLight::within(sources, visibility, eps);
        let lit = |element: usize, node: &Node| direct.at(element, node.position, node.normal);
        let of_elements = |element: usize, own: &NumberedNode<'_>| direct.of_elements_at(element, own.node);
        let mut d = coefficients(sources, &Peaks::NONE, &of_elements, ranks);
        add_lit_by(sources, visibility, ranks, &mut d);
        Self::reflected(sources, visibility, GivenLight { lit: &lit, apart: &[] }, d, eps, ranks)
    }

    /// The first bounce of any direct light, from elements alone.
    pub fn of(
        sources: &Emitters<'_>,
        visibility: &Visibility,
        light: GivenLight<'_>,
        eps: f64,
        ranks: &Ranks,
    ) -> Self {
        let lit = |element: usize, own: &NumberedNode<'_>| (light.lit)(element, own.node);
        let d = coefficients(sources, &Peaks::NONE, &lit, ranks);
        Self::reflected(sources, visibility, light, d, eps, ranks)
    }

    /// The first bounce of direct light with the coefficients d.
    fn reflected(
        sources: &Emitters<'_>,
        visibility: &Visibility,
        GivenLight { lit, apart }: GivenLight<'_>,
        d: Vec<Vec<f64>>,
        eps: f64,
        ranks: &Ranks,
    ) -> Self {
        let Emitters { elements, ref coatings, points, .. } = *sources;
        let bands = coatings.len();
        let scale = scales(elements, coatings, &d);
        let reflection = Reflection::new(elements, coatings, visibility, lit, points, scale, eps);
        let coats = Coats::of(coatings, apart);
        let eps = if sources.are_directed() { REFLECTED * eps } else { eps };
        let light = DirectReflection { lit, reflection, coats: &coats, eps };
        let of_element = |index: usize| of_reflected(&elements[index], index, &light);
        let mut channels = projected(elements.len(), coats.count() * bands, &of_element, ranks).into_iter();
        let reflected = (0..coats.count()).map(|_| channels.by_ref().take(bands).collect()).collect();
        Self { direct: d, coats, reflected, apart: apart.to_vec() }
    }

    /// The bounce by `new` coatings of the same exitance as the `old` ones it was computed for. None where it
    /// has to be computed anew.
    pub fn repainted(&self, old: &[&Coating], new: &[&Coating]) -> Option<Bounce> {
        let factors = self.coats.change(old, new)?;
        let of_band = |band: usize| {
            let mut sum = vec![0.0; self.direct[band].len()];
            for (part, factor) in self.reflected.iter().zip(&factors) {
                let scaled = part[band].iter().map(|g| factor[band] * g);
                sum.iter_mut().zip(scaled).for_each(|(sum, g)| *sum += g);
            }
            sum
        };
        let own = |element: &usize| {
            let coat = self.coats.of_element(*element);
            let bands = self.reflected[coat].iter().zip(&factors[coat]);
            let scaled = bands.map(|(part, factor)| part.iter().map(|g| factor * g).collect());
            (*element, scaled.collect())
        };
        Some(Bounce {
            direct: self.direct.clone(),
            reflected: (0..old.len()).map(of_band).collect(),
            apart: self.apart.iter().map(own).collect(),
        })
    }
}

/// Mean reflected radiosity ρ D (W m⁻²) of each band over the scene.
fn scales(elements: &[Element], coatings: &[&Coating], direct: &[Vec<f64>]) -> Vec<f64> {
    let starts = starts(elements);
    let mean = |(coating, direct): (&&Coating, &Vec<f64>)| {
        reflected::scale(elements, coating.reflected(&starts, direct).into_iter())
    };
    coatings.iter().zip(direct).map(mean).collect()
}

/// The coefficients d of an element, per band.
fn of_direct(
    element: &Element,
    peaks: &Peaks<'_>,
    bands: usize,
    lit: &dyn Fn(&NumberedNode<'_>) -> Vec<f64>,
) -> Vec<Vec<f64>> {
    let mut sums = Sums::new(element, bands);
    let points = direct_points(element, peaks.halvings);
    let whole = element.patches.iter().flat_map(|patch| cells(patch, peaks.halvings));
    let mut open: Vec<(Patch, usize)> = whole.map(|cell| (cell, 0)).collect();
    let mut small = Vec::with_capacity(open.len());
    while let Some((cell, depth)) = open.pop() {
        if depth < MOST_QUARTERINGS_AT_LUMINAIRE && peaks.are_near(&cell) {
            open.extend(cells(&cell, 1).into_iter().map(|quarter| (quarter, depth + 1)));
        } else {
            small.push(cell);
        }
    }
    let count = small.len() * points * points;
    let mut number = 0;
    for cell in small {
        sums.add(&cell, points, |node| {
            let lit = lit(&NumberedNode { node, number, count });
            number += 1;
            lit
        });
    }
    sums.finish()
}

/// The point between two ends that is nearest to a point.
fn nearest([start, end]: &[DVec3; 2], point: DVec3) -> DVec3 {
    let along = *end - *start;
    let square = along.length_squared();
    let part = if square > 0.0 { ((point - *start).dot(along) / square).clamp(0.0, 1.0) } else { 0.0 };
    *start + part * along
}

/// Direct light, and what of it is reflected by which coat.
struct DirectReflection<'a> {
    lit: IrradianceAt<'a>,
    reflection: Reflection<'a>,
    coats: &'a Coats,
    /// Relative accuracy of g at a point.
    eps: f64,
}

/// The coefficients g of an element, per coat and band.
fn of_reflected(element: &Element, index: usize, light: &DirectReflection<'_>) -> Vec<Vec<f64>> {
    let DirectReflection { lit, reflection, coats, eps } = light;
    let mut sums = Sums::new(element, coats.count() * reflection.bands());
    for patch in &element.patches {
        let halvings = reflected_halvings(element, patch);
        let points = reflected_points(element, halvings);
        for cell in cells(patch, halvings) {
            let site = Site { points: &cell.hull(), ..Site::of(element) };
            let around = reflection.around(&site);
            sums.add(&cell, points, |node| {
                let receiver = ReceiverPoint::on(element.surface, node.position, node.normal);
                reflection.irradiance_by_coat(*eps, &receiver, &around, &lit(index, node), coats)
            });
        }
    }
    sums.finish()
}

/// The 2^halvings × 2^halvings cells of a patch.
fn cells(patch: &Patch, halvings: usize) -> Vec<Patch> {
    let mut cells = vec![patch.clone()];
    for _ in 0..halvings {
        let columns = cells.iter().flat_map(|cell| cell.halves(Direction::Along));
        cells = columns.flat_map(|half| half.halves(Direction::Across)).collect();
    }
    cells
}

/// Area of a patch by one point at its middle.
fn area(patch: &Patch) -> f64 {
    patch.node(0.5, 0.5).area
}

/// ∫ R_k f dA in the raw polynomials R_k of an element, per band.
struct Sums<'a> {
    element: &'a Element,
    raw: Vec<f64>,
    sums: Vec<Vec<f64>>,
}

impl<'a> Sums<'a> {
    fn new(element: &'a Element, bands: usize) -> Self {
        let zero = vec![0.0; element.basis.len()];
        Self { element, sums: vec![zero.clone(); bands], raw: zero }
    }

    /// Adds the integral over a cell by the Gauss rule of `points` × `points` points.
    fn add(&mut self, cell: &Patch, points: usize, mut value: impl FnMut(&Node) -> Vec<f64>) {
        let basis = &self.element.basis;
        let rule = UnitRule::of(points);
        for ((s, ws), (t, wt)) in rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t))) {
            check_interrupt();
            let node = cell.node(s, t);
            basis.raw(basis.frame().coordinates(&node), &mut self.raw);
            for (sums, value) in self.sums.iter_mut().zip(value(&node)) {
                let weighted = ws * wt * node.area * value;
                sums.iter_mut().zip(&self.raw).for_each(|(sum, raw)| *sum += weighted * raw);
            }
        }
    }

    /// ∫ φ_k f dA with φ_k = Σ_l T_kl R_l.
    fn finish(self) -> Vec<Vec<f64>> {
        let basis = &self.element.basis;
        let rows = || basis.transform().chunks_exact(basis.len());
        let orthonormal = |sums: &Vec<f64>| rows().map(|row| dot(row, sums)).collect();
        self.sums.iter().map(orthonormal).collect()
    }
}
