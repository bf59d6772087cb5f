//! Solutions as grids of VTK: well-formed, complete, with the light of closed forms; what has no grid is
//! refused. `tests/external/vtu.py` has VTK itself read them.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use radiosity_test_support::data::number;
use radiosity_test_support::folders::{folder, json};

use crate::floor;
use crate::program::{done, refused};

/// A grid as the format's specification says how to read it.
struct Grid {
    points: usize,
    cells: usize,
    numbers: BTreeMap<String, Vec<f64>>,
    integers: BTreeMap<String, Vec<i64>>,
    texts: BTreeMap<String, Vec<String>>,
}

fn words<const N: usize>(bytes: &[u8]) -> Vec<[u8; N]> {
    bytes.chunks_exact(N).map(|word| word.try_into().expect("whole words")).collect()
}

impl Grid {
    fn read(path: &Path) -> Self {
        let text = fs::read_to_string(path).expect("it was written");
        let document = roxmltree::Document::parse(&text).expect("it is well-formed");
        let root = document.root_element();
        assert_eq!(root.attribute("type"), Some("UnstructuredGrid"));
        assert_eq!(root.attribute("header_type"), Some("UInt64"));
        let piece = root.descendants().find(|node| node.has_tag_name("Piece")).expect("a piece");
        let count = |name| piece.attribute(name).and_then(|text| text.parse().ok()).expect("a count");
        let mut grid = Self {
            points: count("NumberOfPoints"),
            cells: count("NumberOfCells"),
            numbers: BTreeMap::new(),
            integers: BTreeMap::new(),
            texts: BTreeMap::new(),
        };
        for array in root.descendants().filter(|node| node.has_tag_name("DataArray")) {
            let name = array.attribute("Name").expect("a name").to_owned();
            let all = STANDARD.decode(array.text().expect("numbers")).expect("base64");
            let (header, bytes) = all.split_at(8);
            assert_eq!(u64::from_le_bytes(header.try_into().expect("eight bytes")), bytes.len() as u64);
            match array.attribute("type") {
                Some("Float64") => {
                    let numbers = words(bytes).into_iter().map(f64::from_le_bytes).collect();
                    grid.numbers.insert(name, numbers);
                }
                Some("Int64") => {
                    let numbers = words(bytes).into_iter().map(i64::from_le_bytes).collect();
                    grid.integers.insert(name, numbers);
                }
                Some("UInt8") => {
                    grid.integers.insert(name, bytes.iter().map(|byte| i64::from(*byte)).collect());
                }
                Some("String") => {
                    let text = String::from_utf8(bytes.to_vec()).expect("text");
                    let texts = text.strip_suffix('\0').expect("each text ends in zero").split('\0');
                    grid.texts.insert(name, texts.map(str::to_owned).collect());
                }
                kind => panic!("{name}: {kind:?}"),
            }
        }
        grid
    }

    fn position(&self, point: usize) -> [f64; 3] {
        self.numbers["Points"][3 * point..3 * point + 3].try_into().expect("three coordinates")
    }

    /// Everything has as many numbers as there are points or cells, and the last cell ends at the last point.
    fn check(&self) {
        let Self { points, cells, numbers, integers, .. } = self;
        for (name, components) in [("Points", 3), ("normal", 3), ("parameters", 2)] {
            assert_eq!(numbers[name].len(), components * points, "{name}");
        }
        for band in &self.texts["bands"] {
            for quantity in ["irradiance", "radiosity"] {
                assert_eq!(numbers[&format!("{quantity} {band}")].len(), *points);
            }
        }
        assert_eq!(integers["connectivity"], (0..*points as i64).collect::<Vec<_>>());
        for name in ["types", "offsets", "surface", "element"] {
            assert_eq!(integers[name].len(), *cells, "{name}");
        }
        assert_eq!(integers["offsets"].last(), Some(&(*points as i64)));
    }
}

