//! The measured Cornell box against path-traced cell means (tests/data/cornell_reference.json).
//!
//! The polynomials alone are judged first: no basis of this kind can follow the shadow edges, and the bounds
//! are what a best fit of the reference itself leaves (2.2 % on the back wall at order 8, 1.4 % on the floor
//! in 4 × 4 at order 4) with room for quadrature. Gathered light follows the shadows: the reference's own
//! noise is 0.14 % there.

#![expect(clippy::print_stdout, reason = "the figures are worth a line in the log")]

use radiosity::Work;
use radiosity::reading::grid::{Cell, Rates, grid};
use radiosity::reading::quality::Quality;
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::solve::Options;
use radiosity::visibility::Visibility;
use radiosity_test_support::data;
use radiosity_test_support::scenes::builtin;
use radiosity_test_support::solved::outcome_of;

/// Emission of the scene file over unit exitance, per band: π × the published values.
const PUBLISHED: [f64; 3] = [16.16, 11.04, 4.8];

fn cells(order: usize, subdivide: usize, surface: &str) -> Vec<Cell> {
    let mut scene = builtin("cornell-box");
    let index = scene.surfaces.iter().position(|s| s.name == surface).expect("the surface is there");
    scene.surfaces[index].subdivide = Some([subdivide; 2]);
    let options = Options { order, subdivide: Some(1), threads: 2, ..Options::default() };
    let outcome = outcome_of(&scene, &options);
    let visibility = Visibility::open(&scene);
    let reader = Reader::new(&outcome.solution, &visibility, ReadMode::Basis, 1e-3);
    let all = grid(&reader, [16, 16], Rates::default(), &Work::alone());
    all.into_iter().filter(|cell| cell.surface == index).collect()
}

/// Area-weighted relative L2 difference per band, %.
fn errors(surface: &str, cells: &[Cell]) -> [f64; 3] {
    sums(surface, cells).map(|[difference, norm]| 100.0 * (difference / norm).sqrt())
}

/// Per band, sums over the cells of area × squared difference and of area × squared reference.
fn sums(surface: &str, cells: &[Cell]) -> [[f64; 2]; 3] {
    let reference = data::table("cornell_reference.json");
    let table = &reference["faces"][surface]["irradiance"];
    std::array::from_fn(|band| {
        let (mut difference, mut norm) = (0.0, 0.0);
        for cell in cells {
            let [i, j] = cell.index;
            let exact = table[i][j][band].as_f64().expect("a number");
            let ours = cell.irradiance[band] / (std::f64::consts::PI * PUBLISHED[band]);
            difference += cell.area * (ours - exact).powi(2);
            norm += cell.area * exact * exact;
        }
        [difference, norm]
    })
}

/// All bands within `least` and `most` %: less than the best fit leaves is as wrong as more.
fn assert_between(surface: &str, order: usize, subdivide: usize, [least, most]: [f64; 2]) {
    let cells = cells(order, subdivide, surface);
    assert_eq!(cells.len(), 256);
    let errors = errors(surface, &cells);
    println!("{surface}, order {order}, subdivide {subdivide}: {errors:.3?} %");
    assert!(errors.iter().all(|error| (least..=most).contains(error)), "{surface}: {errors:?} %");
}

#[test]
fn back_wall_at_order_8() {
    assert_between("back_wall", 8, 1, [2.0, 3.0]);
}

#[test]
fn floor_in_sixteen_parts_at_order_4() {
    assert_between("floor", 4, 4, [1.2, 2.0]);
}

#[test]
fn undivided_floor_at_order_8_is_limited_by_its_shadows() {
    assert_between("floor", 8, 1, [5.0, 9.0]);
}

/// Floor and back wall, all bands: a draft, and what most need.
#[test]
fn gathered_light_follows_the_shadows() {
    for (quality, bound) in [(Quality::Quick, 0.42), (Quality::Default, 0.25)] {
        let error = gathered(quality);
        println!("floor and back wall, {quality:?}: {error:.3} %");
        assert!(error <= bound, "{quality:?}: {error} %");
    }
}

/// Area-weighted relative L2 difference of floor and back wall, all bands together, %.
fn gathered(quality: Quality) -> f64 {
    let scene = builtin("cornell-box");
    let options = quality.options();
    let outcome = outcome_of(&scene, &options);
    let visibility = options.visibility(&scene);
    let reading = quality.reading();
    let reader = Reader::new(&outcome.solution, &visibility, reading.read, reading.eps);
    let all = grid(&reader, [16, 16], reading.rates, &Work::alone());
    let of = |name: &str| -> [[f64; 2]; 3] {
        let index = scene.surfaces.iter().position(|s| s.name == name).expect("the surface is there");
        sums(name, &all.iter().filter(|cell| cell.surface == index).cloned().collect::<Vec<_>>())
    };
    let parts = [of("floor"), of("back_wall")].concat();
    let [difference, norm] = parts.iter().fold([0.0, 0.0], |sum, part| [sum[0] + part[0], sum[1] + part[1]]);
    100.0 * (difference / norm).sqrt()
}
