//! Sensors of a probe: the points of a file, or those of planes.

use radiosity_reading::probe::{Probe, ProbeFault};
use radiosity_scene::SensorPlane;

use crate::{error::CliError, points::Points};

/// Sensors: points of a file, or planes one after the other.
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
            Self::Planes(planes) => planes.iter().flat_map(Probe::of_plane).collect(),
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
        self.planes().iter().scan(0, |next, plane| {
            let first = *next;
            *next += plane.counts().iter().product::<usize>();
            Some(OnPlane { plane, first, items: &items[first..*next] })
        })
    }

    /// The plane of the sensor at `index`; none of a point of a file.
    pub(crate) fn plane_of(&self, index: usize) -> Option<&SensorPlane> {
        let last = self.planes().iter().scan(0, |next, plane| {
            *next += plane.counts().iter().product::<usize>();
            Some((*next, plane))
        });
        last.into_iter().find(|(next, _)| index < *next).map(|(_, plane)| plane)
    }

    /// The error where the point at `index` cannot be read.
    pub(crate) fn unreadable(&self, index: usize, fault: ProbeFault) -> CliError {
        let cure = "the polynomials are known on surfaces alone, along their normals: choose --read gather";
        match self {
            Self::Points(points) => points.error(points.lines[index], fault.to_string(), cure),
            Self::Planes(_) => {
                let name = self.plane_of(index).map_or("", SensorPlane::name);
                let [x, y, z] = self.probes()[index].position.to_array();
                let place = format!("plane {name:?}: the sensor at ({x:.6}, {y:.6}, {z:.6})");
                CliError::refused(format!("{place}: {fault}"), cure)
            }
        }
    }
}

/// A plane with an item for each of its sensors.
pub(crate) struct OnPlane<'a, T> {
    pub(crate) plane: &'a SensorPlane,
    /// Index of its first sensor among those of all planes.
    pub(crate) first: usize,
    pub(crate) items: &'a [T],
}
