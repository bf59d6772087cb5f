//! Lamps: what sends light by itself, and which of them a point asks.
//!
//! A lamp is chosen with a probability about in proportion to what it may send: by descent of a binary tree
//! over all lamps, at each fork by Φ / max(d², r²) of either child, with its flux Φ, the distance d of its box
//! and the radius r of that; a child that lies behind the point, or all of whose lamps face away, is left out.
//! On a surface a point is then drawn by area, on a line by length, on balls and near flat lamps by solid angle
//! ([`ball`], [`facets`]).
//!
//! Reference: A. Conty Estevez, C. Kulla, *Importance sampling of many lights with adaptive tree splitting*,
//! Proc. ACM Comput. Graph. Interact. Tech. 1(2), 2018.

mod on_lamp;
mod ball;
mod facets;
mod tree;

use std::f64::consts::PI;
use std::sync::Arc;

use radiosity_geom::{Aabb, DVec3, Rect, Surface};
use radiosity_scene::{Luminaire, Scene};

use crate::groups::Groups;
use crate::rays::{Place, Rays};
use crate::skin::Skin;
use crate::spectrum::Spectrum;
use crate::spread::Spread;
use ball::Ball;
use facets::Facets;
use on_lamp::OnLamp;
use tree::{Leaf, Tree};

/// The lamps of a scene.
#[derive(Debug)]
pub(crate) struct Lamps {
    list: Vec<Lamp>,
    tree: Tree,
    /// The lamp that a surface is.
    of_surface: Vec<Option<u32>>,
}

#[derive(Debug)]
enum Lamp {
    Surface { surface: usize, spread: Spread, form: Form },
    Line { luminaire: Arc<Luminaire>, strength: Spectrum, half: DVec3, group: usize },
}

/// A point on a lamp, as another point sees it without shadows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LampPoint {
    /// The point.
    pub(crate) end: DVec3,
    /// Cosine at the point that sees it.
    pub(crate) cosine: f64,
    /// Index of its surface; None for luminaires without an area.
    pub(crate) surface: Option<usize>,
    /// The irradiance that it would make if it were all there is, over the density of such points (W m⁻²).
    pub(crate) irradiance: Spectrum,
    /// Density of such points per solid angle; None where no ray can meet the lamp.
    pub(crate) density: Option<f64>,
    /// Index of its light group.
    pub(crate) group: usize,
}

impl Lamps {
    /// The lamps among surfaces with these skins, and the luminaires without an area; `first` is the first band.
    pub(crate) fn of(scene: &Scene, rays: &Rays, skins: &[Skin], groups: &Groups, first: usize) -> Self {
        let mut list = Vec::new();
        let mut leaves = Vec::new();
        let mut of_surface = vec![None; skins.len()];
        for (surface, skin) in skins.iter().enumerate().filter(|(_, skin)| skin.emits()) {
            of_surface[surface] = Some(list.len() as u32);
            let shape = rays.shape(surface);
            leaves.push(Leaf {
                bounds: shape.bounds(&Rect::FULL),
                flux: rays.area(surface) * skin.mean_exitance().sum(),
                plane: shape.region().map(|region| (region.origin(), region.normal())),
            });
            let form = if skin.is_patterned() { Form::Any } else { Form::of(shape.as_ref()) };
            list.push(Lamp::Surface { surface, spread: Spread::over(shape, Rect::FULL), form });
        }
        for (index, luminaire) in scene.luminaires.iter().enumerate() {
            let strength = luminaire.factor() * Spectrum::of(first, &luminaire.strength);
            if luminaire.extent.is_area() || strength.is_dark() {
                continue;
            }
            let half = luminaire.half_line();
            let ends = [luminaire.position - half, luminaire.position + half];
            let flux = strength.sum() * luminaire.distribution.flux_factor();
            leaves.push(Leaf { bounds: Aabb::around(ends), flux, plane: None });
            let group = groups.of_luminaire(index);
            list.push(Lamp::Line { luminaire: Arc::new(luminaire.clone()), strength, half, group });
        }
        Self { tree: Tree::of(&leaves), list, of_surface }
    }

