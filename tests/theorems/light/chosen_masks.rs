//! Shadow masks of pairs that the scene chooses, of emitters that only reflect, and on curved receivers.

use radiosity::Work;
use radiosity::published::zatz1993::masking::Masking;
use radiosity::reading::files::solution_file::{SolutionFile, read};
use radiosity::reading::grid::{Cell, Rates, grid};
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::reading::report::Report;
use radiosity::scene::{MaskedPairDraft, Material, Notation, Scene, SceneBuilder, Source};
use radiosity::solve::solution::{Solution, SurfacePlace};
use radiosity::solve::solved::Solved;
use radiosity::solve::{Direct, Failure, Options, solve};
use radiosity_geom::DVec3;
use radiosity_geom::shapes::Parallelogram;
use radiosity_test_support::scenes::{builtin, typed};
use radiosity_test_support::solved::{outcome_of, sealed, solved_of};

fn masked() -> Options {
    Options { order: 6, subdivide: Some(1), masks: Some(Masking::default()), ..Options::default() }
}

fn unmasked() -> Options {
    Options { masks: None, direct: Direct::Split, ..masked() }
}

/// Means over 12 × 12 cells.
fn means(scene: &Scene, solution: &Solution, read: ReadMode) -> Vec<Cell> {
    let visibility = Options::default().visibility(scene);
    let reader = Reader::new(solution, &visibility, read, 1e-3);
    grid(&reader, [12, 12], Rates::default(), &Work::alone())
}

/// Relative L2 difference of the irradiance over a surface.
fn difference(scene: &Scene, name: &str, ours: &[Cell], exact: &[Cell]) -> f64 {
    let surface = scene.surface_named(name).expect("it is there");
    let both = || ours.iter().zip(exact).filter(|(cell, _)| cell.surface == surface);
    let sum = |term: &dyn Fn(&Cell, &Cell) -> f64| both().map(|(a, b)| a.area * term(a, b)).sum::<f64>();
    let error = sum(&|a, b| (a.irradiance[0] - b.irradiance[0]).powi(2));
    (error / sum(&|_, b| b.irradiance[0].powi(2))).sqrt()
}

fn rectangle(origin: [f64; 3], first: [f64; 3], second: [f64; 3]) -> Parallelogram {
    let [origin, first, second] = [origin, first, second].map(DVec3::from_array);
    Parallelogram::new(origin, first, second).expect("two directions")
}

/// A lamp in the floor lights a white plate above; the plate's light falls back past a black panel, if it is
/// there. Nothing else reflects it much.
fn reflector(panel: bool, pairs: &[[&str; 2]]) -> Scene {
    let mut scene = SceneBuilder::new("reflector", ["grey"]);
    let material =
        |reflectance, emission| Material::new(vec![reflectance], vec![emission]).expect("a material");
    let dark = scene.material("dark", material(0.3, 0.0));
    let white = scene.material("white", material(0.9, 0.0));
    let black = scene.material("black", material(0.0, 0.0));
    let lamp = scene.material("lamp", material(0.0, 10.0));
    scene.surface("floor", rectangle([0.2, 0.0, 0.0], [0.8, 0.0, 0.0], [0.0, 1.0, 0.0]), &dark);
    scene.surface("lamp", rectangle([0.0, 0.4, 0.0], [0.16, 0.0, 0.0], [0.0, 0.2, 0.0]), &lamp);
    scene.surface("plate", rectangle([0.35, 0.35, 1.0], [0.0, 0.3, 0.0], [0.3, 0.0, 0.0]), &white);
    if panel {
        let shape = rectangle([0.45, 0.3, 0.4], [0.25, 0.0, 0.0], [0.0, 0.4, 0.0]);
        scene.surface("panel", shape, &black).two_sided();
    }
    for [emitter, receiver] in pairs {
        scene.masks(MaskedPairDraft::new(*emitter, *receiver));
    }
    scene.build().expect("a scene")
}

/// The light of a surface that only reflects casts a shadow: by polynomials alone it rings, through a mask of
/// that pair it keeps its edge.
#[test]
fn reflected_light_goes_through_a_chosen_mask() {
    let plain = reflector(true, &[]);
    let exact = means(&plain, &outcome_of(&plain, &unmasked()).solution, ReadMode::GatherTwice);
    let ringing = means(&plain, &outcome_of(&plain, &unmasked()).solution, ReadMode::Basis);
    let chosen = reflector(true, &[["plate", "floor"]]);
    let through = means(&chosen, &outcome_of(&chosen, &masked()).solution, ReadMode::Basis);
    let [ringing, through] = [&ringing, &through].map(|own| difference(&plain, "floor", own, &exact));
    // The plate is not evenly bright, which masks take it for.
    assert!(ringing > 0.05 && through < 0.5 * ringing, "{ringing} {through}");
}

