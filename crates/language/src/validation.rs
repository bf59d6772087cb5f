//! Scene file → valid scene: bands, materials, camera and surfaces.

use std::{collections::BTreeMap, sync::Arc};

use radiosity_geom::{DVec3, Surface};
use radiosity_scene::{
    Camera, Fault, FaultKind, Glass, MaskedPairDraft, Material, Opening, SensorPlane, Sky, Source, Sun,
    SurfaceDraft,
    bands::check_bands,
    covering::Covering,
    error::{Located, title},
    luminaire::across,
    material::{check_emission, check_flux, check_reflectance, check_transmittance},
    member_names::NamedMember,
    place::At,
    sky::{check_elevation, check_irradiance, no_up},
    surface_draft::{DraftPlaces, NamedShape},
    unit::{self, check_unit},
};

use crate::{
    file::{
        Amount, CameraFile, GlassFile, MaskFile, MaterialFile, PerBand, PlaneFile, SkyFile, SunFile,
        SurfaceFile,
    },
    instances::PlacedSurface,
    keys::NamedTable,
    textures::pattern,
};

/// Materials by name.
pub(super) type Materials = BTreeMap<String, Covering>;

/// The names of the bands; if none are given, a single one where no list has a number per band, else r, g, b.
pub(super) fn bands(
    names: Option<At<Vec<At<String>>>>,
    is_grey: bool,
    source: &Source,
) -> Result<Vec<String>, Located> {
    let Some(names) = names else {
        let usual: &[&str] = if is_grey { &["grey"] } else { &["r", "g", "b"] };
        return Ok(usual.iter().map(|name| (*name).to_owned()).collect());
    };
    let lines = names.value.iter().map(|name| source.line(name.span.start));
    check_bands(names.value.iter().map(|name| name.value.as_str()).zip(lines)).map_err(
        |(index, fault)| {
            let span = names.value.get(index).map_or(&names.span, |name| &name.span);
            Located::at(span, fault)
        },
    )?;
    Ok(names.value.into_iter().map(|name| name.value).collect())
}

/// The unit of exitance; W/m² if none is given.
pub(super) fn unit(text: Option<At<String>>) -> Result<String, Located> {
    let Some(text) = text else { return Ok(unit::USUAL.to_owned()) };
    check_unit(&text.value).map_err(|fault| Located::at(&text.span, fault))?;
    Ok(text.value)
}

/// A plane of sensors.
pub(super) fn plane(NamedTable { name, file }: NamedTable<PlaneFile>) -> Result<SensorPlane, Located> {
    let PlaneFile { origin, edges, spacing } = file;
    let title = title("plane", &name.value);
    SensorPlane::new(name.value, origin, edges.value, spacing.value).map_err(|fault| {
        let span = if fault.kind == FaultKind::NoDirection { &edges.span } else { &spacing.span };
        Located::at(span, fault).within(|| title)
    })
}

/// A chosen pair of a mask.
pub(super) fn mask(file: &MaskFile) -> MaskedPairDraft {
    let named = |name: &At<String>| NamedMember { name: name.value.clone(), span: Some(name.span.clone()) };
    MaskedPairDraft {
        emitter: named(&file.emitter),
        receiver: named(&file.receiver),
        cells: file.cells,
        span: Some(file.span.clone()),
    }
}

/// Every material, checked number by number.
pub(super) fn materials(
    files: Vec<NamedTable<MaterialFile>>,
    bands: usize,
    source: &Source,
) -> Result<Materials, Located> {
    let checked =
        |NamedTable { name, file }: NamedTable<MaterialFile>| match covering(&name, file, bands, source) {
            Ok(material) => Ok((name.value, material)),
            Err(error) => Err(error.within(|| title("material", &name.value))),
        };
    files.into_iter().map(checked).collect()
}

