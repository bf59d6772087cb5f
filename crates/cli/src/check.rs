//! `radiosity check`: what is in a scene, what looks wrong, and what a solution costs.

mod cost;

use std::collections::BTreeMap;

use clap::{Args, ValueEnum};
use radiosity_geom::Adjacency;
use radiosity_geom::DVec3;
use radiosity_output::table::{Column, Table};
use radiosity_scene::{
    Animation, Camera, Distribution, Extent, Fitted, Imported, LiesOn, Luminaire, Mover, Scene, SceneSurface,
    SensorPlane, Source,
};
use radiosity_visibility::footprints::Footprint;
use radiosity_visibility::inspection::{
    Fronts, Inspection, NearPoint, Passage, Shell, SurfaceContact, Warning,
};
use radiosity_work::listed::{LONG, listed};
use radiosity_work::printable::{printable, printable_lines};
use radiosity_work::ranks::Ranks;
use serde_json::{Value, json};

use cost::Way;

use crate::{console, error::CliError, loaded::outside, materials, options::SceneArg};

/// Says what is in a scene, what touches what, and what looks wrong
#[derive(Debug, Args)]
#[command(
    after_help = "Examples:\n  radiosity check room.toml\n  radiosity check room.toml --cost     what a solution takes, by its usual ways"
)]
pub(crate) struct CheckArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArg,

    /// Text for people, or JSON with the same content
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    pub(crate) format: Format,

    /// Tells about the seconds that direct light and transfers of a solution take here, and its memory, by the usual
    /// ways; light at pixels, cells and points, and checks, come on top, and are told when they begin
    #[arg(long)]
    pub(crate) cost: bool,
}

/// Form of the findings.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(crate) enum Format {
    /// For people.
    Text,
    /// For programs.
    Json,
}

/// Prints the scene's bands, surfaces, contacts and camera, then the warnings.
pub(crate) fn run(args: &CheckArgs, scene: &Scene, ranks: &Ranks) -> Result<(), CliError> {
    let inspection = Inspection::of(scene);
    let ways = args.cost.then(|| Way::all(scene, ranks)).transpose()?;
    let text = match args.format {
        Format::Text => {
            let cost = ways.map(|ways| Way::table(&ways).to_string());
            let lines: Vec<String> = lines(scene, &inspection).into_iter().chain(cost).collect();
            printable_lines(&(lines.join("\n") + "\n")).into_owned()
        }
        Format::Json => {
            let mut found = as_json(scene, &inspection);
            if let Some(ways) = ways {
                found["cost"] = ways.iter().map(Way::as_json).collect();
            }
            format!("{found:#}\n")
        }
    };
    console::print(text.as_bytes(), ranks)?;
    let is_wrong = |warning: &&Warning| !warning.is_of_something_missing();
    let repairs = scene.imported().map_or(0, |imported| imported.repairs.len());
    match inspection.warnings.iter().filter(is_wrong).count() + repairs {
        count if args.scene.strict && count > 0 => Err(CliError::LooksWrong { count }),
        _ => Ok(()),
    }
}

/// Lines on the contents of a scene, then its warnings.
fn lines(scene: &Scene, inspection: &Inspection) -> Vec<String> {
    let mut lines = lines_on_surfaces(scene, inspection);
    let Inspection { footprints, shells, near_points, warnings, .. } = inspection;
    let Fitted { welded, lying, .. } = &scene.fitted;
    lines.extend((welded.corners > 0).then(|| format!("welded: {welded}")));
    lines.extend(lying.iter().map(|LiesOn { surface, on, is_turned }| match is_turned {
        true => format!("set apart: {surface} lies behind {on}, before which it was typed"),
        false => format!("set apart: {surface} lies on {on}"),
    }));
    lines.extend(footprints.iter().map(|own| format!("covered: {}", footprint_line(scene, own))));
    lines.extend(shells.iter().map(|own| format!("closed: {}", shell_line(scene, own))));
    let openings = scene.surfaces.iter().filter(|surface| surface.is_opening());
    let openings: Vec<&str> = openings.map(|surface| surface.name.as_str()).collect();
    if !openings.is_empty() {
        lines.push(format!("openings to the sky: {}", listed(&openings, LONG)));
    }
    if !scene.luminaires.is_empty() {
        lines.push(luminaire_table(scene).to_string());
    }
    lines.extend(near_points.iter().take(LONG).map(|near| format!("as a point: {}", near_line(near))));
    if let Some(rest) = near_points.len().checked_sub(LONG).filter(|rest| *rest > 0) {
        lines.push(format!("as a point: {rest} more; --format json names them all"));
    }
    lines.extend(motion_lines(scene));
    let camera = scene.camera.as_ref().map(|camera| camera_line(camera, scene.middle));
    lines.push(format!("camera: {}", camera.as_deref().unwrap_or("none")));
    lines.extend(scene.planes.iter().map(|plane| format!("plane: {}", plane_line(plane))));
    lines.extend(warning_lines(warnings));
    lines.extend(warnings.is_empty().then(|| clean(scene).to_owned()));
    lines
}

