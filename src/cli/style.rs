//! How a picture shows what was computed: as a photograph, in false colours, as a difference, with wires.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use clap::Args;
use radiosity::output::difference::Difference;
use radiosity::output::exr_file::read_exr;
use radiosity::output::false_colour::false_colour;
use radiosity::output::field::Field;
use radiosity::output::image::Image;
use radiosity::output::legend::Legend;
use radiosity::output::picture::Picture;
use radiosity::output::raster::Raster;
use radiosity::output::scale::{Scale, round_above};
use radiosity::scene::{Camera, Scene};
use radiosity::solved::Solved;

use crate::cli::{error::CliError, numbers::positive, reference};

/// How a picture looks.
#[derive(Debug, Args)]
#[command(next_help_heading = "Style")]
pub(crate) struct StyleArgs {
    /// Factor on the radiosities before they become colours [default: chosen for the picture]
    #[arg(long, value_name = "X", value_parser = positive, conflicts_with_all = ["false_colour", "difference"])]
    pub(crate) exposure: Option<f64>,

    /// Shows the radiosity in false colours, with a legend in W/m²
    #[arg(long, alias = "false-color")]
    pub(crate) false_colour: bool,

    /// Shows by how much the picture differs from that of a solution file, or from an .exr of equal size, in %
    #[arg(long, value_name = "FILE", conflicts_with = "false_colour")]
    pub(crate) difference: Option<PathBuf>,

    /// Numbers at the ends of the legend [default: chosen for the picture]
    #[arg(long, value_name = "LO,HI", allow_hyphen_values = true)]
    pub(crate) range: Option<Range>,

    /// Band of false colours and differences [default: mean of all]
    #[arg(long, value_name = "NAME")]
    pub(crate) band: Option<String>,

    /// Draws the borders of the elements
    #[arg(long)]
    pub(crate) wireframe: bool,
}

/// `--range`: two numbers that ascend.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Range([f64; 2]);

impl FromStr for Range {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |part: &str| part.trim().parse().ok().filter(|x: &f64| x.is_finite());
        let numbers = text.split_once(',').and_then(|(low, high)| Some([number(low)?, number(high)?]));
        let ascending = numbers.filter(|[low, high]| low < high).map(Range);
        ascending.ok_or_else(|| "expected two numbers that ascend with a comma between, such as 0,2.5".into())
    }
}

/// What kind of file a picture is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// 8-bit colours.
    Png,
    /// Radiosities.
    Exr,
}

/// A style with its band and its other picture.
#[derive(Debug)]
pub(crate) struct Style<'a> {
    args: &'a StyleArgs,
    band: Option<usize>,
    /// The band's name, or how several bands become one.
    band_name: String,
    other: Option<Other>,
}

/// What a picture is compared with.
#[derive(Debug)]
enum Other {
    /// A picture that was read from a file.
    Taken(Raster),
    /// A solution to take the same picture of.
    Solved(Box<Solved>),
}

impl StyleArgs {
    /// The kind that the ending of `path` names.
    pub(crate) fn kind(&self, path: &Path) -> Result<Kind, CliError> {
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        let drawn = self.false_colour || self.wireframe || self.difference.is_some();
        match ending.as_deref() {
            Some("png") => Ok(Kind::Png),
            Some("exr") if drawn || self.exposure.is_some() => Err(CliError::Refused {
                message: format!("{}: an .exr holds the radiosities and nothing else", path.display()),
                cure: "leave out the options of style, or choose a file ending in .png".to_owned(),
            }),
            Some("exr") => Ok(Kind::Exr),
            _ => Err(CliError::Refused {
                message: format!("{}: the ending names no kind of picture", path.display()),
                cure: "choose a file ending in .png (colours) or .exr (radiosities)".to_owned(),
            }),
        }
    }

