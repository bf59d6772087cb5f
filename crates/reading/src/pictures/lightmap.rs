//! Light maps: the irradiance of every surface as a texture.
//!
//! The texture of a surface has W × H texels. Their centres span its whole square of parameters, borders
//! included,
//!
//! ```text
//! u_i = −1 + 2 i/(W − 1) ,     v_j = −1 + 2 j/(H − 1) ,
//! ```
//!
//! so that bilinear interpolation never asks for light beyond the outermost texels: textures that lie side by
//! side in an atlas need no padding. The coordinates of an image in [0, 1], whose texels have their centres
//! at (i + ½)/W, follow as s = (½ + ½(1 + u)(W − 1))/W, and t likewise.
//!
//! A texel outside the outline of a flat surface, in a hole, under a body or a sheet has no light of its own.
//! If a bilinear interpolation inside may ask for it, it takes the light of the nearest open point; every
//! other takes the mean of its neighbours, ring by ring. No dark fringe appears at borders.
//!
//! Irradiance is kept apart by light group, not dimmed, so that with the factors f_g
//!
//! ```text
//! E = Σ_g f_g E_g ,     B = f_own E₀ + ρ E        (unit of exitance)
//! ```
//!
//! Light is read as pictures read it (`frame_light`), and anew where polynomials may miss much of it, as at the foot of
//! a block in whose shadow it stands: the same for any number of threads.

mod sizes;
mod places;
mod fill;

use std::sync::atomic::{AtomicUsize, Ordering};

use radiosity_elements::Elements;
use radiosity_scene::Scene;
use radiosity_solve::solution::Solution;
use radiosity_solve::solution::group_light::GroupLight;
use radiosity_solve::solved::Solved;
use radiosity_work::ranks::{PartName, Ranks};
use radiosity_work::{Progress, Stage, Work};
use serde::{Deserialize, Serialize};

use super::frame_light::FrameLight;
use super::frame_light::forecast::seconds;
use super::frame_light::frame::Frame;
use super::light_field::LightField;
use super::picture_light::{GATHERED_FOR_PICTURES, PictureLight};
use crate::reader::ReadMode;
use fill::fill;
use places::Places;
use sizes::sizes;

/// The irradiance of all surfaces of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Lightmap {
    parts: Vec<LightmapPart>,
    surfaces: Vec<LightTexture>,
}

/// A part of the light: that of one group, or of all emitters without a group.
#[derive(Clone, Debug, PartialEq)]
pub struct LightmapPart {
    /// The group; None for light that cannot be dimmed.
    pub group: Option<String>,
    /// The group's factor in the scene; 1 without a group.
    pub factor: f64,
}

/// The irradiance of one surface at its texels.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LightTexture {
    size: [usize; 2],
    bands: usize,
    /// Part by part, band by band, row by row of constant v from v = −1 on, u fastest.
    values: Vec<f32>,
    /// Per texel: whether its light was computed there.
    computed: Vec<bool>,
}

impl Lightmap {
    /// Irradiance (unit of exitance) of a surface in a band at its parameters, at the factors of its parts.
    pub fn irradiance(&self, surface: usize, band: usize, parameters: [f64; 2]) -> f64 {
        let texture = &self.surfaces()[surface];
        self.parts()
            .iter()
            .enumerate()
            .map(|(part, own)| own.factor * texture.at(part, band, parameters))
            .sum()
    }

    /// Radiosity (unit of exitance) of a surface of `scene` in a band at its parameters, under the irradiance
    /// `irradiance`.
    pub fn radiosity(
        &self,
        scene: &Scene,
        surface: usize,
        band: usize,
        parameters: [f64; 2],
        irradiance: f64,
    ) -> f64 {
        let own = &scene.surfaces[surface];
        let radiosity = own.exitance_at(band, parameters) + own.reflectance_at(band, parameters) * irradiance;
        let transmittance = own.material.transmittance[band];
        let behind = own.other_side.filter(|_| transmittance > 0.0);
        radiosity + behind.map_or(0.0, |other| transmittance * self.irradiance(other, band, parameters))
    }

