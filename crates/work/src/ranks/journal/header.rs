//! The header of the file of a journal:
//!
//! ```text
//! 8 bytes RADJRNL2, 4 bytes version of the pieces, 8 bytes fingerprint of the run, little-endian
//! ```

/// The first bytes of all journals, and that of this format.
const FAMILY: &[u8] = b"RADJRNL";
const FORMAT: u8 = b'2';

/// Version of the pieces of runs, to be raised where those of one scene and options change their meaning, as
/// coefficients do with the order of the functions of an element, or where parts are named or numbered anew.
const PIECES: u32 = 7;

/// Bytes of a header.
pub(super) const HEADER: usize = 20;

/// The owner of a file of a journal, as its first bytes say.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Owner {
    /// The run that reads the file.
    Own,
    /// A run that was ended before it had written its header.
    Begun,
    /// A run of an earlier version of the program, whose pieces are of no use.
    Earlier,
    /// Another run.
    Other,
}

/// The header of the files of a run.
pub(super) fn header(fingerprint: u64) -> [u8; HEADER] {
    let mut header = [0; HEADER];
    let (format, run) = header.split_at_mut(8);
    format[..7].copy_from_slice(FAMILY);
    format[7] = FORMAT;
    run[..4].copy_from_slice(&PIECES.to_le_bytes());
    run[4..].copy_from_slice(&fingerprint.to_le_bytes());
    header
}

/// The owner of a file that begins with these bytes, at the most [`HEADER`] of them, where the own run has
/// this fingerprint.
pub(super) fn owner(begins: &[u8], fingerprint: u64) -> Owner {
    let own = header(fingerprint);
    if begins == own {
        return Owner::Own;
    }
    if own.starts_with(begins) || begins.iter().all(|byte| *byte == 0) {
        // A rank that was killed, or lost its power.
        return Owner::Begun;
    }
    if is_earlier(begins) { Owner::Earlier } else { Owner::Other }
}

fn is_earlier(begins: &[u8]) -> bool {
    let Some([format, rest @ ..]) = begins.strip_prefix(FAMILY) else { return false };
    let pieces = rest.first_chunk::<4>().map(|bytes| u32::from_le_bytes(*bytes));
    *format < FORMAT || (*format == FORMAT && pieces.is_some_and(|pieces| pieces < PIECES))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn owners_are_told_by_the_first_bytes() {
        let own = header(7);
        assert_eq!(owner(&own, 7), Owner::Own);
        assert_eq!(owner(&own, 8), Owner::Other);
        for begun in [&[][..], &own[..7], &own[..12], &own[..19], &[0; HEADER]] {
            assert_eq!(owner(begun, 7), Owner::Begun, "{begun:?}");
        }
        // The format before this one: the fingerprint came at once.
        let before = [&b"RADJRNL1"[..], &7u64.to_le_bytes(), &[5, 0, 0, 0]].concat();
        assert_eq!(owner(&before, 7), Owner::Earlier);
        assert_eq!(owner(&before[..16], 7), Owner::Earlier);
        let of_pieces =
            |version: u32| [&b"RADJRNL2"[..], &version.to_le_bytes(), &7u64.to_le_bytes()].concat();
        assert_eq!(owner(&of_pieces(PIECES - 1), 7), Owner::Earlier);
        assert_eq!(owner(&of_pieces(PIECES + 1), 7), Owner::Other);
        assert_eq!(owner(b"something else", 7), Owner::Other);
    }
}
