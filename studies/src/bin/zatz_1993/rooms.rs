//! Table 1: times and shots of the rooms of figures 6, 7, 8 and 12, and the temple of figure 13.

use std::error::Error;
use std::io::Write;
use std::num::NonZeroUsize;

use radiosity::published::zatz1993::masking::{Average, Masking};
use radiosity::published::zatz1993::transfers::PaperRules;
use radiosity::scene::{MaskedPair, Scene};
use radiosity::solve::{Direct, Options, Outcome, RelaxedAtOnce, Relaxing};
use radiosity_core::dot;
use radiosity_solvers::method::Method;

use crate::memory::megabytes;
use crate::reproduction::{RULES, Reproduced, reproduced};

/// Part of the emitted power that may wait to be shot at the end; the paper does not tell its own.
const STOP: f64 = 1e-2;

/// Relative residual to which light is shot, so that less than that part waits.
const TOLERANCE: f64 = 1e-4;

/// Most surfaces of a room whose single functions are shot as well.
const FEW: usize = 20;

/// A room of the paper.
struct Room {
    figure: &'static str,
    name: &'static str,
    /// CPU time of the paper, and in seconds where it is one of one machine.
    time: (&'static str, Option<f64>),
    shots: &'static str,
    scene: Scene,
    options: Options,
}

/// Prints the table: the paper's time and shots, and those of its rule and of ours here.
pub(crate) fn table_1(out: &mut impl Write) -> Result<(), Box<dyn Error>> {
    header(out)?;
    let all = rooms()?;
    let mut rows = all.iter().flat_map(|room| RULES.map(|rules| (room, rules)));
    rows.try_for_each(|(room, rules)| row(out, room, rules))?;
    writeln!(
        out,
        "\nShots are counted until {STOP:e} of the emitted power waits, of all functions of a surface at once / of single functions. With \
         masks the direct light is there before the first shot, and what it lights has been shot once: + n counts these shots of surfaces. Row sums are 1 in a \
         closed room, and less where light is lost through what is open. Memory is what is reckoned before a run by our rules, 10 MB of \
         it for the program. By rays: pairs of elements that our rules leave to rays, behind curved things; those of 1993 leave none."
    )?;
    Ok(())
}

/// Prints the temple, by the rules of the paper alone: ours take more than ten minutes, most of them for the
/// lamps of order 13.
pub(crate) fn figure_13(out: &mut impl Write) -> Result<(), Box<dyn Error>> {
    header(out)?;
    let options = Options { threads: 0, ..shooting()? };
    let temple = Room {
        figure: "13",
        name: "temple, 655 surfaces (paper: 607)",
        time: ("two days, ten machines", None),
        shots: "",
        scene: radiosity::builtin("temple")?,
        options,
    };
    row(out, &temple, RULES[0])
}

fn header(out: &mut impl Write) -> Result<(), Box<dyn Error>> {
    writeln!(
        out,
        "| figure | room | paper: CPU time | shots | rules | CPU time, s | ratio | shots | row sums | by rays | unknowns | memory, MB |"
    )?;
    writeln!(out, "| --- | --- | --- | --- | --- | --- | ---: | --- | --- | --- | --- | --- |")?;
    Ok(())
}

/// Prints a room by one of the rules.
fn row(
    out: &mut impl Write,
    room: &Room,
    (rules, kernel): (&str, Option<PaperRules>),
) -> Result<(), Box<dyn Error>> {
    let Room { figure, name, time: (time, in_seconds), shots, scene, options } = room;
    let Reproduced { outcome, seconds } = reproduced(scene, kernel, options)?;
    let shots_here = shots_here(room, kernel, &outcome)?;
    let ratio = in_seconds.map_or(String::new(), |theirs| format!("{:.0}", theirs / seconds));
    let memory = match kernel {
        Some(_) => String::new(),
        None => format!("{:.0}", megabytes(scene, options)),
    };
    let checks = outcome.checks;
    writeln!(
        out,
        "| {figure} | {name} | {time} | {shots} | {rules} | {seconds:.3} | {ratio} | {shots_here} | {:.3}–{:.3} | {} | {} | {memory} |",
        checks.row_sum_min,
        checks.row_sum_max,
        outcome.pairs.by_rays,
        outcome.solution.elements().coefficients(),
    )?;
    Ok(())
}

/// Shots of surfaces, and of single functions in rooms of flat surfaces.
fn shots_here(room: &Room, kernel: Option<PaperRules>, outcome: &Outcome) -> Result<String, Box<dyn Error>> {
    let Room { scene, options, .. } = room;
    let (share, before) = match options.masks {
        None => (1.0, 0),
        Some(_) => (waiting_at_first(room, kernel)?, shot_before(outcome)),
    };
    let surfaces = shots_until(outcome, STOP / share);
    let before = if before > 0 { format!(" + {before}") } else { String::new() };
    if scene.surfaces.len() > FEW {
        return Ok(format!("{surfaces}{before}"));
    }
    let relaxing = Relaxing { at_once: RelaxedAtOnce::Coefficient, ..options.relaxing };
    let single = reproduced(scene, kernel, &Options { relaxing, ..*options })?.outcome;
    Ok(format!("{surfaces}{before} / {}", shots_until(&single, STOP / share)))
}

/// Shots after which less than a part of what waited at first ever waits.
fn shots_until(outcome: &Outcome, part: f64) -> usize {
    let history = outcome.shots.iter().flat_map(|shots| &shots.history);
    history.enumerate().filter(|(_, shot)| shot.unshot > part).map(|(k, _)| k + 1).last().unwrap_or(0)
}

/// Elements that emit, or reflect direct light: they have been shot once where direct light is masked.
fn shot_before(outcome: &Outcome) -> usize {
    let band = &outcome.solution.bands()[0];
    let starts = outcome.solution.elements().starts();
    let is_lit = |i: &usize| {
        let lit = band.coefficients.direct[starts[*i]..starts[i + 1]].iter().any(|value| *value != 0.0);
        band.coating.exitance[*i] > 0.0 || lit && band.coating.reflectance[*i] > 0.0
    };
    (0..starts.len() - 1).filter(is_lit).count()
}

/// The power that waits to be shot at first where direct light is masked, what surfaces reflect of light that
/// was reflected once, over the power that is emitted.
fn waiting_at_first(room: &Room, kernel: Option<PaperRules>) -> Result<f64, Box<dyn Error>> {
    let sent = |bounces: usize| -> Result<[f64; 2], Box<dyn Error>> {
        let options = Options { bounces: Some(bounces), ..room.options };
        let solution = reproduced(&room.scene, kernel, &options)?.outcome.solution;
        let (ones, band) = (solution.elements().constant(), &solution.bands()[0]);
        let emitted = band.coating.emitted(&solution.elements().starts(), &ones);
        Ok([&band.coefficients.radiosity, &emitted].map(|own| dot(own, &ones)))
    };
    let ([once, emitted], [direct, _]) = (sent(1)?, sent(0)?);
    Ok((once - direct) / emitted)
}

/// Order 4 on whole surfaces, light shot until it is spent.
fn shooting() -> Result<Options, Box<dyn Error>> {
    Ok(Options {
        order: 4,
        subdivide: Some(1),
        direct: Direct::Projected,
        solver: Method::named("southwell")?,
        tolerance: TOLERANCE,
        max_iterations: 100_000,
        threads: 1,
        ..Options::default()
    })
}

fn rooms() -> Result<Vec<Room>, Box<dyn Error>> {
    let shooting = shooting()?;
    let mut empty = radiosity::builtin("occluder-box")?;
    empty.surfaces.retain(|surface| !surface.name.starts_with("panel"));
    let masked = |cells| {
        let masks = NonZeroUsize::new(cells).map(|cells| Masking { cells, average: Average::Plain });
        Options { masks, ..shooting }
    };
    let room = |figure, name, time, shots, scene, options| Room { figure, name, time, shots, scene, options };
    let teapot = || radiosity::builtin("teapot");
    let [six, seven, eight] = [("5.4 s", Some(5.4)), ("59.7 s", Some(59.7)), ("42.8 s", Some(42.8))];
    let twelve = ("6.71 h", Some(6.71 * 3600.0));
    Ok(vec![
        room("6", "empty box, bright ceiling", six, "7", radiosity::builtin("empty-box")?, shooting),
        room("6", "empty box with a lamp", six, "7", empty, shooting),
        room("7", "one occluder", seven, "33", occluder(8, 4)?, shooting),
        room("8", "one occluder, masks 40 × 40", eight, "22", occluder(8, 8)?, masked(40)),
        room("12", "teapot", twelve, "53", teapot()?, Options { order: 6, ..shooting }),
        room(
            "12",
            "teapot, floor and walls masked 20 × 20",
            twelve,
            "53",
            masked_teapot()?,
            Options { order: 6, ..masked(20) },
        ),
    ])
}

/// The teapot, of which the light of its four lamps on floor and walls is masked: of the masks on the pot that
/// the paper has, too, it does not say which.
fn masked_teapot() -> Result<Scene, Box<dyn Error>> {
    let mut scene = radiosity::builtin("teapot")?;
    let named = |start: &'static str| {
        let own = scene.surfaces.iter().enumerate().filter(move |(_, own)| own.name.starts_with(start));
        own.map(|(index, _)| index).collect::<Vec<_>>()
    };
    let receivers = [named("floor"), named("wall")].concat();
    let [emitter, receiver] = ["lamp*", "floor, wall*"].map(str::to_owned);
    let pair = MaskedPair { emitter, receiver, emitters: named("lamp"), receivers, cells: None };
    scene.masks.push(pair);
    Ok(scene)
}

/// The box with a panel, with these orders of floor and lamp.
fn occluder(floor: usize, lamp: usize) -> Result<Scene, Box<dyn Error>> {
    let mut scene = radiosity::builtin("occluder-box")?;
    for (name, order) in [("floor", floor), ("lamp", lamp)] {
        let surface = scene.surface_named(name)?;
        scene.surfaces[surface].order = Some(order);
    }
    Ok(scene)
}