/// Whether a panel at a height of 0.4 lets light through between a point of the floor and one of the plate.
fn passes(x: DVec3, y: DVec3) -> bool {
    let at = x + 0.4 * (y - x);
    !((0.45..0.7).contains(&at.x) && (0.3..0.7).contains(&at.y))
}

/// The floor, which the plate alone lights, gets what eq. 29 says of the plate's radiosity B in the solution:
/// the mask ∫ κ V dA / ∫ κ dA times ∫ κ B dA, both summed over small cells.
#[test]
fn reflected_light_is_that_of_equation_29() {
    let scene = reflector(true, &[["plate", "floor"]]);
    let solution = outcome_of(&scene, &masked()).solution;
    let element =
        |name| solution.elements().of_surface(scene.surface_named(name).expect("it is there")).start;
    let (floor, plate) = (element("floor"), element("plate"));
    let place = |element: usize, position: DVec3| SurfacePlace {
        surface: solution.elements().list()[element].surface,
        parameters: [0.0; 2],
        position,
    };
    let side = 60;
    let cells = (0..side * side).map(|k| {
        let [a, b] = [k / side, k % side].map(|k| 0.35 + 0.3 * (f64::from(k) + 0.5) / f64::from(side));
        DVec3::new(a, b, 1.0)
    });
    let cells: Vec<(DVec3, f64)> =
        cells.map(|y| (y, solution.radiosity(0, plate, &place(plate, y)))).collect();
    let cell = (0.3 / f64::from(side)).powi(2);
    for (i, j) in (1..8).flat_map(|i| (1..8).map(move |j| (i, j))) {
        let x = DVec3::new(0.2 + 0.1 * f64::from(i), 0.125 * f64::from(j), 0.0);
        let (mut open, mut seen, mut light) = (0.0, 0.0, 0.0);
        for (y, radiosity) in &cells {
            // Both cosines are the height, 1, over the distance.
            let kernel = cell / (std::f64::consts::PI * (*y - x).length_squared().powi(2));
            open += kernel;
            seen += if passes(x, *y) { kernel } else { 0.0 };
            light += kernel * radiosity;
        }
        let expected = seen / open * light;
        let found = solution.irradiance(0, floor, &place(floor, x));
        assert!((found - expected).abs() < 0.03 * light, "{x}: {found}, {expected} of {light}");
    }
}

/// Without obstacles the mask is 1 and the light of eq. 29 is that of the unmasked system.
#[test]
fn masks_change_nothing_where_nothing_stands_between() {
    let plain = reflector(false, &[]);
    let chosen = reflector(false, &[["plate", "floor"], ["floor", "plate"]]);
    let [ours, exact] = [(&chosen, masked()), (&plain, unmasked())]
        .map(|(scene, options)| means(scene, &outcome_of(scene, &options).solution, ReadMode::Basis));
    for surface in ["floor", "plate", "lamp"] {
        let difference = difference(&plain, surface, &ours, &exact);
        assert!(difference < 2e-3, "{surface}: {difference}");
    }
}

/// Pairs that are chosen are masked, and no others, each with its own cells; they are listed.
#[test]
fn chosen_pairs_are_the_only_ones() {
    let scene = builtin("two-boxes");
    let text = scene.source.as_ref().expect("it has a text").text().into_owned();
    let text = text + "\n[[masks]]\nemitter = \"lamp\"\nreceiver = \"fl*\"\ncells = 7\n";
    let scene = radiosity::language::read(&Source::new("two.toml", &text)).expect("a scene");
    let solved = solved_of(scene, Options { order: 2, ..masked() });
    let masks = Report::new(&solved, 1).masks;
    let [only] = &masks[..] else { panic!("{masks:?}") };
    assert_eq!(
        (only.emitter.as_str(), only.receiver.as_str(), only.cells, only.chosen),
        ("lamp", "floor", 7, true)
    );
    // Two boxes of 1 and 0.81 m² stand on 16 m² of floor: their shadows take some of the light, not most.
    assert!((0.5..0.95).contains(&only.mean), "{}", only.mean);
}

/// A pair that no light goes between is refused with its names.
#[test]
fn pairs_without_light_are_refused() {
    for (pair, why) in [(["panel", "floor"], "sends no light"), (["lamp", "floor"], "do not see each other")]
    {
        let refused = solve(&reflector(true, &[pair]), &masked(), &Work::alone());
        let failure = refused.expect_err("it is refused");
        assert!(matches!(failure, Failure::NoMask { .. }), "{failure}");
        let message = failure.to_string();
        assert!(message.contains(why) && message.contains(pair[0]), "{message}");
    }
}

