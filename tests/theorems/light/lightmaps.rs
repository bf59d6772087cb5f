//! Light textures: constants, values at single points, groups, borders.

use radiosity::Work;
use radiosity::reading::pictures::lightmap::Lightmap;
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::scene::Scene;
use radiosity::solve::Options;
use radiosity::solve::gather::gather_method::GatherMethod;
use radiosity::solve::solution::SurfacePlace;
use radiosity::solve::solved::Solved;
use radiosity_test_support::scenes::{builtin, typed};
use radiosity_test_support::solved::solved_of;

use super::groups::{LAMPS, room};

/// One of so many texels is compared: gathering takes some milliseconds for each.
const COMPARED: usize = 5;

fn solved(scene: Scene) -> Solved {
    solved_of(scene, Options::default())
}

fn lightmap(solved: &Solved, texels: usize) -> Lightmap {
    Lightmap::new(solved, ReadMode::Gather, texels, &Work::alone())
}

/// A closed room in which everything emits 1 and reflects ½, bodies on its floor, a sheet on a wall and a
/// ceiling of two parts included: 2 arrives everywhere, and so at every texel, those that borrow their light
/// included.
#[test]
fn a_furnace_has_light_two_at_every_texel() {
    let face =
        |name: &str, shape: &str| format!("[[surfaces]]\nname = \"{name}\"\nmaterial = \"glow\"\n{shape}\n");
    let faces = [
        face("floor", "quad = { vertices = [[0,0,0],[1,0,0],[1,1,0],[0,1,0]] }"),
        face("south", "quad = { vertices = [[0,0,0],[0,0,1],[1,0,1],[1,0,0]] }"),
        face("north", "quad = { vertices = [[0,1,0],[1,1,0],[1,1,1],[0,1,1]] }"),
        face("west", "quad = { vertices = [[0,0,0],[0,1,0],[0,1,1],[0,0,1]] }"),
        face("east", "quad = { vertices = [[1,0,0],[1,0,1],[1,1,1],[1,1,0]] }"),
        face("corner", "triangle = { vertices = [[0,0,1],[0,1,1],[1,0,1]] }"),
        face("ceiling", "polygon = { vertices = [[0,1,1],[1,1,1],[1,0,1]] }"),
        face("block", "box = { origin = [0.3,0.33,0], size = [0.3,0.17,0.4] }"),
        face("sheet", "quad = { vertices = [[0.2,1,0.2],[0.4,1,0.2],[0.4,1,0.5],[0.2,1,0.5]] }"),
    ];
    let text =
        format!("bands = [\"grey\"]\n[materials.glow]\nreflectance = 0.5\nemission = 1\n{}", faces.concat());
    let solved = solved(typed(&text));
    let lightmap = lightmap(&solved, 20_000);
    for (texture, surface) in lightmap.surfaces().iter().zip(&solved.scene.surfaces) {
        if surface.name == "block-bottom" {
            continue;
        }
        for value in texture.texels(0, 0) {
            assert!((value - 2.0).abs() < 0.02, "{}: {value}", surface.name);
        }
    }
}

/// Greatest and root-mean-square difference of texels from light gathered at their centres, relative to its
/// mean; light at the very borders, where it may jump, left out. The texels' parts are added with `factors`.
fn difference(solved: &Solved, lightmap: &Lightmap, factors: &[f64]) -> f64 {
    let solution = &solved.outcome.solution;
    let reader = Reader::new(solution, solved.visibility(), ReadMode::Gather, 1e-3);
    let (mut squares, mut sums, mut count) = (0.0, 0.0, 0);
    for (surface, texture) in lightmap.surfaces().iter().enumerate() {
        let [columns, rows] = texture.size();
        let inside = (1..rows - 1).flat_map(|j| (1..columns - 1).map(move |i| [i, j]));
        for texel in inside.filter(|texel| texture.is_computed(*texel)).step_by(COMPARED) {
            let parameters = texture.parameters(texel);
            let shape = solution.elements().shape(surface);
            let jet = shape.jet(parameters[0], parameters[1]);
            if shape.region().is_some_and(|region| !region.contains(jet.position)) {
                continue;
            }
            let Some(element) = solution.elements().at(surface, parameters) else { continue };
            let place = SurfacePlace { surface, parameters, position: jet.position };
            let exact = reader.irradiance(element, &place, jet.normal).irradiance;
            for (band, exact) in exact.into_iter().enumerate() {
                let parts = factors.iter().enumerate();
                let sum: f64 = parts.map(|(part, f)| f * texture.at(part, band, parameters)).sum();
                squares += (sum - exact).powi(2);
                sums += exact;
                count += 1;
            }
        }
    }
    assert!(count > 500, "{count} texels were compared");
    (squares / f64::from(count)).sqrt() / (sums / f64::from(count))
}