/// Words on a scene without warnings.
fn clean(scene: &Scene) -> &'static str {
    match scene.imported() {
        Some(Imported { notes, repairs, .. }) if !(notes.is_empty() && repairs.is_empty()) => {
            "nothing else looks wrong: what the import left out, turned or repaired is told above"
        }
        _ => "nothing looks wrong",
    }
}

/// The head, and lines on surfaces, their materials and contacts.
fn lines_on_surfaces(scene: &Scene, inspection: &Inspection) -> Vec<String> {
    let Scene { surfaces, variables, .. } = scene;
    let area: f64 = inspection.areas.iter().sum();
    let emitters = surfaces.iter().filter(|surface| surface.material.emits()).count();
    let mut lines = vec![
        format!("{}: {}", scene.origin, printable(scene.title.as_deref().unwrap_or("(no title)"))),
        format!("bands: {}; unit: {}", scene.bands.join(", "), scene.unit),
        format!("surfaces: {}, of which {emitters} emit; total area {area:.6}\n", surfaces.len()),
    ];
    lines.extend(scene.imported().into_iter().flat_map(Imported::lines));
    lines.extend(outside(scene));
    if !variables.is_empty() {
        let variables: Vec<String> =
            variables.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        lines.push(format!("variables: {}\n", listed(&variables, LONG)));
    }
    let groups: Vec<&str> = scene.light_groups().iter().map(|group| group.name.as_str()).collect();
    if !groups.is_empty() {
        lines.push(format!("light groups: {}\n", listed(&groups, LONG)));
    }
    lines.push(surface_table(surfaces, &inspection.areas).to_string());
    lines.extend(materials::lines(scene));
    if !scene.unused_materials.is_empty() {
        lines.push(format!("materials that no surface has: {}", listed(&scene.unused_materials, LONG)));
    }
    if !inspection.contacts.is_empty() {
        lines.push(contact_table(scene, &inspection.contacts).to_string());
    }
    lines
}

/// One line for each warning, of each kind the first `LONG`.
fn warning_lines(warnings: &[Warning]) -> Vec<String> {
    let (mut lines, mut counts) = (Vec::new(), BTreeMap::new());
    for warning in warnings {
        let count = counts.entry(warning.code).or_insert(0);
        *count += 1;
        if *count <= LONG {
            lines.push(format!("warning: {}", warning.message));
        }
    }
    for (code, count) in counts.into_iter().filter(|(_, count)| *count > LONG) {
        let rest = count - LONG;
        lines.push(format!("warning: {rest} more of the kind {code:?}: --format json names them all"));
    }
    lines
}

fn surface_table(surfaces: &[SceneSurface], areas: &[f64]) -> Table<'static> {
    let row = |(surface, area): (&SceneSurface, &f64)| {
        let center = surface.shape.jet(0.0, 0.0).normal;
        let curved = if surface.shape.region().is_some() { "" } else { " at its centre" };
        [
            surface.name.clone(),
            surface.kind.to_owned(),
            format!("{area:.6}"),
            vector(center.to_array()) + curved,
            surface.material_name.clone().unwrap_or_else(|| "none".to_owned()),
            numbers(&surface.material.reflectance),
        ]
    };
    let columns = ["surface", "shape", "area", "normal", "material", "reflectance"];
    Table::new(columns.map(Column::text), surfaces.iter().zip(areas).map(row))
}

