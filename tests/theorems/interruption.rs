//! Interrupted work ends soon, whatever it is, and leaves nothing behind: the same work done later finds the
//! same bits.

use std::thread;
use std::time::{Duration, Instant};

use radiosity::geom::DVec3;
use radiosity::heat::{Heat, HeatOptions};
use radiosity::kernel::Accuracy;
use radiosity::reading::pictures::render::{PictureRequest, ReadMode};
use radiosity::reading::quantity::Quantity;
use radiosity::scene::Camera;
use radiosity::solve::animation::follower::{FollowMode, Follower};
use radiosity::solve::animation::sequence::Sequence;
use radiosity::solve::studies::adaptation::{Aim, Goal};
use radiosity::solve::{LightMethod, Transport, in_threads};
use radiosity::work::Progress;
use radiosity::work::interruption::{Interrupted, Interruption};
use radiosity::{Options, Scene, Solution, Solved, ViewFactors, Work, solve, solve::view_factors};
use radiosity_test_support::scenes::builtin;
use radiosity_test_support::solved::{outcome_of, solved_of};

/// Times that work goes on before it is interrupted (s): from none of it to well within.
const BEFORE: [f64; 3] = [0.01, 0.2, 0.7];

/// Time in which interrupted work must have ended (s); the machine may do other things too.
const SOON: f64 = 5.0;

/// Options of exact transfers.
fn exact(order: usize, eps: f64) -> Options {
    Options { order, eps, shadow_eps: eps, transport: Transport::Exact, threads: 2, ..Options::default() }
}

/// Interrupts `work`, which would take long, after several times; all of them end soon.
fn ends_soon(name: &str, work: &(dyn Fn() + Sync)) {
    for before in BEFORE {
        let interruption = Interruption::new();
        let raised = thread::scope(|scope| {
            let other = scope.spawn(|| {
                thread::sleep(Duration::from_secs_f64(before));
                interruption.raise();
                Instant::now()
            });
            assert_eq!(interruption.within(work), Err(Interrupted), "{name} is done in {before} s");
            other.join().expect("it sleeps")
        });
        let took = raised.elapsed().as_secs_f64();
        assert!(took < SOON, "{name} goes on for {took:.2} s after {before} s");
    }
}

/// Does what would take long with one scene or another.
fn solves(scene: &Scene, options: Options) -> impl Fn() + Sync {
    move || drop(solve(scene, &options, &Work::alone()))
}

#[test]
fn solutions_end_soon() {
    let cornell = builtin("cornell-box");
    let dear = Options { subdivide: Some(4), ..exact(8, 1e-6) };
    ends_soon("dear pairs", &solves(&cornell, dear));
    ends_soon("many pairs", &solves(&cornell, Options { subdivide: Some(24), ..exact(0, 1e-4) }));
    ends_soon("curved pairs", &solves(&builtin("teapot"), exact(7, 1e-7)));
    let by_rays = Options {
        transport: Transport::Sampled,
        rays: Some(4_000_000_000),
        threads: 2,
        ..Options::default()
    };
    ends_soon("rays", &solves(&cornell, by_rays));
    ends_soon("rays of many elements", &solves(&cornell, Options { subdivide: Some(16), ..by_rays }));
    let by_links = Options { method: LightMethod::Hierarchical, eps: 1e-9, threads: 2, ..Options::default() };
    ends_soon("links", &solves(&cornell, by_links));
    ends_soon("an accuracy", &|| {
        let options = Options { threads: 2, ..Options::default() };
        drop(Solved::to_accuracy(cornell.clone(), &options, &Goal::new(1e-7, Aim::Gathered), &Work::alone()));
    });
}

#[test]
fn transfers_end_soon() {
    let accuracy = Accuracy { eps: 1e-3, shadow_eps: 3e-3 };
    let options = view_factors::Options {
        subdivide: Some(24),
        accuracy,
        threads: 2,
        ..view_factors::Options::default()
    };
    let cornell = builtin("cornell-box");
    ends_soon("view factors", &|| drop(ViewFactors::new(&cornell, &options, &Work::alone())));
    let oven = builtin("oven");
    let wanted =
        HeatOptions { options: Options { subdivide: Some(12), ..exact(7, 1e-6) }, conductances: true };
    ends_soon("heat", &|| drop(Heat::of(&oven, &wanted, &Work::alone())));
}

