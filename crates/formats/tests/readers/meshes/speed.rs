//! Large meshes.

use std::time::{Duration, Instant};

use radiosity_formats::ply;
use radiosity_photometry::files::NoFiles;

#[test]
fn a_hundred_thousand_triangles_are_read_and_merged_in_seconds_without_optimisation() {
    // A floor with a window in every fourth square, so that sides, loops and holes are many.
    const SIDE: usize = 240;
    let mut text = String::new();
    let number = |i: usize, j: usize| i * (SIDE + 1) + j;
    let mut faces = Vec::new();
    for i in 0..SIDE {
        for j in (0..SIDE).filter(|j| i % 2 == 0 || j % 2 == 0 || *j == 1) {
            let [a, b, c, d] = [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)];
            faces.push(format!("3 {a} {b} {c}\n3 {a} {c} {d}\n"));
        }
    }
    let vertices = (SIDE + 1) * (SIDE + 1);
    text += &format!(
        "ply\nformat ascii 1.0\nelement vertex {vertices}\nproperty float x\nproperty float y\nproperty float z\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        2 * faces.len()
    );
    for k in 0..vertices {
        text += &format!("{} {} 0\n", k / (SIDE + 1), k % (SIDE + 1));
    }
    text += &faces.concat();
    let start = Instant::now();
    let model = ply::read("a.ply", text.as_bytes(), &NoFiles).unwrap();
    assert_eq!(model.surfaces.len(), 1);
    // A quadratic search would take minutes.
    assert!(start.elapsed() < Duration::from_secs(20), "{:?}", start.elapsed());
}