fn luminaire_table(scene: &Scene) -> Table<'static> {
    let row = |own: &Luminaire| {
        let flux: Vec<f64> = (0..scene.bands.len()).map(|band| rounded(own.flux(band))).collect();
        [
            own.name.clone(),
            distribution(&own.distribution),
            extent(&own.extent),
            vector((own.position + scene.middle).to_array()),
            vector(own.aim.to_array()),
            numbers(&flux),
        ]
    };
    let columns = ["luminaire", "light", "extent", "position", "aim", "flux"];
    Table::new(columns.map(Column::text), scene.luminaires.iter().map(row))
}

fn distribution(distribution: &Distribution) -> String {
    match distribution {
        Distribution::Point => "point".to_owned(),
        Distribution::Power { exponent } => format!("spot, exponent {exponent}"),
        Distribution::Cone { angle, edge } => format!("spot, {angle}°, edge {edge}°"),
        Distribution::Table(table) if table.name.is_empty() => "table".to_owned(),
        Distribution::Table(table) => format!("table of {}", table.name),
    }
}

fn extent(extent: &Extent) -> String {
    match *extent {
        Extent::Point => "point".to_owned(),
        Extent::Line { .. } => format!("line of {}", rounded(extent.width())),
        Extent::Rectangle { sides: [x, y] } => format!("{} × {}", rounded(x), rounded(y)),
        Extent::Disk { diameter } => format!("disk of {}", rounded(diameter)),
    }
}

fn near_line(near: &NearPoint) -> String {
    let NearPoint { luminaire, surface, distance, width, error } = near;
    format!(
        "{luminaire} errs by up to about {:.0} % at {surface}, {distance:.2} away, for its file states an opening {width:.2} m wide; \
         extent = \"file\" lets it shine from there",
        (100.0 * error).max(1.0)
    )
}

/// A number with six digits.
fn rounded(number: f64) -> f64 {
    format!("{number:.5e}").parse().unwrap_or(number)
}

fn luminaire_json(own: &Luminaire, scene: &Scene) -> Value {
    json!({
        "name": own.name, "light": distribution(&own.distribution), "extent": extent(&own.extent), "position": (own.position + scene.middle).to_array(),
        "aim": own.aim.to_array(), "along": own.along.to_array(),
        "flux": (0..scene.bands.len()).map(|band| own.flux(band)).collect::<Vec<f64>>(),
        "intensity": own.strength.iter().map(|strength| strength * own.distribution.peak()).collect::<Vec<f64>>(),
        "group": own.group.as_ref().map(|group| &group.name),
    })
}

/// One row for each surface and way of touching, each contact named once.
fn contact_table(scene: &Scene, contacts: &[SurfaceContact]) -> Table<'static> {
    let mut rows: Vec<(usize, &str, Vec<&str>)> = Vec::new();
    for SurfaceContact { surfaces: [own, other], touch } in contacts {
        let (way, name) = (way(*touch), scene.surfaces[*other].name.as_str());
        // All contacts of a surface with later ones stand together.
        match rows.iter_mut().rev().take_while(|row| row.0 == *own).find(|row| row.1 == way) {
            Some(row) => row.2.push(name),
            None => rows.push((*own, way, vec![name])),
        }
    }
    let row = |(own, way, others): (usize, &str, Vec<&str>)| {
        [scene.surfaces[own].name.clone(), way.to_owned(), listed(&others, LONG)]
    };
    Table::new(["surface", "touches", "of"].map(Column::text), rows.into_iter().map(row))
}

fn way(touch: Adjacency) -> &'static str {
    match touch {
        Adjacency::Edge => "edge",
        Adjacency::Tee => "side or face",
        Adjacency::Vertex => "corner",
        Adjacency::Crossing { .. } => "inside",
        Adjacency::Overlap => "area",
    }
}

fn shell_line(scene: &Scene, shell: &Shell) -> String {
    let names: Vec<&str> = shell.surfaces.iter().map(|k| scene.surfaces[*k].name.as_str()).collect();
    let Shell { volume, fronts, .. } = shell;
    format!("{}; volume {volume:.6}, fronts {}", listed(&names, LONG), side(*fronts))
}

