//! Direct light at a point, computed there instead of read from polynomials.
//!
//! ```text
//! D(x) = ∫ κ(x, y) V(x, y) E₀(y) dA_y + Σ_l I_l cos θ V(x, p_l) / |p_l − x|²        W m⁻²
//! ```
//!
//! from elements of the exitance E₀, times what openings to a sky and luminous areas send towards x over what
//! a diffuse emitter would ([`radiosity_scene::Radiance`]), and from luminaires at p_l of the intensity I_l
//! ([`super::point_lights`]). Polynomials smear shadow edges, D does not. D is exact for planar emitters
//! behind planar blockers ([`radiosity_kernel::irradiance::visible_polygon`]). Where an emitter or a blocker
//! is curved, the cells of [`crate`] are refined until D is as accurate as was asked for. A curved emitter that
//! hides nothing of itself and stands free is taken as a whole (`area_light`).

use std::sync::OnceLock;

use radiosity_elements::Element;
use radiosity_elements::patch::Node;
use radiosity_geom::{Aabb, DVec3, Rect};
use radiosity_visibility::Visibility;
use smallvec::{SmallVec, smallvec};

use crate::area_light::AreaLight;
use crate::cells::tree::Tree;
use crate::emitters::Emitters;
use crate::occluders::{Occluders, Site};
use crate::point_lights::PointLights;
use crate::receiver_point::ReceiverPoint;
use crate::tolerances::PER_CELL;
use crate::traversal::Traversal;

/// A site whose diagonal is below this part of its distance from an emitter is small: a rule of 2 × 2 points
/// then has a relative error of about 0.02 · 0.25⁴ = 8e-5.
const SMALL: f64 = 0.25;

/// Most obstacles around a site for which testing each against every shaft pays: an estimate of time, which
/// changes no light.
const FEW: usize = 40;

/// The emitters of a scene, and the possible occluders between them and each element.
#[derive(Debug)]
pub struct DirectLight<'a> {
    elements: &'a [Element],
    points: &'a PointLights,
    visibility: &'a Visibility,
    emitters: Vec<Emitter>,
    trees: Vec<Tree>,
    /// For each emitter, its area light if it can be taken as a whole.
    lamps: Vec<Option<AreaLight<'a>>>,
    /// Occluders per receiving element, of which light was asked for.
    occluders: Vec<OnceLock<Occluders>>,
    bands: usize,
    eps: f64,
}

/// An element that emits.
#[derive(Debug)]
struct Emitter {
    element: usize,
    /// Exitance per band (W m⁻²).
    exitance: Vec<f64>,
}

impl<'a> DirectLight<'a> {
    /// The direct light of `sources`; where it is not exact it errs by about `eps` times all emitters' light
    /// without blockers.
    pub fn within(sources: &Emitters<'a>, visibility: &'a Visibility, eps: f64) -> Self {
        let Emitters { elements, ref coatings, radiances, points } = *sources;
        let emitter = |element: usize| {
            let exitance: Vec<f64> = coatings.iter().map(|coating| coating.exitance[element]).collect();
            exitance.iter().any(|exitance| *exitance > 0.0).then_some(Emitter { element, exitance })
        };
        let emitters: Vec<Emitter> = (0..elements.len()).filter_map(emitter).collect();
        let tree = |emitter: &Emitter| {
            let element = &elements[emitter.element];
            let radiance = radiances.of_surface(element.surface).cloned();
            Tree::uniform(element, emitter.exitance.iter().sum()).spread(radiance)
        };
        let trees: Vec<Tree> = emitters.iter().map(tree).collect();
        let bands = coatings.len();
        let is_whole = |element: &Element| element.rect == Rect::FULL && element.contact.is_none();
        let lamp = |Emitter { element, .. }: &Emitter| {
            let element = Some(&elements[*element]).filter(|element| is_whole(element))?;
            radiances.of_surface(element.surface).is_none().then_some(())?;
            AreaLight::new(visibility, element.surface)
        };
        let lamps = emitters.iter().map(lamp).collect();
        let occluders = elements.iter().map(|_| OnceLock::new()).collect();
        Self { elements, points, visibility, emitters, trees, lamps, occluders, bands, eps }
    }

    /// Possible occluders between the emitters and an element.
    fn around_element(&self, element: usize) -> &Occluders {
        self.occluders[element].get_or_init(|| self.around(&Site::of(&self.elements[element])))
    }

    /// Indices of the emitting elements.
    pub fn emitters(&self) -> impl Iterator<Item = usize> {
        self.emitters.iter().map(|emitter| emitter.element)
    }

    /// For each emitter, its index and the irradiance per unit of its exitance at `x` on element `element`
    /// with the unit normal `n`.
    pub fn factors(&self, element: usize, x: DVec3, n: DVec3) -> Vec<(usize, f64)> {
        let receiver = ReceiverPoint::on(self.elements[element].surface, x, n);
        let factors = self.from(&receiver, self.around_element(element), 0.0);
        self.emitters().zip(factors).collect()
    }

