//! A scene as it is typed: keys, kinds and counts are right, every value knows its place, nothing else is
//! checked.

mod per_band;
mod pattern;
mod thermal;
mod sky;
mod surface;
mod luminaire;
mod part;
mod motion;
mod mask;

use radiosity_geom::DVec3;
use radiosity_scene::{
    animation::{MOST_FRAMES, check_frames, check_rate},
    error::Located,
    place::{At, Span},
    ranges::{MAX_PIXELS, check_fov, check_pixels},
    tree::Node,
};
use serde_json::{Value, json};

use crate::{
    fields::{checked, counted, exactly, list, point, real, text},
    keys::{DefaultValue, GivenFields, KeyTable, ListOfTables, NamedTable, TablesByName, ValueKind, keys},
    kinds::{POINT, TEXT, VECTOR},
    terms,
};
use part::INSTANCES;
use pattern::{amount, amount_schema};
use per_band::per_band;
use thermal::{ConditionFile, EMISSIVITY};

pub(super) use luminaire::{ExtentFile, LuminaireFile};
pub(super) use mask::MaskFile;
pub(super) use motion::{EmissionFile, MotionFile, RotateFile, TranslateFile};
pub(super) use part::{Content, CopyRow, InstanceFile, PartFile, RowsFile};
pub(super) use pattern::{Amount, EachBand, PatternFile, PatternKind};
pub(super) use per_band::PerBand;
pub(super) use sky::{GlassFile, SkyFile, SunFile};
pub(super) use surface::SurfaceFile;

keys! {
    /// A scene file as typed.
    #[derive(Default)]
    SceneFile("A scene, or a list of polygons for view factors") {
        #[expect(dead_code, reason = "files are read before what they are included in")]
        include: Option<()> = ValueKind::new(|_| Ok(()), include_schema), "Files whose content belongs to the scene too";
        title: Option<String> = TEXT, "What the scene is, for people";
        bands: Option<At<Vec<At<String>>>> = ValueKind::new(bands, bands_schema),
            "Names of the bands; grey, or r, g, b where lists are given";
        unit: Option<At<String>> =
            ValueKind::new(|node| Ok(text(node)?.value), || terms::with(terms::text(""), "maxLength", 16.into()))
                .or(DefaultValue::Word("W/m²")),
            "Unit of exitance, irradiance and radiosity, as it is printed";
        frames: Option<At<usize>> =
            ValueKind::new(|node| counted(node, check_frames), || terms::whole(1, MOST_FRAMES, "")),
            "How many frames there are";
        fps: Option<At<f64>> =
            ValueKind::number(|node| checked(node, check_rate), || json!({ "minimum": 1e-6, "maximum": 1e6 }))
                .or(DefaultValue::Number(1.0)),
            "Frames in a unit of time";
        #[expect(dead_code, reason = "variables are evaluated before all else is read")]
        variables: Option<()> = ValueKind::new(|_| Ok(()), variables_schema), "Numbers for formulas, by name";
        camera: Option<CameraFile> = ValueKind::new(
            |node| CameraFile::read(node).map_err(|error| error.within(|| "camera".into())),
            || terms::reference("camera"),
        ), "";
        sky: Option<SkyFile> = ValueKind::new(
            |node| SkyFile::read(node).map_err(|error| error.within(|| "sky".into())),
            || terms::reference("sky"),
        ), "";
        planes: Vec<NamedTable<PlaneFile>> = TablesByName("plane"), "Planes of sensors by name";
        materials: Vec<NamedTable<MaterialFile>> = TablesByName("material"), "Materials by name";
        parts: Vec<NamedTable<PartFile>> = TablesByName("part"), "Parts by name, to be put in many places";
        surfaces: Vec<SurfaceFile> = ListOfTables::of("surface"), "The surfaces";
        luminaires: Vec<LuminaireFile> = ListOfTables::of("luminaire"), "Lamps by their intensity in each direction";
        instances: Vec<InstanceFile> = INSTANCES, "Instances of parts";
        motion: Vec<MotionFile> = ListOfTables::of("motion"), "What moves or is dimmed, each along a path";
        masks: Vec<MaskFile> = ListOfTables { kind: "mask", called_after: Some("receiver") },
            "Pairs of surfaces whose light is masked with --shadows mask";
    }
}

keys! {
    /// `[camera]`.
    CameraFile("A pinhole camera") {
        eye: DVec3 = POINT, "Where the camera is";
        target: DVec3 = POINT, "What is in the middle of the picture";
        up: DVec3 = VECTOR.or(DefaultValue::Numbers(&[0.0, 0.0, 1.0])), "What is up in the picture";
        fov: f64 = ValueKind::number(
            |node| checked(node, check_fov),
            || json!({ "exclusiveMinimum": 0, "exclusiveMaximum": 180 }),
        ).or(DefaultValue::Number(40.0)), "Angle from the lower to the upper border, degrees";
        width: u32 = PIXELS.or(DefaultValue::Number(512.0)), "Width of the picture, pixels";
        height: u32 = PIXELS.or(DefaultValue::Number(512.0)), "Height of the picture, pixels";
        ..span: Span;
    }
}