fn footprint_line(scene: &Scene, footprint: &Footprint) -> String {
    let name = |index: &usize| scene.surfaces[*index].name.as_str();
    let standing: Vec<&str> = footprint.standing.iter().map(name).collect();
    let area = footprint.region.area();
    format!("{:.6} of {}, where {} stand", area, name(&footprint.surface), listed(&standing, LONG))
}

/// Lines on the animation: number of frames, and the things that move or are dimmed.
fn motion_lines(scene: &Scene) -> Vec<String> {
    let Some(Animation { frames, rate, movers, .. }) = &scene.animation else { return Vec::new() };
    let motion = |mover: &Mover| {
        format!("motion: {} {} {}", mover.name, happens(mover), listed(&moved(scene, mover), LONG))
    };
    let head = match rate {
        1.0 => format!("frames: {frames}, 0 to {}", frames - 1),
        rate => format!("frames: {frames}, 0 to {}, {rate} in a unit of time", frames - 1),
    };
    [head].into_iter().chain(movers.iter().map(motion)).collect()
}

/// The verb for a mover.
fn happens(mover: &Mover) -> &'static str {
    match (mover.has_path(), mover.emission.is_some()) {
        (true, true) => "moves and dims",
        (false, true) => "dims",
        (_, false) => "moves",
    }
}

/// The names of all that a mover moves or dims.
fn moved<'a>(scene: &'a Scene, mover: &Mover) -> Vec<&'a str> {
    let surfaces = mover.surfaces.iter().map(|index| scene.surfaces[*index].name.as_str());
    let luminaires = mover.luminaires.iter().map(|index| scene.luminaires[*index].name.as_str());
    surfaces.chain(luminaires).chain(mover.camera.then_some("the camera")).collect()
}

fn motion_json(scene: &Scene, inspection: &Inspection) -> Option<Value> {
    let Animation { frames, rate, movers, .. } = scene.animation.as_ref()?;
    let motion = |mover: &Mover| {
        let surfaces = mover.surfaces.iter().map(|index| scene.surfaces[*index].name.as_str());
        let luminaires = mover.luminaires.iter().map(|index| scene.luminaires[*index].name.as_str());
        json!({
            "name": mover.name, "surfaces": surfaces.collect::<Vec<_>>(), "luminaires": luminaires.collect::<Vec<_>>(),
            "camera": mover.camera, "moves": mover.has_path(), "dims": mover.emission.is_some(),
        })
    };
    let passage = |own: &Passage| json!({ "surface": own.surface, "through": own.other, "frames": own.frames, "before": own.before });
    Some(json!({
        "frames": frames, "rate": rate, "motions": movers.iter().map(motion).collect::<Vec<_>>(),
        "passages": inspection.passages.iter().map(passage).collect::<Vec<_>>(),
    }))
}

fn side(fronts: Fronts) -> &'static str {
    match fronts {
        Fronts::Inside => "inside",
        Fronts::Outside => "outside",
        Fronts::Mixed => "on both sides",
    }
}

fn plane_line(plane: &SensorPlane) -> String {
    let ([along_first, along_second], normal) = (plane.counts(), vector(plane.normal().to_array()));
    format!("{}, {along_first} × {along_second} sensors that face {normal}", plane.name())
}

