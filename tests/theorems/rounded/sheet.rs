//! Flat sheets, the rooms and bodies that they make, and their view factors.

use radiosity::scene::{Material, Scene, SceneBuilder, SceneError};
use radiosity_geom::DVec3;
use radiosity_geom::shapes::Polygon;

/// A polygon with a name.
#[derive(Clone, Debug)]
pub(crate) struct Sheet {
    pub(crate) name: String,
    pub(crate) corners: Vec<DVec3>,
    pub(crate) two_sided: bool,
}

/// A one-sided sheet.
pub(crate) fn sheet(name: &str, corners: &[[f64; 3]]) -> Sheet {
    let corners = corners.iter().map(|x| DVec3::from_array(*x)).collect();
    Sheet { name: name.to_owned(), corners, two_sided: false }
}

/// A sheet both sides of which emit and receive.
pub(crate) fn plate(name: &str, corners: &[[f64; 3]]) -> Sheet {
    Sheet { two_sided: true, ..sheet(name, corners) }
}

/// The faces of a box with these corners, fronts outside, their names behind that of the box; without those
/// in `open`.
pub(crate) fn cuboid(name: &str, low: [f64; 3], high: [f64; 3], open: &[&str]) -> Vec<Sheet> {
    const FACES: [(&str, [usize; 4]); 6] = [
        ("bottom", [0, 2, 3, 1]),
        ("top", [4, 5, 7, 6]),
        ("y0", [0, 1, 5, 4]),
        ("y1", [2, 6, 7, 3]),
        ("x0", [0, 4, 6, 2]),
        ("x1", [1, 3, 7, 5]),
    ];
    let ends = [low, high];
    let corner = |k: usize| [ends[k & 1][0], ends[k >> 1 & 1][1], ends[k >> 2 & 1][2]];
    let kept = FACES.iter().filter(|(face, _)| !open.contains(face));
    kept.map(|(face, places)| sheet(&format!("{name}-{face}"), &places.map(corner))).collect()
}

/// A room of 4 × 3.5 × 2.8, fronts inside.
pub(crate) fn room() -> Vec<Sheet> {
    let mut walls = cuboid("room", [0.0; 3], [4.0, 3.5, 2.8], &[]);
    walls.iter_mut().for_each(|wall| wall.corners.reverse());
    walls
}

/// The sheets with every corner put elsewhere.
pub(crate) fn placed(mut sheets: Vec<Sheet>, place: impl Fn(DVec3) -> DVec3) -> Vec<Sheet> {
    sheets.iter_mut().flat_map(|sheet| &mut sheet.corners).for_each(|corner| *corner = place(*corner));
    sheets
}

/// Turns about the vertical through (x, y).
pub(crate) fn turned(sheets: Vec<Sheet>, [x, y]: [f64; 2], angle: f64) -> Vec<Sheet> {
    let (sin, cos) = angle.sin_cos();
    let about = |p: DVec3| {
        let (a, b) = (p.x - x, p.y - y);
        DVec3::new(x + a * cos - b * sin, y + a * sin + b * cos, p.z)
    };
    placed(sheets, about)
}

/// The scene of these sheets, all of one material.
pub(crate) fn scene(sheets: &[Sheet]) -> Result<Scene, Box<dyn std::error::Error>> {
    scene_lit_by(sheets, |_| true)
}

/// The scene of these sheets, all of reflectance ½; those with certain names emit 1.
pub(crate) fn scene_lit_by(
    sheets: &[Sheet],
    shines: impl Fn(&str) -> bool,
) -> Result<Scene, Box<dyn std::error::Error>> {
    let mut scene = SceneBuilder::new("sheets", ["grey"]);
    let [grey, lamp] = [("grey", 0.0), ("lamp", 1.0)].map(|(name, emission)| {
        Material::new(vec![0.5], vec![emission]).map(|material| scene.material(name, material))
    });
    let (grey, lamp) = (grey?, lamp?);
    for sheet in sheets {
        let material = if shines(&sheet.name) { &lamp } else { &grey };
        let draft = scene.surface(&sheet.name, Polygon::new(sheet.corners.clone(), Vec::new())?, material);
        if sheet.two_sided {
            draft.two_sided();
        }
    }
    scene.build().map_err(|error: SceneError| error.into())
}
