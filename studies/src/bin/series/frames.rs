//! Frames of rooms in which something moves, by series and with integrals.

use cpu_time::ProcessTime;

use radiosity::solve::animation::sequence::Sequence;
use radiosity::solve::{Direct, Options, Transport};
use radiosity::visibility::Shadows;
use radiosity::{Scene, Work, language, scene::Source};

/// A room with a lamp at its ceiling.
const ROOM: &str = r#"
frames = 100
materials.wall = { reflectance = 0.6 }
materials.lamp = { reflectance = 0, emission = 40 }
[[surfaces]]
name = "room"
material = "wall"
box = { origin = [0, 0, 0], size = [5, 4, 3], inward = true }
[[surfaces]]
name = "lamp"
material = "lamp"
quad = { vertices = [[2, 1.7, 2.4], [2, 2.3, 2.4], [2.8, 2.3, 2.4], [2.8, 1.7, 2.4]] }
"#;

/// The lamp turns about a line through its middle.
const TURNING: &str = r#"
[[motion]]
surfaces = "lamp"
rotate = { center = [2.4, 2, 2.4], axis = [0.3, 1, 0], angles = [-20, 20] }
"#;

/// A panel turns like a door.
const DOOR: &str = r#"
[[surfaces]]
name = "panel"
material = "wall"
two_sided = true
quad = { vertices = [[1, 1, 0.5], [2, 1, 0.5], [2, 1, 1.5], [1, 1, 1.5]] }
[[motion]]
surfaces = "panel"
rotate = { center = [1, 1, 0], axis = [0, 0, 1], angles = [20, 70] }
"#;

struct Run {
    order: usize,
    eps: f64,
    /// Elements along the edges of surfaces.
    parts: usize,
    /// Whether bodies hide each other.
    shadows: bool,
    /// Distance of moments (frames).
    step: f64,
}

const COARSE: Run = Run { order: 2, eps: 1e-4, parts: 1, shadows: false, step: 1.0 };
const FINE: Run = Run { parts: 3, ..COARSE };
const RUNS: [Run; 5] = [
    COARSE,
    FINE,
    Run { order: 4, eps: 1e-6, ..FINE },
    Run { step: 0.1, ..FINE },
    Run { shadows: true, ..FINE },
];

/// Prints the table.
pub(crate) fn frames() {
    let turning = room(TURNING);
    let door = room(DOOR);
    let sliding = radiosity::builtin("sliding-light").expect("it is built in");
    println!(
        "| scene | order | eps | parts | step | shadows | integrated | by series: integrated, summed, expanded | integrated, ms | by series, ms | told |"
    );
    println!("|{}", " --- |".repeat(11));
    for Run { order, eps, parts, shadows, step } in RUNS {
        let options = Options {
            order,
            eps,
            subdivide: Some(parts),
            transport: Transport::Exact,
            direct: Direct::Projected,
            threads: 1,
            shadows: if shadows { Options::default().shadows } else { Shadows::Off },
            ..Options::default()
        };
        for (name, scene) in [("turning lamp", &turning), ("door", &door), ("sliding light", &sliding)] {
            let selective = Cost::of(Sequence::new(scene, &options), scene.frames(), step);
            let series = Cost::of(Sequence::by_series(scene, &options, eps), scene.frames(), step);
            let Cost { integrated, summed, expanded, error, .. } = series;
            println!(
                "| {name} | {order} | {eps:.0e} | {parts} | {step} | {} | {:.0} | {integrated:.0}, {summed:.0}, {expanded:.1} | {:.2} | {:.2} | {error:.0e} |",
                if shadows { "yes" } else { "no" },
                selective.integrated,
                selective.milliseconds,
                series.milliseconds
            );
        }
    }
}

fn room(more: &str) -> Scene {
    language::read(&Source::new("room.toml", &format!("{ROOM}{more}"))).expect("it is valid")
}

/// Means of all frames but the first, and the largest error told.
#[derive(Default)]
struct Cost {
    integrated: f64,
    summed: f64,
    expanded: f64,
    milliseconds: f64,
    error: f64,
}

impl Cost {
    fn of(mut sequence: Sequence<'_>, frames: usize, step: f64) -> Self {
        let mut cost = Self::default();
        let part = 1.0 / (frames - 1) as f64;
        for frame in 0..frames {
            let begun = ProcessTime::now();
            sequence.at(step * frame as f64, &Work::alone()).expect("the frame can be solved");
            if frame == 0 {
                continue;
            }
            cost.milliseconds += 1e3 * part * begun.elapsed().as_secs_f64();
            cost.integrated += part * sequence.integrated() as f64;
            cost.summed += part * sequence.summed() as f64;
            cost.expanded += part * sequence.expanded() as f64;
            cost.error = cost.error.max(sequence.error().unwrap_or(0.0));
        }
        cost
    }
}
