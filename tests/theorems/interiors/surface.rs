//! Surfaces with names, as text of a scene.

use radiosity_geom::DVec3;

/// The shape of a surface (metres).
#[derive(Clone, Debug)]
pub(crate) enum Shape {
    Polygon(Vec<DVec3>),
    Sphere {
        center: DVec3,
        radius: f64,
    },
    /// A cylinder without its ends.
    Pipe {
        base: DVec3,
        axis: DVec3,
        radius: f64,
    },
    Disk {
        center: DVec3,
        normal: DVec3,
        radius: f64,
    },
}

/// A surface, its front in the air of the room.
#[derive(Clone, Debug)]
pub(crate) struct Surface {
    pub(crate) name: String,
    pub(crate) shape: Shape,
}

impl Surface {
    pub(crate) fn polygon(name: impl Into<String>, corners: Vec<DVec3>) -> Self {
        Self { name: name.into(), shape: Shape::Polygon(corners) }
    }

    /// The surface with all its points moved; `turn` moves directions.
    pub(crate) fn moved(&self, place: impl Fn(DVec3) -> DVec3, turn: impl Fn(DVec3) -> DVec3) -> Self {
        let shape = match &self.shape {
            Shape::Polygon(corners) => Shape::Polygon(corners.iter().map(|x| place(*x)).collect()),
            Shape::Sphere { center, radius } => Shape::Sphere { center: place(*center), radius: *radius },
            Shape::Pipe { base, axis, radius } => {
                Shape::Pipe { base: place(*base), axis: turn(*axis), radius: *radius }
            }
            Shape::Disk { center, normal, radius } => {
                Shape::Disk { center: place(*center), normal: turn(*normal), radius: *radius }
            }
        };
        Self { name: self.name.clone(), shape }
    }

    /// The surface as a table of a scene file.
    pub(crate) fn text(&self) -> String {
        let shape = match &self.shape {
            Shape::Polygon(corners) => {
                let corners: Vec<[f64; 3]> = corners.iter().map(|x| x.to_array()).collect();
                format!("polygon = {{ vertices = {corners:?} }}")
            }
            Shape::Sphere { center, radius } => {
                format!("sphere = {{ center = {:?}, radius = {radius:?} }}", center.to_array())
            }
            Shape::Pipe { base, axis, radius } => {
                let (base, axis) = (base.to_array(), axis.to_array());
                format!("cylinder = {{ base = {base:?}, axis = {axis:?}, radius = {radius:?} }}")
            }
            Shape::Disk { center, normal, radius } => {
                let (center, normal) = (center.to_array(), normal.to_array());
                format!("disk = {{ center = {center:?}, normal = {normal:?}, radius = {radius:?} }}")
            }
        };
        format!("[[surfaces]]\nname = '{}'\nmaterial = 'white'\n{shape}\n", self.name)
    }
}