fn covering(
    name: &At<String>,
    file: MaterialFile,
    bands: usize,
    source: &Source,
) -> Result<Covering, Located> {
    let given = file.transmittance.as_ref();
    let given = given
        .map(|given| spread(&given.value, bands, "the transmittance", check_transmittance))
        .transpose()?;
    let transmittance = given.unwrap_or_else(|| vec![0.0; bands]);
    let mut bare = Material::black(bands);
    bare.transmittance = transmittance;
    let material = match &file.reflectance {
        Some(given) => reflecting(bare, given, source)?,
        // A material of an emissivity alone is grey at all wavelengths.
        None => {
            bare.reflectance = vec![1.0 - file.emissivity.unwrap_or(1.0); bands];
            bare
        }
    };
    let material = emitting(material, &file.emission, source)?;
    let span = file.transmittance.as_ref().map_or(&name.span, |given| &given.span);
    material.check(bands).map_err(|fault| Located::at(span, fault))?;
    let group = file.group.map(|group| group.value);
    let thermal = file.condition.thermal(file.emissivity);
    Ok(Covering { thermal, group, ..Covering::new(name.value.clone(), material) })
}

/// The material with this reflectance.
fn reflecting(mut material: Material, given: &Amount, source: &Source) -> Result<Material, Located> {
    let bands = material.transmittance.len();
    match given {
        Amount::Even(numbers) => {
            material.reflectance = spread(numbers, bands, "the reflectance", check_reflectance)?;
            Ok(material)
        }
        Amount::Varied(file) => material
            .with_reflectance_pattern(pattern(file, bands, source)?)
            .map_err(|fault| Located::at(file.place(), fault)),
    }
}

/// The material with this emission.
fn emitting(mut material: Material, given: &Amount, source: &Source) -> Result<Material, Located> {
    let bands = material.transmittance.len();
    match given {
        Amount::Even(numbers) => {
            material.emission = spread(numbers, bands, "the emission", check_emission)?;
            Ok(material)
        }
        Amount::Varied(file) => material
            .with_emission_pattern(pattern(file, bands, source)?)
            .map_err(|fault| Located::at(file.place(), fault)),
    }
}

/// One number for each band.
pub(super) fn spread(
    numbers: &PerBand,
    bands: usize,
    what: &'static str,
    check: fn(f64) -> Result<(), Fault>,
) -> Result<Vec<f64>, Located> {
    let checked = |number: &At<f64>| match check(number.value) {
        Ok(()) => Ok(number.value),
        Err(fault) => Err(Located::at(&number.span, fault)),
    };
    match numbers {
        PerBand::All(number) => Ok(vec![checked(number)?; bands]),
        PerBand::Each(list) if list.value.len() == bands => list.value.iter().map(checked).collect(),
        PerBand::Each(list) => {
            let expected = format!("one number for all bands or {bands}, one per band");
            Err(Located::at(&list.span, Fault::wrong_count(what, &expected, list.value.len())))
        }
    }
}

/// The camera.
pub(super) fn camera(file: CameraFile) -> Result<Camera, Located> {
    let CameraFile { eye, target, up, fov, width, height, span } = file;
    let camera = Camera { eye, target, up, fov, width, height };
    camera.checked().map_err(|fault| Located::at(&span, fault).within(|| "camera".into()))
}

