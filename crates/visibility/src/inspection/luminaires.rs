//! Luminaires whose light reaches no front, what is odd about their tables, and how far points err that are
//! as large as their tables say.

use radiosity_geom::{DVec3, Encounter, Ray, Rect, Surface};
use radiosity_scene::{Distribution, Extent, Luminaire, Scene};
use serde::Serialize;

use crate::inspection::warning::Warning;
use crate::tolerances::OWN_END;
use crate::{Shadows, Visibility, golden_spiral};

/// Rays all around a luminaire that look for a front that it lights, before rays to each surface do.
const RAYS: usize = 256;

/// Units of illuminance, in which the light of tables comes out.
const ILLUMINANCE: [&str; 4] = ["lx", "lux", "lm/m²", "lm/m^2"];

/// Times the size of an opening from which on its light is that of a point, to 1 %: the five-times rule of
/// photometry.
const FIVE_TIMES: f64 = 5.0;

/// A luminaire that shines as a point, yet nearer to a surface than five times the size of the opening that
/// its file states.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NearPoint {
    /// Name of the luminaire.
    pub luminaire: String,
    /// The nearest surface that it lights.
    pub surface: String,
    /// Approximate distance of that surface (scene length).
    pub distance: f64,
    /// Largest width w of the opening, m.
    pub width: f64,
    /// About the largest error of the light there, as a part of it: w²/(2 r)² at the distance r, as on the
    /// axis of a disk.
    pub error: f64,
}

/// The luminaires of a scene that err as points.
pub(super) fn near_points(scene: &Scene) -> Vec<NearPoint> {
    let width = |own: &Luminaire| match &own.distribution {
        Distribution::Table(table) if own.extent == Extent::Point => {
            let whole = DVec3::from(table.opening.extent);
            Extent::of_opening(&table.opening).map_or(whole.length(), |flat| flat.width().max(whole.z))
        }
        _ => 0.0,
    };
    let large: Vec<&Luminaire> = scene.luminaires.iter().filter(|own| width(own) > 0.0).collect();
    if large.is_empty() {
        return Vec::new();
    }
    let visibility = Visibility::new(scene, Shadows::Rays, 1e-3);
    let near = |own: &Luminaire| {
        let fronts = lit(own, around(own), &visibility).filter(|met| met.front);
        let nearest = fronts.min_by(|a, b| a.hit.t.total_cmp(&b.hit.t))?;
        let (width, distance) = (width(own), nearest.hit.t);
        (distance < FIVE_TIMES * width).then(|| NearPoint {
            luminaire: own.name.clone(),
            surface: scene.surfaces[nearest.surface].name.clone(),
            distance,
            width,
            error: (0.5 * width / distance).powi(2),
        })
    };
    large.into_iter().filter_map(near).collect()
}

/// Warnings about the luminaires of a scene.
pub(super) fn odd(scene: &Scene) -> Vec<Warning> {
    if scene.luminaires.is_empty() {
        return Vec::new();
    }
    let visibility = Visibility::new(scene, Shadows::Rays, 1e-3);
    let of_each = scene.luminaires.iter().flat_map(|own| {
        let dark = (own.emits() && !lights_a_front(own, scene, &visibility)).then(|| {
            let message = "lights no front of a surface: it is within a body, behind a wall or outside the room; move it, \
                           or turn it";
            Warning::of_luminaire("unlit", &own.name, message)
        });
        dark.into_iter().chain(remarks(own))
    });
    of_each.chain(unit(scene)).collect()
}

/// Whether a ray of its light meets a front, beyond the surface that it may be mounted on: one of all directions, or
/// one to a surface that is far off, or small.
fn lights_a_front(own: &Luminaire, scene: &Scene, visibility: &Visibility) -> bool {
    let towards = scene.surfaces.iter().flat_map(|surface| places(&*surface.shape));
    lit(own, around(own), visibility).any(|met| met.front)
        || lit(own, towards.map(|place| (place - own.position).normalize_or_zero()), visibility)
            .any(|met| met.front)
}

/// Places on a surface that rays are sent to: a middle of each part.
fn places(shape: &dyn Surface) -> Vec<DVec3> {
    let middle = |corners: &Vec<DVec3>| corners.iter().sum::<DVec3>() / corners.len() as f64;
    match shape.region() {
        Some(region) => region.convex_pieces().iter().map(middle).collect(),
        None => Rect::FULL
            .quarters()
            .map(|quarter| quarter.at(0.0, 0.0))
            .map(|[u, v]| shape.jet(u, v).position)
            .to_vec(),
    }
}

/// The aim of a luminaire, and directions all around it.
fn around(own: &Luminaire) -> impl Iterator<Item = DVec3> {
    [own.aim].into_iter().chain((0..RAYS).map(|place| golden_spiral::direction(place, RAYS)))
}

/// First hits of rays of a luminaire's light in these directions, beyond the surface that it may be mounted on.
fn lit(
    own: &Luminaire,
    directions: impl Iterator<Item = DVec3>,
    visibility: &Visibility,
) -> impl Iterator<Item = Encounter> {
    let lit = directions.filter(|direction| own.relative(*direction) > 0.0);
    let start = OWN_END * visibility.bounds().diagonal();
    lit.filter_map(move |direction: DVec3| {
        let ray = Ray { range: [start, f64::INFINITY], ..Ray::new(own.position, direction) };
        visibility.nearest(&ray)
    })
}

/// Warnings about the table of a luminaire, and about an extent that leaves out the height of its opening.
fn remarks(own: &Luminaire) -> Vec<Warning> {
    let Distribution::Table(table) = &own.distribution else { return Vec::new() };
    let remark =
        |text: &str| Warning::of_luminaire("photometry", &own.name, &format!("has an odd table: {text}"));
    let height = table.opening.extent[2];
    let flat = (height > 0.0 && own.extent != Extent::Point).then(|| {
        let message = format!(
            "shines across its aim alone, yet its file states an opening {height} m high: near its sides light is not that of its sides"
        );
        Warning::of_luminaire("extent", &own.name, &message)
    });
    table.notes.iter().map(|note| remark(&note.text)).chain(flat).collect()
}

/// A unit that is not that of tables.
fn unit(scene: &Scene) -> Option<Warning> {
    let is_table = |own: &&Luminaire| matches!(own.distribution, Distribution::Table(_));
    let first = scene.luminaires.iter().find(is_table)?;
    let is_lux = ILLUMINANCE.contains(&scene.unit.as_str());
    let message = format!(
        "has a table in candela, from which illuminance comes out in lx where lengths are in metres, yet the unit of the \
         scene is {}: state unit = \"lx\"",
        scene.unit
    );
    (!is_lux).then(|| Warning::of_luminaire("unit", &first.name, &message))
}