    /// Finds the band and reads the other picture, before the work.
    pub(crate) fn prepare(&self, scene: &Scene, camera: &Camera) -> Result<Style<'_>, CliError> {
        let coded = self.false_colour || self.difference.is_some();
        if !coded && (self.range.is_some() || self.band.is_some()) {
            return Err(CliError::Refused {
                message: "--range and --band speak of false colours and differences".to_owned(),
                cure: "add --false-colour or --difference FILE.exr, or leave them out".to_owned(),
            });
        }
        let find = |name: &String| {
            scene.bands.iter().position(|band| band == name).ok_or_else(|| CliError::Refused {
                message: format!("{}: there is no band {name:?}", scene.origin),
                cure: format!("bands of this scene: {}", scene.bands.join(", ")),
            })
        };
        let band = self.band.as_ref().map(find).transpose()?;
        let mean = if scene.bands.len() > 1 { "mean of bands".to_owned() } else { scene.bands[0].clone() };
        let band_name = band.map_or(mean, |band| scene.bands[band].clone());
        let other = self.difference.as_deref().map(|path| other(path, scene, camera)).transpose()?;
        Ok(Style { args: self, band, band_name, other })
    }
}

fn other(path: &Path, scene: &Scene, camera: &Camera) -> Result<Other, CliError> {
    if path.extension().is_none_or(|ending| !ending.eq_ignore_ascii_case("exr")) {
        return Ok(Other::Solved(Box::new(reference::solution(path, scene)?)));
    }
    let refused = |reason: String, cure: &str| CliError::Refused {
        message: format!("{}: {reason}", path.display()),
        cure: cure.to_owned(),
    };
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

    /// The picture, and the message to print after its name.
    pub(crate) fn picture(
        &self,
        raster: &Raster,
        balance: [f64; 3],
        borders: Option<&[f64]>,
    ) -> Result<(Picture, String), CliError> {
        let wired = |mut picture: Picture| {
            if let Some(borders) = borders {
                picture.overlay(borders, raster.size()[0], WIRE);
            }
            picture
        };
        if let Some(Other::Taken(other)) = &self.other {
            let (picture, figures) =
                self.difference(&raster.field(self.band), &other.field(self.band), wired)?;
            return Ok((picture, figures));
        }
        if self.args.false_colour {
            return Ok((self.false_colours(&raster.field(self.band), wired), String::new()));
        }
        let image = Image::new(raster, balance);
        let exposure = self.args.exposure.unwrap_or_else(|| image.automatic_exposure());
        Ok((wired(image.exposed(exposure)), String::new()))
    }

    fn false_colours(&self, field: &Field, wired: impl Fn(Picture) -> Picture) -> Picture {
        let range = self.args.range.map_or_else(|| [0.0, round_above(field.usual_size())], |range| range.0);
        let scale = Scale::sequential(range);
        let greatest = field.seen().fold(0.0, f64::max);
        let title = vec!["radiosity".to_owned(), self.band_name.clone(), "W/m²".to_owned()];
        let note = if greatest > range[1] { vec![format!("max {greatest:.3}")] } else { Vec::new() };
        Legend { scale: &scale, title, note }.beside(&wired(false_colour(field, &scale)))
    }

    fn difference(
        &self,
        field: &Field,
        other: &Field,
        wired: impl Fn(Picture) -> Picture,
    ) -> Result<(Picture, String), CliError> {
        let difference = Difference::new(field, other).ok_or_else(|| CliError::Refused {
            message: "the picture to compare with is black".to_owned(),
            cure: "choose another picture or another band".to_owned(),
        })?;
        let Difference { field, rms, largest } = &difference;
        let size = round_above(field.usual_size());
        let scale = match self.args.range {
            Some(Range(range)) => Scale::diverging(range[0].abs().max(range[1].abs())),
            None => Scale::diverging(size),
        };
        let title = vec!["difference".to_owned(), self.band_name.clone(), "% of mean".to_owned()];
        let note = vec![format!("rms {rms:.3}"), format!("max {largest:.3}")];
        let picture = Legend { scale: &scale, title, note }.beside(&wired(false_colour(field, &scale)));
        let figures = format!(
            "\ndifference: rms {rms:.4} %, largest {largest:.4} % of the other picture's mean radiosity"
        );
        Ok((picture, figures))
    }
}

/// Colour of the borders of elements. Chosen.
const WIRE: [u8; 3] = [20, 20, 20];
