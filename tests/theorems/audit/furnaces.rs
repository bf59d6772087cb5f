//! Furnaces: closed rooms where every surface emits M = (1 − ρ − τ) E, so that E arrives everywhere, whatever
//! the shapes and however ρ and τ differ.

use std::sync::Arc;

use radiosity::scene::{Material, NamedMaterial};
use radiosity::{Scene, SceneBuilder};
use radiosity_geom::shapes::{
    Bezier, Cone, Cylinder, Disk, Extrusion, FULL_TURN, Parallelogram, Polygon, Revolution, Sphere, Torus,
};
use radiosity_geom::{Aabb, DVec3, Rect, Surface};
use radiosity_test_support::gallery::{Exhibit, gallery};
use radiosity_test_support::scenes::typed;
use radiosity_test_support::shapes::{ball, disk, faces, inside};

use super::fairness::assert_fair;
use super::trial::{Trial, quotients};

/// Irradiance everywhere.
const LIGHT: f64 = 3.0;

const WALKS: f64 = 1024.0;

/// Paint of a furnace.
fn paint(builder: &mut SceneBuilder, name: &str, reflectance: f64, transmittance: f64) -> NamedMaterial {
    let emission = (1.0 - reflectance - transmittance) * LIGHT;
    let own = Material::new(vec![reflectance], vec![emission]).expect("a reflectance below 1");
    builder.material(name, own.with_transmittance(vec![transmittance]).expect("a transmittance"))
}

/// A furnace of these shapes, their fronts inside.
fn furnace(shapes: Vec<Arc<dyn Surface>>) -> Scene {
    let mut builder = SceneBuilder::new("furnace", ["grey"]);
    for (index, shape) in shapes.into_iter().enumerate() {
        let own = paint(&mut builder, &format!("paint {index}"), [0.6, 0.3, 0.8][index % 3], 0.0);
        builder.surface(format!("surface {index}"), shape, &own);
    }
    builder.build().unwrap_or_else(|error| panic!("{error}"))
}

/// A sheet of this shape, that reflects, lets through, and emits, in a box three times its size.
fn sheet_in_a_box(shape: Arc<dyn Surface>) -> Scene {
    let bounds: Aabb = shape.bounds(&Rect::FULL);
    let size = (bounds.max - bounds.min).max_element();
    let corner = bounds.center() - DVec3::new(1.4, 1.5, 1.3) * size;
    let mut builder = SceneBuilder::new("sheet", ["grey"]);
    let wall = paint(&mut builder, "wall", 0.5, 0.0);
    let [front, back] =
        [("front", 0.3), ("back", 0.5)].map(|(name, own)| paint(&mut builder, name, own, 0.4));
    builder.surface("sheet", shape, &front).two_sided().back_material(&back);
    for (index, face) in faces(corner, [3.0 * size * DVec3::X, 2.9 * size * DVec3::Y, 2.8 * size * DVec3::Z])
        .into_iter()
        .enumerate()
    {
        builder.surface(format!("wall {index}"), face, &wall);
    }
    builder.build().unwrap_or_else(|error| panic!("{error}"))
}

fn closed_shapes() -> Vec<(&'static str, Vec<Arc<dyn Surface>>)> {
    let (c, z) = (DVec3::new(0.3, -0.2, 0.5), DVec3::new(0.4, 0.5, 1.0));
    let along = z.normalize();
    let caps = |low: f64, high: f64| -> [Arc<dyn Surface>; 2] {
        [Arc::new(disk(c, z, low)), Arc::new(disk(c + z, -z, high))]
    };
    let can = |side: Arc<dyn Surface>, ends: [f64; 2]| {
        let [bottom, top] = caps(ends[0], ends[1]);
        vec![side, bottom, top]
    };
    let bellied = [[0.0, 0.0], [0.9, 0.0], [0.9, 1.5], [0.0, 1.5]];
    let turned = |curve: [[f64; 2]; 4]| {
        let curve = curve.map(|[x, z]| DVec3::new(x, 0.0, z));
        Revolution::new(curve, DVec3::ZERO, DVec3::Z, FULL_TURN).expect("a revolution")
    };
    vec![
        ("sphere", vec![inside(ball(c, 0.7))]),
        ("torus", vec![inside(Torus::new(c, z, 1.0, 0.4, FULL_TURN, FULL_TURN).expect("a torus"))]),
        ("fat torus", vec![inside(Torus::new(c, z, 1.0, 0.97, FULL_TURN, FULL_TURN).expect("a torus"))]),
        ("cylinder", can(inside(Cylinder::new(c, z, 0.5, FULL_TURN).expect("a tube")), [0.5, 0.5])),
        ("frustum", can(inside(Cone::new(c, z, 0.8, 0.3, FULL_TURN).expect("a cone")), [0.8, 0.3])),
        (
            "cone",
            vec![inside(Cone::new(c, z, 0.8, 0.0, FULL_TURN).expect("a cone")), Arc::new(disk(c, z, 0.8))],
        ),
        (
            "half ball",
            vec![
                inside(Sphere::new(c, 0.8, along, [0.0, 0.8], FULL_TURN).expect("half a ball")),
                Arc::new(disk(c, along, 0.8)),
            ],
        ),
        ("revolution", vec![inside(turned(bellied))]),
        (
            "ring",
            vec![
                inside(Cylinder::new(c, z, 0.8, FULL_TURN).expect("a tube")),
                Arc::new(Cylinder::new(c, z, 0.3, FULL_TURN).expect("a tube")),
                Arc::new(Disk::new(c, z, 0.8, 0.3, FULL_TURN).expect("a ring")),
                Arc::new(Disk::new(c + z, -z, 0.8, 0.3, FULL_TURN).expect("a ring")),
            ],
        ),
        ("pillow", pillow()),
        ("gutter", gutter()),
        ("room with holes", pierced_room()),
        ("box with balls", box_with_balls()),
    ]
}

