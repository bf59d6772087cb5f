//! Styles of a picture: a photograph, false colours, a difference, with wires.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use radiosity_output::documents::viewer::{FirstViewColours, FirstViewSettings};
use radiosity_output::drawings::false_colour::{FalseColours, false_colour};
use radiosity_output::drawings::legend::Legend;
use radiosity_output::drawings::nice_numbers::round_above;
use radiosity_output::drawings::picture::Picture;
use radiosity_output::drawings::scale::Scale;
use radiosity_output::files::exr_file::read_exr;
use radiosity_output::pictures::image::Image;
use radiosity_reading::difference::Difference;
use radiosity_reading::exposure::Exposure;
use radiosity_reading::field::Field;
use radiosity_reading::pictures::pixel_grid::PixelGrid;
use radiosity_reading::pictures::raster::Raster;
use radiosity_reading::pictures::seen_surfaces::SeenSurfaces;
use radiosity_reading::quantity::{Quantity, band_name};
use radiosity_scene::{Camera, Scene};
use radiosity_solve::solved::Solved;
use radiosity_work::digits::three_digits;
use radiosity_work::ranks::Ranks;

use crate::{
    colours::ColourArgs,
    error::CliError,
    exposure::{EXPOSURE, TypedExposure},
    format, reference,
};

/// How a picture looks.
#[derive(Debug, Args)]
#[command(next_help_heading = "Style")]
pub(crate) struct StyleArgs {
    /// Exposure: a factor on the values before they become colours, or exposure values such as -6.5EV, log₂ of
    /// it, both in proportion up to white; or auto, which lets the brightest fiftieth of what is seen and does
    /// not emit be white, with a soft approach to it [default: auto]
    #[arg(long, value_name = "auto|X|nEV", allow_hyphen_values = true, conflicts_with_all = ["false_colour", "difference"])]
    pub(crate) exposure: Option<TypedExposure>,

    /// Shows numbers in false colours, with a legend in the scene's unit
    #[arg(long, alias = "false-color")]
    pub(crate) false_colour: bool,

    /// Shows by how much the picture differs from that of a solution file, or from an .exr of equal size, in
    /// %
    #[arg(long, value_name = "FILE", conflicts_with = "false_colour")]
    pub(crate) difference: Option<PathBuf>,

    /// Draws the borders of the elements
    #[arg(long)]
    pub(crate) wireframe: bool,

    /// The quantity that is shown
    #[arg(long, value_name = "QUANTITY", default_value = "radiosity")]
    pub(crate) show: Quantity,

    #[command(flatten)]
    pub(crate) colours: ColourArgs,
}

/// File format of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum PictureFormat {
    /// 8-bit colours.
    Png,
    /// Values as they are, in 32 bits.
    Exr,
    /// The surfaces with their light in textures.
    Glb,
    /// A page to walk through.
    Html,
}

/// A picture in its style.
#[derive(Debug)]
pub(crate) struct StyledPicture {
    pub(crate) picture: Picture,
    /// The message to print after the picture's name.
    pub(crate) told: String,
    /// Its exposure, where it is a photograph.
    pub(crate) exposure: Option<Exposure>,
}

/// A style with its band and its other picture.
#[derive(Debug)]
pub(crate) struct Style<'a> {
    args: &'a StyleArgs,
    band: Option<usize>,
    /// The quantity, the band, the unit.
    title: Vec<String>,
    /// The band's name, or how several bands become one.
    band_name: Option<String>,
    other: Option<Other>,
}

/// The picture or solution that a picture is compared with.
#[derive(Debug)]
enum Other {
    /// A picture that was read from a file.
    Taken(Raster),
    /// A solution to take the same picture of.
    Solved(Box<Solved>),
}

impl StyleArgs {
    /// The kind that the ending of `path` names.
    pub(crate) fn kind(&self, path: &Path) -> Result<PictureFormat, CliError> {
        let cure = "choose a file ending in .png (colours), .exr (values), .html (to walk through) or .glb (surfaces with \
                    their light)";
        let kind = format::of_kind(path, "kind of picture", cure)?;
        let drawn = self.false_colour || self.wireframe || self.difference.is_some();
        match kind {
            PictureFormat::Exr if drawn || self.exposure.is_some() => Err(CliError::refused(
                format!("{}: an .exr holds the values and nothing else", path.display()),
                "leave out the options of style, or choose a file ending in .png",
            )),
            PictureFormat::Glb => {
                let drawn = ["--false-colour", "--wireframe", "--difference"];
                let of_colours = ["--range", "--band", "--log", "--isolines"];
                let unfit = [&drawn[..], &of_colours].concat();
                self.require_none(path, &unfit, "a .glb holds textures of light, for which there is")
            }
            PictureFormat::Html => {
                let unfit = ["--wireframe", "--difference", "--isolines"];
                self.require_none(path, &unfit, "a page to walk through has")
            }
            PictureFormat::Png | PictureFormat::Exr => Ok(()),
        }?;
        Ok(kind)
    }

