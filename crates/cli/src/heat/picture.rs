//! Pictures of temperatures.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use radiosity_heat::{Heat, kelvin};
use radiosity_output::drawings::false_colour::false_colour;
use radiosity_output::drawings::picture::Picture;
use radiosity_reading::pictures::pixel_grid::PixelGrid;
use radiosity_reading::pictures::render::PictureRequest;
use radiosity_reading::pictures::seen_surfaces::SeenSurfaces;
use radiosity_reading::quantity::Quantity;
use radiosity_reading::reader::ReadMode;
use radiosity_request::picture::{SAMPLES, sized};
use radiosity_request::view::View;
use radiosity_scene::{Camera, Scene};
use radiosity_visibility::Visibility;
use radiosity_work::Work;

use crate::{
    colours::ColourArgs,
    error::CliError,
    format::{self, PictureFormat},
    numbers::counts,
    output_file::OutputFile,
    style::with_legend,
};

/// `--picture` and how it looks.
#[derive(Debug, Args)]
#[command(next_help_heading = "Picture")]
pub(crate) struct PictureArgs {
    /// Picture through the scene's camera in false colours, .png
    #[arg(long, value_name = "FILE")]
    pub(crate) picture: Option<PathBuf>,

    /// The quantity that it shows
    #[arg(long, value_name = "QUANTITY", default_value = "temperature", requires = "picture")]
    show: HeatQuantity,

    /// Pixels across and down [default: as the scene's camera says]
    #[arg(long, value_name = "WxH", requires = "picture", value_parser = counts)]
    size: Option<[u32; 2]>,

    #[command(flatten)]
    colours: ColourArgs,
}

/// The quantity of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum HeatQuantity {
    /// Temperature, K
    Temperature,
    /// σT⁴, what a black surface of that temperature emits, W/m²
    Exitance,
}

/// A picture about to be taken.
pub(crate) struct HeatPicture<'a> {
    args: &'a PictureArgs,
    camera: Camera,
    /// Words on its view, where it was chosen.
    pub(crate) told: Option<String>,
    pub(crate) file: OutputFile,
}

impl PictureArgs {
    /// The picture, if one is wanted; `reserve` opens its file.
    pub(crate) fn wanted(
        &self,
        scene: &Scene,
        reserve: impl FnOnce(&Path) -> Result<OutputFile, CliError>,
    ) -> Result<Option<HeatPicture<'_>>, CliError> {
        self.colours.require_picture(self.picture.is_some())?;
        let Some(path) = &self.picture else { return Ok(None) };
        if self.colours.band.is_some() {
            return Err(CliError::refused("--band: heat is of all wavelengths together", "leave it out"));
        }
        self.colours.check()?;
        format::of_file::<PictureFormat>(path)?;
        let View { camera, told } = View::usual(scene);
        Ok(Some(HeatPicture { args: self, camera: sized(camera, self.size), told, file: reserve(path)? }))
    }
}

impl HeatPicture<'_> {
    /// The picture of this balance.
    pub(crate) fn take(
        &self,
        scene: &Scene,
        visibility: &Visibility,
        heat: &Heat,
        work: &Work<'_>,
    ) -> Picture {
        let PictureArgs { show, colours, .. } = self.args;
        let levels = heat.levels();
        let (read, shown) = (ReadMode::Basis, Quantity::Radiosity);
        let request = PictureRequest {
            solution: &levels,
            visibility,
            camera: &self.camera,
            samples: SAMPLES,
            read,
            shown,
            is_preview: false,
        };
        let raster = request.picture(work);
        let (field, title) = match show {
            HeatQuantity::Temperature => (raster.field(None).map(kelvin), ["temperature", "K"]),
            HeatQuantity::Exitance => (raster.field(None), ["σT⁴", "W/m²"]),
        };
        // No surface is left out of the range for its light.
        let mut dark = scene.clone();
        dark.surfaces.iter_mut().for_each(|surface| surface.material.emission.fill(0.0));
        let grid = PixelGrid::new(SAMPLES);
        let seen_surfaces = SeenSurfaces::through(&self.camera, &grid, &dark, visibility, work.ranks);
        let usual = field.usual_range().unwrap_or_default();
        let colours = match show {
            HeatQuantity::Temperature => colours.colours_between(usual),
            HeatQuantity::Exitance => colours.colours(usual),
        };
        let picture = false_colour(&field, &colours.scale);
        with_legend(&colours, picture, &field, &seen_surfaces, title.map(str::to_owned).to_vec())
    }
}
