//! Surfaces as they are given, in a file or in code → surfaces of one scene.
//!
//! A draft becomes one surface, or two if it is two-sided; `patches` in a file become several. Each is of a
//! size that can be computed with, has a name of its own, and lies in no other.

use radiosity_fit::sides::back_of;
use std::sync::Arc;

use radiosity_geom::{Flipped, Rect, Surface};

use crate::{
    covering::Covering,
    error::{Located, title},
    fault::Fault,
    light_group::LightGroup,
    material::{Material, check_count, check_flux, check_sheet},
    named_material::NamedMaterial,
    names::check_name,
    outlook::{KnownOutlooks, Opening},
    place::{Line, Place, Span},
    radiance::Radiance,
    ranges::{check_number, check_order, check_parts},
    surface::SceneSurface,
    thermal::{BackCondition, Condition, Thermal},
};

/// A surface on its way into a scene; see [`SceneBuilder::surface`](crate::SceneBuilder::surface).
#[derive(Debug)]
pub struct SurfaceDraft {
    /// Name of the entry; each surface has the name of its shape.
    pub name: String,
    /// The kind of its shape, for messages.
    pub kind: &'static str,
    /// Its shapes, each with the name of the surface that it makes.
    pub shapes: Vec<NamedShape>,
    /// The covering of its front.
    pub front: Covering,
    /// Covering of its back, if that is another one.
    pub back: Option<Covering>,
    /// Its own light group, instead of those of its materials.
    pub group: Option<String>,
    /// Flux of each band (W), instead of an emission.
    pub flux: Option<Vec<f64>>,
    /// The sky behind it, if it is an opening.
    pub opening: Option<Opening>,
    /// Angular distribution of its light, for sides of luminous areas; none for other surfaces, openings
    /// included.
    pub radiance: Option<Radiance>,
    /// Emissivity and thermal condition, instead of those of its materials.
    pub thermal: Thermal,
    /// Order of its basis, instead of the order asked for.
    pub order: Option<usize>,
    /// Number of elements along u and v, instead of the subdivision asked for.
    pub subdivide: Option<[usize; 2]>,
    /// Whether its back emits and receives too.
    pub two_sided: bool,
    /// Whether its front and its back are exchanged.
    pub flip: bool,
    /// Its places in a file or a tree; none if it was made in code.
    pub typed: Option<DraftPlaces>,
}

/// A shape with the name of the surface it makes.
#[derive(Clone, Debug)]
pub struct NamedShape {
    /// Name of the surface.
    pub name: String,
    /// The shape.
    pub shape: Arc<dyn Surface>,
}

/// The place of a draft in a file or a tree.
#[derive(Clone, Debug)]
pub struct DraftPlaces {
    /// The place of the whole draft.
    pub place: Option<Place>,
    /// Place of its name.
    pub name: Span,
    /// Line of its name.
    pub name_line: Option<Line>,
    /// Place of its shape.
    pub shape: Span,
    /// Places of its material and of the material of its back.
    pub materials: [Option<Span>; 2],
    /// Place of its flux, if it has one.
    pub flux: Option<Span>,
    /// Place of the statement that it is an opening, if it is one.
    pub opening: Option<Span>,
}

impl SurfaceDraft {
    /// Turns the surface over: its front becomes its back.
    pub fn flip(&mut self) -> &mut Self {
        self.flip = true;
        self
    }

    /// Lets its back emit and receive too, as a surface named `name:back` that follows it.
    pub fn two_sided(&mut self) -> &mut Self {
        self.two_sided = true;
        self
    }

    /// Covers its back with another material, where it is [two-sided](Self::two_sided). Both materials must
    /// have one transmittance.
    pub fn back_material(&mut self, material: &NamedMaterial) -> &mut Self {
        self.back = Some(Covering::from(material));
        self
    }

    /// Makes it a member of the light group `name`, whose light is kept apart and can be dimmed
    /// ([`Scene::dimmed`](crate::Scene::dimmed)).
    pub fn group(&mut self, name: impl Into<String>) -> &mut Self {
        self.group = Some(name.into());
        self
    }

    /// Sets the flux of each band (W) that the whole surface emits, the back included where it is two-sided,
    /// instead of the emission of its material, which has to be 0: its exitance is the flux over its area.
    pub fn flux(&mut self, flux: Vec<f64>) -> &mut Self {
        self.flux = Some(flux);
        self
    }

    /// Makes it an opening to a sky, whose light it sends. It is flat, its front faces the room, and its
    /// material emits nothing.
    pub fn opening(&mut self, opening: Opening) -> &mut Self {
        self.opening = Some(opening);
        self
    }

