//! `radiosity render`: a picture of a scene.

use std::path::{Path, PathBuf};

use clap::Args;
use radiosity_output::documents::viewer::FirstViewSettings;
use radiosity_output::files::exr_file::write_exr;
use radiosity_output::pictures::wireframe::wireframe;
use radiosity_reading::own_error::OwnError;
use radiosity_reading::pictures::pixel_grid::PixelGrid;
use radiosity_reading::pictures::printed_pixels::{PrintedPixels, settings_of_pictures};
use radiosity_reading::pictures::raster::Raster;
use radiosity_reading::pictures::render::{ACCURACY_OF_PREVIEWS, PictureRequest, white_balance};
use radiosity_reading::pictures::seen_surfaces::SeenSurfaces;
use radiosity_reading::quality::Quality;
use radiosity_reading::quantity::Quantity;
use radiosity_reading::reader::ReadMode;
use radiosity_request::aim::AccuracyOf;
use radiosity_request::check_aim;
use radiosity_request::picture::{SAMPLES, pixels, require_pixels, sized};
use radiosity_request::view::{View, ViewRequest};
use radiosity_scene::{Camera, Scene};
use radiosity_solve::solution::Solution;
use radiosity_solve::studies::adaptation::{Goal, importance};
use radiosity_visibility::Visibility;
use radiosity_work::ranks::Ranks;

use crate::{
    aim::goal,
    bake::Bake,
    error::CliError,
    loaded::Loaded,
    numbers::counts,
    options::{PARAMETER_OR_GROUP, SCENE_OR_SOLUTION, SceneArg},
    page::{self, Page},
    run::{Run, RunArgs},
    style::{PictureFormat, Style, StyleArgs, StyledPicture},
};

/// Pixels of a preview. Measured in a classroom of 5800 surfaces and a soda shop of 1700: previews took 2.6 and 0.9 s
/// of a core, with 96 × 72 pixels 2.3 s in the classroom.
const PREVIEW_PIXELS: f64 = 128.0 * 96.0;

/// A summary's words on a preview.
const PREVIEW: &str = " (a preview: light from lamps recomputed, all other light as polynomials: without --preview \
                       the picture is finer, and takes longer)";

/// Solves a scene and takes a picture through its camera
#[derive(Debug, Args)]
#[command(mut_arg("scene", |scene| scene.help(SCENE_OR_SOLUTION)), mut_arg("settings", |set| set.help(PARAMETER_OR_GROUP)), after_help = "Examples:\n  radiosity render cornell-box --order 5 --size 800x800 -o box.png\n  radiosity render cornell-box -o box.html\n  radiosity render cornell-box -o box.glb")]
pub(crate) struct RenderArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArg,

    /// File of the picture: .png, or .exr for the values as they are, in the scene's unit; .html, one file to
    /// walk through in a browser; or .glb, the surfaces with their light in a texture, and an .exr of the
    /// same texels as they are beside it [default: SCENE.png]
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,

    /// Pixels across and down [default: as the scene's camera says]; of a .glb about so many texels in all,
    /// more where small surfaces are many: each has 2 × 2 at the least, a curved one 9 × 9 [default:
    /// 1024x1024]
    #[arg(long, value_name = "WxH", value_parser = counts)]
    pub(crate) size: Option<[u32; 2]>,

    /// Camera rays along each side of a pixel, about: S² + 1 in all, on a square grid that is turned [default: 3]
    #[arg(long, value_name = "S", value_parser = clap::value_parser!(u32).range(1..=64))]
    pub(crate) samples: Option<u32>,

    /// Light that the picture shows [default: gather; of .html and .glb direct where that would take two threads more
    /// than some ten seconds]
    #[arg(long, value_name = "MODE")]
    pub(crate) read: Option<ReadMode>,

    /// Shows, instead of light, how much the light that leaves each place is worth to what --for names: its
    /// mean irradiance is the integral of this times the exitance (1/area)
    #[arg(long, conflicts_with_all = ["read", "show", "difference"])]
    pub(crate) importance: bool,

    /// A picture within a second or two, of rooms of 6000 surfaces in three, to look around: a draft of few pixels,
    /// with light from lamps recomputed at these and all other light as polynomials: as --quality quick --read direct
    /// --samples 1; other qualities, sizes and samples go before it. Its error is told as that of any picture
    #[arg(long, conflicts_with_all = ["importance", "accuracy", "read", "shots"])]
    pub(crate) preview: bool,

    #[command(flatten)]
    pub(crate) view: ViewRequest,

    #[command(flatten)]
    pub(crate) style: StyleArgs,

    #[command(flatten)]
    pub(crate) run: RunArgs,
}