#[test]
fn texels_hold_the_light_that_is_gathered_at_their_centres() {
    let solved = solved(builtin("cornell-box"));
    let rms = difference(&solved, &lightmap(&solved, 4000), &[1.0]);
    assert!(rms < 1e-2, "{rms}");
}

/// Where a block stands on the floor its dark side sees nothing but the edge of the block's shadow, which polynomials
/// do not follow: texels there hold the light that walks find. With polynomials they are 13 % too bright.
#[test]
fn texels_at_the_foot_of_a_block_hold_the_light_there() {
    let solved = solved(builtin("cornell-box"));
    let lightmap = lightmap(&solved, 3000);
    let solution = &solved.outcome.solution;
    let walks = Reader::by(GatherMethod::Walks, solution, solved.visibility(), ReadMode::Gather, 5e-3);
    let surface = solved.scene.surface_named("short_block_side2").expect("it is there");
    let (texture, shape) = (&lightmap.surfaces()[surface], solution.elements().shape(surface));
    let mean: f64 = solution.mean_arriving().iter().sum();
    let rows = texture.size()[1];
    let errors = (1..rows - 1).map(|j| {
        let [_, v] = texture.parameters([0, j]);
        let parameters = [-1.0 + 1e-3, v];
        let jet = shape.jet(parameters[0], parameters[1]);
        let place = SurfacePlace { surface, parameters, position: jet.position };
        let element = solution.elements().at(surface, parameters).expect("nothing lies there");
        let right: f64 = walks.irradiance(element, &place, jet.normal).irradiance.iter().sum();
        let found: f64 = (0..solution.bands().len()).map(|band| texture.at(0, band, parameters)).sum();
        (found - right) / (right * right.max(mean)).sqrt()
    });
    let errors: Vec<f64> = errors.collect();
    let rms = (errors.iter().map(|error| error * error).sum::<f64>() / errors.len() as f64).sqrt();
    assert!(errors.len() >= 5 && rms < 0.04, "{rms}: {errors:?}");
}

#[test]
fn groups_add_up_to_the_light_at_their_factors() {
    let solved = solved(room([1.0; LAMPS]));
    let settings = [("lamp0", 0.3), ("lamp2", 2.0)];
    let dimmed = solved.relight(&settings).expect("two groups");
    let lightmap = lightmap(&dimmed, 3000);
    let parts: Vec<(Option<&str>, f64)> =
        lightmap.parts().iter().map(|part| (part.group.as_deref(), part.factor)).collect();
    for part in [(Some("lamp0"), 0.3), (Some("lamp1"), 1.0), (Some("lamp2"), 2.0), (None, 1.0)] {
        assert!(parts.contains(&part), "{parts:?}");
    }
    let factors: Vec<f64> = parts.iter().map(|(_, factor)| *factor).collect();
    let rms = difference(&dimmed, &lightmap, &factors);
    assert!(rms < 1e-2, "{rms}");
}

#[test]
fn textures_do_not_depend_on_the_number_of_threads() {
    let solved = solved(room([1.0; LAMPS]));
    let by = |threads: usize| {
        radiosity::solve::in_threads(threads, || lightmap(&solved, 500)).expect("threads can be had")
    };
    assert_eq!(by(1), by(3));
}
