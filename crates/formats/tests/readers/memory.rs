//! Files in memory.

use std::collections::HashMap;
use std::io;

use radiosity_photometry::files::{Files, Unread};

/// Files by their names.
#[derive(Default)]
pub(crate) struct Memory(HashMap<String, Vec<u8>>);

impl Memory {
    pub(crate) fn of<N: Into<String>, C: Into<Vec<u8>>>(files: impl IntoIterator<Item = (N, C)>) -> Self {
        Self(files.into_iter().map(|(name, content)| (name.into(), content.into())).collect())
    }
}

impl Files for Memory {
    fn bytes(&self, name: &str) -> Result<Vec<u8>, Unread> {
        let missing = || io::Error::new(io::ErrorKind::NotFound, "no such file").into();
        self.0.get(name).cloned().ok_or_else(missing)
    }
}
