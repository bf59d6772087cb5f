//! A record: a piece of work in a file of a journal. Numbers are little-endian:
//!
//! ```text
//! 4 bytes length, 8 bytes part, 4 bytes piece, the bytes of the piece, 4 bytes CRC-32 of all these
//! ```

use std::io;
use std::io::Read;

use crate::checksum::Checksum;

/// The key of a piece: its part of the run, and its number in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Key {
    /// The part of the run.
    pub(super) part: u64,
    /// The number of the piece in it.
    pub(super) piece: u32,
}

/// Bytes of a record before those of the piece, and after them.
pub(super) const HEAD: usize = 16;
pub(super) const CHECK: usize = 4;

/// The record of a piece.
///
/// # Errors
/// A piece that is too long.
pub(super) fn record(key: &Key, piece: &[u8]) -> io::Result<Vec<u8>> {
    let length = u32::try_from(piece.len()).map_err(|_| io::Error::other("a piece has more than 4 GiB"))?;
    let mut record = Vec::with_capacity(HEAD + piece.len() + CHECK);
    record.extend(length.to_le_bytes());
    record.extend(key.part.to_le_bytes());
    record.extend(key.piece.to_le_bytes());
    record.extend(piece);
    record.extend(Checksum::of(&record).to_le_bytes());
    Ok(record)
}

/// The piece of a record, if it is whole and that of this key.
pub(super) fn piece<'a>(key: &Key, record: &'a [u8]) -> Option<&'a [u8]> {
    let (checked, check) = record.split_last_chunk::<CHECK>()?;
    let (head, piece) = checked.split_first_chunk::<HEAD>()?;
    let is_own = parsed(head) == (*key, piece.len() as u32);
    (is_own && Checksum::of(checked).to_le_bytes() == *check).then_some(piece)
}

/// The key of the next record, and the length of its piece; None at the end.
pub(super) fn next_head(reader: &mut impl Read) -> Option<(Key, u32)> {
    let mut head = [0; HEAD];
    reader.read_exact(&mut head).ok()?;
    Some(parsed(&head))
}

fn parsed(head: &[u8; HEAD]) -> (Key, u32) {
    let number = |start: usize| u32::from_le_bytes(head[start..start + 4].try_into().expect("four bytes"));
    let part = u64::from_le_bytes(head[4..12].try_into().expect("eight bytes"));
    (Key { part, piece: number(12) }, number(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_record_is_read_back_and_no_changed_byte_is_missed() {
        let key = Key { part: 7, piece: 3 };
        let whole = record(&key, b"of work").expect("it is short");
        assert_eq!(next_head(&mut &whole[..]), Some((key, 7)));
        assert_eq!(piece(&key, &whole), Some(&b"of work"[..]));
        assert_eq!(piece(&Key { piece: 4, ..key }, &whole), None);
        for place in 0..whole.len() {
            let mut changed = whole.clone();
            changed[place] ^= 1;
            assert_eq!(piece(&key, &changed), None, "byte {place}");
            assert_eq!(piece(&key, &whole[..place]), None, "{place} bytes");
        }
    }
}