/// Solves the scene and writes a picture of it, seen through its camera.
///
/// `view` has words on that, where it was chosen.
pub(crate) fn run(
    args: &RenderArgs,
    loaded: Loaded,
    view: Option<String>,
    ranks: &Ranks,
) -> Result<(), CliError> {
    let view = view.map_or_else(String::new, |view| format!("; {view}"));
    let path = args.output.clone().unwrap_or_else(|| format!("{}.png", loaded.scene().name).into());
    check_aim(args.read, &args.run.method)?;
    let kind = args.style.kind(&path)?;
    if args.preview && matches!(kind, PictureFormat::Glb | PictureFormat::Html) {
        return Err(CliError::refused(
            format!("{}: previews are pictures of one view", path.display()),
            "leave out --preview, or choose a file ending in .png",
        ));
    }
    if kind == PictureFormat::Glb {
        return args.bake(&path, &view)?.run(loaded, ranks);
    }
    let output = loaded.reserve(&path, &args.run.report, ranks)?;
    let camera = args.camera(loaded.scene());
    if kind == PictureFormat::Html {
        let start = args.start(loaded.scene(), camera)?;
        let page = Page { path: &path, output: &output, start: &start, view: &view };
        return page::write(loaded, &args.run, &page, args.read, ranks);
    }
    require_pixels(&camera, loaded.scene(), args.run.method.memory, ranks)?;
    let [quantity, unit] = args.shown(loaded.scene());
    let mut style = args.style.prepare(loaded.scene(), &camera, quantity, unit, ranks)?;
    let wanted = args.wanted(loaded.scene(), ranks)?;
    let mut run = Run::solve(loaded, &args.run, ranks)?;
    let found = &run.solved.outcome.solution;
    let worth = wanted.map(|goal| importance(found, run.solved.visibility(), &goal, run.threads, ranks));
    let worth = worth.transpose()?;
    let solution = worth.as_ref().unwrap_or(found);
    let shot = args.shot(&run, solution, &camera, &mut style, ranks)?;
    let mut written = format!("{}{}", path.display(), shot.way.note());
    if kind == PictureFormat::Exr {
        let [quantity, unit] = args.shown(&run.solved.scene);
        output.write(|writer| write_exr(&shot.raster, [&quantity, &unit], writer))?;
    } else {
        let Shot { raster, borders, seen_surfaces, .. } = &shot;
        let balance = white_balance(solution);
        let StyledPicture { picture, told, exposure } =
            style.picture(raster, balance, borders.as_deref(), seen_surfaces.as_ref())?;
        written += &told;
        output.write(|writer| picture.write_png(writer))?;
        exposure.into_iter().for_each(|exposure| run.add_exposure(exposure));
    }
    if !args.importance {
        args.check(&mut run, &shot, &camera)?;
    }
    written += &view;
    run.finish(Some(&written))
}

/// A way of taking a picture.
#[derive(Clone, Copy)]
struct Way {
    read: ReadMode,
    /// Camera rays along each side of a pixel.
    samples: u32,
    /// Whether recomputed light has the accuracy of previews.
    is_rough: bool,
    /// Whether another way was asked for, and time was short.
    is_hurried: bool,
}

impl Way {
    /// A way of less time than usual pictures take.
    const fn hurried(read: ReadMode) -> Self {
        Self { read, samples: 1, is_rough: true, is_hurried: true }
    }

    /// A summary's words on it.
    fn note(&self) -> &'static str {
        match (self.is_rough, self.is_hurried, self.read) {
            (_, true, ReadMode::Basis) => {
                " (time was short: light as polynomials: a longer --time-limit shows shadows and edges)"
            }
            (_, true, _) => {
                " (time was short: light from lamps recomputed, all other light as polynomials: a longer --time-limit is \
                 finer)"
            }
            (true, false, _) => PREVIEW,
            (false, false, _) => "",
        }
    }
}

/// A picture as the camera takes it.
struct Shot {
    way: Way,
    raster: Raster,
    /// Borders of elements, where they are drawn.
    borders: Option<Vec<f64>>,
    /// Surfaces that each pixel sees, where false colours name them.
    seen_surfaces: Option<SeenSurfaces>,
}

impl RenderArgs {
    /// Takes the settings of a preview, if it is one, where no others were asked for.
    pub(crate) fn set_preview(&mut self) {
        if self.preview {
            self.run.method.quality.get_or_insert(Quality::Quick);
            self.read = Some(ReadMode::Direct);
            self.samples.get_or_insert(1);
        }
    }

    /// The camera with the pixels that were asked for; of a preview the usual ones, no more than are quick.
    fn camera(&self, scene: &Scene) -> Camera {
        let camera = sized(View::usual(scene).camera, self.size);
        let share = (PREVIEW_PIXELS / pixels(&camera) as f64).sqrt();
        if !self.preview || self.size.is_some() || share >= 1.0 {
            return camera;
        }
        let [width, height] =
            [camera.width, camera.height].map(|count| ((share * f64::from(count)).round() as u32).max(1));
        Camera { width, height, ..camera }
    }

