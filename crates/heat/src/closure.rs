//! The closure of transfers: in a closed scene each row sums to 1.
//!
//! All that leaves an element i of a closed region arrives somewhere, and what two elements exchange is the
//! same both ways:
//!
//! ```text
//! Σ_j G_ij c_j = c_i ,     G_ji = G_ijᵀ ,     c_i the coefficients of the constant 1 on element i .
//! ```
//!
//! Blocks by quadrature or by rays keep the second exactly, the first to their accuracy. They are moved until
//! they keep both ([`correction`]), so that no heat is made or lost. Some view factors follow from the two
//! alone: those of a body without hollows in a ball, F₁₂ = 1, F₂₁ = A₁/A₂ and F₂₂ = 1 − A₁/A₂, are exact
//! then, however roughly they were found ([`pairs`]).
//!
//! Whether a region is closed is read off the borders of its surfaces ([`Regions`]), not off the transfers.
//! Where these say otherwise by more than they may err, or it is open, rows of constants are made to sum to 1 at the
//! most ([`bound_rows`]): light of surfaces of known flux would grow without end where more arrives than is sent. Those
//! of rays of whole elements keep their noise, which has no sign.

mod pairs;
mod correction;

use radiosity_elements::Elements;
use radiosity_kernel::Blocks;
use radiosity_kernel::blocks::bounded_rows::bound_rows;
use radiosity_scene::Scene;
use radiosity_solve::{Model, Options};
use radiosity_visibility::inspection::Regions;

use correction::{Deficit, corrected};
use pairs::Pairs;

/// Largest distance of a row sum from 1, over the error of the transfers, that is theirs and not that of the
/// scene: what is told of errors may be too small by some factor. With a larger value gaps of a scene would
/// be corrected away.
const TRUSTED: f64 = 10.0;

/// Accuracy of the transfers between the elements of a scene.
#[derive(Clone, Debug)]
pub(super) struct Closure {
    /// Largest distance of a row sum from 1 before the rows were made to sum to 1; None where they were left
    /// as they were.
    pub(super) moved: Option<f64>,
    /// By how much the mean row sum of each surface was above 1 before it was bounded; none where rows were left as
    /// they were or sum to 1.
    pub(super) excess: Vec<f64>,
    /// Whether all exchanges are exact: elements carry constants, and what is not integrated exactly follows
    /// from sums.
    pub(super) is_exact: bool,
}

/// The model with rows that sum to 1 where its `scene` is closed.
pub(super) fn close(scene: &Scene, model: Model, options: &Options) -> (Model, Closure) {
    let regions = if may_be_moved(&model) { Regions::of(scene) } else { None };
    let elements = model.elements();
    let is_closed = |surface: usize| regions.as_ref().is_some_and(|regions| regions.is_closed(surface));
    let rows: Vec<bool> = elements.list().iter().map(|element| is_closed(element.surface)).collect();
    let moved = Deficit::of(elements, model.blocks(), &rows).largest(elements);
    let told = options.eps.max(options.shadow_eps).max(model.blocks().statistics.accuracy_reached);
    let is_trusted = rows.contains(&true) && moved <= TRUSTED * told;
    let pairs = Pairs::of(&model, regions.as_ref());
    let are_constants = elements.list().iter().all(|element| element.basis.len() == 1);
    let is_exact = are_constants && (pairs.are_exact() || (is_trusted && pairs.follow_from(&rows)));
    if is_trusted {
        let model = model.with_corrected(|elements, blocks| corrected(elements, blocks, &pairs, &rows));
        return (model, Closure { moved: Some(moved), excess: Vec::new(), is_exact });
    }
    let mut excess = Vec::new();
    let bounded = |elements: &Elements, mut blocks: Blocks| {
        if are_constants && !blocks.is_by_rays() {
            excess = of_surfaces(elements, &bound_rows(&mut blocks, &elements.constant()));
        }
        blocks
    };
    (model.with_corrected(bounded), Closure { moved: None, excess, is_exact })
}

/// Means over surfaces of what is known of their elements; 0 of surfaces without any.
fn of_surfaces(elements: &Elements, known: &[f64]) -> Vec<f64> {
    let list = elements.list();
    let mean = |surface: usize| {
        let own = elements.of_surface(surface);
        let area: f64 = list[own.clone()].iter().map(|element| element.area).sum();
        let sum: f64 =
            list[own.clone()].iter().zip(&known[own]).map(|(element, known)| element.area * known).sum();
        if area > 0.0 { sum / area } else { 0.0 }
    };
    (0..elements.surfaces()).map(mean).collect()
}

/// Whether rows may be moved: rays that carried all pairs have closed theirs themselves, and elements that
/// lie on each other see each other alone.
fn may_be_moved(model: &Model) -> bool {
    !model.blocks().is_by_rays() && model.elements().list().iter().all(|element| element.contact.is_none())
}

#[cfg(test)]
mod tests {
    use radiosity_geom::DVec3;
    use radiosity_geom::shapes::Parallelogram;
    use radiosity_scene::{Material, SceneBuilder};
    use radiosity_work::Work;

    use super::*;

    /// Five walls of a cube, whose transfers between constants are all too large.
    fn open_box(factor: f64) -> (Scene, Model, Options) {
        let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
        let walls = [
            ("floor", DVec3::ZERO, x, y),
            ("west", DVec3::ZERO, y, z),
            ("east", x, z, y),
            ("south", DVec3::ZERO, z, x),
            ("north", y, x, z),
        ];
        let mut open = SceneBuilder::new("box", ["heat"]);
        let grey = open.material("grey", Material::new(vec![0.5], vec![1.0]).expect("a material"));
        for (name, origin, a, b) in walls {
            open.surface(name, Parallelogram::new(origin, a, b).expect("a wall"), &grey);
        }
        let scene = open.build().expect("a scene");
        let options = Options { order: 0, ..Options::default() };
        let model = Model::assemble(&scene, &options, &Work::alone()).expect("a model");
        let larger = model.with_corrected(|_, mut blocks| {
            blocks.change(|_, _, values| values[0] *= factor);
            blocks
        });
        (scene, larger, options)
    }

    fn row_sums(model: &Model) -> Vec<f64> {
        let ones = model.elements().constant();
        model.blocks().apply(&ones).iter().zip(&ones).map(|(arrived, one)| arrived / one).collect()
    }

    #[test]
    fn no_more_arrives_in_an_open_scene_than_is_sent() {
        let (scene, model, options) = open_box(1.4);
        assert!(row_sums(&model).iter().any(|sum| *sum > 1.1));
        let (model, closure) = close(&scene, model, &options);
        let sums = row_sums(&model);
        assert!(sums.iter().all(|sum| *sum <= 1.0 + 1e-13), "{sums:?}");
        // The floor of a cube sees each of its four walls with the factor 0.200044.
        let above = 1.4 * 4.0 * 0.200_043_8 - 1.0;
        assert!((closure.excess[0] - above).abs() < 1e-3 && closure.moved.is_none(), "{closure:?}");
    }

    #[test]
    fn rows_of_an_open_scene_below_one_stay_as_they_are() {
        let (scene, model, options) = open_box(1.0);
        let before = row_sums(&model);
        let (model, closure) = close(&scene, model, &options);
        assert_eq!((row_sums(&model), closure.excess), (before, vec![0.0; 5]));
    }
}
