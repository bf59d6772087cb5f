//! `radiosity view-factors`: the share of what leaves each surface that reaches each other.

use std::collections::BTreeSet;
use std::io::{self, Write};
use std::path::PathBuf;
use std::time::Instant;

use clap::{Args, ValueEnum};
use radiosity_audit::Checked;
use radiosity_kernel::WorstError;
use radiosity_output::files::view_factors as output;
use radiosity_output::files::view_factors::Sparse;
use radiosity_reading::accuracy_warning::{missed, missed_by_rays};
use radiosity_reading::checked_factors::CheckedFactors;
use radiosity_reading::row_sums::RowSums;
use radiosity_scene::Scene;
use radiosity_solve::in_threads;
use radiosity_solve::view_factors::{Options, ViewFactors};
use radiosity_work::digits::significant;
use radiosity_work::ranks::Ranks;
use radiosity_work::{Observer, Progress as Event, Stage, Work};

use crate::{
    destination::Destination, error::CliError, format, options::SceneArg, progress::Progress,
    transfers::TransferArgs, typed_options::TypedOptions,
};

const NOTES: &str = "\
Examples:
  radiosity view-factors room.toml -o F.npz             F, names and areas for NumPy
  radiosity view-factors hall.obj --sparse csr -o F.npz   without zeros, for scipy.sparse.load_npz
  radiosity view-factors room.toml -o F.txt             as View3D writes them
  radiosity view-factors room.toml --pairs floor,ceiling --eps 1e-10
  radiosity view-factors faces.csv > F.csv

Materials and emitters are not needed. Instead of a scene, SCENE may be a plain list of polygons:
  .csv   a row name,x,y,z for each vertex; rows of one name that follow each other make a polygon
  .json  [[[0,0,0],[1,0,0],[0,1,0]], …], a list of vertices for each polygon
Vertices run counterclockwise as seen from the front, which alone sees; the back blocks.";

/// Seconds of rules from which the way by rays is named. Chosen.
const LONG: f64 = 60.0;

/// The words before a forecast of so long: rays take less.
const OTHER_WAY: &str = "view factors (--transport auto takes rays where rules take long)";

/// Prints the view factors F_ij between the surfaces of a scene, each with its error, and their row sums
#[derive(Debug, Args)]
#[command(after_help = NOTES)]
pub(crate) struct ViewFactorsArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArg,

    /// File of the matrix, in the format of its ending: .csv, .json, .npy, .npz, or .txt as View3D writes it
    /// [default: CSV on standard output]
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,

    /// Format of the matrix
    #[arg(long, value_name = "FORMAT")]
    pub(crate) format: Option<Format>,

    /// Leaves zeros out: of .npz, by rows (csr) or as triples (coo); of .csv and .json, as a list of pairs
    /// (coo)
    #[arg(long, value_name = "FORM", conflicts_with = "pairs")]
    pub(crate) sparse: Option<Sparse>,

    /// Computes and prints F from surface A to surface B only, with 17 digits; may be repeated
    #[arg(long, value_name = "A,B")]
    pub(crate) pairs: Vec<String>,

    #[command(flatten)]
    transfers: TransferArgs,
}

/// `--format` of a matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Names as header and first column
    Csv,
    /// Names, areas, factors, row sums and checks
    Json,
    /// `NumPy`: N × N numbers of 8 bytes
    Npy,
    /// `NumPy`: F, names and areas
    Npz,
    /// View3D: areas, factors and emittances as text
    #[value(alias = "view3d")]
    Txt,
}

impl Format {
    /// Whether the format has a place for a list of pairs.
    fn holds_pairs(self) -> bool {
        matches!(self, Self::Csv | Self::Json)
    }
}

/// Computes the factors and writes them.
pub(crate) fn run(args: &ViewFactorsArgs, given: &TypedOptions, ranks: &Ranks) -> Result<(), CliError> {
    let start = Instant::now();
    let format = args.format()?;
    let options = args.transfers.request.factors()?;
    let scene = args.scene.request().load(ranks)?;
    let ranks = &args.transfers.checkpoint.recording(given, &scene, &scene, &[], ranks)?;
    let pairs = args.pairs.iter().map(|pair| named_pair(&scene, pair)).collect::<Result<Vec<_>, _>>()?;
    let output = args.output.as_deref().map(|path| args.scene.reserve(path, ranks));
    let destination = Destination::of(output.transpose()?, ranks);
    let progress = Progress::new(args.transfers.quiet, options.threads, start, ranks);
    let chosen: BTreeSet<[usize; 2]> = pairs.iter().copied().collect();
    let wanted = |i, j| chosen.is_empty() || chosen.contains(&[i, j]);
    let show = |event| match event {
        Event::Expected { stage, seconds } => {
            progress.ledger().expect(stage, seconds);
            let seconds = progress.seconds(seconds);
            let what = if seconds > LONG { OTHER_WAY } else { "view factors" };
            progress.announce(what, seconds);
        }
        Event::Done { done, of, .. } => progress.show("pairs", done, of),
        Event::Rays { .. } | Event::Began { .. } | Event::Ended { .. } => progress.report(event),
        _ => {}
    };
    let work = Work::among(ranks).observed_by(&show);
    let factors = ViewFactors::of_pairs(&scene, &wanted, &options, &work)?;
    let told = args.checked(&scene, &factors, &options, &pairs, &work)?;
    progress.begin_output();
    let form = Form { format, sparse: args.sparse, pairs };
    destination.write(|writer| form.write(&scene, &factors, &told, writer))?;
    progress.clear();
    let findings = work.during(Stage::Checks, || args.findings(&scene, &factors, &options, &told, ranks))?;
    let mut first = costs(&scene, &factors, start.elapsed().as_secs_f64());
    first.push(progress.stages());
    args.transfers.tell(first, &scene, findings, &args.output, ranks);
    args.judge(&told)
}