    /// Takes the picture of `solution`, and the one that `style` compares it with.
    fn shot(
        &self,
        run: &Run,
        solution: &Solution,
        camera: &Camera,
        style: &mut Style<'_>,
        ranks: &Ranks,
    ) -> Result<Shot, CliError> {
        let visibility = run.solved.visibility();
        let way = run.in_threads(|| self.way(run, solution, camera))?;
        let samples = way.samples;
        let take = |solution: &Solution, visibility: &Visibility| {
            self.request(&way, solution, visibility, camera).picture(&run.work())
        };
        run.in_threads(|| {
            style.take_other(|other| take(&other.outcome.solution, other.visibility()));
            let borders = || wireframe(solution.elements(), visibility, camera, samples, ranks);
            let seen_surfaces = || {
                SeenSurfaces::through(camera, &PixelGrid::new(samples), &run.solved.scene, visibility, ranks)
            };
            let borders = self.style.wireframe.then(borders);
            let seen_surfaces = self.style.false_colour.then(seen_surfaces);
            Shot { way, raster: take(solution, visibility), borders, seen_surfaces }
        })
    }

    /// The way in which the picture is taken: the one that was asked for, or, where time is limited, the best that is
    /// done in time by its forecast.
    fn way(&self, run: &Run, solution: &Solution, camera: &Camera) -> Way {
        let read = if self.importance {
            ReadMode::Basis
        } else {
            self.run.method.read(self.read).unwrap_or(ReadMode::Gather)
        };
        let asked = Way { read, samples: self.samples(), is_rough: self.preview, is_hurried: false };
        // A wanted accuracy counts more than the time.
        let is_bound = read == ReadMode::Basis || self.run.method.wanted_accuracy().is_some();
        let Some(left) = run.allowance().filter(|_| !is_bound) else { return asked };
        let fits = |way: &Way| {
            let request = self.request(way, solution, run.solved.visibility(), camera);
            left.suffices(request.seconds(&run.work()))
        };
        let basis = Way::hurried(ReadMode::Basis);
        [asked, Way::hurried(ReadMode::Direct)].into_iter().find(fits).unwrap_or(basis)
    }

    /// The request for the picture of a solution.
    fn request<'a>(
        &self,
        way: &Way,
        solution: &'a Solution,
        visibility: &'a Visibility,
        camera: &'a Camera,
    ) -> PictureRequest<'a> {
        let Way { read, samples, is_rough, .. } = *way;
        let shown = self.shown_quantity();
        PictureRequest { solution, visibility, camera, samples, read, shown, is_preview: is_rough }
    }

    /// The quantity that the pixels hold.
    fn shown_quantity(&self) -> Quantity {
        if self.importance { Quantity::Irradiance } else { self.style.show }
    }

    /// Checks a picture of radiosity by its pixels, one of irradiance by points of surfaces.
    fn check(&self, run: &mut Run, shot: &Shot, camera: &Camera) -> Result<(), CliError> {
        let mut settings = settings_of_pictures(shot.way.read);
        if shot.way.is_rough {
            settings.eps = ACCURACY_OF_PREVIEWS;
        }
        if self.style.show == Quantity::Irradiance {
            return run.check_solution(&settings);
        }
        let (scene, own) = (&run.solved.scene, OwnError::of(&run.solved, &settings));
        let pixels = PrintedPixels::of(&shot.raster, camera, scene, run.solved.visibility(), own);
        let seconds = run.seconds_to_read(&settings, pixels.gathered_points());
        let checked = run.check(pixels.count(), |number| pixels.reading(number), seconds)?;
        run.add_checked(checked.map(|own| own.checked), settings.read);
        Ok(())
    }

    /// The light in textures instead of a picture.
    fn bake<'a>(&'a self, path: &'a Path, view: &'a str) -> Result<Bake<'a>, CliError> {
        let Self { size, samples, read, importance, style, run, .. } = self;
        let refuse = |reason: &str, option: &str| {
            Err(CliError::refused(
                format!("{}: {reason}", path.display()),
                format!("leave out {option}, or choose a file ending in .png"),
            ))
        };
        if *importance {
            return refuse("textures hold light, not its importance", "--importance");
        }
        if samples.is_some() {
            return refuse("light is read at the middles of texels, and --samples counts rays", "--samples");
        }
        Ok(Bake { path, view, size: *size, read: *read, style, args: run })
    }

    /// Camera rays along each side of a pixel.
    fn samples(&self) -> u32 {
        self.samples.unwrap_or(SAMPLES)
    }

    /// The quantity that the picture shows and its unit.
    fn shown(&self, scene: &Scene) -> [String; 2] {
        match self.importance {
            true => ["importance".to_owned(), "1/area".to_owned()],
            false => [self.style.show.name(&scene.unit).to_owned(), scene.unit.clone()],
        }
    }

    /// The first view of a page.
    fn start(&self, scene: &Scene, camera: Camera) -> Result<FirstViewSettings, CliError> {
        if self.importance {
            return Err(CliError::refused(
                "--importance: a page to walk through shows light",
                "leave out --importance, or choose a file ending in .png",
            ));
        }
        self.style.start(scene, camera, self.samples())
    }

    /// The goal to which light is worth something, where its importance is shown.
    fn wanted(&self, scene: &Scene, ranks: &Ranks) -> Result<Option<Goal>, CliError> {
        let of = self.run.method.aim.as_ref().unwrap_or(&AccuracyOf::Gathered);
        // No accuracy follows from the sensors alone; any stands for none.
        self.importance.then(|| goal(of, 1.0, scene, ranks)).transpose()
    }
}
