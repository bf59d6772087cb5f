//! Ranks change no bit: what one process computes, any number of ranks computes, each of them.

use std::path::Path;
use std::time::Instant;

use radiosity::geom::DVec3;
use radiosity::kernel::Accuracy;
use radiosity::reading::checkpoint::Checkpoint;
use radiosity::solve::animation::sequence::Sequence;
use radiosity::solve::studies::adaptation::{Aim, Goal};
use radiosity::solve::view_factors;
use radiosity::solve::{Direct, Transport};
use radiosity::visibility::Shadows;
use radiosity::work::Deadline;
use radiosity::work::ranks::journal::{Begin, fingerprint};
use radiosity::work::ranks::threads::on_ranks;
use radiosity::work::ranks::{Ranks, Traffic};
use radiosity::{Options, Solved, ViewFactors, Work};
use radiosity_test_support::scenes::{builtin, builtin_with, typed};

/// Two threads, so that ranks have some.
fn options() -> Options {
    Options { threads: 2, ..Options::default() }
}

/// All numbers of a solution: coefficients, what was counted, and checks, as text, which tells each number
/// from all others.
fn told(solved: &Solved) -> String {
    let outcome = &solved.outcome;
    let bands: Vec<_> = outcome.solution.bands().iter().map(|band| &band.coefficients).collect();
    format!(
        "{bands:?} {:?} {:?} {} {} {} {:?} {} {} {:?} {:?}",
        outcome.checks,
        outcome.pairs,
        outcome.samples,
        outcome.distinct,
        outcome.rays,
        outcome.sampling,
        outcome.iterations,
        outcome.solver,
        outcome.worst_error,
        solved.achieved,
    )
}

