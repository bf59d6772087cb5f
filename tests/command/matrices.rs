//! Matrices for NumPy and SciPy, and as View3D writes them. `tests/external/matrices.py` has NumPy and SciPy
//! read them.

use radiosity_test_support::folders::folder;
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::Read;
use std::path::Path;

use crate::program::{done, refused};

/// An array of NPY: its kind, its shape, its bytes.
struct Array {
    kind: String,
    shape: Vec<usize>,
    bytes: Vec<u8>,
}

impl Array {
    fn numbers(&self) -> Vec<f64> {
        let words = |size: usize| self.bytes.chunks_exact(size);
        match self.kind.as_str() {
            "<f8" => words(8).map(|x| f64::from_le_bytes(x.try_into().unwrap())).collect(),
            "<i8" => words(8).map(|x| i64::from_le_bytes(x.try_into().unwrap()) as f64).collect(),
            "<i4" => words(4).map(|x| f64::from(i32::from_le_bytes(x.try_into().unwrap()))).collect(),
            kind => panic!("{kind}"),
        }
    }

    fn texts(&self) -> Vec<String> {
        let longest: usize = self.kind.strip_prefix("<U").expect("texts").parse().expect("a length");
        let letter = |code: &[u8]| char::from_u32(u32::from_le_bytes(code.try_into().unwrap()));
        let text = |bytes: &[u8]| -> String {
            bytes.chunks_exact(4).map(|code| letter(code).unwrap()).filter(|letter| *letter != '\0').collect()
        };
        self.bytes.chunks_exact(4 * longest).map(text).collect()
    }
}

/// The arrays of an archive, as the formats' specifications say how to read them.
fn arrays(path: &Path) -> BTreeMap<String, Array> {
    let mut archive = zip::ZipArchive::new(File::open(path).expect("it was written")).expect("a ZIP file");
    let mut arrays = BTreeMap::new();
    for index in 0..archive.len() {
        let mut file = archive.by_index(index).expect("a file");
        let name = file.name().expect("text").strip_suffix(".npy").expect("an array").to_owned();
        let mut all = Vec::new();
        file.read_to_end(&mut all).expect("it can be read, and its checksum fits");
        assert_eq!(&all[..8], b"\x93NUMPY\x01\x00");
        let start = 10 + usize::from(u16::from_le_bytes([all[8], all[9]]));
        assert_eq!(start % 64, 0, "{name}");
        let header = String::from_utf8(all[10..start].to_vec()).expect("text");
        let between = |from: &str, to: &str| {
            let rest = &header[header.find(from).expect("a key") + from.len()..];
            rest[..rest.find(to).expect("an end")].to_owned()
        };
        let shape = between("'shape': (", ")");
        let shape: Vec<usize> = shape.split(',').filter_map(|count| count.trim().parse().ok()).collect();
        arrays.insert(name, Array { kind: between("'descr': '", "'"), shape, bytes: all[start..].to_vec() });
    }
    arrays
}

/// Names and rows of a matrix in CSV.
fn table(path: &Path) -> (Vec<String>, Vec<Vec<f64>>) {
    let text = fs::read_to_string(path).expect("it was written");
    let mut lines = text.lines();
    let names = lines.next().expect("a header").split(',').skip(1).map(str::to_owned).collect();
    let row = |line: &str| line.split(',').skip(1).map(|number| number.parse().expect("a number")).collect();
    (names, lines.map(row).collect())
}

/// Two parallel plates, of which nothing else is seen, and a third one far away behind them; names that are
/// not ASCII.
const PLATES: &str = r#"
materials.grey = { reflectance = 0.25 }
[[surfaces]]
name = "Boden"
material = "grey"
quad = { vertices = [[0,0,0],[1,0,0],[1,1,0],[0,1,0]] }
[[surfaces]]
name = "Wärme"
quad = { vertices = [[0,0,1],[0,1,1],[1,1,1],[1,0,1]] }
[[surfaces]]
name = "dahinter"
quad = { vertices = [[0,0,-2],[0,1,-2],[1,1,-2],[1,0,-2]] }
"#;

/// Two unit squares, one above the other at the distance 1 (Hottel 1954).
const OPPOSITE: f64 = 0.199_824_895_698_387;

#[test]
fn archives_hold_factors_names_and_areas() {
    let folder = folder(&[("plates.toml", PLATES)]);
    let path = folder.path();
    for name in ["F.csv", "F.npz"] {
        done(path, &["view-factors", "plates.toml", "-q", "--eps", "1e-8", "-o", name]);
    }
    let (names, rows) = table(&path.join("F.csv"));
    let arrays = arrays(&path.join("F.npz"));
    assert_eq!(arrays["F"].shape, [3, 3]);
    assert_eq!(arrays["F"].numbers(), rows.concat());
    assert_eq!(arrays["names"].texts(), names);
    assert_eq!(names, ["Boden", "Wärme", "dahinter"]);
    assert!(arrays["areas"].numbers().iter().all(|area| (area - 1.0).abs() < 1e-14));
    assert!((rows[0][1] - OPPOSITE).abs() < 1e-9, "{}", rows[0][1]);
}