/// Every surface with its name, shape and material.
pub(super) fn surfaces(
    files: &[PlacedSurface<'_>],
    materials: &Materials,
    sky: Option<&Arc<Sky>>,
    bands: usize,
    source: &Source,
) -> impl Iterator<Item = Result<SurfaceDraft, Located>> {
    files.iter().map(move |placed| {
        let error = |error: Located| error.within(|| title("surface", &placed.name));
        let draft = draft(placed, materials, bands, source);
        draft.and_then(|draft| opened(draft, placed.file, sky)).map_err(error)
    })
}

/// One entry, with its material and shapes.
fn draft(
    placed: &PlacedSurface<'_>,
    materials: &Materials,
    bands: usize,
    source: &Source,
) -> Result<SurfaceDraft, Located> {
    let PlacedSurface { file, name, .. } = placed;
    let name_span = &file.name.span;
    let covering =
        |name: &Option<At<String>>| name.as_ref().map(|name| covering_named(name, materials)).transpose();
    let span = |name: &Option<At<String>>| name.as_ref().map(|name| name.span.clone());
    Ok(SurfaceDraft {
        kind: file.shape.kind,
        flux: flux(file.flux.as_ref(), bands)?,
        opening: None,
        radiance: None,
        thermal: file.condition.thermal(None),
        front: covering(&file.material)?.unwrap_or_else(|| Covering::black(bands)),
        back: covering(&file.back_material)?,
        group: file.group.as_ref().map(|own| own.value.clone()),
        shapes: shapes(placed)?,
        name: name.clone(),
        order: file.order,
        subdivide: file.subdivide,
        two_sided: file.two_sided,
        flip: file.flip,
        typed: Some(DraftPlaces {
            place: source.place(&file.span),
            name: name_span.clone(),
            name_line: source.line(name_span.start),
            shape: file.shape.span.clone(),
            materials: [span(&file.material), span(&file.back_material)],
            flux: file.flux.as_ref().map(|flux| flux.span().clone()),
            opening: file.opening().cloned(),
        }),
    })
}

/// The draft as an opening to the sky, if it is one.
fn opened(draft: SurfaceDraft, file: &SurfaceFile, sky: Option<&Arc<Sky>>) -> Result<SurfaceDraft, Located> {
    let Some(span) = file.opening() else { return Ok(draft) };
    let no_sky = || {
        let cure =
            "add [sky] with model = \"overcast\" and illuminance = 10000, or leave `opening` and `glass` out";
        Located::at(span, Fault::bad_opening("there is no sky", cure))
    };
    let sky = Arc::clone(sky.ok_or_else(no_sky)?);
    let glass = |own: &At<GlassFile>| {
        let GlassFile { panes, index, transmittance } = own.value;
        Glass::new(panes, index, transmittance).map_err(|fault| Located::at(&own.span, fault))
    };
    let glass = file.glass.as_ref().map(glass).transpose()?;
    Ok(SurfaceDraft { opening: Some(Opening { sky, glass }), ..draft })
}

/// The sky. Azimuths are counted from north over east.
pub(super) fn sky(file: &SkyFile, bands: usize) -> Result<Arc<Sky>, Located> {
    let located = |fault| Located::at(&file.span, fault);
    let irradiance = spread(&file.illuminance, bands, "the illuminance", check_irradiance)?;
    let sun = file.sun.as_ref().map(|sun| {
        let elevation = &sun.elevation;
        check_elevation(elevation.value).map_err(|fault| Located::at(&elevation.span, fault))?;
        let direction = sun_direction(sun, file.up, file.north);
        let direction = direction.map_err(|fault| Located::at(&sun.span, fault))?;
        let irradiance = spread(&sun.illuminance, bands, "the illuminance", check_irradiance)?;
        Ok(Sun { direction, irradiance })
    });
    let sun = sun.transpose()?;
    Sky::new(file.model, file.up, irradiance, file.ground, sun).map(Arc::new).map_err(located)
}

fn sun_direction(sun: &SunFile, up: DVec3, north: DVec3) -> Result<DVec3, Fault> {
    let up = up.try_normalize().ok_or_else(no_up)?;
    let north = north.try_normalize().and_then(|north| across(north, up));
    let cure = "give a direction that is not along `up`, e.g. [0, 1, 0] where `up` is [0, 0, 1]";
    let north = north.ok_or_else(|| Fault::no_direction("north", cure))?;
    let (height, around) = (sun.elevation.value.to_radians().sin_cos(), sun.azimuth.to_radians().sin_cos());
    Ok((height.1 * (around.1 * north + around.0 * north.cross(up)) + height.0 * up).normalize())
}

fn flux(flux: Option<&PerBand>, bands: usize) -> Result<Option<Vec<f64>>, Located> {
    flux.map(|flux| spread(flux, bands, "the flux", check_flux)).transpose()
}

/// The shapes of one entry, each with the name of its surface.
fn shapes(PlacedSurface { file, name, motion, .. }: &PlacedSurface<'_>) -> Result<Vec<NamedShape>, Located> {
    let shapes = file.shape.surfaces(motion).map_err(|error| {
        let span = file.shape.span_of(error.field()).clone();
        Located::at(&span, error.into())
    })?;
    let named = |(index, shape): (usize, Box<dyn Surface>)| NamedShape {
        name: file.shape.name(name, index),
        shape: Arc::from(shape),
    };
    Ok(shapes.into_iter().enumerate().map(named).collect())
}

fn covering_named(name: &At<String>, materials: &Materials) -> Result<Covering, Located> {
    materials.get(&name.value).cloned().ok_or_else(|| {
        let known = materials.keys().cloned().collect();
        Located::at(&name.span, Fault::unknown_material(&name.value, known))
    })
}
