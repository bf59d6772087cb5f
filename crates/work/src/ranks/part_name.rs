//! The parts of a run that ranks share.

/// The parts of a run that ranks share. Its name numbers a part in a [journal](super::journal): where one
/// gets another meaning, the version of pieces is to be raised there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PartName {
    /// Rows of pairs of elements, sorted by what they need.
    SortedPairs,
    /// Blocks of pairs of elements.
    Blocks,
    /// Rays of elements.
    Rays,
    /// Rows of pairs of many small flat elements.
    Facets,
    /// Projections of direct light, and of its first bounce, element by element.
    FirstBounce,
    /// Ends of walks by which light from elements is judged.
    Importance,
    /// Light gathered at sensors.
    SensorLight,
    /// Walks from sensors.
    SensorWalks,
    /// Light that polynomials miss, element by element.
    Missed,
    /// Points that are read.
    Points,
    /// Cells that are read.
    Cells,
    /// Surfaces and places that the pixels of a picture see.
    Seen,
    /// Direct light of pixels.
    DirectLight,
    /// Direct light of those pixels that want more rays.
    MoreDirectLight,
    /// Light gathered at some pixels.
    GatheredLight,
    /// Gathered light of pixels between these.
    FittedLight,
    /// Middles of pixels.
    Middles,
    /// Pixels of a picture.
    Pixels,
    /// Surfaces that are seen in pixels.
    Sights,
    /// Elements along the rows of a picture.
    Borders,
    /// Textures of light, surface by surface.
    Textures,
    /// Walks of the referee, reading by reading.
    Referee,
    /// Pixels that are to be sampled finely.
    Crossings,
    /// Places that samples of pixels see, and direct light there.
    SampleLight,
}

impl PartName {
    /// Whether pieces of the part follow from the geometry and the options of an assembly alone.
    pub(super) fn is_of_transfers(self) -> bool {
        matches!(self, Self::SortedPairs | Self::Blocks | Self::Rays | Self::Facets)
    }
}