/// Two Bézier sheets over one square that meet along its sides.
fn pillow() -> Vec<Arc<dyn Surface>> {
    let half = |height: f64| {
        let points = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let is_inner = (1..3).contains(&i) && (1..3).contains(&j);
                DVec3::new(i as f64 / 3.0, j as f64 / 3.0, if is_inner { height } else { 0.0 })
            })
        });
        Bezier::new(points).expect("a patch")
    };
    let up = half(0.9);
    let faces_up = up.jet(0.0, 0.0).normal.z > 0.0;
    let (top, bottom) = (half(0.9), half(-0.5));
    let turned = |shape: Bezier, flip: bool| if flip { inside(shape) } else { Arc::new(shape) };
    vec![turned(top, faces_up), turned(bottom, !faces_up)]
}

/// A roof of an extruded arch over a floor, its ends closed by polygons of many corners on the arch.
fn gutter() -> Vec<Arc<dyn Surface>> {
    let arch = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]].map(|[x, z]| DVec3::new(x, 0.0, z));
    let roof = Extrusion::new(arch, 2.0 * DVec3::Y).expect("an extrusion");
    let is_outside = roof.jet(0.0, 0.0).normal.z > 0.0;
    let roof: Arc<dyn Surface> = if is_outside { inside(roof) } else { Arc::new(roof) };
    let floor = Parallelogram::new(DVec3::ZERO, DVec3::X, 2.0 * DVec3::Y).expect("a floor");
    // B(t) of the arch is (3t² − 2t³, 3t(1 − t)).
    let end = |y: f64, is_first: bool| -> Arc<dyn Surface> {
        let corner = |k: usize| {
            let t = k as f64 / 400.0;
            DVec3::new(t * t * (3.0 - 2.0 * t), y, 3.0 * t * (1.0 - t))
        };
        let mut corners: Vec<DVec3> = (0..=400).map(corner).collect();
        if is_first {
            corners.reverse();
        }
        Arc::new(Polygon::new(corners, vec![]).expect("an end"))
    };
    let ends = [(0.0, true), (2.0, false)].map(|(y, is_first)| {
        let own = end(y, is_first);
        let is_inward = own.jet(0.0, 0.0).normal.y * (1.0 - y) > 0.0;
        if is_inward { own } else { end(y, !is_first) }
    });
    let [first, last] = ends;
    vec![roof, Arc::new(floor), first, last]
}

/// A box whose floor has two holes with plates in them, one in a pit.
fn pierced_room() -> Vec<Arc<dyn Surface>> {
    let [floor, top, sides @ ..] = faces(DVec3::ZERO, [DVec3::Z, 2.0 * DVec3::X, 1.5 * DVec3::Y]);
    drop(floor);
    let flat =
        |list: &[[f64; 2]], z: f64| list.iter().map(|[x, y]| DVec3::new(*x, *y, z)).collect::<Vec<_>>();
    let outline = flat(&[[0.0, 0.0], [2.0, 0.0], [2.0, 1.5], [0.0, 1.5]], 0.0);
    let triangle = [[0.3, 0.3], [0.9, 0.4], [0.5, 1.1]];
    let square = [[1.2, 0.5], [1.7, 0.5], [1.7, 1.0], [1.2, 1.0]];
    let floor = Polygon::new(outline, vec![flat(&triangle, 0.0), flat(&square, 0.0)]).expect("a floor");
    let mut all: Vec<Arc<dyn Surface>> = vec![Arc::new(floor), Arc::new(top)];
    all.extend(sides.into_iter().map(|side| Arc::new(side) as Arc<dyn Surface>));
    all.push(Arc::new(Polygon::new(flat(&triangle, 0.0), vec![]).expect("a lid")));
    all.push(Arc::new(Polygon::new(flat(&square, -0.4), vec![]).expect("the ground of a pit")));
    for k in 0..4 {
        let [a, b] = [square[k], square[(k + 1) % 4]].map(|[x, y]| DVec3::new(x, y, -0.4));
        all.push(Arc::new(Parallelogram::new(a, 0.4 * DVec3::Z, b - a).expect("a side of the pit")));
    }
    all
}