const ROOM: &str = r#"
bands = ["visible & near", "<far>"]
unit = "lx"
materials.white = { reflectance = [0.5, 0.2] }
materials.lamp = { reflectance = 0, emission = [10, 1], group = "lamps" }
[[surfaces]]
name = "floor \"one\""
material = "white"
polygon = { vertices = [[0,0,0],[4,0,0],[4,4,0],[0,4,0]], holes = [[[1,1,0],[2,1,0],[1.5,2,0]]] }
[[surfaces]]
name = "ball"
material = "white"
sphere = { center = [3, 3, 1], radius = 0.5 }
[[surfaces]]
name = "lamp"
material = "lamp"
quad = { vertices = [[1,1,3],[1,2,3],[2,2,3],[2,1,3]] }
"#;

#[test]
fn furnaces_are_even_at_every_point() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for scene in ["furnace-cube", "furnace-sphere"] {
        done(folder.path(), &["solve", scene, "--order", "4", "--eps", "1e-5", "-o", "even.vtu"]);
        let grid = Grid::read(&folder.path().join("even.vtu"));
        grid.check();
        let band = &grid.texts["bands"][0];
        let [least, most] = [f64::min, f64::max]
            .map(|pick| grid.numbers[&format!("radiosity {band}")].iter().copied().reduce(pick).unwrap());
        // B = E₀/(1 − ρ), with E₀ = 1 and ρ = ½.
        assert!((least - 2.0).abs() < 1e-3 && (most - 2.0).abs() < 1e-3, "{scene}: {least} to {most}");
    }
}

#[test]
fn cells_lie_on_their_surfaces() {
    let folder = folder(&[("room.toml", ROOM)]);
    let [_, told] = done(folder.path(), &["solve", "room.toml", "-o", "room.vtu"]);
    let grid = Grid::read(&folder.path().join("room.vtu"));
    grid.check();
    assert!(told.contains(&format!("{} cells, {} points", grid.cells, grid.points)), "{told}");
    assert_eq!(grid.texts["surfaces"], ["floor \"one\"", "ball", "lamp"]);
    assert_eq!(grid.texts["bands"], ["visible & near", "<far>"]);
    assert_eq!(grid.texts["unit of irradiance and radiosity"], ["lx"]);
    let mut start = 0;
    for (cell, end) in grid.integers["offsets"].iter().enumerate() {
        for point in start..*end as usize {
            let [x, y, z] = grid.position(point);
            let off = match grid.integers["surface"][cell] {
                0 => z,
                1 => (x - 3.0).hypot(y - 3.0).hypot(z - 1.0) - 0.5,
                _ => z - 3.0,
            };
            assert!(off.abs() < 1e-12, "cell {cell}: {off}");
        }
        start = *end as usize;
    }
    // Of a triangulated floor the corner triangles of the cells cover its area, 16 − ½.
    let floor = |cell: &usize| grid.integers["surface"][*cell] == 0;
    let area: f64 = (0..grid.cells).filter(floor).map(|cell| grid.corner_area(cell)).sum();
    assert!((area - 15.5).abs() < 1e-12, "{area}");
}

impl Grid {
    /// Area of the polygon of a flat cell's corners, seen from above.
    fn corner_area(&self, cell: usize) -> f64 {
        let start = if cell == 0 { 0 } else { self.integers["offsets"][cell - 1] as usize };
        let corners = if self.integers["types"][cell] == 69 { 3 } else { 4 };
        let at = |k: usize| self.position(start + k % corners);
        (0..corners).map(|k| 0.5 * (at(k)[0] * at(k + 1)[1] - at(k + 1)[0] * at(k)[1])).sum()
    }
}

