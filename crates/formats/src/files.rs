//! The files that a scene names: materials of an OBJ, buffers of a glTF, included parts.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Component, Path, PathBuf};

use crate::tolerances::MOST_BYTES;

/// Finds files by the names that a scene gives them.
pub trait Files {
    /// The bytes of the file `name`, a path relative to the scene's own folder.
    ///
    /// # Errors
    /// A file that is missing, cannot be read, or is too long.
    fn bytes(&self, name: &str) -> io::Result<Vec<u8>>;

    /// Whether there is a file `name`.
    fn has(&self, name: &str) -> bool {
        self.bytes(name).is_ok()
    }
}

/// Files in the folder of the scene and below or beside it.
#[derive(Clone, Debug)]
pub struct Beside(PathBuf);

impl Beside {
    /// Files beside the scene at `path`.
    pub fn scene(path: &Path) -> Self {
        Beside(path.parent().unwrap_or(Path::new("")).to_path_buf())
    }

    fn path(&self, name: &str) -> io::Result<PathBuf> {
        // Files made on Windows write backslashes.
        let name = name.replace('\\', "/");
        let path = Path::new(&name);
        match path.components().any(|part| matches!(part, Component::RootDir | Component::Prefix(_))) {
            true => {
                let reason = "only paths relative to the scene are followed";
                Err(io::Error::new(io::ErrorKind::InvalidInput, reason))
            }
            false => Ok(self.0.join(path)),
        }
    }
}

impl Files for Beside {
    fn bytes(&self, name: &str) -> io::Result<Vec<u8>> {
        let mut bytes = Vec::new();
        File::open(self.path(name)?)?.take(MOST_BYTES + 1).read_to_end(&mut bytes)?;
        match bytes.len() as u64 > MOST_BYTES {
            true => Err(io::Error::new(
                io::ErrorKind::FileTooLarge,
                format!("it is longer than {MOST_BYTES} bytes"),
            )),
            false => Ok(bytes),
        }
    }

    fn has(&self, name: &str) -> bool {
        self.path(name).is_ok_and(|path| path.is_file())
    }
}

/// No files: a scene from standard input or from memory.
#[derive(Clone, Copy, Debug)]
pub struct NoFiles;

impl Files for NoFiles {
    fn bytes(&self, _name: &str) -> io::Result<Vec<u8>> {
        Err(io::Error::new(
            io::ErrorKind::NotFound,
            "a scene without a folder of its own names no other files",
        ))
    }
}