/// The first lines of the summary of a run of so many seconds.
fn costs(scene: &Scene, factors: &ViewFactors, seconds: f64) -> Vec<String> {
    let ViewFactors { names, elapsed, samples, rays, choice, .. } = factors;
    let elapsed = elapsed.as_secs_f64();
    let of = if choice.sampled { "rays" } else { "shadow rays" };
    let mut lines = vec![
        format!("{}: {} surfaces", scene.name, names.len()),
        format!("{seconds:.3} s, of which factors {elapsed:.3} s ({samples} kernel samples, {rays} {of})"),
    ];
    lines.extend(choice.sampled.then(|| by_rays(factors)));
    lines
}

/// The errors that rays left in the factors that they carried, and why they did.
fn by_rays(factors: &ViewFactors) -> String {
    let errors = factors.relative_errors();
    let part = |share: f64| errors.get((share * errors.len() as f64) as usize).or(errors.last());
    let [half, most, all] = [0.5, 0.9, 1.0]
        .map(|share| part(share).map_or("0".to_owned(), |error| significant(100.0 * error, 2)));
    let unseen = factors.errors_of_unseen();
    let least = unseen.iter().copied().fold(0.0, f64::max);
    let of_unseen = match unseen.len() {
        0 => String::new(),
        count => format!(", without {count} rows that see nothing above {least:.0e}"),
    };
    format!(
        "carried by rays ({}), {} pairs by rules: errors of half of the rows are within {half} % of their largest \
         factor, of nine tenths {most} %, of all {all} %{of_unseen}",
        factors.choice.why, factors.exact_pairs
    )
}

/// Form in which factors are written, and the pairs.
struct Form {
    format: Format,
    sparse: Option<Sparse>,
    /// Pairs (i, j) that were asked for; none for all.
    pairs: Vec<[usize; 2]>,
}

impl Form {
    fn write(
        &self,
        scene: &Scene,
        factors: &ViewFactors,
        told: &CheckedFactors,
        writer: &mut dyn Write,
    ) -> io::Result<()> {
        match (self.format, self.listed(factors), self.sparse) {
            (Format::Csv, Some(pairs), _) => output::pairs_csv(factors, told, &pairs, writer),
            (Format::Csv, None, _) => output::csv(factors, writer),
            (Format::Json, Some(pairs), _) => output::pairs_json(factors, told, &pairs, writer),
            (Format::Json, None, _) => output::json(factors, told, writer),
            (Format::Npy, ..) => output::npy(factors, writer),
            (Format::Npz, _, Some(sparse)) => output::sparse_npz(factors, told, sparse, writer),
            (Format::Npz, _, None) => output::npz(factors, told, writer),
            (Format::Txt, ..) => output::view3d(factors, &emittances(scene), writer),
        }
    }

    /// The pairs that are listed one by one, where the factors are no matrix.
    fn listed(&self, factors: &ViewFactors) -> Option<Vec<[usize; 2]>> {
        match (self.pairs.is_empty(), self.sparse) {
            (false, _) => Some(self.pairs.clone()),
            (true, Some(_)) => Some(output::nonzero_pairs(factors)),
            (true, None) => None,
        }
    }
}

/// Emissivities of all surfaces, of all bands together: those of heat where they are stated, else 1 − ρ − τ.
fn emittances(scene: &Scene) -> Vec<f64> {
    let mean = |numbers: &[f64]| numbers.iter().sum::<f64>() / numbers.len() as f64;
    let surfaces = scene.surfaces.iter();
    surfaces
        .map(|surface| {
            let material = &surface.material;
            let given = surface.thermal.emissivity;
            given.unwrap_or_else(|| 1.0 - mean(&material.reflectance) - mean(&material.transmittance))
        })
        .collect()
}

