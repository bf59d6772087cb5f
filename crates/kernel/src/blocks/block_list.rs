//! Places of the blocks of one kind, run by run: of ten thousand elements that all see each other few numbers are kept
//! beside the values.

/// Chunks of blocks that are multiplied in parallel: enough for some cores, few enough for the sums of their
/// results.
const CHUNKS: usize = 32;

/// Places of the blocks of one kind.
#[derive(Clone, Debug, Default)]
pub(super) struct BlockList {
    /// Runs of blocks that this rank holds, by places ascending.
    starts: Vec<RunStart>,
    /// The emitter of each block.
    columns: Vec<u32>,
    /// The end of the values of the last block.
    end: usize,
    /// Number of blocks of all ranks.
    pub(super) all: usize,
}

/// The first block of a run.
#[derive(Clone, Copy, Debug)]
struct RunStart {
    row: u32,
    /// Its number among the blocks of the list.
    number: usize,
    start: usize,
    place: usize,
}

/// Blocks of one receiver whose values, and whose places among those of all ranks, follow each other.
#[derive(Clone, Copy, Debug)]
pub(super) struct Run<'a> {
    /// The receiver.
    pub(super) row: u32,
    /// The emitter of each block.
    pub(super) columns: &'a [u32],
    /// The first value.
    pub(super) start: usize,
    /// Place of the first block.
    place: usize,
}

/// The block of receiver `row` and emitter `column`, row-major from `start` on; `row ≤ column` where G is
/// symmetric.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stored {
    pub(super) row: u32,
    pub(super) column: u32,
    pub(super) start: usize,
    /// Place of the block among those of all ranks.
    pub(super) place: usize,
}

impl Stored {
    /// This block behind so many values and places.
    pub(super) fn after(self, values: usize, places: usize) -> Self {
        Self { start: values + self.start, place: places + self.place, ..self }
    }
}

impl BlockList {
    /// Appends a block of so many values.
    pub(super) fn push(&mut self, Stored { row, column, start, place }: Stored, values: usize) {
        let number = self.columns.len();
        let follows = |last: &RunStart| {
            last.row == row && self.end == start && place - last.place == number - last.number
        };
        if !self.starts.last().is_some_and(follows) {
            self.starts.push(RunStart { row, number, start, place });
        }
        self.columns.push(column);
        self.end = start + values;
    }

    /// The runs of this rank.
    pub(super) fn runs(&self) -> impl Iterator<Item = Run<'_>> {
        let ends = self.starts.iter().skip(1).map(|next| next.number).chain([self.columns.len()]);
        self.starts.iter().zip(ends).map(|(RunStart { row, number, start, place }, end)| Run {
            row: *row,
            columns: &self.columns[*number..end],
            start: *start,
            place: *place,
        })
    }

    /// The runs of this rank in [`CHUNKS`] lists, cut where those of all ranks would be; `size` tells the number of
    /// values of a block.
    pub(super) fn chunks(&self, size: impl Fn(usize, usize) -> usize) -> Vec<Vec<Run<'_>>> {
        let length = self.all.div_ceil(CHUNKS).max(1);
        let mut chunks: Vec<Vec<Run<'_>>> = Vec::new();
        let mut current = None;
        for mut rest in self.runs() {
            while !rest.columns.is_empty() {
                let chunk = rest.place / length;
                let (own, after) = rest.split((chunk + 1) * length, &size);
                if current != Some(chunk) {
                    chunks.push(Vec::new());
                    current = Some(chunk);
                }
                chunks.last_mut().expect("one was pushed").push(own);
                rest = after;
            }
        }
        chunks
    }
}

impl<'a> Run<'a> {
    /// Its blocks; `size` tells the number of values of each.
    pub(super) fn blocks(self, size: impl Fn(usize, usize) -> usize) -> impl Iterator<Item = Stored> {
        let Self { row, columns, mut start, place } = self;
        columns.iter().zip(place..).map(move |(column, place)| {
            let stored = Stored { row, column: *column, start, place };
            start += size(row as usize, *column as usize);
            stored
        })
    }

    /// The parts before and from a place on.
    fn split(self, place: usize, size: impl Fn(usize, usize) -> usize) -> (Self, Self) {
        let count = (place - self.place).min(self.columns.len());
        let (before, after) = self.columns.split_at(count);
        let skipped: usize = before.iter().map(|column| size(self.row as usize, *column as usize)).sum();
        let rest = Self { columns: after, start: self.start + skipped, place: self.place + count, ..self };
        (Self { columns: before, ..self }, rest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Number of values of a block.
    fn size(row: usize, column: usize) -> usize {
        row + 2 * column + 1
    }

    /// Blocks of three rows, of which one is pushed twice and one place and some values belong to others.
    fn pushed() -> (BlockList, Vec<[usize; 4]>) {
        let mut list = BlockList::default();
        let mut all = Vec::new();
        let mut start = 0;
        let places = (0..40).filter(|place| *place != 7);
        for place in places {
            let (row, column) = (place / 10 % 3, place % 10);
            start += if place == 25 { 4 } else { 0 };
            all.push([row, column, start, place]);
            list.push(Stored { row: row as u32, column: column as u32, start, place }, size(row, column));
            start += size(row, column);
        }
        list.all = 40;
        (list, all)
    }

    fn told(run: Run<'_>) -> Vec<[usize; 4]> {
        run.blocks(size).map(|own| [own.row as usize, own.column as usize, own.start, own.place]).collect()
    }

    #[test]
    fn runs_hold_what_was_pushed() {
        let (list, all) = pushed();
        assert_eq!(list.runs().flat_map(told).collect::<Vec<_>>(), all);
        assert_eq!(list.runs().count(), 6);
    }

    #[test]
    fn chunks_hold_all_blocks_and_are_cut_at_places() {
        let (list, all) = pushed();
        let chunks = list.chunks(size);
        assert_eq!(chunks.iter().flatten().copied().flat_map(told).collect::<Vec<_>>(), all);
        for chunk in &chunks {
            let mut places = chunk.iter().copied().flat_map(told).map(|[.., place]| place / 2);
            let first = places.next();
            assert!(places.all(|place| Some(place) == first));
        }
    }
}