    /// The light of `solved`, in about `texels` texels together, shared among the surfaces by area: every one
    /// has two along each parameter at the least, a curved one nine. About how long that takes is told first.
    pub fn new(solved: &Solved, read: ReadMode, texels: usize, work: &Work<'_>) -> Self {
        work.during(Stage::Texels, || Self::read(solved, read, texels, work))
    }

    fn read(solved: &Solved, read: ReadMode, texels: usize, work: &Work<'_>) -> Self {
        let solution = &solved.outcome.solution;
        let (parts, alone): (Vec<LightmapPart>, Vec<Solution>) =
            parts(&solved.scene, solution).into_iter().unzip();
        let (parts, solutions) = match parts.is_empty() {
            true => (vec![LightmapPart { group: None, factor: 1.0 }], vec![solution]),
            false => (parts, alone.iter().collect()),
        };
        let lights: Vec<PictureLight> = solutions
            .into_iter()
            .map(|solution| {
                PictureLight::new(solution, solved.visibility(), read, GATHERED_FOR_PICTURES).of_texels()
            })
            .collect();
        let sizes = sizes(&solved.scene, texels);
        let diagonal = solved.visibility().bounds().diagonal();
        let all = SurfaceTexels { elements: solution.elements(), sizes: &sizes, diagonal };
        let seconds = lights.iter().map(|light| all.seconds(light, work.ranks)).sum();
        work.report(Progress::Expected { stage: Stage::Texels, seconds });
        let count = parts.len() * all.count();
        let done = AtomicUsize::new(0);
        let texture = |surface: usize| {
            let size = sizes[surface];
            let tell = |own: usize| {
                work.report_done(Stage::Texels, done.fetch_add(own, Ordering::Relaxed) + own, count);
            };
            let places = Places::of(solution.elements(), surface, size, diagonal);
            LightTexture::of(solution.bands().len(), &places, size, &lights, &tell)
        };
        let texels: Vec<f64> = sizes.iter().map(|[along_u, along_v]| (along_u * along_v) as f64).collect();
        let surfaces = work.ranks.map(PartName::Textures, &texels, texture);
        Self { parts, surfaces }
    }

    /// The texels along u and along v that [`Lightmap::new`] gives each surface of `scene` of about `texels`:
    /// what is reckoned before the work.
    pub fn sizes(scene: &Scene, texels: usize) -> Vec<[usize; 2]> {
        sizes(scene, texels)
    }

    /// The parts of the light: of each group, and of light without a group; one for all light where it is not
    /// kept apart.
    pub fn parts(&self) -> &[LightmapPart] {
        &self.parts
    }

    /// The texture of each surface.
    pub fn surfaces(&self) -> &[LightTexture] {
        &self.surfaces
    }
}

impl LightTexture {
    /// Texels along u and along v.
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// The parameters of the centre of texel (i, j), counted from (u, v) = (−1, −1).
    pub fn parameters(&self, texel: [usize; 2]) -> [f64; 2] {
        places::parameters(self.size, texel)
    }

    /// The place of the parameters (u, v) in an image of these texels, in [0, 1] from the outer border of the
    /// first texel.
    pub fn image_coordinates(&self, [u, v]: [f64; 2]) -> [f64; 2] {
        let place = |x: f64, count: usize| (0.5 + 0.5 * (1.0 + x) * (count - 1) as f64) / count as f64;
        [place(u, self.size[0]), place(v, self.size[1])]
    }

    /// Irradiance (unit of exitance) of a part in a band, undimmed: rows of constant v from v = −1 on, u
    /// fastest.
    pub fn texels(&self, part: usize, band: usize) -> &[f32] {
        let count = self.size[0] * self.size[1];
        &self.values[(part * self.bands + band) * count..][..count]
    }

    /// Whether the light of texel (i, j) was computed at its own centre or at the nearest open point, not
    /// filled in from its neighbours.
    pub fn is_computed(&self, [i, j]: [usize; 2]) -> bool {
        self.computed[j * self.size[0] + i]
    }

