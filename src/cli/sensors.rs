//! Where a probe reads: at the points of a file, or on planes.

use radiosity::output::probe::{Probe, ProbeFault};
use radiosity::scene::SensorPlane;

use crate::cli::{
    error::CliError,
    points::{Points, PointsError},
};

/// Points of a file, or planes one after the other.
#[derive(Debug)]
pub(crate) enum Sensors {
    /// The points of a file.
    Points(Points),
    /// The sensors of planes.
    Planes(Vec<SensorPlane>),
}

impl Sensors {
    /// All points, in order.
    pub(crate) fn probes(&self) -> Vec<Probe> {
        match self {
            Self::Points(points) => points.probes.clone(),
            Self::Planes(planes) => planes.iter().flat_map(probes).collect(),
        }
    }

    /// The planes.
    pub(crate) fn planes(&self) -> &[SensorPlane] {
        match self {
            Self::Points(_) => &[],
            Self::Planes(planes) => planes,
        }
    }

    /// The items of each plane, of items for every point.
    pub(crate) fn by_plane<'a, T>(&'a self, items: &'a [T]) -> impl Iterator<Item = OnPlane<'a, T>> {
        let ends = self.planes().iter().scan(0, |end, plane| {
            *end += plane.counts().iter().product::<usize>();
            Some(*end)
        });
        self.planes().iter().zip(ends).map(|(plane, end)| {
            let count: usize = plane.counts().iter().product();
            OnPlane { plane, items: &items[end - count..end] }
        })
    }

    /// The error where the point at `index` cannot be read.
    pub(crate) fn unreadable(&self, index: usize, fault: ProbeFault) -> CliError {
        let cure = "the polynomials are known on surfaces alone, along their normals: choose --read gather"
            .to_owned();
        match self {
            Self::Points(points) => CliError::Points(PointsError {
                origin: points.origin.clone(),
                place: Some(points.lines[index]),
                fault: fault.to_string(),
                cure,
            }),
            Self::Planes(_) => {
                let probes: Vec<(usize, Probe)> = self.probes().into_iter().enumerate().collect();
                let place = |on: OnPlane<(usize, Probe)>| {
                    let [x, y, z] = on.items.iter().find(|(k, _)| *k == index)?.1.position.to_array();
                    Some(format!("plane {:?}: the sensor at ({x:.6}, {y:.6}, {z:.6})", on.plane.name()))
                };
                let place = self.by_plane(&probes).find_map(place).unwrap_or_default();
                CliError::Refused { message: format!("{place}: {fault}"), cure }
            }
        }
    }
}

/// A plane with an item for each of its sensors.
pub(crate) struct OnPlane<'a, T> {
    pub(crate) plane: &'a SensorPlane,
    pub(crate) items: &'a [T],
}

fn probes(plane: &SensorPlane) -> Vec<Probe> {
    let normal = plane.normal();
    plane.sensors().map(|position| Probe { position, normal }).collect()
}
