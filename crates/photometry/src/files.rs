//! The files that a scene names: included parts, materials of an OBJ, buffers of a glTF, meshes, photometry,
//! pictures.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::fmt;
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use crate::error::Refusal;

/// Most bytes that are read from one file: some million surfaces. An endless one ends here.
pub const MOST_BYTES: u64 = 1 << 30;

/// Cure of a file outside the folder of the scene, where it is not read.
pub const CURE_OF_OUTSIDE: &str =
    "put a copy of it into the folder of the scene or below, and give its path from there";

/// How far a scene may reach for files.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Reach {
    /// Into the folder of the scene and below, links followed.
    #[default]
    Inside,
    /// Anywhere; what is read outside that folder is told.
    Anywhere,
}

/// A file that was not read.
#[derive(Debug)]
pub enum Unread {
    /// It is outside the folder of the scene, and may not be read.
    Outside,
    /// It is missing, too long, or cannot be read.
    Failed(io::Error),
}

impl Unread {
    /// The refusal of `what` is the file, such as "the mesh 'a.ply'"; `cure` mends a file that is missing.
    pub fn refusal(&self, what: &str, cure: &str) -> Refusal {
        let cure = if matches!(self, Self::Outside) { CURE_OF_OUTSIDE } else { cure };
        Refusal::new(format!("{what} cannot be read: {self}"), cure)
    }
}

impl From<io::Error> for Unread {
    fn from(error: io::Error) -> Self {
        Self::Failed(error)
    }
}

impl fmt::Display for Unread {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Outside => write!(f, "it is outside the folder of the scene"),
            Self::Failed(error) => error.fmt(f),
        }
    }
}

/// Finds files by the names that a scene gives them.
pub trait Files {
    /// The bytes of the file `name`, a path relative to the scene's own folder.
    ///
    /// # Errors
    /// A file that is missing, cannot be read, is too long, or is out of reach.
    fn bytes(&self, name: &str) -> Result<Vec<u8>, Unread>;

    /// Whether there is a file `name` that can be read.
    fn has(&self, name: &str) -> bool {
        self.bytes(name).is_ok()
    }
}

/// The folder of a scene, and how far beyond it the scene may reach.
#[derive(Debug)]
pub struct Folder {
    path: PathBuf,
    reach: Reach,
    /// Names of the files that were read outside it.
    outside: RefCell<BTreeSet<String>>,
}

/// The bytes of a file, and whether it is outside the folder of the scene.
#[derive(Debug)]
pub struct FoundFile {
    /// Its bytes.
    pub bytes: Vec<u8>,
    /// Whether it is outside the folder of the scene.
    pub is_outside: bool,
}

impl Folder {
    /// The folder of the scene at `path`.
    pub fn of_scene(path: &Path, reach: Reach) -> Self {
        let path = path.parent().unwrap_or(Path::new("")).to_path_buf();
        Self { path, reach, outside: RefCell::default() }
    }

    /// Reads the file at `path`, seen from the current folder.
    ///
    /// # Errors
    /// A file that is missing, no regular one, too long, or out of reach.
    pub fn read(&self, path: &Path) -> Result<FoundFile, Unread> {
        let (real, is_outside) = self.found(path)?;
        // Opening a pipe would wait for somebody who writes.
        if !fs::metadata(&real)?.is_file() {
            return Err(io::Error::new(io::ErrorKind::InvalidInput, "it is no regular file").into());
        }
        Ok(FoundFile { bytes: all(File::open(real)?, MOST_BYTES)?, is_outside })
    }

    /// Names of the files that were read outside the folder, as the scene names them.
    pub fn outside(&self) -> BTreeSet<String> {
        self.outside.borrow().clone()
    }

    /// The file at `path` with links followed, and whether it is outside. A file that is not there is where the
    /// nearest folder above it is.
    fn found(&self, path: &Path) -> Result<(PathBuf, bool), Unread> {
        let canonical =
            |path: &Path| fs::canonicalize(if path.as_os_str().is_empty() { Path::new(".") } else { path });
        let root = canonical(&self.path)?;
        let real = canonical(path);
        let nearest = match &real {
            Ok(real) => Some(real.clone()),
            Err(_) => path.ancestors().skip(1).find_map(|above| canonical(above).ok()),
        };
        let is_outside = !nearest.is_some_and(|place| place.starts_with(&root));
        match is_outside && self.reach == Reach::Inside {
            true => Err(Unread::Outside),
            false => Ok((real?, is_outside)),
        }
    }

    fn path_of(&self, name: &str) -> PathBuf {
        // Files made on Windows write backslashes.
        self.path.join(name.replace('\\', "/"))
    }
}

impl Files for Folder {
    fn bytes(&self, name: &str) -> Result<Vec<u8>, Unread> {
        let FoundFile { bytes, is_outside } = self.read(&self.path_of(name))?;
        if is_outside {
            self.outside.borrow_mut().insert(name.to_owned());
        }
        Ok(bytes)
    }