/// A solution of the Cornell box in a moment.
fn quick() -> Solution {
    let options = Options { order: 2, threads: 2, ..Options::default() };
    outcome_of(&builtin("cornell-box"), &options).solution
}

#[test]
fn pictures_end_soon() {
    let (scene, solution) = (builtin("cornell-box"), quick());
    let visibility = Options::default().visibility(&scene);
    let camera = scene.camera.expect("it has one");
    let large = Camera { width: 4000, height: 4000, ..camera };
    for read in [ReadMode::Gather, ReadMode::GatherTwice] {
        ends_soon("a picture", &|| {
            let picture = || {
                PictureRequest {
                    solution: &solution,
                    visibility: &visibility,
                    camera: &large,
                    samples: 8,
                    read,
                    shown: Quantity::Radiosity,
                    is_preview: false,
                }
                .picture(&Work::alone())
            };
            drop(in_threads(2, picture));
        });
    }
}

#[test]
fn what_is_done_after_an_interruption_finds_the_same_bits() {
    let coefficients = |solution: &Solution| -> Vec<Vec<f64>> {
        solution.bands().iter().map(|band| band.coefficients.radiosity.clone()).collect()
    };
    let before = coefficients(&quick());
    // Tables that are kept between runs are made in the work that is interrupted.
    let cornell = builtin("cornell-box");
    ends_soon("dear pairs", &solves(&cornell, Options { subdivide: Some(3), ..exact(9, 1e-6) }));
    assert_eq!(coefficients(&quick()), before);
    let solved = Solved::new(cornell, Options { order: 2, threads: 2, ..Options::default() }, &Work::alone());
    let solved = solved.expect("a solution");
    let read = || in_threads(1, || solved.irradiance_at(DVec3::splat(100.0), DVec3::Y));
    let interruption = Interruption::new();
    interruption.raise();
    assert!(matches!(interruption.within(read), Err(Interrupted)));
    let again = solved_of(builtin("cornell-box"), solved.options);
    let place = [DVec3::splat(100.0), DVec3::Y];
    assert_eq!(read().expect("a thread"), again.irradiance_at(place[0], place[1]));
}

#[test]
fn a_frame_that_was_interrupted_leaves_nothing_to_the_next() {
    let sliding = builtin("sliding-light");
    let options = Options { subdivide: Some(1), ..exact(1, 1e-4) };
    let light = |sequence: &mut Sequence<'_>, moment: f64| {
        let frame = sequence.at(moment, &Work::alone()).expect("a frame");
        format!("{:?}", frame.solution.bands().iter().map(|band| &band.coefficients).collect::<Vec<_>>())
    };
    let alone = [1.0, 2.0].map(|moment| light(&mut Sequence::fresh(&sliding, &options), moment));
    let ways = [Sequence::new(&sliding, &options), Sequence::by_series(&sliding, &options, 1e-4)];
    for (mut sequence, frames) in ways.into_iter().zip([2, 1]) {
        (0..3).for_each(|frame| drop(light(&mut sequence, f64::from(frame))));
        let interruption = Interruption::new();
        let raise = |_: Progress| interruption.raise();
        let ended = interruption.within(|| sequence.at(5.0, &Work::alone().observed_by(&raise)).map(drop));
        assert!(matches!(ended, Err(Interrupted)));
        // A series begins anew, with blocks that are integrated.
        for (moment, alone) in [1.0, 2.0].into_iter().zip(&alone).take(frames) {
            assert_eq!(light(&mut sequence, moment), *alone);
        }
    }
}

#[test]
fn segments_of_a_path_are_those_of_one_that_was_not_interrupted() {
    let sliding = builtin("sliding-light");
    let options = Options { subdivide: Some(1), ..exact(1, 1e-4) };
    let ends = [0, 12];
    let course = || Follower::new(&sliding, &options, FollowMode::Path { tolerance: 1e-2 }, ends);
    let (mut whole, mut torn) = (course(), course());
    let interruption = Interruption::new();
    let raise = |_: Progress| interruption.raise();
    let ended = interruption.within(|| torn.frame(0, &Work::alone().observed_by(&raise)).map(drop));
    assert!(matches!(ended, Err(Interrupted)));
    let [found, right] = [&mut torn, &mut whole].map(|course| {
        let frame = course.frame(3, &Work::alone()).expect("a frame");
        format!("{:?}", frame.solution.bands().iter().map(|band| &band.coefficients).collect::<Vec<_>>())
    });
    assert_eq!((found, torn.segments()), (right, whole.segments()));
}