/// The content of the text as JSON, numbers in full.
fn as_json(scene: &Scene, inspection: &Inspection) -> Value {
    let name = |index: &usize| scene.surfaces[*index].name.as_str();
    let surfaces = scene.surfaces.iter().zip(&inspection.areas);
    let surfaces = surfaces.map(|(surface, area)| surface_json(surface, *area, scene));
    let contacts = inspection.contacts.iter().map(|contact| contact_json(contact, scene));
    let shells = inspection.shells.iter().map(|shell| {
        let surfaces: Vec<&str> = shell.surfaces.iter().map(name).collect();
        json!({ "surfaces": surfaces, "volume": shell.volume, "fronts": side(shell.fronts) })
    });
    let footprints = inspection.footprints.iter().map(|footprint| {
        let standing: Vec<&str> = footprint.standing.iter().map(name).collect();
        json!({ "surface": name(&footprint.surface), "area": footprint.region.area(), "standing": standing })
    });
    json!({
        "scene": scene.name, "title": scene.title, "bands": scene.bands, "unit": scene.unit,
        "area": inspection.areas.iter().sum::<f64>(),
        "variables": scene.variables.iter().cloned().collect::<BTreeMap<_, _>>(),
        "surfaces": surfaces.collect::<Vec<_>>(), "materials": materials::as_json(scene), "unused_materials": scene.unused_materials, "contacts": contacts.collect::<Vec<_>>(),
        "imported": scene.imported(), "read_outside": scene.source.as_ref().map(Source::outside), "fitted": scene.fitted, "middle": scene.middle.to_array(), "covered": footprints.collect::<Vec<_>>(), "closed": shells.collect::<Vec<_>>(), "camera": camera_json(scene),
        "luminaires": scene.luminaires.iter().map(|own| luminaire_json(own, scene)).collect::<Vec<_>>(),
        "animation": motion_json(scene, inspection),
        "near_points": inspection.near_points, "planes": scene.planes.iter().map(plane_json).collect::<Vec<_>>(), "warnings": inspection.warnings,
    })
}

fn surface_json(surface: &SceneSurface, area: f64, scene: &Scene) -> Value {
    let other_side = surface.other_side.map(|index| scene.surfaces[index].name.as_str());
    json!({
        "name": surface.name, "shape": surface.kind, "area": area,
        "planar": surface.shape.region().is_some(), "normal": surface.shape.jet(0.0, 0.0).normal.to_array(),
        "material": surface.material_name, "reflectance": surface.material.reflectance,
        "emission": surface.material.emission, "other_side": other_side, "opening": surface.is_opening(), "flux": surface.flux, "group": surface.group.as_ref().map(|group| &group.name),
    })
}

fn contact_json(contact: &SurfaceContact, scene: &Scene) -> Value {
    let surfaces = contact.surfaces.map(|index| scene.surfaces[index].name.as_str());
    let at = if let Adjacency::Crossing { at } = contact.touch {
        Some((at + scene.middle).to_array())
    } else {
        None
    };
    json!({ "surfaces": surfaces, "touch": touch_key(contact.touch), "at": at })
}

fn camera_json(scene: &Scene) -> Option<Value> {
    let camera = scene.camera.as_ref()?;
    Some(json!({
        "eye": (camera.eye + scene.middle).to_array(), "target": (camera.target + scene.middle).to_array(), "up": camera.up.to_array(),
        "fov": camera.fov, "width": camera.width, "height": camera.height,
    }))
}

fn plane_json(plane: &SensorPlane) -> Value {
    json!({
        "name": plane.name(), "origin": plane.origin().to_array(),
        "edges": plane.edges().map(|edge| edge.to_array()), "counts": plane.counts(),
    })
}

fn touch_key(touch: Adjacency) -> &'static str {
    match touch {
        Adjacency::Edge => "edge",
        Adjacency::Tee => "tee",
        Adjacency::Vertex => "vertex",
        Adjacency::Crossing { .. } => "crossing",
        Adjacency::Overlap => "overlap",
    }
}

/// A vector with three decimals, without the −0 of rounding.
fn vector(numbers: [f64; 3]) -> String {
    let [x, y, z] = numbers.map(|number| (number * 1e3).round() / 1e3 + 0.0);
    format!("({x}, {y}, {z})")
}

fn numbers(numbers: &[f64]) -> String {
    let equal = numbers.iter().all(|number| *number == numbers[0]);
    let shown = if equal { &numbers[..1] } else { numbers };
    shown.iter().map(f64::to_string).collect::<Vec<_>>().join(", ")
}

fn camera_line(camera: &Camera, middle: DVec3) -> String {
    let Camera { eye, target, fov, width, height, .. } = camera;
    let (eye, target) = (vector((eye + middle).to_array()), vector((target + middle).to_array()));
    format!("at {eye}, looking at {target}, {fov:.1} degrees high, {width}x{height} pixels")
}
