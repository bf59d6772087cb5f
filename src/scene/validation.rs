//! As typed → valid: bands, materials, camera and surfaces of a scene.

use std::{collections::BTreeMap, sync::Arc};

use radiosity_geom::{DVec3, Flipped, Rect, Surface};

use crate::scene::{
    camera::Camera,
    coincident::Occupied,
    error::{Fault, Located},
    file::{CameraFile, MaterialFile, PerBand, SurfaceFile, default_name, material_title, surface_title},
    material::{Material, check_emission, check_reflectance},
    source::{At, Source, Span},
    surface::SceneSurface,
};

/// Materials by name.
pub(super) type Materials = BTreeMap<String, Material>;

/// The names of the bands; r, g, b if none are given.
pub(super) fn bands(names: Option<At<Vec<At<String>>>>, source: &Source) -> Result<Vec<String>, Located> {
    let Some(names) = names else { return Ok(["r", "g", "b"].map(str::to_owned).to_vec()) };
    if names.value.is_empty() {
        let expected = "at least one name".to_owned();
        let fault = Fault::WrongCount { what: "the list of bands", expected, found: 0 };
        return Err(Located::at(&names.span, fault));
    }
    let mut unique = UniqueNames::default();
    for name in &names.value {
        unique.add(&name.value, &name.span, source)?;
    }
    Ok(names.value.into_iter().map(|name| name.value).collect())
}

/// Every material, checked number by number.
pub(super) fn materials(files: Vec<MaterialFile>, bands: usize) -> Result<Materials, Located> {
    let checked = |file: MaterialFile| {
        let name = file.name.value.clone();
        match material(file, bands) {
            Ok(material) => Ok((name, material)),
            Err(error) => Err(error.within(|| material_title(&name))),
        }
    };
    files.into_iter().map(checked).collect()
}

fn material(file: MaterialFile, bands: usize) -> Result<Material, Located> {
    let reflectance = spread(&file.reflectance, bands, "the reflectance", check_reflectance)?;
    let emission = file.emission.map(|emission| spread(&emission, bands, "the emission", check_emission));
    let emission = emission.transpose()?.unwrap_or_else(|| vec![0.0; bands]);
    Material::new(reflectance, emission).map_err(|fault| Located::at(&file.name.span, fault))
}

/// One number for each band.
fn spread(
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
            Err(Located::at(&list.span, Fault::WrongCount { what, expected, found: list.value.len() }))
        }
    }
}

/// A camera with a view; up +z, 40 degrees and 512 × 512 pixels where nothing is said.
pub(super) fn camera(file: CameraFile) -> Result<Camera, Located> {
    let camera = Camera {
        eye: file.eye,
        target: file.target,
        up: file.up.unwrap_or(DVec3::Z),
        fov: file.fov.unwrap_or(40.0),
        width: file.width.unwrap_or(512),
        height: file.height.unwrap_or(512),
    };
    camera.checked().map_err(|fault| Located::at(&file.span, fault).within(|| "camera".into()))
}

/// Every surface with its name, shape and material, no two in one another.
pub(super) fn surfaces(
    files: Vec<SurfaceFile>,
    materials: &Materials,
    bands: usize,
    source: &Source,
) -> Result<Vec<SceneSurface>, Located> {
    if files.is_empty() {
        return Err(Located::nowhere(Fault::EmptyScene));
    }
    let mut names = UniqueNames::default();
    let mut surfaces: Vec<SceneSurface> = Vec::with_capacity(files.len());
    let mut occupied = Vec::new();
    for (index, file) in files.iter().enumerate() {
        let name = file.name.as_ref().map_or_else(|| default_name(index), |name| name.value.clone());
        let sides =
            sides(file, &name, materials, bands, source).map_err(|e| e.within(|| surface_title(&name)))?;
        let name_span = file.name.as_ref().map_or(&file.span, |name| &name.span);
        for side in &sides {
            names.add(&side.name, name_span, source)?;
        }
        for pair in sides.chunks(if file.two_sided { 2 } else { 1 }) {
            occupied.push(apart(&occupied, &pair[0], &file.shape.span)?);
            surfaces.extend_from_slice(pair);
        }
    }
    Ok(surfaces)
}