fn box_with_balls() -> Vec<Arc<dyn Surface>> {
    let walls = faces(DVec3::ZERO, [3.0 * DVec3::X, 3.0 * DVec3::Y, 2.0 * DVec3::Z]);
    let mut all: Vec<Arc<dyn Surface>> =
        walls.into_iter().map(|own| Arc::new(own) as Arc<dyn Surface>).collect();
    all.push(Arc::new(ball(DVec3::new(1.0, 1.0, 0.9), 0.5)));
    all.push(Arc::new(ball(DVec3::new(2.0, 2.0, 0.6), 0.6)));
    all.push(Arc::new(
        Torus::new(DVec3::new(2.0, 1.0, 1.4), DVec3::new(1.0, 0.0, 1.0), 0.4, 0.1, FULL_TURN, FULL_TURN)
            .expect("a torus"),
    ));
    all
}

pub(super) fn sheets() -> Vec<Trial> {
    let sheet = |exhibit: Exhibit| {
        let trial = Trial::of(exhibit.name, sheet_in_a_box(Arc::from(exhibit.surface)));
        trial.everywhere(12, &[LIGHT])
    };
    gallery().into_iter().map(sheet).collect()
}

pub(super) fn concave() -> Vec<Trial> {
    let trial = |(name, shapes)| Trial::of(name, furnace(shapes)).everywhere(12, &[LIGHT]);
    closed_shapes().into_iter().map(trial).collect()
}

#[test]
fn rooms_of_concave_shapes_are_furnaces() {
    assert_fair(&quotients(&concave(), WALKS, 100));
}

#[test]
fn sheets_of_all_shapes_are_as_bright_on_both_sides() {
    assert_fair(&quotients(&sheets(), WALKS, 200));
}

/// Reflectance varies as ρ(u, v), and the emission is (1 − ρ(u, v)) E.
pub(super) fn patterns() -> Vec<Trial> {
    let text = r#"
bands = ["lm"]
materials.wall = { reflectance = 0.5, emission = 1.5 }
[materials.tiles]
reflectance = { cells = [[0.1, 0.7, 0.2], [0.8, 0.1, 0.6]], scale = 2, offset = [0.3, 0.1], wrap = "mirror" }
emission = { cells = [[2.7, 0.9, 2.4], [0.6, 2.7, 1.2]], scale = 2, offset = [0.3, 0.1], wrap = "mirror" }
[materials.glow]
reflectance = { polynomial = [[0, 0, 0.4], [1, 0, 0.2], [1, 2, -0.1]] }
emission = { polynomial = [[0, 0, 1.8], [1, 0, -0.6], [1, 2, 0.3]] }
[[surfaces]]
material = "tiles"
box = { origin = [0, 0, 0], size = [2, 3, 2], inward = true, open = ["bottom"] }
[[surfaces]]
material = "glow"
quad = { vertices = [[0, 0, 0], [2, 0, 0], [2, 3, 0], [0, 3, 0]], holes = [[[0.5, 0.5, 0], [1.0, 0.5, 0], [0.7, 1.2, 0]]] }
[[surfaces]]
material = "wall"
triangle = { vertices = [[0.5, 0.5, 0], [1.0, 0.5, 0], [0.7, 1.2, 0]] }
[[surfaces]]
material = "glow"
sphere = { center = [1, 2, 1], radius = 0.4 }
[[surfaces]]
material = "tiles"
two_sided = true
bezier = { points = [
 [[0.3,0.5,1.0],[0.3,0.9,1.2],[0.3,1.3,1.2],[0.3,1.7,1.0]],
 [[0.7,0.5,1.2],[0.7,0.9,1.4],[0.7,1.3,1.4],[0.7,1.7,1.2]],
 [[1.1,0.5,1.2],[1.1,0.9,1.4],[1.1,1.3,1.4],[1.1,1.7,1.2]],
 [[1.5,0.5,1.0],[1.5,0.9,1.2],[1.5,1.3,1.2],[1.5,1.7,1.0]]] }
"#;
    let trial = Trial::of("patterns", typed(text)).everywhere(60, &[LIGHT]);
    vec![trial]
}

#[test]
fn patterns_are_furnaces() {
    assert_fair(&quotients(&patterns(), 4.0 * WALKS, 300));
}