/// The two surfaces of `A,B`. Names may contain commas: the first comma with known names on both sides
/// separates them.
fn named_pair(scene: &Scene, pair: &str) -> Result<[usize; 2], CliError> {
    let halves = || pair.match_indices(',').map(|(at, _)| (pair[..at].trim(), pair[at + 1..].trim()));
    let Some((first, second)) = halves().next() else {
        let cure = "write the names of two surfaces, as in --pairs floor,ceiling";
        return Err(CliError::refused(format!("--pairs {pair}: two names are needed"), cure));
    };
    let found = |(a, b)| Some([scene.surface_named(a).ok()?, scene.surface_named(b).ok()?]);
    match halves().find_map(found) {
        Some(pair) => Ok(pair),
        None => Ok([scene.surface_named(first)?, scene.surface_named(second)?]),
    }
}

impl ViewFactorsArgs {
    /// The format asked for, or that of the output's ending.
    fn format(&self) -> Result<Format, CliError> {
        let format = format::chosen(self.format, self.output.as_deref(), Format::Csv)?;
        let named = || format::name(&format).to_uppercase();
        if !format.holds_pairs() && !self.pairs.is_empty() {
            let message = format!("--pairs are no matrix, which is all that {} holds", named());
            return Err(CliError::refused(message, "choose --format csv or json"));
        }
        let Some(sparse) = self.sparse else { return Ok(format) };
        let cure = match (format, sparse) {
            (Format::Npz, _) | (Format::Csv | Format::Json, Sparse::Coo) => return Ok(format),
            (Format::Csv | Format::Json, Sparse::Csr) => "take --sparse coo, or choose a file ending in .npz",
            (Format::Npy | Format::Txt, _) => "leave out --sparse, or choose a file ending in .npz",
        };
        let message = format!("--sparse {}: {} has no place for it", format::name(&sparse), named());
        Err(CliError::refused(message, cure))
    }

    /// The errors of the factors, of all or of the `pairs` that were asked for.
    fn checked(
        &self,
        scene: &Scene,
        factors: &ViewFactors,
        options: &Options,
        pairs: &[[usize; 2]],
        work: &Work<'_>,
    ) -> Result<CheckedFactors, CliError> {
        let check = &self.transfers.check;
        let chosen: BTreeSet<[usize; 2]> = pairs.iter().copied().collect();
        let mut from: Vec<usize> = match chosen.is_empty() {
            true => (0..factors.names.len()).collect(),
            false => chosen.iter().map(|pair| pair[0]).collect(),
        };
        from.dedup();
        let wanted = |i, j| chosen.is_empty() || chosen.contains(&[i, j]);
        let Some(effort) = check.of_factors(factors, options, from.len(), scene) else {
            return Ok(CheckedFactors::unjudged(factors));
        };
        let judge = || CheckedFactors::judged(scene, factors, &from, &wanted, &effort, work);
        let judged = || work.during(Stage::Referee, judge);
        Ok(in_threads(work.ranks.threads(options.threads), judged)?)
    }

    /// Fails where a strict run finds more than is told.
    fn judge(&self, told: &CheckedFactors) -> Result<(), CliError> {
        match told.checked.as_ref().filter(|checked| self.scene.strict && checked.finds_more()) {
            Some(checked) => {
                Err(CliError::FoundMore { what: "the view factors are", told: checked.own_error })
            }
            None => Ok(()),
        }
    }

    /// The lines of the summary on the factors.
    fn findings(
        &self,
        scene: &Scene,
        factors: &ViewFactors,
        options: &Options,
        told: &CheckedFactors,
        ranks: &Ranks,
    ) -> Result<Vec<String>, CliError> {
        let threads = ranks.threads(self.transfers.request.threads());
        let sums = || sums(scene, factors, options);
        let mut lines = if self.pairs.is_empty() { in_threads(threads, sums)? } else { Vec::new() };
        lines.extend(told.checked.as_ref().map(ToString::to_string));
        if let Some(finding) = told.checked.as_ref().and_then(Checked::finding) {
            lines.push(format!("warning: walks find the factors off by more than these tell: {finding}"));
        }
        lines
            .extend(missed_by_rays(factors, options.accuracy.eps).map(|missed| format!("warning: {missed}")));
        if let Some(worst) = factors.worst_error.filter(WorstError::is_real) {
            let names = worst.pair.map(|surface| &factors.names[surface][..]);
            lines.push(format!("warning: {}", missed(&worst, names)));
        }
        Ok(lines)
    }
}

/// Lines on row sums.
fn sums(scene: &Scene, factors: &ViewFactors, options: &Options) -> Vec<String> {
    let sums = RowSums::of(scene, factors, options);
    let [range, closed] = sums.lines();
    let warning = sums.warning().map(|warning| warning.to_string());
    [range, closed].into_iter().chain(warning).collect()
}
