//! Texels without light of their own: filled in from their neighbours.

/// The eight neighbours of a texel.
const AROUND: [[isize; 2]; 8] = [[-1, -1], [0, -1], [1, -1], [-1, 0], [1, 0], [-1, 1], [0, 1], [1, 1]];

/// Gives every texel that is not `known` the mean of those of its eight neighbours that are, ring by ring
/// outwards; zero to all where none is.
pub(super) fn fill(plane: &mut [f32], size: [usize; 2], known: &[bool]) {
    let mut known = known.to_vec();
    let mut ring: Vec<usize> = (0..plane.len()).filter(|texel| !known[*texel]).collect();
    while !ring.is_empty() {
        let values: Vec<(usize, f32)> =
            ring.iter().filter_map(|texel| Some((*texel, mean(plane, size, &known, *texel)?))).collect();
        for (texel, value) in &values {
            plane[*texel] = *value;
            known[*texel] = true;
        }
        // Only what lies beside these has got a new neighbour.
        let beside = values.iter().flat_map(|(texel, _)| around(size, *texel));
        ring = beside.filter(|other| !known[*other]).collect();
        ring.sort_unstable();
        ring.dedup();
    }
}

/// The mean of the known neighbours of a texel.
fn mean(plane: &[f32], size: [usize; 2], known: &[bool], texel: usize) -> Option<f32> {
    let beside = around(size, texel).filter(|other| known[*other]);
    let (sum, count) = beside.fold((0.0, 0.0), |(sum, count), other| (sum + plane[other], count + 1.0));
    (count > 0.0).then(|| sum / count)
}

/// The neighbours of a texel.
fn around([columns, rows]: [usize; 2], texel: usize) -> impl Iterator<Item = usize> {
    let [i, j] = [texel % columns, texel / columns].map(|at| at as isize);
    let beside = AROUND
        .iter()
        .map(move |[x, y]| [i + x, j + y])
        .filter(move |[x, y]| (0..columns as isize).contains(x) && (0..rows as isize).contains(y));
    beside.map(move |[x, y]| y as usize * columns + x as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unknown_texels_lie_between_the_known_ones() {
        let mut plane = vec![0.0; 12];
        let mut known = vec![false; 12];
        (plane[0], plane[11]) = (2.0, 4.0);
        (known[0], known[11]) = (true, true);
        fill(&mut plane, [4, 3], &known);
        assert!(plane.iter().all(|value| (2.0..=4.0).contains(value)), "{plane:?}");
        assert_eq!([plane[0], plane[1], plane[10], plane[11]], [2.0, 2.0, 4.0, 4.0]);
        let mut dark = vec![0.0; 4];
        fill(&mut dark, [2, 2], &[false; 4]);
        assert_eq!(dark, [0.0; 4]);
    }
}