keys! {
    /// `[planes.NAME]`.
    PlaneFile("A plane of sensors") {
        origin: DVec3 = POINT, "A corner";
        edges: At<[DVec3; 2]> =
            ValueKind::new(|node| exactly(node, "edges", "vectors", point), || terms::exactly(2, "vector", ""))
                .example(", two vectors, each three numbers in brackets"),
            "Two edges; sensors receive along the first × the second";
        spacing: At<[f64; 2]> = ValueKind::new(spacing, spacing_schema).example(", a length, or one along each edge"),
            "Largest distance of sensors, for both edges or along each";
    }
}

keys! {
    /// `[materials.NAME]`; without a reflectance where an emissivity is given.
    MaterialFile("A diffuse material", terms::required("anyOf", &["reflectance", "emissivity"]); check_material) {
        reflectance: Option<Amount> = ValueKind::new(amount, || amount_schema(below_one())),
            "Reflectance ρ, for all bands, of each, or as it varies";
        emission: Amount = ValueKind::new(amount, || amount_schema(terms::at_least_zero())).or(DefaultValue::Number(0.0)),
            "Exitance of the surface's own light, W/m²";
        transmittance: Option<At<PerBand>> =
            ValueKind::new(per_band, || terms::per_band(below_one(), "")).or(DefaultValue::Number(0.0)),
            "Diffuse transmittance τ of two-sided surfaces, ρ + τ < 1";
        emissivity: Option<f64> = EMISSIVITY, "Emissivity, of all wavelengths together";
        group: Option<At<String>> = TEXT, "Light group of its surfaces that name none";
        ..condition: ConditionFile;
    }
}

const PIXELS: ValueKind<u32> =
    ValueKind::new(|node| Ok(counted(node, check_pixels)? as u32), || terms::whole(1, MAX_PIXELS, ""));

fn include_schema() -> Value {
    let file = terms::text("Path of a scene file, from the folder of this one");
    let files = json!({ "type": "array", "items": file });
    json!({ "anyOf": [file, files] })
}

fn bands(node: &Node) -> Result<Vec<At<String>>, Located> {
    list(node)?.iter().map(text).collect()
}

fn bands_schema() -> Value {
    terms::with(terms::list("name", "", 1), "uniqueItems", true.into())
}

fn variables_schema() -> Value {
    json!({
        "type": "object", "additionalProperties": terms::reference("number"),
        "propertyNames": { "pattern": "^[\\p{L}_][\\p{L}\\p{N}_]*$" },
    })
}

/// One length for both edges, or one along each.
fn spacing(node: &Node) -> Result<[f64; 2], Located> {
    match node.items() {
        Some(_) => exactly(node, "spacing", "numbers, one along each edge", real),
        None => Ok([real(node)?; 2]),
    }
}

fn spacing_schema() -> Value {
    let one = terms::positive("A length");
    let two = terms::with(terms::exactly(2, "number", "Along each edge"), "items", one.clone());
    json!({ "anyOf": [one["anyOf"][0], one["anyOf"][1], two] })
}

fn below_one() -> Value {
    json!({ "minimum": 0, "exclusiveMaximum": 1 })
}

fn check_material(own: &MaterialFile, fields: &GivenFields<'_>) -> Result<(), Located> {
    match own.reflectance.is_some() || own.emissivity.is_some() {
        true => Ok(()),
        false => Err(fields.missing(
            "reflectance",
            ", a number or one per band, 0 ≤ ρ < 1; 0 is black; or, for heat alone, `emissivity = …`, 0 < ε ≤ 1",
        )),
    }
}

impl SceneFile {
    /// Whether every reflectance, transmittance, emission, flux, intensity and factor over time is a single
    /// number, or a pattern alike in all bands.
    pub(super) fn is_grey(&self) -> bool {
        let materials = || self.materials.iter().map(|own| &own.file);
        let mut amounts = materials().flat_map(|own| own.reflectance.iter().chain([&own.emission]));
        let transmittances = materials().filter_map(|own| Some(&own.transmittance.as_ref()?.value));
        let contents = self.parts.iter().map(|part| part.file.content()).chain([self.content()]);
        let fluxes = contents.flat_map(|content| {
            let luminaires = content.luminaires.iter().filter_map(LuminaireFile::strength);
            content.surfaces.iter().filter_map(|surface| surface.flux.as_ref()).chain(luminaires)
        });
        let skies = self.sky.iter().flat_map(|sky| {
            [&sky.illuminance].into_iter().chain(sky.sun.as_ref().map(|sun| &sun.illuminance))
        });
        let tracks = self.motion.iter().filter_map(|own| own.emission.as_ref());
        let factors = tracks.flat_map(|own| &own.value.factors.value);
        let mut numbers = transmittances.chain(fluxes).chain(skies).chain(factors);
        numbers.all(PerBand::is_one_number) && amounts.all(Amount::is_one_for_all)
    }

    /// Its surfaces, luminaires and instances.
    pub(super) fn content(&self) -> Content<'_> {
        let SceneFile { surfaces, luminaires, instances, .. } = self;
        Content { surfaces, luminaires, instances }
    }
}