    /// Refuses the first of the options `unfit` that was typed, for a file of which `what` begins to say that
    /// it has none.
    fn require_none(&self, path: &Path, unfit: &[&str], what: &str) -> Result<(), CliError> {
        let drawn = [
            ("--false-colour", self.false_colour),
            ("--wireframe", self.wireframe),
            ("--difference", self.difference.is_some()),
        ];
        let drawn = drawn.into_iter().filter(|(_, typed)| *typed).map(|(option, _)| option);
        match drawn.chain(self.colours.typed()).find(|option| unfit.contains(option)) {
            Some(option) => Err(CliError::refused(
                format!("{}: {what} no {option}", path.display()),
                format!("leave out {option}, or choose a file ending in .png"),
            )),
            None => Ok(()),
        }
    }

    /// The first view of a page through `camera`, with so many samples along each side of a pixel.
    pub(crate) fn start(
        &self,
        scene: &Scene,
        camera: Camera,
        samples: u32,
    ) -> Result<FirstViewSettings, CliError> {
        self.check_colours()?;
        self.colours.check()?;
        let ColourArgs { range, log, .. } = &self.colours;
        let colours = FirstViewColours { band: self.colours.band(scene)?, range: *range, log: *log };
        let false_colours = self.false_colour.then_some(colours);
        let exposure = TypedExposure::fixed(self.exposure).map(|exposure| exposure.factor());
        Ok(FirstViewSettings {
            camera,
            grid: PixelGrid::new(samples),
            exposure,
            shown: self.show,
            false_colours,
        })
    }

    /// Finds the band and reads the other picture of a quantity in this unit, before the work.
    pub(crate) fn prepare(
        &self,
        scene: &Scene,
        camera: &Camera,
        quantity: String,
        unit: String,
        ranks: &Ranks,
    ) -> Result<Style<'_>, CliError> {
        self.check_colours()?;
        self.colours.check()?;
        let band = self.colours.band(scene)?;
        let band_name = band_name(&scene.bands, band);
        let title = [quantity].into_iter().chain(band_name.clone()).chain([unit]).collect();
        let other = self.difference.as_deref().map(|path| other(path, scene, camera, ranks)).transpose()?;
        Ok(Style { args: self, band, title, band_name, other })
    }

    /// Refuses options of colours where there are none.
    fn check_colours(&self) -> Result<(), CliError> {
        let typed = self.colours.typed();
        let (unfit, message, cure) = match (self.false_colour, &self.difference) {
            (true, _) => return Ok(()),
            (false, Some(_)) => (
                &["--log", "--isolines"][..],
                "false colours",
                "choose --false-colour instead of --difference",
            ),
            (false, None) => (
                &["--range", "--band", "--log", "--isolines"][..],
                "false colours and differences",
                "add --false-colour or --difference FILE.exr",
            ),
        };
        if !typed.iter().any(|option| unfit.contains(option)) {
            return Ok(());
        }
        Err(CliError::refused(
            format!("{} speak of {message}", unfit.join(", ")),
            format!("{cure}, or leave them out"),
        ))
    }
}

fn other(path: &Path, scene: &Scene, camera: &Camera, ranks: &Ranks) -> Result<Other, CliError> {
    if path.extension().is_none_or(|ending| !ending.eq_ignore_ascii_case("exr")) {
        return Ok(Other::Solved(Box::new(reference::solution(path, scene, ranks)?)));
    }
    let refused =
        |reason: String, cure: &str| CliError::refused(format!("{}: {reason}", path.display()), cure);
    let cure = "give a picture of this scene that `radiosity render -o FILE.exr` wrote";
    let file = std::fs::File::open(path).map_err(|error| refused(error.to_string(), cure))?;
    let raster = read_exr(std::io::BufReader::new(file), &scene.bands);
    let raster = raster.map_err(|error| refused(error.to_string(), cure))?;
    let [width, height] = raster.size();
    if [width, height] != [camera.width, camera.height] {
        let reason =
            format!("it has {width}x{height} pixels, the picture {}x{}", camera.width, camera.height);
        return Err(refused(reason, &format!("add --size {width}x{height}")));
    }
    Ok(Other::Taken(raster))
}