    /// Whether there is a file; one out of reach is taken for one, so that reading it refuses it by name.
    fn has(&self, name: &str) -> bool {
        match self.found(&self.path_of(name)) {
            Ok((real, _)) => real.is_file(),
            Err(Unread::Outside) => true,
            Err(Unread::Failed(_)) => false,
        }
    }
}

/// No files: a scene from standard input or from memory.
#[derive(Clone, Copy, Debug)]
pub struct NoFiles;

impl Files for NoFiles {
    fn bytes(&self, _name: &str) -> Result<Vec<u8>, Unread> {
        let cause = "a scene without a folder of its own names no other files";
        Err(io::Error::new(io::ErrorKind::NotFound, cause).into())
    }
}

/// All bytes of an input that has no more than `most`.
///
/// # Errors
/// Input that cannot be read, or is longer.
pub fn all(input: impl Read, most: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    input.take(most + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most {
        let message = format!("it is longer than {most} bytes, the most that is read");
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, message));
    }
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_endless_input_is_refused() {
        assert_eq!(all(&b"abc"[..], 3).expect("it fits"), b"abc");
        assert!(all(&b"abcd"[..], 3).is_err());
        assert!(all(io::repeat(0), 1000).is_err());
    }

    /// A folder with `room/a`, `room/sub/b` and `other/c`.
    fn house() -> tempfile::TempDir {
        let house = tempfile::tempdir().expect("a folder");
        for (name, text) in [("room/a", "A"), ("room/sub/b", "B"), ("other/c", "C")] {
            let path = house.path().join(name);
            fs::create_dir_all(path.parent().expect("it has one")).expect("it can be made");
            fs::write(path, text).expect("it can be written");
        }
        house
    }

    #[test]
    fn files_are_inside_or_outside() {
        let house = house();
        let scene = house.path().join("room/scene.toml");
        let absolute = |name: &str| house.path().join(name).to_string_lossy().into_owned();
        let inside = ["a", "sub/b", "sub\\b", "./sub/../a", "../room/a", &absolute("room/a")];
        let outside = ["../other/c", "sub/../../other/c", &absolute("other/c")];
        let missing = ["x", "sub/x", "x/y/z"];
        let out_of_reach = ["../x", "/x/y", &absolute("x")];
        let here = Folder::of_scene(&scene, Reach::Inside);
        let all = Folder::of_scene(&scene, Reach::Anywhere);
        for name in inside {
            assert!(here.bytes(name).is_ok() && all.bytes(name).is_ok() && here.has(name), "{name}");
        }
        assert!(all.outside().is_empty());
        for name in outside {
            assert!(matches!(here.bytes(name), Err(Unread::Outside)), "{name}");
            assert_eq!(all.bytes(name).expect("it is there"), b"C");
        }
        assert_eq!(all.outside(), outside.map(str::to_owned).into());
        for name in missing {
            assert!(matches!(here.bytes(name), Err(Unread::Failed(_))) && !here.has(name), "{name}");
        }
        for name in out_of_reach {
            assert!(matches!(here.bytes(name), Err(Unread::Outside)), "whether {name} is there is not told");
            assert!(matches!(all.bytes(name), Err(Unread::Failed(_))), "{name}");
        }
        for name in ["sub", ".", ""] {
            assert!(matches!(here.bytes(name), Err(Unread::Failed(_))), "a folder is no file");
        }
    }

    #[test]
    fn scenes_without_a_folder_stand_in_the_current_one() {
        let here = Folder::of_scene(Path::new("<stdin>"), Reach::Inside);
        assert!(here.read(Path::new("Cargo.toml")).is_ok(), "tests run in the folder of their crate");
        assert!(matches!(here.read(Path::new("")), Err(Unread::Failed(_))), "a folder is no file");
        assert!(matches!(here.read(Path::new("../formats/Cargo.toml")), Err(Unread::Outside)));
    }

    #[test]
    #[cfg(unix)]
    fn pipes_are_not_waited_for() {
        let house = house();
        let pipe = house.path().join("room/pipe");
        let made = std::process::Command::new("mkfifo").arg(pipe).status();
        assert!(made.is_ok_and(|status| status.success()), "mkfifo runs");
        let here = Folder::of_scene(&house.path().join("room/scene.toml"), Reach::Inside);
        assert!(matches!(here.bytes("pipe"), Err(Unread::Failed(_))));
    }

    #[test]
    #[cfg(unix)]
    fn links_lead_outside() {
        use std::os::unix::fs::symlink;
        let house = house();
        symlink("../other", house.path().join("room/link")).expect("it can be made");
        symlink("sub/b", house.path().join("room/near")).expect("it can be made");
        let here = Folder::of_scene(&house.path().join("room/scene.toml"), Reach::Inside);
        assert!(matches!(here.bytes("link/c"), Err(Unread::Outside)));
        assert!(matches!(here.bytes("link/x"), Err(Unread::Outside)));
        assert_eq!(here.bytes("near").expect("it is inside"), b"B");
    }
}