/// Asserts that every one of two, three and four ranks finds what one process does.
fn same_on_ranks(what: impl Fn(&Work<'_>) -> String + Sync) {
    same_up_to(4, what);
}

/// Asserts that every one of two and more ranks, up to `most`, finds what one process does.
fn same_up_to(most: usize, what: impl Fn(&Work<'_>) -> String + Sync) {
    let alone = what(&Work::alone());
    assert!(alone.len() > 40, "{alone}");
    for ranks in 2..=most {
        for (rank, found) in on_ranks(ranks, |ranks| what(&Work::among(ranks))).into_iter().enumerate() {
            let differs = alone.bytes().zip(found.bytes()).position(|(a, b)| a != b);
            assert!(alone == found, "rank {rank} of {ranks}: from character {differs:?} on");
        }
    }
}

fn solved(name: &str, options: Options, work: &Work<'_>) -> Solved {
    Solved::new(builtin(name), options, work).expect("a solution")
}

#[test]
fn exact_pairs() {
    same_on_ranks(|work| told(&solved("cornell-box", options(), work)));
}

#[test]
fn curved_pairs_and_pairs_that_no_rule_reaches() {
    same_on_ranks(|work| told(&solved("teapot", Options { order: 1, eps: 1e-2, ..options() }, work)));
}

#[test]
fn rays() {
    let sampled = Options { transport: Transport::Sampled, rays: Some(60_000), ..options() };
    same_on_ranks(|work| told(&solved("two-boxes", sampled, work)));
    let few = Options { rays: Some(2_000), order: 1, ..sampled };
    same_on_ranks(|work| told(&solved("cornell-box", few, work)));
}

#[test]
fn solvers_that_need_entries_and_solvers_that_multiply() {
    for name in ["cholesky", "gauss-seidel", "southwell", "gmres", "jacobi", "cg"] {
        let method = radiosity::solvers::method::Method::named(name).expect("it is listed");
        same_on_ranks(|work| {
            told(&solved("cornell-box", Options { solver: method, order: 1, ..options() }, work))
        });
    }
}

#[test]
fn light_of_a_wanted_accuracy() {
    same_on_ranks(|work| {
        let scene = builtin("empty-box");
        let points = vec![[DVec3::new(0.5, 0.5, 0.2), DVec3::Z]];
        let goal = Goal::at(1e-2, points);
        let solved = Solved::to_accuracy(scene, &options(), &goal, work).expect("a solution");
        told(&solved)
    });
}

#[test]
fn links() {
    let linked = Options { method: radiosity::solve::LightMethod::Hierarchical, order: 0, ..options() };
    same_on_ranks(|work| told(&solved("two-boxes", linked, work)));
}

#[test]
fn view_factors_and_heat() {
    same_on_ranks(|work| {
        let scene = builtin("two-boxes");
        let accuracy = Accuracy { eps: 1e-4, shadow_eps: 1e-2 };
        let options = view_factors::Options {
            subdivide: Some(2),
            accuracy,
            threads: 2,
            ..view_factors::Options::default()
        };
        let factors = ViewFactors::new(&scene, &options, work).expect("all have area");
        let rows: Vec<Vec<f64>> = (0..factors.names.len()).map(|row| factors.row(row)).collect();
        format!("{rows:?} {:?} {} {}", factors.pairs, factors.samples, factors.rays)
    });
}

/// Irradiance of a few frames, back and forth, and what they took.
fn frames(mut sequence: Sequence<'_>, work: &Work<'_>) -> String {
    let told = [0.0, 1.0, 2.0, 3.0, 1.0, 1.0, 7.0].map(|moment| {
        let frame = sequence.at(moment, work).expect("it can be solved");
        let bands: Vec<_> = frame.solution.bands().iter().map(|band| &band.coefficients).collect();
        let rays = sequence.report().rays;
        let counts = [sequence.integrated(), sequence.recalled(), sequence.summed(), sequence.expanded()];
        format!("{moment} {bands:?} {counts:?} {rays:?} {:?}\n", sequence.error())
    });
    told.concat()
}

#[test]
fn frames_of_what_moves() {
    let scene = builtin("sliding-light");
    for shadows in [Shadows::Off, Options::default().shadows] {
        let exact = Options {
            transport: Transport::Exact,
            direct: Direct::Projected,
            subdivide: Some(2),
            order: 1,
            shadows,
            ..options()
        };
        same_up_to(3, |work| frames(Sequence::new(&scene, &exact), work));
        same_up_to(3, |work| frames(Sequence::incremental(&scene, &exact), work));
        same_up_to(3, |work| frames(Sequence::by_series(&scene, &exact, 1e-4), work));
    }
    let sampled = Options { transport: Transport::Sampled, rays: Some(60_000), order: 1, ..options() };
    same_up_to(3, |work| frames(Sequence::new(&scene, &sampled), work));
    same_up_to(3, |work| frames(Sequence::incremental(&scene, &sampled), work));
}

/// A tetrahedron seen from within, and a lamp in it: no two pairs are congruent.
const UNEQUAL: &str = r#"
materials.wall = { reflectance = 0.6 }
materials.lamp = { reflectance = 0.1, emission = 10 }
surfaces = [
    { name = "floor", material = "wall", polygon = { vertices = [[0, 0, 0], [3, 0, 0], [0.5, 2.7, 0]] } },
    { name = "front", material = "wall", polygon = { vertices = [[0, 0, 0], [0.8, 0.9, 2.9], [3, 0, 0]] } },
    { name = "right", material = "wall", polygon = { vertices = [[3, 0, 0], [0.8, 0.9, 2.9], [0.5, 2.7, 0]] } },
    { name = "left", material = "wall", polygon = { vertices = [[0.5, 2.7, 0], [0.8, 0.9, 2.9], [0, 0, 0]] } },
    { name = "lamp", material = "lamp", parallelogram = { origin = [0.8, 0.6, 0.9], edge1 = [0, 0.4, 0], edge2 = [0.5, 0, 0] } },
]
"#;

#[test]
fn all_work_is_counted_once() {
    let scene = typed(UNEQUAL);
    for transport in [Transport::Exact, Transport::Sampled] {
        let options = Options { transport, rays: Some(50_000), order: 1, subdivide: Some(1), ..options() };
        let found = on_ranks(3, |ranks| {
            let solved = Solved::new(scene.clone(), options, &Work::among(ranks)).expect("a solution");
            (ranks.traffic(), solved.outcome)
        });
        let outcome = &found[0].1;
        let sum = |of: fn(&Traffic) -> u64| found.iter().map(|(own, _)| of(own)).sum::<u64>();
        assert_eq!(
            [sum(|own| own.samples), sum(|own| own.rays)],
            [outcome.samples, outcome.rays],
            "{transport:?}"
        );
        assert!(found.iter().all(|(own, _)| own.samples + own.rays > 0), "{found:?}");
        // A step sends the own part of the unknowns to each of the others.
        let dim = outcome.solution.bands()[0].coefficients.irradiance.len() as u64;
        let products = found[0].0.products;
        assert_eq!(sum(|own| own.numbers), products * 8 * dim * 2);
    }
}

#[test]
fn a_run_goes_on_from_its_journal() {
    let folder = tempfile::tempdir().expect("a folder");
    let sampled = Options { transport: Transport::Sampled, rays: Some(20_000), order: 1, ..options() };
    let run = |begin: Begin, ranks: usize| {
        on_ranks(ranks, |ranks| {
            let ranks = ranks.recording(folder.path(), 1, begin).expect("a folder");
            let work = &Work::among(&ranks);
            let told =
                told(&solved("two-boxes", sampled, work)) + &told(&solved("cornell-box", options(), work));
            (told, Checkpoint::so_far(&ranks).expect("it is kept"))
        })
    };
    let first = run(Begin::Anew, 2);
    let all = first[0].1.recorded;
    assert!(all > 0 && first.iter().all(|(_, checkpoint)| checkpoint.recalled == 0));
    // As if both ranks had been killed: the last third of what one of them wrote is lost.
    let file = folder.path().join("000000-000001.journal");
    let bytes = std::fs::read(&file).expect("it was written");
    std::fs::write(&file, &bytes[..bytes.len() * 2 / 3]).expect("it can be written");
    for (ranks, is_complete) in [(3, false), (1, true)] {
        for (told, Checkpoint { recalled, recorded, .. }) in run(Begin::Resume, ranks) {
            assert!(told == first[0].0, "{ranks} ranks");
            assert_eq!(recalled + recorded, all, "{ranks} ranks");
            assert!(recalled > 0 && is_complete == (recorded == 0), "{ranks} ranks: {recorded} made again");
        }
    }
}

/// The end of a run to a wanted accuracy, as text, and the pieces that it took from its journal.
fn to_accuracy(folder: &Path, begin: Begin, deadline: Option<&Deadline>) -> (String, Checkpoint) {
    let ranks = Ranks::alone().recording(folder, 1, begin).expect("a folder");
    let goal = Goal::new(1e-3, Aim::Gathered);
    let work = Work { deadline, ..Work::among(&ranks) };
    let solved = Solved::to_accuracy(builtin("empty-box"), &options(), &goal, &work).expect("a solution");
    (told(&solved), Checkpoint::so_far(&ranks).expect("it is kept"))
}

#[test]
fn a_run_whose_time_was_up_goes_on_as_if_it_had_not_been() {
    let folders = [(); 2].map(|()| tempfile::tempdir().expect("a folder"));
    let [folder, other] = folders.each_ref().map(|folder| folder.path());
    let (whole, made) = to_accuracy(other, Begin::Anew, None);
    let (ended, first) = to_accuracy(folder, Begin::Anew, Some(&Deadline::at(Some(Instant::now()))));
    assert_ne!(ended, whole, "time was up after the first of several runs");
    let (resumed, rest) = to_accuracy(folder, Begin::Resume, None);
    assert_eq!(resumed, whole);
    assert!(rest.recalled > 0 && rest.recorded > 0, "{rest:?}");
    assert_eq!(rest.recalled + rest.recorded, made.recorded);
    // Pieces after readings that were left out have other places, and are made again.
    assert!(first.recorded < made.recorded, "{first:?} {made:?}");
    let (again, all) = to_accuracy(folder, Begin::Resume, None);
    assert_eq!((again, all.recorded, all.recalled), (whole, 0, made.recorded));
}

#[test]
fn runs_are_told_apart_by_their_scenes() {
    for (name, parameter, values) in
        [("parallel-squares", "distance", [0.5, 0.6]), ("temple", "bays", [3.0, 4.0])]
    {
        let scene = |value: f64| builtin_with(name, &[(parameter, value)]);
        let [one, again, other] =
            [values[0], values[0], values[1]].map(|value| fingerprint(&(scene(value), 1)));
        assert_eq!(one, again, "{name}");
        assert_ne!(one, other, "{name}");
        assert_ne!(one, fingerprint(&(scene(values[0]), 2)), "{name}");
    }
}