    /// Sets its emissivity, 0 < ε ≤ 1, for `heat`.
    pub fn emissivity(&mut self, emissivity: f64) -> &mut Self {
        self.thermal.emissivity = Some(emissivity);
        self
    }

    /// Sets its thermal condition for `heat`: its temperature (K), or the heat flux (W m⁻²) that it sends
    /// out.
    pub fn condition(&mut self, condition: Condition) -> &mut Self {
        self.thermal.condition = Some(condition);
        self
    }

    /// Sets the condition of its back for `heat`, where it is of one side.
    pub fn back_condition(&mut self, back: BackCondition) -> &mut Self {
        self.thermal.back = Some(back);
        self
    }

    /// Sets the order of the basis here, at most [`MAX_ORDER`](crate::MAX_ORDER), instead of the order asked
    /// for.
    pub fn order(&mut self, order: usize) -> &mut Self {
        self.order = Some(order);
        self
    }

    /// Cuts it into `u` × `v` elements, each from 1 to 256, instead of the subdivision asked for.
    pub fn subdivide(&mut self, u: usize, v: usize) -> &mut Self {
        self.subdivide = Some([u, v]);
        self
    }

    /// Checks order, subdivision, light group and thermal condition, which files check where they are typed.
    pub(super) fn checked(self) -> Result<Self, Located> {
        let order = self.order.map_or(Ok(()), check_order);
        let parts = || self.subdivide.into_iter().flatten().try_for_each(check_parts);
        let group = || self.group.as_deref().map_or(Ok(()), check_name);
        let thermal = || self.thermal.check();
        match order.and_then(|()| parts()).and_then(|()| group()).and_then(|()| thermal()) {
            Ok(()) => Ok(self),
            Err(fault) => Err(self.located(None, fault)),
        }
    }

    /// Turns its flux into the emission of its materials; checks its opening, and that its sides have one
    /// transmittance.
    pub(super) fn lit(mut self) -> Result<Self, Located> {
        self.check_sides()?;
        self.check_opening()?;
        let span = self.typed.as_ref().and_then(|typed| typed.flux.clone());
        let emission = self.flux.as_deref().map(|flux| self.emission(flux)).transpose();
        match emission {
            Ok(None) => Ok(self),
            Ok(Some(emission)) => {
                self.coverings_mut().for_each(|own| own.material.emission.clone_from(&emission));
                Ok(self)
            }
            Err(fault) => Err(self.located(span.as_ref(), fault).within(|| title("surface", &self.name))),
        }
    }

    /// Coverings of its front and, if it has another one, of its back.
    fn coverings(&self) -> impl Iterator<Item = &Covering> {
        [&self.front].into_iter().chain(&self.back)
    }

    fn coverings_mut(&mut self) -> impl Iterator<Item = &mut Covering> {
        [&mut self.front].into_iter().chain(&mut self.back)
    }

    /// Refuses a back material on a surface of one side, and sides of different transmittances.
    fn check_sides(&self) -> Result<(), Located> {
        let [front, back] = self.typed.as_ref().map_or([None, None], |typed| typed.materials.clone());
        let other = self.back.as_ref().map(|own| &own.material);
        let is_own = self.two_sided && self.thermal.back.is_some();
        let (span, checked) = match other {
            _ if is_own => (None, Err(Fault::two_sided_back())),
            Some(_) if !self.two_sided => (back, Err(Fault::one_sided("a back material"))),
            Some(other) => (back, check_sheet(&self.front.material, Some(other))),
            None if self.two_sided => return Ok(()),
            None => (front, check_sheet(&self.front.material, None)),
        };
        checked.map_err(|fault| self.located(span.as_ref(), fault).within(|| title("surface", &self.name)))
    }

    /// The exitance of each band (W m⁻²) that makes this flux (W).
    fn emission(&self, flux: &[f64]) -> Result<Vec<f64>, Fault> {
        check_count("the flux", flux, self.front.material.reflectance.len())?;
        flux.iter().try_for_each(|flux| check_flux(*flux))?;
        if let Some(Covering { material, name, .. }) = self.coverings().find(|own| own.material.emits()) {
            let name = name.as_deref().unwrap_or_default();
            let cause = format!("a flux is given, yet the material {name:?} emits as well");
            return Err(Fault::conflict(
                cause,
                match material.emission_pattern {
                    Some(_) => {
                        "leave the flux out, and scale the pattern by its `factor`: the mean exitance is the flux over \
                            the area"
                    }
                    None => {
                        "leave the flux out, or give the surface a material of the same reflectance without emission"
                    }
                },
            ));
        }
        let sides = if self.two_sided { 2.0 } else { 1.0 };
        let area = sides * self.shapes.iter().map(|own| own.shape.area()).sum::<f64>();
        let emission: Vec<f64> = flux.iter().map(|flux| flux / area).collect();
        emission.iter().try_for_each(|exitance| check_number(*exitance))?;
        Ok(emission)
    }

