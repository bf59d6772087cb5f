//! The axis that points upwards: a model whose y points upwards becomes one whose z does.

use std::str::FromStr;

use crate::model::Model;
use crate::xform::Similarity;

/// The axis that points upwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Up {
    /// y: x to the right, z towards the viewer.
    Y,
    /// z, as in scenes of `radiosity`: x to the right, y away from the viewer.
    Z,
}

impl FromStr for Up {
    type Err = String;

    /// An axis by its name, `y` or `z`.
    fn from_str(name: &str) -> Result<Self, String> {
        match name {
            "y" => Ok(Up::Y),
            "z" => Ok(Up::Z),
            _ => Err("expected the axis that points upwards: y or z".to_owned()),
        }
    }
}

impl Up {
    /// Turns a model whose upward axis this is so that z points upwards: of y, (x, y, z) becomes (x, −z, y),
    /// exactly. Fronts stay fronts.
    pub fn to_z(self, model: &mut Model) {
        if self == Up::Z {
            return;
        }
        let turn = Similarity::rotation(0, 90.0);
        model.surfaces.iter_mut().for_each(|surface| surface.shape = turn.shape(&surface.shape));
        if let Some(camera) = &mut model.camera {
            camera.eye = turn.point(camera.eye);
            camera.target = turn.point(camera.target);
            camera.up = turn.direction(camera.up);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Camera, Shape, Sides, Surface};
    use glam::DVec3;

    #[test]
    fn what_points_upwards_along_y_does_along_z() {
        let floor = [DVec3::new(0.1, 0.0, 0.0), DVec3::new(0.1, 0.0, 0.7), DVec3::new(0.3, 0.2, 0.7)];
        let shape = Shape::Polygon { outline: floor.to_vec(), holes: Vec::new() };
        let surface = Surface {
            name: "floor".into(),
            material: None,
            shape,
            sides: Sides::Front,
            file: None,
            place: None,
        };
        let camera = Camera {
            eye: DVec3::new(1.0, 2.0, 3.0),
            target: DVec3::ZERO,
            up: DVec3::Y,
            fov: 40.0,
            size: None,
        };
        let mut model = Model { surfaces: vec![surface], camera: Some(camera), ..Model::default() };
        let before = model.clone();
        Up::Z.to_z(&mut model);
        assert_eq!(model, before);
        Up::Y.to_z(&mut model);
        let outline = vec![DVec3::new(0.1, 0.0, 0.0), DVec3::new(0.1, -0.7, 0.0), DVec3::new(0.3, -0.7, 0.2)];
        assert_eq!(model.surfaces[0].shape, Shape::Polygon { outline, holes: Vec::new() });
        let Some(camera) = model.camera else { panic!("the camera stays") };
        assert_eq!(
            (camera.eye, camera.target, camera.up),
            (DVec3::new(1.0, -3.0, 2.0), DVec3::ZERO, DVec3::Z)
        );
    }
}