    /// Irradiance (unit of exitance) of a part in a band at (u, v), undimmed, bilinear between texels.
    pub fn at(&self, part: usize, band: usize, [u, v]: [f64; 2]) -> f64 {
        let texels = self.texels(part, band);
        let along = |x: f64, count: usize| {
            let place = 0.5 * (1.0 + x.clamp(-1.0, 1.0)) * (count - 1) as f64;
            let first = (place.floor() as usize).min(count - 2);
            (first, place - first as f64)
        };
        let ((i, s), (j, t)) = (along(u, self.size[0]), along(v, self.size[1]));
        let texel = |i: usize, j: usize| f64::from(texels[j * self.size[0] + i]);
        let row = |j: usize| (1.0 - s) * texel(i, j) + s * texel(i + 1, j);
        (1.0 - t) * row(j) + t * row(j + 1)
    }

    /// The texture in so many bands at the places that its texels see, under the light of each part; `tell`
    /// gets the texels that are done.
    fn of(
        bands: usize,
        places: &Places,
        size: [usize; 2],
        lights: &[PictureLight],
        tell: &dyn Fn(usize),
    ) -> Self {
        let seen = places.all();
        let computed: Vec<bool> = seen.iter().map(Option::is_some).collect();
        let frame = Frame::of(size[0], seen, places.apart());
        let count = frame.len();
        let mut values = vec![0.0; lights.len() * bands * count];
        for (light, part) in lights.iter().zip(values.chunks_exact_mut(bands * count)) {
            let mut field = light.gathers().then(|| LightField::new(light, places.diagonal()));
            let lit = FrameLight::over(&frame, light, field.as_mut(), &Work::alone());
            for (texel, irradiance) in (0..count).filter_map(|texel| Some((texel, lit.irradiance(texel)?))) {
                for (band, value) in irradiance.iter().enumerate() {
                    part[band * count + texel] = value.max(0.0) as f32;
                }
            }
            tell(count);
        }
        for plane in values.chunks_exact_mut(count) {
            fill(plane, size, &computed);
        }
        Self { size, bands, values, computed }
    }
}

/// The texels of all surfaces, one after another.
struct SurfaceTexels<'a> {
    elements: &'a Elements,
    sizes: &'a [[usize; 2]],
    /// Diagonal of the scene (scene length).
    diagonal: f64,
}

impl SurfaceTexels<'_> {
    fn count(&self) -> usize {
        self.sizes.iter().map(|[columns, rows]| columns * rows).sum()
    }

    /// About the seconds that their light takes.
    fn seconds(&self, light: &PictureLight, ranks: &Ranks) -> f64 {
        let counts = self.sizes.iter().map(|[columns, rows]| columns * rows);
        let ends: Vec<usize> = counts
            .scan(0, |end, count| {
                *end += count;
                Some(*end)
            })
            .collect();
        let seen = |texel: usize| {
            let surface = ends.partition_point(|end| *end <= texel);
            let size @ [columns, rows] = self.sizes[surface];
            let own = texel + columns * rows - ends[surface];
            let places = Places::of(self.elements, surface, size, self.diagonal);
            places.at([own % columns, own / columns])
        };
        seconds(light, self.count(), &seen, ranks)
    }
}

/// The parts that the light of a solution is kept apart by, each with its light, not dimmed; dark ones left
/// out. None where it is not kept apart.
fn parts(scene: &Scene, solution: &Solution) -> Vec<(LightmapPart, Solution)> {
    let known = scene.light_groups();
    let part = |light: &GroupLight| {
        let alone = solution.of_group(scene, light);
        let shines = |exitance: &f64| *exitance > 0.0;
        let emits = !alone.emitters().points.is_empty()
            || alone.coatings().iter().any(|coating| coating.exitance.iter().any(shines));
        let own = known.iter().find(|own| Some(own.name.as_str()) == light.group.as_deref());
        let factor = own.map_or(1.0, |own| own.factor);
        emits.then(|| (LightmapPart { group: light.group.clone(), factor }, alone))
    };
    solution.groups().iter().filter_map(part).collect()
}