    /// Refuses openings that are curved, have two sides or emit, and skies of other bands.
    fn check_opening(&self) -> Result<(), Located> {
        let Some(opening) = &self.opening else { return Ok(()) };
        let span = self.typed.as_ref().and_then(|typed| typed.opening.clone());
        let is_flat = self.shapes.iter().all(|own| own.shape.region().is_some());
        let bands = self.front.material.reflectance.len();
        let own_light = "leave the flux out, and give it a material without emission: the sky is its light";
        let fault = match () {
            () if !is_flat => Fault::bad_opening("it is curved", "make it of flat surfaces"),
            () if self.two_sided => {
                Fault::bad_opening("it has two sides", "leave two_sided out: its front faces the room")
            }
            () if self.flux.is_some() => Fault::bad_opening("it has a flux", own_light),
            () if self.front.material.emits() => Fault::bad_opening("its material emits", own_light),
            () => match check_count("the illuminance of the sky", opening.sky.irradiance(), bands) {
                Ok(()) => return Ok(()),
                Err(fault) => fault,
            },
        };
        Err(self.located(span.as_ref(), fault).within(|| title("surface", &self.name)))
    }

    /// Angular distribution of the light of one of its shapes, and its material, which for an opening emits
    /// the exitance of the outlook.
    fn radiance(&self, shape: &dyn Surface, known: &mut KnownOutlooks) -> (Option<Radiance>, Material) {
        let Some(opening) = &self.opening else {
            return (self.radiance.clone(), self.front.material.clone());
        };
        let normal = shape.jet(0.0, 0.0).normal;
        let outlook = known.of(opening, if self.flip { -normal } else { normal });
        let material = Material { emission: outlook.exitance(), ..self.front.material.clone() };
        (Some(Radiance::Sky(outlook)), material)
    }

    /// A fault at `span` if the draft comes from a file, else one of the surface.
    pub(super) fn located(&self, span: Option<&Span>, fault: Fault) -> Located {
        match span {
            Some(span) => Located::at(span, fault),
            None => Located::nowhere(fault).within(|| title("surface", &self.name)),
        }
    }

    /// Refuses sizes outside 1e-30 to 1e30, whose fourth powers leave the range of numbers.
    pub(super) fn check_extents(&self) -> Result<(), Located> {
        let span = self.typed.as_ref().map(|typed| &typed.shape);
        self.shapes.iter().try_for_each(|own| {
            check_extent(&own.shape)
                .map_err(|fault| self.located(span, fault).within(|| title("surface", &self.name)))
        })
    }

    /// The surface of one of its shapes, and its back if it is two-sided; equal outlooks of openings are
    /// shared with those `known`.
    pub(super) fn sides(&self, named: &NamedShape, known: &mut KnownOutlooks) -> Vec<SceneSurface> {
        let NamedShape { name, shape } = named;
        let (radiance, material) = self.radiance(shape, known);
        let front = Covering { material, ..self.front.clone() };
        let side = |name: String, flip: bool, covering: &Covering| SceneSurface {
            name,
            kind: self.kind,
            shape: if flip { Arc::new(Flipped::new(Box::new(shape.clone()))) } else { shape.clone() },
            material: covering.material.clone(),
            emission_factors: None,
            radiance: radiance.clone(),
            material_name: covering.name.clone(),
            other_side: None,
            group: self.group.as_ref().or(covering.group.as_ref()).map(LightGroup::new),
            flux: self
                .flux
                .as_ref()
                .map(|_| covering.material.emission.iter().map(|own| own * shape.area()).collect()),
            thermal: Thermal {
                emissivity: self.thermal.emissivity.or(covering.thermal.emissivity),
                condition: self.thermal.condition.or(covering.thermal.condition),
                back: self.thermal.back.or(covering.thermal.back).filter(|_| !self.two_sided),
            },
            order: self.order,
            subdivide: self.subdivide,
            place: self.typed.as_ref().and_then(|typed| typed.place.clone()),
        };
        let other = self.back.as_ref().unwrap_or(&front);
        let back = self.two_sided.then(|| side(back_of(name), !self.flip, other));
        [side(name.clone(), self.flip, &front)].into_iter().chain(back).collect()
    }
}

fn check_extent(shape: &dyn Surface) -> Result<(), Fault> {
    let value = shape.bounds(&Rect::FULL).diagonal();
    if (1e-30..=1e30).contains(&value) {
        return Ok(());
    }
    Err(Fault::out_of_range("the extent of the surface", value, "1e-30 ≤ extent ≤ 1e30"))
}