#[test]
fn sparse_matrices_have_the_members_that_scipy_reads() {
    let folder = folder(&[("plates.toml", PLATES)]);
    let path = folder.path();
    for (name, form) in [("csr.npz", "csr"), ("coo.npz", "coo"), ("coo.csv", "coo")] {
        done(path, &["view-factors", "plates.toml", "-q", "--sparse", form, "-o", name]);
    }
    let [csr, coo] = ["csr", "coo"].map(|form| arrays(&path.join(format!("{form}.npz"))));
    for (arrays, form) in [(&csr, b"csr"), (&coo, b"coo")] {
        let format = &arrays["format"];
        assert_eq!((format.kind.as_str(), format.shape.len(), &format.bytes[..]), ("|S3", 0, &form[..]));
        assert_eq!(arrays["shape"].numbers(), [3.0, 3.0]);
        assert_eq!(arrays["names"].texts().len(), 3);
        assert_eq!(arrays["areas"].shape, [3]);
    }
    // The plates see each other; the one behind sees their backs.
    assert_eq!(csr["indices"].numbers(), [1.0, 0.0]);
    assert_eq!(csr["indptr"].numbers(), [0.0, 1.0, 2.0, 2.0]);
    assert_eq!(coo["row"].numbers(), [0.0, 1.0]);
    assert_eq!(coo["col"].numbers(), [1.0, 0.0]);
    assert_eq!(csr["data"].numbers(), coo["data"].numbers());
    assert!(csr["data"].numbers().iter().all(|factor| (factor - OPPOSITE).abs() < 1e-3));
    let list = fs::read_to_string(path.join("coo.csv")).expect("it was written");
    let pairs = list.lines().map(|line| line.rsplitn(3, ',').last().expect("four columns"));
    assert_eq!(pairs.collect::<Vec<_>>(), ["from,to", "Boden,Wärme", "Wärme,Boden"]);
}

#[test]
fn view3d_reads_areas_factors_and_emittances() {
    let folder = folder(&[("plates.toml", PLATES)]);
    let path = folder.path();
    done(path, &["view-factors", "plates.toml", "-q", "-o", "F.txt"]);
    done(path, &["view-factors", "plates.toml", "-q", "--format", "view3d", "-o", "same.txt"]);
    let [text, same] =
        ["F.txt", "same.txt"].map(|name| fs::read_to_string(path.join(name)).expect("written"));
    assert_eq!(text, same);
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[0].len(), 30, "View3D reads a line of 30 characters");
    let words: Vec<&str> = lines[0].split_whitespace().collect();
    assert_eq!((words[0], &words[2..]), ("radiosity", &["0", "0", "0", "3"][..]));
    let numbers =
        |line: &str| -> Vec<f64> { line.split(' ').map(|word| word.parse().expect("a number")).collect() };
    assert_eq!(lines.len(), 6);
    assert!(numbers(lines[1]).iter().all(|area| (area - 1.0).abs() < 1e-14));
    assert!((numbers(lines[2])[1] - OPPOSITE).abs() < 1e-3);
    // 1 − ρ, and black where no material is given.
    assert_eq!(numbers(lines[5]), [0.75, 1.0, 1.0]);
}

#[test]
fn conductances_come_with_names_and_areas() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path();
    for name in ["C.npz", "C.csv"] {
        done(path, &["heat", "oven", "-q", "-o", "heat.csv", "--conductances", name]);
    }
    let (names, rows) = table(&path.join("C.csv"));
    let arrays = arrays(&path.join("C.npz"));
    let count = rows.len();
    assert_eq!(arrays["names"].texts(), names[..count]);
    let matrix: Vec<f64> = rows.iter().flat_map(|row| &row[..count]).copied().collect();
    let lost: Vec<f64> = rows.iter().map(|row| row[count]).collect();
    assert_eq!((arrays["C"].numbers(), arrays["surroundings"].numbers()), (matrix, lost));
    assert_eq!(arrays["areas"].shape, [count]);
}

#[test]
fn forms_without_a_place_for_sparse_matrices_or_pairs_are_refused() {
    let folder = folder(&[("plates.toml", PLATES)]);
    let factors = ["view-factors", "plates.toml", "-q"];
    for (more, parts) in [
        (&["--sparse", "csr", "-o", "F.csv"][..], &["--sparse csr: CSV", "--sparse coo"][..]),
        (&["--sparse", "coo", "-o", "F.txt"], &["--sparse coo: TXT", ".npz"]),
        (&["--sparse", "coo", "-o", "F.npy"], &["--sparse coo: NPY", ".npz"]),
        (&["--pairs", "Boden,Wärme", "-o", "F.npz"], &["--pairs are no matrix", "NPZ", "csv or json"]),
        (&["--pairs", "Boden,Wärme", "-o", "F.txt"], &["--pairs are no matrix", "TXT"]),
        (&["-o", "F.mat"], &["F.mat: the ending names no format", ".npz"]),
    ] {
        refused(folder.path(), &[&factors[..], more].concat(), parts);
    }
    assert_eq!(fs::read_dir(folder.path()).expect("it is there").count(), 1, "nothing is half-written");
}
