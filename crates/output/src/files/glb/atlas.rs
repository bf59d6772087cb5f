//! An atlas: rectangles of texels side by side in one image.
//!
//! They stand in rows, highest first. The image is about as wide as a square of all their texels, or as the
//! widest, and as high as the rows need: a rectangle far higher than that square leaves much empty. Around
//! each is a margin, which repeats its outermost texels: graphics hardware that smooths edges reads a pixel
//! at its middle, which may lie beyond the edge of the triangle.

/// Part by which an image is wider than the root of its texels, to leave room at the ends of rows. Chosen.
const ROOM: f64 = 1.05;

/// Texels of the margin on every side: pixels of up to eight texels read none beyond. Chosen.
pub(super) const MARGIN: usize = 4;

/// Places of rectangles.
#[derive(Clone, Debug)]
pub(super) struct Atlas {
    size: [usize; 2],
    sizes: Vec<[usize; 2]>,
    corners: Vec<[usize; 2]>,
}

impl Atlas {
    /// The atlas of rectangles of these sizes, across and down.
    pub(super) fn of(sizes: Vec<[usize; 2]>) -> Self {
        let whole = |[across, down]: [usize; 2]| [across + 2 * MARGIN, down + 2 * MARGIN];
        let texels: usize = sizes.iter().map(|size| whole(*size)).map(|[across, down]| across * down).sum();
        let widest = sizes.iter().map(|size| whole(*size)[0]).max().unwrap_or(1);
        let width = widest.max((ROOM * (texels as f64).sqrt()).ceil() as usize);
        let mut order: Vec<usize> = (0..sizes.len()).collect();
        order.sort_by_key(|index| std::cmp::Reverse(sizes[*index][1]));
        let mut corners = vec![[0, 0]; sizes.len()];
        let (mut left, mut top, mut bottom) = (0, 0, 0);
        for index in order {
            let [across, down] = whole(sizes[index]);
            if left + across > width {
                (left, top) = (0, bottom);
            }
            corners[index] = [left + MARGIN, top + MARGIN];
            left += across;
            bottom = bottom.max(top + down);
        }
        Self { size: [width, bottom.max(1)], sizes, corners }
    }

    /// Texels across and down.
    pub(super) fn size(&self) -> [usize; 2] {
        self.size
    }

    /// The left upper texel of a rectangle, within its margin.
    pub(super) fn corner(&self, index: usize) -> [usize; 2] {
        self.corners[index]
    }

    /// A place in [0, 1]² of a rectangle as one of the image.
    pub(super) fn place(&self, index: usize, at: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| {
            let texel = self.corners[index][k] as f64 + at[k] * self.sizes[index][k] as f64;
            texel / self.size[k] as f64
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rectangles_lie_apart_in_an_image_of_little_waste() {
        let sizes: Vec<[usize; 2]> = (0..60).map(|k| [2 + (k * 37) % 90, 2 + (k * 53) % 70]).collect();
        let atlas = Atlas::of(sizes.clone());
        let [width, height] = atlas.size();
        let mut taken = vec![false; width * height];
        for (index, [across, down]) in sizes.iter().enumerate() {
            let [left, top] = atlas.corner(index);
            let [right, bottom] = [left + across + MARGIN, top + down + MARGIN];
            for (x, y) in (top - MARGIN..bottom).flat_map(|y| (left - MARGIN..right).map(move |x| (x, y))) {
                let at = y * width + x;
                assert!(!std::mem::replace(&mut taken[at], true), "{index} lies on another");
            }
            let end = atlas.place(index, [1.0, 1.0]);
            assert!((end[0] * width as f64 - (left + across) as f64).abs() < 1e-9);
            assert!((end[1] * height as f64 - (top + down) as f64).abs() < 1e-9);
        }
        let used = taken.iter().filter(|taken| **taken).count();
        assert!(10 * used > 7 * taken.len(), "{used} of {}", taken.len());
    }
}
