//! The data files as surfaces.

use radiosity_geom::shapes::{
    Bezier, Bilinear, Cone, Cylinder, Disk, FULL_TURN, Parallelogram, Revolution, Sphere, Triangle,
};
use radiosity_geom::{DVec3, Flipped, Surface};
use serde::Deserialize;
use std::collections::BTreeMap;

#[derive(Deserialize)]
pub(crate) struct Teapot {
    /// By a computation independent of this crate, to 9 decimals.
    pub(crate) areas: Vec<f64>,
    pub(crate) patches: Vec<[usize; 16]>,
    pub(crate) vertices: Vec<[f64; 3]>,
}

impl Teapot {
    pub(crate) fn load() -> Teapot {
        serde_json::from_str(include_str!("../data/teapot.json")).unwrap()
    }

    /// The control points of patch k, i along u.
    pub(crate) fn points(&self, k: usize) -> [[DVec3; 4]; 4] {
        let point = |i: usize, j: usize| DVec3::from_array(self.vertices[self.patches[k][4 * i + j]]);
        std::array::from_fn(|i| std::array::from_fn(|j| point(i, j)))
    }

    pub(crate) fn surfaces(&self) -> Vec<Bezier> {
        (0..self.patches.len()).map(|k| Bezier::new(self.points(k)).unwrap()).collect()
    }
}

#[derive(Deserialize)]
struct CornellBox {
    faces: BTreeMap<String, [[f64; 3]; 4]>,
}

/// The corners of the 16 faces of the Cornell box, by name.
pub(crate) fn cornell_corners() -> BTreeMap<String, [DVec3; 4]> {
    let data: CornellBox = serde_json::from_str(include_str!("../data/cornell_box.json")).unwrap();
    data.faces.into_iter().map(|(name, corners)| (name, corners.map(DVec3::from_array))).collect()
}

/// The faces of the Cornell box as bilinear patches, without holes.
pub(crate) fn cornell_faces() -> BTreeMap<String, Bilinear> {
    cornell_corners().into_iter().map(|(name, corners)| (name, Bilinear::new(corners).unwrap())).collect()
}

#[derive(Deserialize)]
struct ViewFactors {
    cases: Vec<ViewFactor>,
}

#[derive(Deserialize)]
pub(crate) struct ViewFactor {
    pub(crate) id: String,
    pub(crate) surface1: Part,
    pub(crate) surface2: Part,
    pub(crate) occluders: Vec<Part>,
    #[serde(rename = "F12")]
    pub(crate) f12: f64,
}

pub(crate) fn view_factors() -> Vec<ViewFactor> {
    let data: ViewFactors = serde_json::from_str(include_str!("../data/view_factors.json")).unwrap();
    data.cases
}

#[derive(Deserialize, PartialEq, Clone, Copy)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Side {
    Inside,
    Outside,
}

/// A surface of the view factor catalogue.
#[derive(Deserialize)]
#[serde(tag = "type", rename_all = "snake_case")]
pub(crate) enum Part {
    Parallelogram {
        origin: [f64; 3],
        edge1: [f64; 3],
        edge2: [f64; 3],
    },
    Triangle {
        origin: [f64; 3],
        edge1: [f64; 3],
        edge2: [f64; 3],
    },
    Disk {
        center: [f64; 3],
        normal: [f64; 3],
        radius: f64,
    },
    Sphere {
        center: [f64; 3],
        radius: f64,
        z_range_from_center: [f64; 2],
        side: Side,
    },
    CylinderLateral {
        base_center: [f64; 3],
        axis: [f64; 3],
        radius: f64,
        height: f64,
        side: Side,
    },
    ConeFrustumLateral {
        base_center: [f64; 3],
        axis: [f64; 3],
        base_radius: f64,
        top_radius: f64,
        height: f64,
        side: Side,
    },
    Paraboloid {
        apex: [f64; 3],
        axis: [f64; 3],
        rho2_over_z: f64,
        height: f64,
        side: Side,
    },
    DifferentialElement {
        point: [f64; 3],
        normal: [f64; 3],
    },
}

impl Part {
    /// The surface; `None` for a differential element, which is a place to probe and no surface.
    pub(crate) fn build(&self) -> Option<Box<dyn Surface>> {
        let v = DVec3::from_array;
        Some(match *self {
            Part::Parallelogram { origin, edge1, edge2 } => {
                Box::new(Parallelogram::new(v(origin), v(edge1), v(edge2)).unwrap())
            }
            Part::Triangle { origin, edge1, edge2 } => {
                Box::new(Triangle::new([v(origin), v(origin) + v(edge1), v(origin) + v(edge2)]).unwrap())
            }
            Part::Disk { center, normal, radius } => {
                Box::new(Disk::new(v(center), v(normal), radius, 0.0, FULL_TURN).unwrap())
            }
            Part::Sphere { center, radius, z_range_from_center, side } => turned(
                Sphere::new(v(center), radius, DVec3::Z, z_range_from_center, FULL_TURN).unwrap(),
                side,
            ),
            Part::CylinderLateral { base_center, axis, radius, height, side } => {
                turned(Cylinder::new(v(base_center), height * v(axis), radius, FULL_TURN).unwrap(), side)
            }
            Part::ConeFrustumLateral { base_center, axis, base_radius, top_radius, height, side } => turned(
                Cone::new(v(base_center), height * v(axis), base_radius, top_radius, FULL_TURN).unwrap(),
                side,
            ),
            Part::Paraboloid { apex, axis, rho2_over_z, height, side } => {
                turned(paraboloid(v(apex), v(axis), rho2_over_z, height), side)
            }
            Part::DifferentialElement { point, normal } => {
                assert!(v(point).is_finite() && v(normal).length() > 0.0);
                return None;
            }
        })
    }
}

fn turned(surface: impl Surface + 'static, side: Side) -> Box<dyn Surface> {
    if side == Side::Inside { Box::new(Flipped::new(Box::new(surface))) } else { Box::new(surface) }
}

/// ρ² = k z up to z = h: with ρ = R s, z = h s², an exact cubic.
fn paraboloid(apex: DVec3, axis: DVec3, k: f64, h: f64) -> Revolution {
    let (out, rim) = (axis.any_orthonormal_vector(), (k * h).sqrt());
    let point = |rho: f64, z: f64| apex + rho * rim * out + z * h * axis;
    let curve = [point(0.0, 0.0), point(1.0 / 3.0, 0.0), point(2.0 / 3.0, 1.0 / 3.0), point(1.0, 1.0)];
    Revolution::new(curve, apex, axis, FULL_TURN).unwrap()
}