impl Style<'_> {
    /// Has `take` take the picture to compare with, if it is that of a solution.
    pub(crate) fn take_other(&mut self, take: impl FnOnce(&Solved) -> Raster) {
        if let Some(Other::Solved(solved)) = &self.other {
            self.other = Some(Other::Taken(take(solved)));
        }
    }

    /// The picture, in false colours where there are `seen_surfaces`.
    pub(crate) fn picture(
        &self,
        raster: &Raster,
        balance: [f64; 3],
        borders: Option<&[f64]>,
        seen_surfaces: Option<&SeenSurfaces>,
    ) -> Result<StyledPicture, CliError> {
        let wired = |mut picture: Picture| {
            if let Some(borders) = borders {
                picture.overlay(borders, raster.size()[0], WIRE);
            }
            picture
        };
        if let Some(Other::Taken(other)) = &self.other {
            return self.difference(&raster.field(self.band), &other.field(self.band), wired);
        }
        if let Some(seen_surfaces) = seen_surfaces {
            let picture = self.false_colours(&raster.field(self.band), seen_surfaces, wired);
            return Ok(StyledPicture { picture, told: String::new(), exposure: None });
        }
        let image = Image::new(raster, balance);
        let exposure = TypedExposure::fixed(self.args.exposure).unwrap_or_else(|| image.automatic_exposure());
        let told = exposure.told(&self.title[0], self.unit());
        let picture = wired(image.exposed(exposure)).with_remark(EXPOSURE, told.clone());
        Ok(StyledPicture { picture, told: format!("; {told}"), exposure: Some(exposure) })
    }

    /// The unit of what is shown.
    fn unit(&self) -> &str {
        self.title.last().map_or("", String::as_str)
    }

    fn false_colours(
        &self,
        field: &Field,
        seen_surfaces: &SeenSurfaces,
        wired: impl Fn(Picture) -> Picture,
    ) -> Picture {
        // Where everything emits, emitters are what there is to see.
        let usual = field.without(seen_surfaces.emitters()).usual_range().or(field.usual_range());
        let colours = self.args.colours.colours(usual.unwrap_or_default());
        with_legend(
            &colours,
            wired(false_colour(field, &colours.scale)),
            field,
            seen_surfaces,
            self.title.clone(),
        )
    }

    fn difference(
        &self,
        field: &Field,
        other: &Field,
        wired: impl Fn(Picture) -> Picture,
    ) -> Result<StyledPicture, CliError> {
        let black = "the picture to compare with is black";
        let difference = Difference::new(field, other)
            .ok_or_else(|| CliError::refused(black, "choose another picture or another band"))?;
        let Difference { field, rms, largest } = &difference;
        let size = round_above(field.usual_size());
        let scale = match self.args.colours.range {
            Some(range) => Scale::diverging(range[0].abs().max(range[1].abs())),
            None => Scale::diverging(size),
        };
        let title = ["difference".to_owned()].into_iter().chain(self.band_name.clone());
        let title = title.chain(["% of mean".to_owned()]).collect();
        let note = vec![format!("rms {rms:.3}"), format!("max {largest:.3}")];
        let picture = Legend { scale: &scale, title, note, levels: Vec::new() }
            .beside(&wired(false_colour(field, &scale)));
        let figures = format!(
            "\ndifference: rms {rms:.4} %, largest {largest:.4} % of the other picture's mean {}",
            self.title[0]
        );
        Ok(StyledPicture { picture, told: figures, exposure: None })
    }
}

/// A picture of `field` in false colours with its isolines, and the legend beside it.
pub(crate) fn with_legend(
    colours: &FalseColours,
    mut picture: Picture,
    field: &Field,
    seen_surfaces: &SeenSurfaces,
    title: Vec<String>,
) -> Picture {
    colours.draw_isolines(&mut picture, field, seen_surfaces.parts());
    let greatest = field.seen().fold(0.0, f64::max);
    let beyond = greatest > colours.scale.range()[1];
    let note = if beyond { vec![format!("max {}", three_digits(greatest))] } else { Vec::new() };
    let levels = colours.isolines.iter().map(|tick| tick.value).collect();
    Legend { scale: &colours.scale, title, note, levels }.beside(&picture)
}

/// Colour of the borders of elements. Chosen.
const WIRE: [u8; 3] = [20, 20, 20];