/// The surfaces of one entry, the back of a two-sided one after its front.
fn sides(
    file: &SurfaceFile,
    name: &str,
    materials: &Materials,
    bands: usize,
    source: &Source,
) -> Result<Vec<SceneSurface>, Located> {
    let material = surface_material(file.material.as_ref(), materials, bands)?;
    let surface = |name: String, shape: Arc<dyn Surface>| SceneSurface {
        name,
        kind: file.shape.kind,
        shape,
        material: material.clone(),
        material_name: file.material.as_ref().map(|material| material.value.clone()),
        order: file.order,
        subdivide: file.subdivide,
        place: source.place(&file.span),
    };
    let names =
        |index: usize| if file.shape.is_numbered() { format!("{name}-{index}") } else { name.to_owned() };
    let fronts = shapes(file, file.flip)?.into_iter().enumerate();
    let fronts = fronts.map(|(index, shape)| surface(names(index), shape));
    if !file.two_sided {
        return Ok(fronts.collect());
    }
    let backs = shapes(file, !file.flip)?;
    let pair = |(front, back): (SceneSurface, _)| {
        let back = surface(format!("{}:back", front.name), back);
        [front, back]
    };
    Ok(fronts.zip(backs).flat_map(pair).collect())
}

/// The shapes of one entry, turned over if `flip`.
fn shapes(file: &SurfaceFile, flip: bool) -> Result<Vec<Arc<dyn Surface>>, Located> {
    let shapes = file.shape.surfaces(&file.motion).map_err(|error| {
        let span = file.shape.span_of(error.field()).clone();
        Located::at(&span, Fault::Shape(error))
    })?;
    let turned = |shape: Box<dyn Surface>| -> Result<Arc<dyn Surface>, Located> {
        check_extent(&*shape, &file.shape.span)?;
        Ok(if flip { Arc::new(Flipped::new(shape)) } else { Arc::from(shape) })
    };
    shapes.into_iter().map(turned).collect()
}

/// Refuses sizes whose powers leave the range of numbers.
fn check_extent(shape: &dyn Surface, span: &Span) -> Result<(), Located> {
    let value = shape.bounds(&Rect::FULL).diagonal();
    if (1e-30..=1e30).contains(&value) {
        return Ok(());
    }
    let range = "1e-30 ≤ extent ≤ 1e30";
    Err(Located::at(span, Fault::OutOfRange { what: "the extent of the surface", value, range }))
}

fn surface_material(
    name: Option<&At<String>>,
    materials: &Materials,
    bands: usize,
) -> Result<Material, Located> {
    let Some(name) = name else { return Ok(Material::black(bands)) };
    materials.get(&name.value).cloned().ok_or_else(|| {
        let known = materials.keys().cloned().collect();
        Located::at(&name.span, Fault::UnknownMaterial { name: name.value.clone(), known })
    })
}

/// What `new` occupies, if that is no part of what others do, each given with its name.
fn apart(
    others: &[(String, Occupied)],
    new: &SceneSurface,
    span: &Span,
) -> Result<(String, Occupied), Located> {
    let own = Occupied::new(&new.shape);
    match others.iter().find(|(_, other)| other.coincides(&own)) {
        None => Ok((new.name.clone(), own)),
        Some((name, _)) => {
            let fault = Fault::Coincident { other: name.clone() };
            Err(Located::at(span, fault).within(|| surface_title(&new.name)))
        }
    }
}

/// Names seen so far, each with its line.
#[derive(Default)]
struct UniqueNames(BTreeMap<String, usize>);

impl UniqueNames {
    fn add(&mut self, name: &str, span: &Span, source: &Source) -> Result<(), Located> {
        let line = source.place(span).line;
        match self.0.insert(name.to_owned(), line) {
            None => Ok(()),
            Some(first_line) => {
                Err(Located::at(span, Fault::DuplicateName { name: name.to_owned(), first_line }))
            }
        }
    }
}