#[test]
fn solutions_become_grids_at_any_factor() {
    let folder = folder(&[("room.toml", ROOM)]);
    let path = folder.path();
    done(path, &["solve", "room.toml", "-o", "room.json", "-q"]);
    done(path, &["solve", "room.toml", "-o", "solved.vtu", "-q"]);
    done(path, &["convert", "room.json", "read.vtu"]);
    let [solved, read] = ["solved.vtu", "read.vtu"].map(|name| fs::read(path.join(name)).expect("written"));
    assert!(solved == read, "the same solution makes the same file");
    done(path, &["convert", "room.json", "dim.vtu", "--set", "lamps=0.25"]);
    done(path, &["relight", "room.json", "--set", "lamps=0.25", "-q", "-o", "relit.vtu"]);
    let [dim, relit] = ["dim.vtu", "relit.vtu"].map(|name| fs::read(path.join(name)).expect("written"));
    assert!(dim == relit, "convert and relight dim alike");
    let [day, dim] = ["read.vtu", "dim.vtu"].map(|name| Grid::read(&path.join(name)));
    for (day, dim) in day.numbers["irradiance <far>"].iter().zip(&dim.numbers["irradiance <far>"]) {
        assert!((0.25 * day - dim).abs() < 1e-12, "{day} {dim}");
    }
}

#[test]
fn what_is_no_polynomial_or_no_solution_is_refused() {
    let folder = folder(&[("room.toml", ROOM)]);
    let path = folder.path();
    let masked = ["solve", "room.toml", "--shadows", "mask", "-o", "room.vtu"];
    refused(path, &masked, &["room.vtu", "shadow masks", "solve with --shadows auto"]);
    let tensor = ["solve", "room.toml", "--tensor", "--order", "11", "--subdivide", "1", "-o", "room.vtu"];
    let rough = [&tensor[..], &["--eps", "1e-1", "--shadows", "off"]].concat();
    refused(path, &rough, &["floor", "total degree 22", "--order of 10"]);
    refused(path, &["convert", "room.toml", "room.vtu"], &["no light yet", "solve room.toml -o room.vtu"]);
    refused(path, &["solve", "room.toml", "-o", "none/room.vtu"], &["its folder does not exist"]);
    assert!(!path.join("room.vtu").exists(), "nothing is half-written");
}

/// The relative error in the L2 mean of the mean of the light on that floor, by the midpoint rule.
fn error_of_the_mean() -> f64 {
    const SIDE: usize = 400;
    let place = |k: usize| 2.0 * (k as f64 + 0.5) / SIDE as f64 - 1.0;
    let light = |k: usize| {
        let [x, y] = [k % SIDE, k / SIDE].map(place);
        (1.0 + x * x + y * y).powf(-1.5)
    };
    let count = SIDE * SIDE;
    let mean = |power: i32| (0..count).map(|k| light(k).powi(power)).sum::<f64>() / count as f64;
    (1.0 - mean(1) * mean(1) / mean(2)).sqrt()
}

/// A constant on the floor is all that is in cells of VTK, and is what is checked; of a solution that is read again
/// light is gathered, which is exact there, unless its polynomials are to be accurate.
#[test]
fn a_check_is_of_what_is_written() {
    let folder = folder(&[("floor.toml", floor::BELOW_A_LAMP)]);
    let folder = folder.path();
    let error = |args: &[&str]| {
        done(folder, &[args, &["--report", "r.json", "-q"]].concat());
        number(&json(&folder.join("r.json"))["error"])
    };
    let solve = ["solve", "floor.toml", "--order", "0", "-o"];
    let gathered = error(&[&solve[..], &["floor.json"]].concat());
    assert!(gathered < 1e-4, "{gathered}");
    let wrong = error_of_the_mean();
    assert!(wrong > 0.3);
    let relight = ["relight", "floor.json", "--set", "lamps=1", "-o", "relit.vtu"];
    for written in [&[&solve[..], &["floor.vtu"]].concat()[..], &relight] {
        let found = error(written);
        assert!((found / wrong - 1.0).abs() < 0.15, "{written:?}: {found} found, {wrong} true");
    }
    let of_polynomials =
        error(&["solve", "floor.toml", "--accuracy", "0.5", "--for", "solution", "-o", "of.json"]);
    assert!(of_polynomials > 100.0 * gathered, "{of_polynomials}");
}
