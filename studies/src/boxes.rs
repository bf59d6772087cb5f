//! A closed room in which boxes hover, as many as are asked for.

use radiosity::scene::{Material, NamedMaterial, Scene, SceneBuilder};
use radiosity_geom::DVec3;
use radiosity_geom::shapes::Parallelogram;

use radiosity_test_support::random::Random;

/// The room (m).
const ROOM: DVec3 = DVec3::new(10.0, 8.0, 4.0);

/// The room with a box, turned and of random sides, in each cell of a grid.
pub fn room(grid: [usize; 3]) -> Scene {
    let mut room = SceneBuilder::new("boxes", ["grey"]);
    let grey = room.material("grey", Material::new(vec![0.5], vec![0.0]).expect("½ is a reflectance"));
    let glow = room.material("glow", Material::new(vec![0.5], vec![1.0]).expect("½ is a reflectance"));
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    add_box(&mut room, "room", 0.5 * ROOM, axes.map(|axis| -ROOM.dot(axis) * axis), &glow, &grey);
    let cell = ROOM / DVec3::from_array(grid.map(|count| count.max(1) as f64));
    let mut random = Random(1);
    for k in 0..grid.iter().product() {
        let at = [k % grid[0], k / grid[0] % grid[1], k / grid[0] / grid[1]].map(|place| place as f64 + 0.5);
        let (sin, cos) = random.between(0.0, 1.5).sin_cos();
        let turned = [DVec3::new(cos, sin, 0.0), DVec3::new(-sin, cos, 0.0), DVec3::Z];
        let edges = turned.map(|axis| random.between(0.2, 0.6) * cell.min_element() * axis);
        add_box(&mut room, &format!("box-{k}"), DVec3::from_array(at) * cell, edges, &grey, &grey);
    }
    room.build().expect("the boxes keep apart")
}

/// The six faces of the box with three `edges` about `center`, fronts outside, or inside where the edges are
/// left-handed. The face where the third edge starts is of the material `first`.
fn add_box(
    room: &mut SceneBuilder,
    name: &str,
    center: DVec3,
    edges: [DVec3; 3],
    first: &NamedMaterial,
    others: &NamedMaterial,
) {
    let corner = center - 0.5 * edges.iter().sum::<DVec3>();
    for k in 0..3 {
        let [normal, a, b] = [0, 1, 2].map(|step| edges[(k + step) % 3]);
        let start = if k == 2 { first } else { others };
        for (side, origin, a, b, material) in
            [("start", corner, b, a, start), ("end", corner + normal, a, b, others)]
        {
            let face = Parallelogram::new(origin, a, b).expect("edges at right angles span it");
            room.surface(format!("{name}-{k}-{side}"), face, material);
        }
    }
}
