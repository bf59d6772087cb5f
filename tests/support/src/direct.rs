//! Direct light at points.

use radiosity::geom::DVec3;
use radiosity::light::direct::DirectLight;
use radiosity::light::receiver_point::ReceiverPoint;
use radiosity::{Options, Scene};

use crate::sources::Sources;

/// Accuracy of direct light that is not exact, over all emitters' light without blockers: a quarter of the
/// step between two of 256 levels.
pub const ACCURACY: f64 = 1e-3;

/// Direct light of a scene's first band in the open at points, each with the normal of the receiver, to this
/// accuracy.
pub fn in_the_open(scene: &Scene, options: &Options, points: &[(DVec3, DVec3)], eps: f64) -> Vec<f64> {
    let visibility = options.visibility(scene);
    let sources = Sources::of(scene, &visibility);
    let direct = DirectLight::within(&sources.emitters(), &visibility, eps);
    let read = |(x, n): &(DVec3, DVec3)| {
        let point = ReceiverPoint::free(*x, n.normalize());
        direct.irradiance(&point, &direct.around(&point.site()))[0]
    };
    points.iter().map(read).collect()
}
