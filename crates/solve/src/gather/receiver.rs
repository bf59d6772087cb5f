//! Receivers of gathered light: points and patches.

use radiosity_elements::measure::WeightedNode;
use radiosity_elements::patch::Patch;
use radiosity_elements::sampling::area_preserving_map::AreaPreservingMap;
use radiosity_light::receiver_point::ReceiverPoint;

/// Where light is read, and its rays start.
#[derive(Debug)]
pub enum Receiver {
    /// Irradiance at a point.
    Point(ReceiverPoint),
    /// The mean over a patch.
    Patch(ReceiverPatch),
}

/// A patch of a surface, over which light is read in the mean.
#[derive(Debug)]
pub struct ReceiverPatch {
    /// Index of the surface.
    pub(super) surface: usize,
    pub(super) patch: Patch,
    area_map: AreaPreservingMap,
}

/// Numbers that choose the middle of a patch, and points near its corners.
const WITNESSES: [[f64; 2]; 5] = [[0.5, 0.5], [0.01, 0.01], [0.99, 0.01], [0.99, 0.99], [0.01, 0.99]];

impl Receiver {
    /// The mean over a patch of the surface of this index.
    pub fn over(surface: usize, patch: &Patch) -> Self {
        let area_map = AreaPreservingMap::of(std::slice::from_ref(patch));
        Self::Patch(ReceiverPatch { surface, patch: patch.clone(), area_map })
    }

    pub(super) fn middle(&self) -> ReceiverPoint {
        self.at([0.5; 2]).0
    }

    /// Points by which it is told what sends light to it: itself, or its middle and points near its corners, some of
    /// which may be behind an emitter.
    pub(super) fn witnesses(&self) -> Vec<ReceiverPoint> {
        match self {
            Self::Point(receiver) => vec![*receiver],
            Self::Patch(_) => WITNESSES.map(|place| self.at(place).0).to_vec(),
        }
    }

    /// The point that two numbers in [0, 1] choose, and its weight.
    pub(super) fn at(&self, place: [f64; 2]) -> (ReceiverPoint, f64) {
        match self {
            Self::Point(receiver) => (*receiver, 1.0),
            Self::Patch(own) => {
                let WeightedNode { node, weight } = own.area_map.point(place);
                (ReceiverPoint::on(own.surface, node.position, node.normal), weight)
            }
        }
    }
}
