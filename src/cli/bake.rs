//! `radiosity render -o room.glb`: the scene with its light in textures, for Blender and viewers.

use std::path::Path;

use radiosity::output::exr_file::write_exr;
use radiosity::output::glb::Baked;
use radiosity::output::image::Image;
use radiosity::output::lightmap::Lightmap;
use radiosity::output::reader::Read;
use radiosity::output::render::{usual_read, white_balance};
use radiosity::output::tessellation::tessellation;
use radiosity::output::tone::Tone;
use radiosity_geom::{Aabb, Rect};
use serde_json::json;

use crate::cli::{
    error::CliError,
    numbers::Counts,
    options::{MethodArgs, ReportArgs},
    progress::Progress,
    run::{Loaded, Run},
    style::StyleArgs,
};

/// Texels across and down, unless told otherwise.
const SIZE: [u32; 2] = [1024, 1024];

/// Distance of triangles from a curved surface, over the diagonal of the scene. Chosen: half a pixel of a picture of the whole.
const NEAR: f64 = 5e-4;

/// What is baked, and how.
#[derive(Debug)]
pub(crate) struct Bake<'a> {
    /// The file.
    pub(crate) path: &'a Path,
    /// The number of texels, as that of a picture.
    pub(crate) size: Option<Counts>,
    /// What the light is read from.
    pub(crate) read: Option<Read>,
    pub(crate) style: &'a StyleArgs,
    pub(crate) method: &'a MethodArgs,
    pub(crate) report: &'a ReportArgs,
}

impl Bake<'_> {
    /// Solves the scene and writes it with its light; the light as it is goes to an .exr beside it.
    pub(crate) fn run(&self, loaded: Loaded) -> Result<(), CliError> {
        let beside = self.path.with_extension("exr");
        let output = loaded.reserve(self.path, self.report)?;
        let linear = loaded.reserve(&beside, self.report)?.apart_from(self.path, "the triangles")?;
        let progress = Progress::new(self.report.quiet);
        let run = Run::solve(loaded, self.method, self.report, &progress)?;
        let (scene, solution) = (&run.solved.scene, &run.solved.outcome.solution);
        let [across, down] = self.size.map_or(SIZE, |Counts(size)| size);
        let texels = u64::from(across) * u64::from(down);
        let read =
            self.read.unwrap_or_else(|| usual_read(solution, run.solved.visibility(), texels, run.threads()));
        let show = |done, all| progress.show("light map", done, all);
        let (triangles, lightmap) = run.in_threads(|| {
            let shapes = scene.surfaces.iter().map(|surface| &surface.shape);
            let bounds = shapes.fold(Aabb::EMPTY, |bounds, shape| bounds.union(shape.bounds(&Rect::FULL)));
            let triangles = tessellation(scene, NEAR * bounds.diagonal());
            (triangles, Lightmap::new(&run.solved, read, texels as usize, &show))
        })?;
        let baked = Baked::new(scene, &triangles, &lightmap, self.style.show);
        let image = Image::new(baked.raster(), white_balance(solution));
        let (exposure, tone) = match self.style.exposure {
            Some(exposure) => (exposure, Tone::Linear),
            None => (image.automatic_exposure(), Tone::Shoulder),
        };
        let about = json!({
            "quantity": self.style.show.name(&scene.unit), "unit": scene.unit, "bands": scene.bands,
            "exposure": exposure, "white_balance": white_balance(solution),
            "linear": beside.file_name().map(|name| name.to_string_lossy()),
        });
        linear.write(|writer| write_exr(baked.raster(), writer))?;
        output.write(|writer| baked.write(&image.exposed(exposure, tone), &about, writer))?;
        let [width, height] = baked.raster().size();
        let figures = format!("{} triangles, texture of {width} × {height}", baked.triangles());
        let written =
            format!("{} ({figures}) and {}, its light as it is", self.path.display(), beside.display());
        run.finish(progress, Some(&written))
    }
}
