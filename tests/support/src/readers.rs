//! Every reader of files, with a right file of each: whatever is put in its place is read or refused.

use std::cell::OnceCell;
use std::fs;
use std::path::{Path, PathBuf};

use radiosity::language;
use radiosity::reading::files::solution_file::{self, SolutionFile};
use radiosity::scene::{Scene, SceneError, Source};
use radiosity::solve::Options;
use radiosity::work::ranks::PartName;
use radiosity::work::ranks::Ranks;
use radiosity::work::ranks::journal::Begin;
use tempfile::TempDir;

use crate::folders::folder;
use crate::scenes::builtin_with;
use crate::solved::{sealed, solved_of};

/// A text that stands in a file beside the folder of the scenes, and that no message may show.
const SECRET: &str = "hidden-from-scenes";

/// Words that mutations put into files: paths that lead out of the folder of the scene, and parts of texts.
pub const WORDS: [&str; 8] =
    ["../secret.toml", "/etc/passwd", "../secret", "\\\n", "[", "{}", "null", "\"=width^99\""];

/// Files that the readers read, by their names.
const FILES: [(&str, &[u8]); 25] = [
    ("scene.toml", include_bytes!("../seeds/scene.toml")),
    ("scene.json", include_bytes!("../seeds/scene.json")),
    ("scene.csv", include_bytes!("../seeds/scene.csv")),
    ("scene.mgf", include_bytes!("../seeds/scene.mgf")),
    ("scene.obj", include_bytes!("../seeds/scene.obj")),
    ("scene.mtl", include_bytes!("../seeds/scene.mtl")),
    ("scene.gltf", include_bytes!("../seeds/scene.gltf")),
    ("scene.glb", include_bytes!("../seeds/scene.glb")),
    ("scene.xml", include_bytes!("../seeds/scene.xml")),
    ("scene.rad", include_bytes!("../seeds/scene.rad")),
    ("scene.vs3", include_bytes!("../seeds/scene.vs3")),
    ("text.stl", include_bytes!("../seeds/text.stl")),
    ("binary.stl", include_bytes!("../seeds/binary.stl")),
    ("text.ply", include_bytes!("../seeds/text.ply")),
    ("binary.ply", include_bytes!("../seeds/binary.ply")),
    ("lamp.ies", include_bytes!("../seeds/lamp.ies")),
    ("lamp.ldt", include_bytes!("../seeds/lamp.ldt")),
    ("wood.png", include_bytes!("../seeds/wood.png")),
    ("grain.exr", include_bytes!("../seeds/grain.exr")),
    ("part.toml", include_bytes!("../seeds/part.toml")),
    ("part.mgf", include_bytes!("../seeds/part.mgf")),
    ("part.rad", include_bytes!("../seeds/part.rad")),
    ("part.xml", include_bytes!("../seeds/part.xml")),
    ("../secret.toml", SECRET.as_bytes()),
    ("../secret", SECRET.as_bytes()),
];

/// A reader of a kind of files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reader {
    /// A scene in one of these files.
    Scene(&'static str),
    /// A file that the scene in another one names.
    NamedBy(&'static str, &'static str),
    /// A solution.
    Solution,
    /// The file of a journal.
    Journal,
}

impl Reader {
    /// All of them.
    pub const ALL: [Self; 22] = [
        Self::Scene("scene.toml"),
        Self::Scene("scene.json"),
        Self::Scene("scene.csv"),
        Self::NamedBy("scene.toml", "part.toml"),
        Self::Scene("scene.mgf"),
        Self::Scene("scene.obj"),
        Self::NamedBy("scene.obj", "scene.mtl"),
        Self::Scene("scene.gltf"),
        Self::Scene("scene.glb"),
        Self::Scene("scene.xml"),
        Self::Scene("scene.rad"),
        Self::Scene("scene.vs3"),
        Self::Scene("text.stl"),
        Self::Scene("binary.stl"),
        Self::Scene("text.ply"),
        Self::Scene("binary.ply"),
        Self::NamedBy("scene.toml", "lamp.ies"),
        Self::NamedBy("scene.toml", "lamp.ldt"),
        Self::NamedBy("scene.toml", "wood.png"),
        Self::NamedBy("scene.toml", "grain.exr"),
        Self::Solution,
        Self::Journal,
    ];

    /// The name of the file that is put in the place of a right one.
    pub fn file(self) -> &'static str {
        match self {
            Self::Scene(file) | Self::NamedBy(_, file) => file,
            Self::Solution => "solution.json",
            Self::Journal => "kept/000000-000000.journal",
        }
    }
}

