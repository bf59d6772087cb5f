//! Scenes made in code, with the faults of scene files.

use std::{collections::BTreeMap, sync::Arc};

use radiosity_geom::Surface;

use crate::{
    Scene,
    animation::{Animation, Clock},
    bands::check_bands,
    camera::Camera,
    covering::Covering,
    error::{Located, SceneError, title},
    fault::Fault,
    luminaire::Luminaire,
    luminous_surface::luminous_surfaces,
    masked_pair::{MaskedPairDraft, masked_pairs},
    material::Material,
    member_names::MemberNames,
    mover_draft::{MovableThings, MoverDraft, movers},
    named_material::NamedMaterial,
    names::{UniqueNames, check_name},
    sensor_plane::SensorPlane,
    surface_draft::{NamedShape, SurfaceDraft},
    surfaces::{Surfaces, emitting, fitted_surfaces, unused_materials},
    thermal::Thermal,
    unit::{self, check_unit},
};

/// A scene in the making. Parts are taken as they are given; [`SceneBuilder::build`] finds what is wrong with
/// them.
///
/// ```
/// use radiosity_scene::{Material, SceneBuilder};
/// use radiosity_geom::{DVec3, shapes::Parallelogram};
///
/// let mut room = SceneBuilder::new("room", ["grey"]);
/// let white = room.material("white", Material::new(vec![0.7], vec![0.0])?);
/// room.surface("floor", Parallelogram::new(DVec3::ZERO, DVec3::X, DVec3::Y)?, &white).order(5);
/// room.surface("sheet", Parallelogram::new(DVec3::Z, DVec3::X, DVec3::Y)?, &white).two_sided();
/// assert_eq!(room.build()?.surfaces.len(), 3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct SceneBuilder {
    name: String,
    bands: Vec<String>,
    unit: String,
    camera: Option<Camera>,
    planes: Vec<SensorPlane>,
    tolerance: Option<f64>,
    materials: Vec<NamedMaterial>,
    surfaces: Vec<SurfaceDraft>,
    luminaires: Vec<Luminaire>,
    clock: Option<Clock>,
    movers: Vec<MoverDraft>,
    masks: Vec<MaskedPairDraft>,
}

impl SceneBuilder {
    /// A builder of a scene of that name with these bands, without parts. The name stands before messages.
    pub fn new<B: Into<String>>(name: impl Into<String>, bands: impl IntoIterator<Item = B>) -> Self {
        Self {
            name: name.into(),
            bands: bands.into_iter().map(Into::into).collect(),
            unit: unit::USUAL.to_owned(),
            camera: None,
            planes: Vec::new(),
            tolerance: None,
            materials: Vec::new(),
            surfaces: Vec::new(),
            luminaires: Vec::new(),
            clock: None,
            movers: Vec::new(),
            masks: Vec::new(),
        }
    }

    /// Adds a material for surfaces, with a number per band, and returns it.
    pub fn material(&mut self, name: impl Into<String>, material: Material) -> NamedMaterial {
        let named = NamedMaterial::new(name.into(), material);
        self.materials.push(named.clone());
        named
    }

    /// Adds a surface, and returns it to be turned over, cut, and so on.
    ///
    /// A surface behind an `Arc` is a surface: so lists of different shapes are added, and one shape several
    /// times.
    pub fn surface(
        &mut self,
        name: impl Into<String>,
        shape: impl Surface + 'static,
        material: &NamedMaterial,
    ) -> &mut SurfaceDraft {
        if !self.materials.iter().any(|own| own.is(material)) {
            self.materials.push(material.clone());
        }
        let name = name.into();
        let draft = SurfaceDraft {
            kind: "surface",
            shapes: vec![NamedShape { name: name.clone(), shape: Arc::new(shape) }],
            name,
            front: Covering::from(material),
            back: None,
            group: None,
            flux: None,
            opening: None,
            radiance: None,
            thermal: Thermal::default(),
            order: None,
            subdivide: None,
            two_sided: false,
            flip: false,
            typed: None,
        };
        let index = self.surfaces.len();
        self.surfaces.push(draft);
        &mut self.surfaces[index]
    }

    /// Adds a luminaire.
    pub fn luminaire(&mut self, luminaire: Luminaire) -> &mut Self {
        self.luminaires.push(luminaire);
        self
    }

    /// Sets the frames in which things move, instead of those given before.
    pub fn clock(&mut self, clock: Clock) -> &mut Self {
        self.clock = Some(clock);
        self
    }

    /// Adds things that move along one path; [`SceneBuilder::clock`] gives the number of frames.
    pub fn moves(&mut self, mover: MoverDraft) -> &mut Self {
        self.movers.push(mover);
        self
    }

    /// Chooses pairs of surfaces for shadow masks, where light is masked.
    pub fn masks(&mut self, pair: MaskedPairDraft) -> &mut Self {
        self.masks.push(pair);
        self
    }

    /// Gives the scene a camera, instead of one given before.
    pub fn camera(&mut self, camera: Camera) -> &mut Self {
        self.camera = Some(camera);
        self
    }

    /// States the unit of exitance, irradiance and radiosity, such as `lx`, instead of W/m². Nothing is
    /// converted.
    pub fn unit(&mut self, unit: impl Into<String>) -> &mut Self {
        self.unit = unit.into();
        self
    }

    /// Adds a plane of sensors.
    pub fn plane(&mut self, plane: SensorPlane) -> &mut Self {
        self.planes.push(plane);
        self
    }

    /// Makes corners and planes agree within `length` (scene length) instead of within the rounding of their
    /// coordinates; 0 leaves all corners where they are.
    pub fn tolerance(&mut self, length: f64) -> &mut Self {
        self.tolerance = Some(length);
        self
    }