    /// Irradiance (W m⁻²) per band at `x` on element `element` with unit normal `n`.
    pub fn at(&self, element: usize, x: DVec3, n: DVec3) -> Vec<f64> {
        self.at_beside(element, x, n, &[])
    }

    /// As [`DirectLight::at`], where `other` light (W m⁻² per band) arrives too: the tolerance is relative to
    /// both.
    pub fn at_beside(&self, element: usize, x: DVec3, n: DVec3, other: &[f64]) -> Vec<f64> {
        let receiver = ReceiverPoint::on(self.elements[element].surface, x, n);
        self.irradiance_beside(&receiver, self.around_element(element), other)
    }

    /// Irradiance (W m⁻²) per band at a node of element `element`, from elements alone.
    pub(crate) fn of_elements_at(&self, element: usize, node: &Node) -> Vec<f64> {
        let receiver = ReceiverPoint::on(self.elements[element].surface, node.position, node.normal);
        self.add_elements(&receiver, self.around_element(element), vec![0.0; self.bands], 0.0)
    }

    /// Possible occluders between the emitters and a site.
    pub fn around(&self, site: &Site) -> Occluders {
        let occluders = Occluders::new(self.visibility, self.trees.iter().map(Tree::sender), site);
        if occluders.obstacles.len() > FEW {
            return occluders;
        }
        let hulls: Vec<&[DVec3]> =
            self.emitters.iter().map(|emitter| &self.elements[emitter.element].hull[..]).collect();
        occluders.narrowed(self.visibility, &hulls, site)
    }

    /// Whether direct light at a site has no shadows and varies little more than linearly, since all emitters
    /// are far; never said where luminaires shine, or where the horizon of a part of the site crosses an
    /// opening: light has a kink where it leaves it.
    pub fn is_smooth(&self, site: &Site, occluders: &Occluders) -> bool {
        let own = Aabb::around(site.points.iter().copied());
        let gap = |tree: &Tree| {
            let apart = (own.min - tree.bounds.max).max(tree.bounds.min - own.max);
            apart.max(DVec3::ZERO).length()
        };
        let is_far = |tree: &Tree| own.diagonal() < SMALL * gap(tree) && !tree.meets_horizon(site.points);
        self.points.is_empty() && occluders.is_clear() && self.trees.iter().all(is_far)
    }

    /// Irradiance (W m⁻²) per band straight from the emitters, at the point `receiver` of a site.
    pub fn irradiance(&self, receiver: &ReceiverPoint, occluders: &Occluders) -> Vec<f64> {
        self.irradiance_beside(receiver, occluders, &[])
    }

    fn irradiance_beside(&self, receiver: &ReceiverPoint, occluders: &Occluders, other: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; self.bands];
        self.points.add(receiver, self.visibility, &mut sums);
        let other = other.iter().chain(&sums).map(|other| other.max(0.0)).sum();
        self.add_elements(receiver, occluders, sums, other)
    }

    /// `sums` and the irradiance from elements per band; `other` is known further irradiance, all bands
    /// together.
    fn add_elements(
        &self,
        receiver: &ReceiverPoint,
        occluders: &Occluders,
        mut sums: Vec<f64>,
        other: f64,
    ) -> Vec<f64> {
        for (emitter, factor) in self.emitters.iter().zip(self.from(receiver, occluders, other)) {
            sums.iter_mut().zip(&emitter.exitance).for_each(|(sum, exitance)| *sum += factor * exitance);
        }
        sums
    }

    /// Irradiance from each emitter per unit of its exitance; `other` is known further irradiance, all bands
    /// together.
    fn from(&self, receiver: &ReceiverPoint, occluders: &Occluders, other: f64) -> SmallVec<[f64; 4]> {
        let mut traversal = Traversal::new(receiver, self.visibility, occluders);
        let add = |traversal: &mut Traversal, index: usize, tolerance: f64, factor: &mut [f64]| {
            let tree = &self.trees[index];
            let lamp = self.lamps[index].as_ref();
            match lamp.and_then(|lamp| traversal.lamp(index, lamp, 1.0 / tree.scale()[0], tolerance)) {
                Some(whole) => factor[0] = whole,
                None => traversal.add(index, tree, tolerance, factor),
            }
        };
        if self.trees.iter().all(|tree| tree.plane.is_some() && tree.radiance.is_none())
            && traversal.is_flat()
        {
            let mut factors = smallvec![0.0; self.trees.len()];
            let each = factors.chunks_exact_mut(1).enumerate();
            each.for_each(|(index, factor)| add(&mut traversal, index, 0.0, factor));
            return factors;
        }
        let level =
            |factors: &[f64]| factors.iter().zip(&self.trees).map(|(f, tree)| f / tree.scale()[0]).sum();
        traversal.within_share(&self.trees, PER_CELL * self.eps, other, add, level).into()
    }
}
