//! `radiosity render -o room.glb`: the scene with its light in textures, for Blender and viewers.

use std::path::Path;

use radiosity_geom::{Aabb, Rect};
use radiosity_output::drawings::picture::Picture;
use radiosity_output::files::exr_file::write_exr;
use radiosity_output::files::glb::{BakedScene, texture_size};
use radiosity_output::pictures::image::Image;
use radiosity_output::pictures::lightmap_view::lightmap_view;
use radiosity_output::pictures::tessellation::tessellation;
use radiosity_reading::exposure::Exposure;
use radiosity_reading::pictures::lightmap::Lightmap;
use radiosity_reading::pictures::pixel_grid::PixelGrid;
use radiosity_reading::pictures::printed_pixels::settings_of_pictures;
use radiosity_reading::pictures::render::{usual_read, white_balance};
use radiosity_reading::reader::ReadMode;
use radiosity_request::picture::SAMPLES;
use radiosity_request::view::View;
use radiosity_scene::Scene;
use radiosity_solve::solved::Solved;
use radiosity_work::ranks::Ranks;
use serde_json::{Value, json};

use crate::{
    error::CliError,
    exposure::TypedExposure,
    forecast,
    loaded::Loaded,
    read::rough,
    run::{Run, RunArgs},
    style::StyleArgs,
};

/// Texels across and down, unless told otherwise.
const SIZE: [u32; 2] = [1024, 1024];

/// Distance of triangles from a curved surface, over the diagonal of the scene. Chosen: half a pixel of a
/// picture of the whole.
const NEAR: f64 = 5e-4;

/// A scene with its light to be written as a file, with the options.
#[derive(Debug)]
pub(crate) struct Bake<'a> {
    /// Path of the .glb file.
    pub(crate) path: &'a Path,
    /// Words on the view that it is exposed for; empty for none.
    pub(crate) view: &'a str,
    /// The number of texels, as that of a picture.
    pub(crate) size: Option<[u32; 2]>,
    /// Source of the light.
    pub(crate) read: Option<ReadMode>,
    pub(crate) style: &'a StyleArgs,
    pub(crate) args: &'a RunArgs,
}

impl Bake<'_> {
    /// Solves the scene and writes it with its light; the light as it is goes to an .exr beside it.
    pub(crate) fn run(&self, loaded: Loaded, ranks: &Ranks) -> Result<(), CliError> {
        let beside = self.path.with_extension("exr");
        let report = &self.args.report;
        let output = loaded.reserve(self.path, report, ranks)?;
        let linear = loaded.reserve(&beside, report, ranks)?.apart_from(Some(self.path), "the triangles")?;
        let [across, down] = self.size.unwrap_or(SIZE);
        let texels = u64::from(across) * u64::from(down);
        let [width, height] = texture_size(Lightmap::sizes(loaded.scene(), texels as usize));
        let less = "ask for fewer with --size";
        forecast::require_texels(width * height, loaded.scene(), &self.args.method, less, ranks)?;
        let mut run = Run::solve(loaded, self.args, ranks)?;
        let (scene, solution) = (&run.solved.scene, &run.solved.outcome.solution);
        let usual = || usual_read(solution, run.solved.visibility(), texels, run.time_left());
        let read = self.args.method.read(self.read).unwrap_or_else(usual);
        let (triangles, lightmap) = run.in_threads(|| {
            let lightmap = Lightmap::new(&run.solved, read, texels as usize, &run.work());
            (tessellation(scene, NEAR * diagonal(scene)), lightmap)
        })?;
        let baked = BakedScene::new(scene, &triangles, &lightmap, self.style.show);
        let exposure = TypedExposure::fixed(self.style.exposure).unwrap_or_else(|| {
            let view = lightmap_view(
                &run.solved,
                &lightmap,
                &View::usual(scene).camera,
                &PixelGrid::new(SAMPLES),
                self.style.show,
            );
            Image::new(&view, white_balance(solution)).automatic_exposure()
        });
        let (picture, about) = self.coloured(&baked, exposure, &run.solved, &beside);
        // Both are written before one is put in place: they belong together.
        let linear = linear.pending(|writer| write_exr(baked.raster(), self.shown(scene), writer))?;
        output.pending(|writer| baked.write(&picture, &about, writer))?.put()?;
        linear.put()?;
        let [width, height] = baked.raster().size();
        let figures = format!("{} triangles, texture of {width} × {height}", baked.triangles());
        let [quantity, unit] = self.shown(scene);
        let note = format!("{}; {}{}", rough(self.read, read), exposure.told(quantity, unit), self.view);
        run.add_exposure(exposure);
        run.check_solution(&settings_of_pictures(read))?;
        let files = [self.path, &beside].map(Path::display);
        run.finish(Some(&format!("{} ({figures}) and {}{note}", files[0], files[1])))
    }

    /// The texture in colours, and the remarks on it in the file; `beside` is the file of the light as it is.
    fn coloured(
        &self,
        baked: &BakedScene,
        exposure: Exposure,
        solved: &Solved,
        beside: &Path,
    ) -> (Picture, Value) {
        let (scene, balance) = (&solved.scene, white_balance(&solved.outcome.solution));
        let [quantity, unit] = self.shown(scene);
        let about = json!({
            "quantity": quantity, "unit": unit, "bands": scene.bands,
            "exposure": exposure.factor(), "exposure_ev": exposure.ev(), "white_balance": balance,
            "linear": beside.file_name().map(|name| name.to_string_lossy()),
        });
        (Image::new(baked.raster(), balance).exposed(exposure), about)
    }

    /// The quantity that the textures hold, and its unit.
    fn shown<'a>(&self, scene: &'a Scene) -> [&'a str; 2] {
        [self.style.show.name(&scene.unit), &scene.unit]
    }
}

/// Diagonal of the box around a scene (scene length).
fn diagonal(scene: &Scene) -> f64 {
    let shapes = scene.surfaces.iter().map(|surface| &surface.shape);
    shapes.fold(Aabb::EMPTY, |bounds, shape| bounds.union(shape.bounds(&Rect::FULL))).diagonal()
}