    /// The scene, if everything in it is right.
    ///
    /// # Errors
    /// The first thing wrong with bands, unit, planes, materials, luminaires, camera, surfaces, masks or
    /// motions, in this order: a [`SceneError`] that names the part and has no place in a text.
    pub fn build(self) -> Result<Scene, SceneError> {
        let name = self.name.clone();
        self.assemble().map_err(|located| located.in_code(&name))
    }

    fn assemble(self) -> Result<Scene, Located> {
        check_bands(self.bands.iter().map(|band| (band.as_str(), None)))
            .map_err(|(_, fault)| Located::nowhere(fault).within(|| "bands".into()))?;
        check_unit(&self.unit).map_err(|fault| Located::nowhere(fault).within(|| "unit".into()))?;
        check_planes(&self.planes)?;
        check_materials(&self.materials, self.bands.len())?;
        check_backs(&self.surfaces, &self.materials, self.bands.len())?;
        check_luminaires(&self.luminaires, self.bands.len())?;
        let camera = self.camera.map(Camera::checked).transpose();
        let camera = camera.map_err(|fault| Located::nowhere(fault).within(|| "camera".into()))?;
        let drafts = self.surfaces.into_iter().map(SurfaceDraft::checked);
        let drafts = drafts.collect::<Result<Vec<_>, _>>()?;
        let entries: Vec<String> = drafts.iter().map(|draft| draft.name.clone()).collect();
        let luminous = self.luminaires.iter().map(|own| luminous_surfaces(own, || None));
        let luminous = luminous.collect::<Result<Vec<_>, _>>()?;
        let drafts = drafts.into_iter().chain(luminous.into_iter().flatten());
        let Surfaces { list, makers, middle, fitted } = fitted_surfaces(drafts.map(Ok), self.tolerance)?;
        let lamp = |own: &Luminaire| MemberNames::named([own.name.clone()]).in_group(own.group.as_ref());
        let lamps: Vec<MemberNames> = self.luminaires.iter().map(lamp).collect();
        let own = makers.iter().zip(&list).map(|(own, surface)| match entries.get(own.draft) {
            Some(entry) => {
                MemberNames::named([own.front.clone(), entry.clone()]).in_group(surface.group.as_ref())
            }
            None => MemberNames::of_area(&own.front, &lamps),
        });
        let movable = MovableThings {
            surfaces: own.collect(),
            emitting: emitting(&list, &self.luminaires),
            bands: self.bands.len(),
            camera: camera.is_some(),
            luminaires: lamps,
        };
        let masks = masked_pairs(self.masks, &movable.surfaces)?;
        let animation = animation(self.clock, self.movers, &movable)?;
        Ok(Scene {
            middle,
            fitted,
            unused_materials: unused_materials(self.materials.iter().map(NamedMaterial::name), &list),
            surfaces: list,
            luminaires: self.luminaires.into_iter().map(|own| own.about(middle)).collect(),
            bands: self.bands,
            unit: self.unit,
            planes: self.planes,
            masks,
            variables: Vec::new(),
            camera: camera.map(|camera| camera.about(middle)),
            animation: animation.map(|animation| animation.about(middle)),
            title: None,
            origin: self.name.clone(),
            name: self.name,
            source: None,
        })
    }
}

/// The movers, in the frames of the clock; each needs the other.
fn animation(
    clock: Option<Clock>,
    drafts: Vec<MoverDraft>,
    movable: &MovableThings,
) -> Result<Option<Animation>, Located> {
    match clock {
        Some(clock) => movers(drafts, clock, movable).map(Some),
        None if drafts.is_empty() => Ok(None),
        None => Err(Located::nowhere(Fault::no_frame_count())),
    }
}

/// Checks that each plane has a name of its own.
fn check_planes(planes: &[SensorPlane]) -> Result<(), Located> {
    let mut names = UniqueNames::default();
    planes.iter().try_for_each(|plane| {
        let added = names.add(plane.name(), None);
        added.map_err(|fault| Located::nowhere(fault).within(|| title("plane", plane.name())))
    })
}

/// Checks that each luminaire has a name of its own and a strength for each band.
fn check_luminaires(luminaires: &[Luminaire], bands: usize) -> Result<(), Located> {
    let mut names = UniqueNames::default();
    luminaires.iter().try_for_each(|own| {
        let checked = names.add(&own.name, None).and_then(|()| own.check(bands));
        checked.map_err(|fault| Located::nowhere(fault).within(|| title("luminaire", &own.name)))
    })
}

/// Checks that each material has a name of its own and a number in range for each band.
fn check_materials(materials: &[NamedMaterial], bands: usize) -> Result<(), Located> {
    let mut names = UniqueNames::default();
    materials.iter().try_for_each(|named| {
        let checked = names.add(named.name(), None).and_then(|()| named.material().check(bands));
        checked.map_err(|fault| Located::nowhere(fault).within(|| title("material", named.name())))
    })
}

/// Checks the materials of backs, which may be given to nothing else: none has the name of another one.
fn check_backs(drafts: &[SurfaceDraft], materials: &[NamedMaterial], bands: usize) -> Result<(), Located> {
    let known = materials.iter().map(|own| (own.name(), own.material()));
    let mut known: BTreeMap<&str, &Material> = known.collect();
    for Covering { name, material, .. } in drafts.iter().filter_map(|draft| draft.back.as_ref()) {
        let name = name.as_deref().unwrap_or_default();
        let checked = check_name(name).and_then(|()| material.check(bands));
        let checked = checked.and_then(|()| match known.insert(name, material) {
            Some(other) if other != material => Err(Fault::duplicate_name(name, None)),
            _ => Ok(()),
        });
        checked.map_err(|fault| Located::nowhere(fault).within(|| title("material", name)))?;
    }
    Ok(())
}
