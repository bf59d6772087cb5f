//! Refusals of pictures: too large, empty, transparent or not finite.

use std::fmt::Display;

use radiosity_photometry::error::{Refusal, refuse};

/// Most texels of a file in all, 8192 × 8192: a bound of time and memory.
pub(super) const MOST_READ: u64 = 1 << 26;

/// Most texels of a file along one side, so that a row has at most half a megabyte.
pub(super) const LONGEST: u64 = 1 << 16;

/// Refuses more texels than are read, before anything is allocated for them.
pub(super) fn check_size([columns, rows]: [u64; 2]) -> Result<(), Refusal> {
    if columns == 0 || rows == 0 {
        return refuse("it has no texels", "choose another picture");
    }
    if columns > LONGEST || rows > LONGEST || columns * rows > MOST_READ {
        return refuse(
            format!("it has {columns} × {rows} texels, more than 65536 along a side or 8192 × 8192 in all"),
            "make it smaller, e.g. with ImageMagick: magick large.png -resize 4096x4096 small.png",
        );
    }
    Ok(())
}

/// A damaged or cut file; `problem` is what its reader says.
pub(super) fn damaged(problem: impl Display) -> Refusal {
    Refusal::new(format!("it is damaged or cut off: {problem}"), "write it again")
}

/// Refusal of a transparent texel.
pub(super) fn transparent(place: [usize; 2]) -> Refusal {
    Refusal::new(
        format!("{} is transparent", title(place)),
        "lay it on a colour, e.g. with ImageMagick: magick wood.png -background white -flatten flat.png",
    )
}

/// Refusal of a texel that is not finite.
pub(super) fn not_finite(place: [usize; 2], value: f64) -> Refusal {
    let cause = format!("{} is {value}, no finite number", title(place));
    Refusal::new(cause, "write the picture with finite numbers")
}

fn title([column, row]: [usize; 2]) -> String {
    format!("the texel in column {}, row {} from the top", column + 1, row + 1)
}