    /// No lamps: light is found where rays end.
    pub(crate) fn none(surfaces: usize) -> Self {
        Self { list: Vec::new(), tree: Tree::of(&[]), of_surface: vec![None; surfaces] }
    }

    /// Whether there are none.
    pub(crate) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// A point on a lamp for a point that receives along `normal`; None where the draws lead to no light.
    pub(crate) fn point(
        &self,
        rays: &Rays,
        skins: &[Skin],
        groups: &Groups,
        [choice, s, t]: [f64; 3],
        point: DVec3,
        normal: DVec3,
    ) -> Option<LampPoint> {
        let (lamp, share) = self.tree.choose(point, normal, choice)?;
        match &self.list[lamp] {
            Lamp::Surface { surface, spread, form } => {
                let skin = &skins[*surface];
                let on = match form.point([s, t], point) {
                    Some(on) => on,
                    None => OnLamp::of(spread.point([s, t])?, point, || rays.shape(*surface), skin)?,
                };
                let cosine = normal.dot(on.along);
                if cosine <= 0.0 {
                    return None;
                }
                let density = share * on.density;
                Some(LampPoint {
                    end: on.point,
                    cosine,
                    surface: Some(*surface),
                    irradiance: (cosine / (PI * density)) * skin.sent(on.parameters, -on.along),
                    density: Some(density),
                    group: groups.of_surface(*surface),
                })
            }
            Lamp::Line { luminaire, strength, half, group } => {
                let end = luminaire.position + (2.0 * s - 1.0) * *half;
                let step = end - point;
                let squared = step.length_squared();
                let along = step / squared.sqrt();
                let cosine = normal.dot(along);
                if cosine <= 0.0 {
                    return None;
                }
                let factor = luminaire.relative(-along) * cosine / (squared * share);
                Some(LampPoint {
                    end,
                    cosine,
                    surface: None,
                    irradiance: factor * *strength,
                    density: None,
                    group: *group,
                })
            }
        }
    }

    /// Density per solid angle at which a point that receives along `normal` draws this place on a lamp; 0 where
    /// there is no lamp.
    pub(crate) fn density(&self, place: &Place, point: DVec3, normal: DVec3) -> f64 {
        let Some(lamp) = self.of_surface[place.surface] else { return 0.0 };
        let Lamp::Surface { spread, form, .. } = &self.list[lamp as usize] else { return 0.0 };
        let share = self.tree.share(lamp as usize, point, normal);
        if let Some(density) = form.density(point) {
            return share * density;
        }
        let step = place.point - point;
        let squared = step.length_squared();
        let leaving = -place.normal.dot(step) / squared.sqrt();
        if leaving.is_nan() || leaving <= 0.0 {
            return 0.0;
        }
        share * spread.density(place.parameters) * squared / leaving
    }
}

/// Form of a lamp whose points can be drawn evenly over the solid angle in which it is seen.
#[derive(Clone, Debug)]
enum Form {
    Ball(Ball),
    Facets(Facets),
    /// Any other: its points are drawn by area.
    Any,
}

impl Form {
    fn of(shape: &dyn Surface) -> Self {
        let facets = || Facets::of(shape).map(Self::Facets);
        Ball::of(shape).map(Self::Ball).or_else(facets).unwrap_or(Self::Any)
    }

    /// The point of two draws for a point; None where it is to be drawn by area.
    fn point(&self, draws: [f64; 2], from: DVec3) -> Option<OnLamp> {
        match self {
            Self::Ball(ball) => ball.point(draws, from),
            Self::Facets(facets) => facets.point(draws, from),
            Self::Any => None,
        }
    }

    /// Density per solid angle of its points for a point; None where they are drawn by area.
    fn density(&self, from: DVec3) -> Option<f64> {
        match self {
            Self::Ball(ball) => ball.density(from),
            Self::Facets(facets) => facets.density(from),
            Self::Any => None,
        }
    }
}