/// Masks of one cell in a closed room that reflects nearly all light: each solution is brighter than the one
/// before, and none is told as the light.
#[test]
fn light_that_does_not_settle_is_refused() {
    let scene = typed(
        r#"
        materials.white = { reflectance = 0.99 }
        materials.lamp = { reflectance = 0.99, emission = 100 }
        surfaces = [
            { name = "box", material = "white", box = { origin = [-0.5, -0.5, 0.8], size = [1, 1, 0.4] } },
            { name = "room", material = "white", box = { origin = [-2, -2, 0], size = [4, 4, 3], inward = true } },
            { name = "lamp", material = "lamp", box = { origin = [-0.3, -0.3, 2], size = [0.6, 0.6, 0.2] } },
        ]
        masks = [{ emitter = "*", receiver = "*", cells = 1 }]
        "#,
    );
    let refused = solve(&scene, &Options { order: 0, subdivide: None, ..masked() }, &Work::alone());
    assert!(matches!(refused, Err(Failure::MasksUnsettled { .. })));
}

/// Faults of a pair are told with their place and a cure; pairs without fault are written again.
#[test]
fn pairs_are_read_with_their_places() {
    let room = builtin("occluder-box").source.expect("it has a text").text().into_owned();
    let with = |pair: &str| {
        radiosity::language::read(&Source::new("box.toml", &format!("{room}\n[[masks]]\n{pair}")))
    };
    for (pair, cause, cure) in [
        (
            "emitter = \"lam\"\nreceiver = \"floor\"",
            "mask 1: unknown surface \"lam\"",
            "did you mean \"lamp\"",
        ),
        ("emitter = \"lamp\"\nreceiver = \"lamp\"", "the emitter and the receiver", "name two surfaces"),
        ("emitter = \"lamp\"\nreceiver = \"floor\"\ncells = 0", "outside 1 ≤ cells ≤ 1000", "choose a value"),
        ("emitter = \"lamp\"", "the key \"receiver\" is missing", "add `receiver"),
    ] {
        let error = with(pair).expect_err("it is refused");
        assert!(error.place.is_some() && error.to_string().contains(cause), "{error}");
        assert!(error.cure().is_some_and(|own| own.contains(cure)), "{:?}", error.cure());
    }
    let scene = with("emitter = \"lamp\"\nreceiver = \"wall*\"\ncells = 9").expect("it is right");
    let text = radiosity::language::text(&scene, Notation::Toml).expect("it is written");
    let again = typed(&text);
    assert_eq!(again.masks, scene.masks);
    assert_eq!((scene.masks[0].receivers.len(), scene.masks[0].cells.map(|own| own.get())), (4, Some(9)));
}

/// A solution file holds its masks: what is read from it is the same light.
#[test]
fn masks_are_kept_with_the_solution() {
    let scene = builtin("occluder-box");
    let solved = solved_of(scene, Options { order: 2, ..masked() });
    let file = serde_json::to_value(SolutionFile::new(&solved)).expect("a file");
    let again = read(&Source::new("a.json", &file.to_string())).expect("it is read");
    let light = |solved: &Solved| -> Vec<f64> {
        let cells = means(&solved.scene, &solved.outcome.solution, ReadMode::Basis);
        cells.into_iter().flat_map(|cell| cell.irradiance).collect()
    };
    assert_eq!(light(&again), light(&solved));
    let mut older = file;
    older.as_object_mut().expect("a table").remove("masked");
    let refused =
        read(&Source::new("a.json", &sealed(&older.to_string()))).expect_err("its masks are missing");
    assert!(refused.to_string().contains("does not hold its shadow masks"), "{refused}");
    assert!(refused.cure().contains("solve the scene again"));
}

/// A ball under a lamp: its own horizon ends the light, which no polynomial follows. The mask holds the
/// cosine.
#[test]
fn masks_follow_the_horizon_of_a_ball() {
    let scene = typed(
        r#"
        materials.grey = { reflectance = 0.5 }
        materials.lamp = { reflectance = 0, emission = 10 }
        [[surfaces]]
        name = "lamp"
        material = "lamp"
        disk = { center = [0, 0, 2], normal = [0, 0, -1], radius = 0.2 }
        [[surfaces]]
        name = "ball"
        material = "grey"
        sphere = { center = [0, 0, 0], radius = 0.5 }
        "#,
    );
    let options = Options { order: 4, ..masked() };
    let exact = means(&scene, &outcome_of(&scene, &options).solution, ReadMode::Gather);
    let [plain, masked] = [Options { masks: None, direct: Direct::Projected, ..options }, options]
        .map(|options| means(&scene, &outcome_of(&scene, &options).solution, ReadMode::Basis))
        .map(|cells| difference(&scene, "ball", &cells, &exact));
    assert!(masked < 0.25 * plain && masked < 0.03, "{masked} {plain}");
}
