//! A floor of planks by whole numbers alone, so that every machine makes the same picture.

/// Columns and rows.
pub const SIZE: [usize; 2] = [96, 64];

/// Rows of a plank.
const PLANK: usize = 16;

/// Red, green and blue in sRGB, texel after texel, row after row from the top.
pub fn texels() -> Vec<u8> {
    let [columns, rows] = SIZE;
    (0..columns * rows).flat_map(|index| texel(index % columns, index / columns)).collect()
}

fn texel(column: usize, row: usize) -> [u8; 3] {
    let (plank, within) = (row / PLANK, row % PLANK);
    // The joints of a plank: its long side, and one short side.
    if within == 0 || (column + 37 * plank).is_multiple_of(SIZE[0]) {
        return [52, 34, 22];
    }
    let bend = wave(2 * column + 53 * plank) / 4;
    let ring = wave(24 * within + bend + 31 * plank);
    let tone = 12 * (noise(plank) % 3) + ring / 4 + noise(97 * row + column) % 10;
    [(112 + tone) as u8, (72 + tone * 3 / 4) as u8, (44 + tone / 2) as u8]
}

/// A wave of triangles, 0 to 127 and back.
fn wave(place: usize) -> usize {
    let place = place % 256;
    if place < 128 { place } else { 255 - place }
}

/// A number that looks like chance (one step of a linear congruential generator, its upper bits).
fn noise(seed: usize) -> usize {
    (seed as u64 + 1).wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407) as usize
        >> 40
}
