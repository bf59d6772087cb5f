//! Cut of the unknowns of a system into blocks.

use std::ops::Range;

/// A cut of the unknowns `0..dim` into consecutive blocks, some of which may be empty.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Partition {
    /// Block `i` is `offsets[i]..offsets[i + 1]`.
    offsets: Vec<usize>,
}

impl Partition {
    /// Blocks of the given `sizes`, in this order.
    pub fn new(sizes: &[usize]) -> Self {
        let mut offsets = Vec::with_capacity(sizes.len() + 1);
        offsets.push(0);
        for size in sizes {
            offsets.push(offsets[offsets.len() - 1] + size);
        }
        Self { offsets }
    }

    /// `dim` blocks of one unknown each.
    pub fn points(dim: usize) -> Self {
        Self { offsets: (0..=dim).collect() }
    }

    /// The first unknown of each block, followed by the dimension: `len() + 1` ascending numbers.
    pub fn offsets(&self) -> &[usize] {
        &self.offsets
    }

    /// Number of blocks.
    pub fn len(&self) -> usize {
        self.offsets.len() - 1
    }

    /// Whether there is no block at all.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Number of unknowns in all blocks together.
    pub fn dim(&self) -> usize {
        self.offsets[self.len()]
    }

    /// The unknowns of one `block`.
    ///
    /// # Panics
    /// If `block` is not below [`len`](Self::len).
    pub fn range(&self, block: usize) -> Range<usize> {
        self.offsets[block]..self.offsets[block + 1]
    }

    /// Number of unknowns of one `block`.
    ///
    /// # Panics
    /// If `block` is not below [`len`](Self::len).
    pub fn size(&self, block: usize) -> usize {
        self.range(block).len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_tile_the_unknowns() {
        let partition = Partition::new(&[3, 0, 1, 91]);
        let unknowns: Vec<usize> = (0..partition.len()).flat_map(|block| partition.range(block)).collect();
        assert_eq!(unknowns, (0..95).collect::<Vec<_>>());
        assert_eq!(partition.dim(), 95);
        assert_eq!(partition.offsets(), [0, 3, 3, 4, 95]);
    }

    #[test]
    fn nothing_is_a_partition_too() {
        assert_eq!(Partition::new(&[]).dim(), 0);
        assert!(Partition::new(&[]).is_empty());
        assert_eq!(Partition::points(2), Partition::new(&[1, 1]));
    }
}
