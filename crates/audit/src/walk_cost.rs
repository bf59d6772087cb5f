//! Cost of a walk: about how many rays a scene asks of it, and how long they take.
//!
//! A walk in a closed scene that absorbs the part α of what arrives has 1/α vertices in the mean, and a ray takes
//! longer by the logarithm of the number of surfaces, as the choice of a lamp at each vertex does by that of lamps.
//! Where α is a fifth or more walks cost alike.

use radiosity_scene::{Condition, Scene, SceneSurface};

/// Walks a second of two threads of a common machine in a box of flat surfaces. Measured: study `referee`.
const WALKS_A_SECOND: f64 = 1.2e6;

/// By how much longer a walk takes where there are twice as many surfaces. Measured: 17 scenes of up to 10 000.
const DEEPER: f64 = 0.125;

/// By how much longer a walk of light takes where there are twice as many lamps. Measured: a box with 1, 10, 100 and
/// 400 point lamps took 6.0, 7.5, 9.9 and 11.5 s of CPU time.
const MORE_LAMPS: f64 = 0.1;

/// Surfaces of a box, with what is in it.
const BOX: f64 = 16.0;

/// Absorbed part from which walks are as short as in the scenes that were measured.
const ABSORBED: f64 = 0.2;

/// Least absorbed part with which walks end before they are caught: the mean has 10⁵ vertices, the most are 2¹⁸.
const LEAST: f64 = 1e-5;

/// Fewest readings that are worth a look. Chosen: fewer have no spread to speak of.
const FEWEST: usize = 4;

/// Seconds that a walk takes two threads, from counts of the scene alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WalkCost {
    seconds: f64,
    /// Whether most walks would be caught before they end.
    is_endless: bool,
}

impl WalkCost {
    /// Of walks of light.
    pub fn of_light(scene: &Scene) -> Self {
        let absorbed = |surface: &SceneSurface| {
            let material = &surface.material;
            let sent = material.reflectance.iter().zip(&material.transmittance);
            1.0 - sent.map(|(reflected, through)| reflected + through).fold(0.0, f64::max)
        };
        let emitting = scene.surfaces.iter().filter(|surface| surface.material.emits()).count();
        let lamps =
            scene.luminaires.iter().filter(|luminaire| !luminaire.extent.is_area()).count() + emitting;
        let own = Self::of(scene, mean_by_area(scene, absorbed));
        Self { seconds: own.seconds * (1.0 + MORE_LAMPS * (lamps.max(1) as f64).log2()), ..own }
    }

    /// Of walks of heat: surfaces of known temperature absorb the part ε.
    pub fn of_heat(scene: &Scene) -> Self {
        let absorbed = |surface: &SceneSurface| match surface.thermal.condition {
            Some(Condition::Temperature(_)) => surface.thermal.emissivity.unwrap_or(1.0),
            _ => 0.0,
        };
        Self::of(scene, mean_by_area(scene, absorbed))
    }

    /// Of single rays.
    pub fn of_view_factors(scene: &Scene) -> Self {
        Self::of(scene, 1.0)
    }

    fn of(scene: &Scene, absorbed: f64) -> Self {
        let surfaces = scene.surfaces.len() as f64;
        let curved = scene.surfaces.iter().filter(|surface| surface.shape.region().is_none()).count();
        let deeper = 1.0 + DEEPER * (surfaces.max(BOX) / BOX).log2();
        let bent = 1.0 + curved as f64 / surfaces;
        let longer = (ABSORBED / absorbed.max(f64::MIN_POSITIVE)).max(1.0);
        Self { seconds: deeper * bent * longer / WALKS_A_SECOND, is_endless: absorbed < LEAST }
    }

    /// Whether walks end before they are caught, for the most part.
    pub fn ends(&self) -> bool {
        !self.is_endless
    }

    /// Walks of so many seconds.
    pub(crate) fn walks(&self, seconds: f64) -> f64 {
        seconds / self.seconds
    }

    /// As many readings as `walks` walks each fit into so many seconds: at most `most`, and four at least; none where
    /// walks do not end.
    pub(crate) fn readings(&self, seconds: f64, walks: usize, most: usize) -> usize {
        if self.is_endless {
            return 0;
        }
        let fit = (self.walks(seconds) / walks as f64) as usize;
        fit.max(FEWEST).min(most)
    }
}

/// Mean of a number of each surface by area.
fn mean_by_area(scene: &Scene, number: impl Fn(&SceneSurface) -> f64) -> f64 {
    let [sum, area] = scene.surfaces.iter().fold([0.0; 2], |[sum, area], surface| {
        let own = surface.shape.area();
        [sum + own * number(surface), area + own]
    });
    sum / area
}

#[cfg(test)]
mod tests {
    use radiosity_geom::DVec3;
    use radiosity_geom::Flipped;
    use radiosity_geom::shapes::{FULL_TURN, Sphere};
    use radiosity_scene::{Material, SceneBuilder};
    use radiosity_work::Work;

    use super::*;
    use crate::effort::Effort;
    use crate::referee::Referee;
    use crate::spot::Spot;

    /// The inside of a sphere that reflects the part `reflectance` and glows.
    fn sphere(reflectance: f64) -> Scene {
        let mut scene = SceneBuilder::new("sphere", ["lm"]);
        let grey = scene.material("grey", Material::new(vec![reflectance], vec![1.0]).unwrap());
        let ball = Sphere::new(DVec3::ZERO, 1.0, DVec3::Z, [-1.0, 1.0], FULL_TURN).unwrap();
        scene.surface("wall", Flipped::new(Box::new(ball)), &grey);
        scene.build().unwrap()
    }

    fn rays_of_a_walk(scene: &Scene) -> f64 {
        let spots = [DVec3::X, DVec3::Y].map(|position| Spot::Point { position, normal: -position });
        let effort = Effort::of_walks(64.0);
        let found = Referee::of_light(scene).estimates(&spots, &effort, &Work::alone());
        found.iter().map(|own| own.rays as f64).sum::<f64>() / (2.0 * effort.walks() as f64)
    }

    #[test]
    fn walks_cost_as_many_rays_as_light_is_reflected() {
        let usual = rays_of_a_walk(&sphere(0.8)) / WalkCost::of_light(&sphere(0.8)).seconds;
        for reflectance in [0.9, 0.99, 0.999] {
            let scene = sphere(reflectance);
            let ratio = rays_of_a_walk(&scene) / WalkCost::of_light(&scene).seconds / usual;
            assert!((0.4..2.5).contains(&ratio), "{reflectance}: {ratio}");
        }
    }

    #[test]
    fn readings_are_fewer_where_light_goes_on_for_long_and_none_where_it_does_so_for_good() {
        let readings = |reflectance| Effort::readings(0.1, 64, &WalkCost::of_light(&sphere(reflectance)));
        assert_eq!([0.5, 0.9999, 0.999_999].map(readings), [64, FEWEST, 0]);
    }
}