/// A reader at work in a folder of its own, with the files that scenes name beside a secret.
#[derive(Debug)]
pub struct ReaderAtWork {
    reader: Reader,
    /// A right file of its kind.
    pub whole: Vec<u8>,
    house: TempDir,
}

impl ReaderAtWork {
    /// The reader with a right file.
    pub fn new(reader: Reader) -> Self {
        let files: Vec<(String, &[u8])> =
            FILES.iter().map(|(name, bytes)| (format!("room/{name}"), *bytes)).collect();
        let files: Vec<(&str, &[u8])> = files.iter().map(|(name, bytes)| (name.as_str(), *bytes)).collect();
        let house = folder(&files);
        Self { reader, whole: whole(reader, house.path()), house }
    }

    fn folder(&self) -> PathBuf {
        self.house.path().join("room")
    }

    /// The file that is being read.
    pub fn path(&self) -> PathBuf {
        self.folder().join(self.reader.file())
    }

    /// Reads a file of these bytes, and says whether it was right.
    ///
    /// # Panics
    /// A reader that panics, reads outside the folder of the scene, or shows what stands there.
    pub fn read(&self, bytes: &[u8]) -> bool {
        if self.reader == Reader::Journal {
            emptied(&self.folder());
        }
        fs::write(self.path(), bytes).expect("it can be written");
        let scene = |name: &str| inside(language::load(&self.folder().join(name).to_string_lossy()));
        match self.reader {
            Reader::Scene(_) => scene(self.reader.file()),
            Reader::NamedBy(main, _) => scene(main),
            Reader::Solution => {
                let text = String::from_utf8_lossy(bytes);
                let read = |text: &str| solution_file::read(&Source::new("solution.json", text)).is_ok();
                // A file whose checksum is wrong is refused; one who wrote it anew gets further.
                read(&text) || read(&sealed(&text))
            }
            Reader::Journal => resumed(&self.folder()),
        }
    }
}

/// Reads a file of these bytes, the folder kept from one to the next in each thread.
///
/// # Panics
/// As [`ReaderAtWork::read`].
pub fn with(reader: Reader, bytes: &[u8]) {
    thread_local! {
        static AT_WORK: OnceCell<ReaderAtWork> = const { OnceCell::new() };
    }
    AT_WORK.with(|own| own.get_or_init(|| ReaderAtWork::new(reader)).read(bytes));
}

/// A right file of a reader.
fn whole(reader: Reader, house: &Path) -> Vec<u8> {
    match reader {
        Reader::Scene(file) | Reader::NamedBy(_, file) => {
            FILES.iter().find(|(name, _)| *name == file).expect("it is listed").1.to_vec()
        }
        Reader::Solution => {
            let scene = builtin_with("furnace-cube", &[]);
            let solved = solved_of(scene, Options { order: 1, eps: 0.3, ..Options::default() });
            serde_json::to_vec(&SolutionFile::new(&solved)).expect("a solution is JSON")
        }
        Reader::Journal => {
            let room = house.join("room");
            emptied(&room);
            assert!(resumed(&room), "pieces are made");
            fs::read(room.join(reader.file())).expect("it was recorded")
        }
    }
}

/// Whether a scene was read, and nothing outside its folder.
fn inside(read: Result<Scene, SceneError>) -> bool {
    match read {
        Ok(scene) => {
            let outside = scene.source.as_ref().map(|source| source.outside().clone()).unwrap_or_default();
            assert!(outside.is_empty(), "read outside the folder: {outside:?}");
            true
        }
        Err(error) => {
            let told = format!("{error} {} {:?}", error.cure().unwrap_or_default(), error.place);
            assert!(!told.contains(SECRET), "what is outside is shown: {told}");
            false
        }
    }
}

/// Empties the folder of the journal.
fn emptied(room: &Path) {
    let kept = room.join("kept");
    drop(fs::remove_dir_all(&kept));
    fs::create_dir(&kept).expect("it can be made");
}

/// Whether a run goes on from its journal; its results are right whatever that holds.
fn resumed(room: &Path) -> bool {
    let Ok(ranks) = Ranks::alone().recording(&room.join("kept"), 7, Begin::Resume) else { return false };
    let squares = ranks.map(PartName::Points, &[1.0; 8], |piece| piece * piece);
    assert_eq!(squares, (0..8).map(|piece| piece * piece).collect::<Vec<_>>());
    true
}
