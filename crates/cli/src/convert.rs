//! `radiosity convert`: a scene in another format, or a solution as a grid.

use std::io::Write;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use clap::Args;
use radiosity_formats::{
    format::Format,
    model::Model,
    write::{WRITTEN, write},
};
use radiosity_reading::files::solution_file::{is_solution, read};
use radiosity_request::ranges::Pieces;
use radiosity_scene::{Notation, Scene, Source};
use radiosity_work::ranks::Ranks;

use crate::{
    console,
    error::CliError,
    format,
    loaded::{outside, relit},
    options::SceneArg,
    solution_format::SolutionFormat,
};

const EXAMPLES: &str = "\
Scenes of other programs are repaired as for every verb, and each repair is told. What a format has no words for is left out, \
and told too; surfaces that it has no shape for are refused, with their names, unless --tessellate cuts them. Comments are not kept.

A solution becomes .vtu: its polynomials on curved cells of VTK, for ParaView.

Examples:
  radiosity convert room.mgf room.toml --one-sided   a scene to work on, its materials by name
  radiosity convert kitchen.obj kitchen.json --unit mm --materials paint.toml
  radiosity convert cornell-box cornell.obj          a built-in scene, with cornell.mtl
  radiosity convert teapot teapot.obj --tessellate 20  curved surfaces as flat pieces
  radiosity convert room.solution.json room.vtu      light that `radiosity solve` computed";

/// Writes a scene in another format, .toml, .json, .mgf, .vs3 or .obj, or a solution as .vtu
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, allow_missing_positional = true)]
pub(crate) struct ConvertArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArg,

    /// File that is written, in the format of its ending: .toml, .json, .mgf, .vs3 or .obj with .mtl; .vtu of
    /// a solution
    #[arg(value_name = "OUT")]
    pub(crate) output: PathBuf,

    /// Curved surfaces become flat pieces between points of them, over so many cells along u and v
    #[arg(long, value_name = "N")]
    pub(crate) tessellate: Option<Pieces>,
}

/// A format that is written.
#[derive(Clone, Copy)]
enum Target {
    /// A scene of radiosity.
    Own(Notation),
    /// A scene of another program.
    Foreign(Format),
}

impl Target {
    /// The format that the ending of a file's name tells.
    fn of(path: &Path) -> Result<Self, CliError> {
        let ending = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
        let format = Format::of(&path.to_string_lossy()).filter(|format| WRITTEN.contains(format));
        match (ending.as_str(), format) {
            ("toml", _) => Ok(Target::Own(Notation::Toml)),
            ("json", _) => Ok(Target::Own(Notation::Json)),
            (_, Some(format)) => Ok(Target::Foreign(format)),
            _ => {
                let names = WRITTEN.map(Format::name).join(", ");
                let cure = format!("end the name in one of toml, json, {names}, or vtu for a solution");
                Err(format::unknown(path, "format that is written", &cure))
            }
        }
    }
}

/// Reads the scene, or the solution, and writes it.
pub(crate) fn run(args: &ConvertArgs, ranks: &Ranks) -> Result<(), CliError> {
    if SolutionFormat::of(&args.output) == SolutionFormat::Vtu {
        return grid(args, ranks);
    }
    let target = Target::of(&args.output)?;
    let beside = args.output.with_extension("mtl");
    let output = args.scene.reserve(&args.output, ranks)?;
    let materials = match target {
        Target::Foreign(Format::Obj) => Some(args.scene.reserve(&beside, ranks)?),
        _ => None,
    };
    let name = beside.file_name().unwrap_or_default().to_string_lossy();
    let texts = texts(args, target, &name, ranks)?;
    if let (Some(file), Some(text)) = (&materials, &texts.materials) {
        file.write(|writer| writer.write_all(text.as_bytes()))?;
    }
    output.write(|writer| writer.write_all(texts.scene.as_bytes()))?;
    let also = materials.map(|_| format!(" and {}", beside.display())).unwrap_or_default();
    let mut lines = texts.remarks;
    lines.push(format!("wrote {}{also}", args.output.display()));
    console::tell(&lines, ranks);
    Ok(())
}

/// Reads a solution and writes its grid.
fn grid(args: &ConvertArgs, ranks: &Ranks) -> Result<(), CliError> {
    if args.tessellate.is_some() {
        return Err(CliError::refused(
            "--tessellate cuts the surfaces of a scene, and a grid has the curved cells of a solution",
            "leave it out",
        ));
    }
    let output = args.scene.reserve(&args.output, ranks)?;
    let request = args.scene.request();
    let text = request.text(ranks)?;
    if !is_solution(&text.text()) {
        return Err(CliError::refused(
            format!("{}: a scene has no light yet, and a grid holds light", text.origin),
            format!("solve it: `radiosity solve {} -o {}`", text.origin, args.output.display()),
        ));
    }
    if args.scene.frame.is_some() {
        return Err(CliError::fixed(&text.origin, "--frame"));
    }
    let solved = relit(read(&text)?, &request.later())?;
    let written = SolutionFormat::Vtu.write(&solved, &args.output, &output)?;
    console::tell(&[format!("wrote {written}")], ranks);
    Ok(())
}

/// Texts of the files to be written, and remarks to be told.
struct Texts {
    scene: String,
    materials: Option<String>,
    remarks: Vec<String>,
}

fn texts(args: &ConvertArgs, target: Target, materials: &str, ranks: &Ranks) -> Result<Texts, CliError> {
    let scene = args.scene.request().load(ranks)?;
    let mut remarks: Vec<String> = scene.imported().map(|own| own.lines().collect()).unwrap_or_default();
    remarks.extend(outside(&scene));
    if let (Target::Own(notation), None) = (target, args.tessellate) {
        check_includes(args, &scene)?;
        return Ok(Texts { scene: radiosity_language::text(&scene, notation)?, materials: None, remarks });
    }
    let pieces = args.tessellate.and_then(|pieces| NonZeroUsize::new(u64::from(pieces) as usize));
    let model: Model = radiosity_language::model(&scene, pieces)?;
    let output = args.output.display();
    remarks.extend(model.notes.iter().map(|note| format!("{output}: {}", note.text)));
    match target {
        Target::Own(notation) => {
            let scene = radiosity_language::model_text(&model, notation);
            Ok(Texts { scene, materials: None, remarks })
        }
        Target::Foreign(format) => {
            let written = write(format, &model, materials)
                .map_err(|refusal| CliError::refused(format!("{output}: {}", refusal.cause), refusal.cure))?;
            Ok(Texts { scene: written.text, materials: written.materials, remarks })
        }
    }
}

/// Refuses to move a scene away from the files that it includes or names.
fn check_includes(args: &ConvertArgs, scene: &Scene) -> Result<(), CliError> {
    let folder = |path: &Path| path.parent().map(Path::to_owned).unwrap_or_default();
    let names_files =
        |source: &Source| source.included().next().is_some() || source.pictures().next().is_some();
    let includes = scene.source.as_ref().is_some_and(names_files);
    let moves = args.scene.path().is_some_and(|path| folder(path) != folder(&args.output));
    let output = args.output.display();
    match includes && moves {
        false => Ok(()),
        true => Err(CliError::refused(
            format!("{output}: the scene includes files or names pictures beside it"),
            "write it into the folder of the scene",
        )),
    }
}
