//! A page to walk through a scene in a browser.

use std::path::Path;

use radiosity_output::documents::viewer::{FirstViewSettings, automatic_exposure, texels, write_viewer};
use radiosity_reading::exposure::Exposure;
use radiosity_reading::pictures::lightmap::Lightmap;
use radiosity_reading::pictures::printed_pixels::settings_of_pictures;
use radiosity_reading::pictures::render::usual_read;
use radiosity_reading::reader::ReadMode;
use radiosity_scene::{Material, Scene};
use radiosity_work::ranks::Ranks;

use crate::{
    error::CliError,
    forecast,
    loaded::Loaded,
    output_file::OutputFile,
    read::rough,
    run::{Run, RunArgs},
};

/// Pixels of a picture whose light is reckoned to take as long as that of a texel. Chosen: on small and
/// curved surfaces fewer texels can be interpolated.
const PIXELS: u64 = 2;

/// A page that is to be written.
pub(crate) struct Page<'a> {
    /// Its file as typed.
    pub path: &'a Path,
    pub output: &'a OutputFile,
    /// Its first view.
    pub start: &'a FirstViewSettings,
    /// Words on that; empty for none.
    pub view: &'a str,
}

/// Solves the scene and writes the page of its light, read by `read` or as that takes little time.
pub(crate) fn write(
    loaded: Loaded,
    args: &RunArgs,
    page: &Page<'_>,
    read: Option<ReadMode>,
    ranks: &Ranks,
) -> Result<(), CliError> {
    let Page { path, output, start, view } = *page;
    let scene = loaded.scene();
    let reckoned = Lightmap::sizes(scene, texels(scene.light_groups().len().max(1), scene.bands.len()));
    let reckoned = reckoned.iter().map(|[across, down]| across * down).sum();
    forecast::require_texels(reckoned, scene, &args.method, "choose a file ending in .png", ranks)?;
    let mut run = Run::solve(loaded, args, ranks)?;
    let solution = &run.solved.outcome.solution;
    let parts = solution.groups().len().max(1);
    let texels = texels(parts, solution.bands().len());
    let pixels = PIXELS * (texels * parts) as u64;
    let usual = || usual_read(solution, run.solved.visibility(), pixels, run.time_left());
    let read_by = args.method.read(read).unwrap_or_else(usual);
    let lightmap = run.in_threads(|| Lightmap::new(&run.solved, read_by, texels, &run.work()))?;
    let automatic = automatic_exposure(&run.solved, &lightmap, start);
    output.write(|writer| write_viewer(&run.solved, &lightmap, start, automatic, writer))?;
    let exposure = start.exposure.map_or(automatic, Exposure::fixed);
    let Scene { unit, .. } = &run.solved.scene;
    let exposed = format!("; {}", exposure.told(start.shown.name(unit), unit));
    let notes = [rough(read, read_by), left_out(&run.solved.scene), &exposed, view].concat();
    run.add_exposure(exposure);
    run.check_solution(&settings_of_pictures(read_by))?;
    run.finish(Some(&format!("{}{notes}", path.display())))
}

/// Words on the materials of a scene that a page does not show in full; empty for none.
fn left_out(scene: &Scene) -> &'static str {
    let any = |is: fn(&Material) -> bool| scene.surfaces.iter().any(|surface| is(&surface.material));
    match (any(Material::is_patterned), any(Material::transmits)) {
        (false, false) => "",
        (true, false) => "; once the viewer moves, what varies over surfaces is shown by its mean",
        (false, true) => "; once the viewer moves, light that comes through surfaces is not shown",
        (true, true) => {
            "; once the viewer moves, what varies is shown by its mean, and light that comes through surfaces not at all"
        }
    }
}
