//! What a page shows first.

use radiosity_scene::Camera;

use crate::readings::shown::Shown;

/// What the page shows first.
#[derive(Clone, Debug, PartialEq)]
pub struct Start {
    /// From where.
    pub camera: Camera,
    /// Samples along each side of a pixel, once the picture stands still.
    pub samples: u32,
    /// Factor on radiosities before they become colours, in proportion up to white; None: as it is chosen for pictures, with a
    /// soft approach to white.
    pub exposure: Option<f64>,
    /// The quantity.
    pub shown: Shown,
    /// False colours instead of a photograph.
    pub false_colours: Option<StartColours>,
}

/// False colours to begin with.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StartColours {
    /// The band; None for the mean of all.
    pub band: Option<usize>,
    /// Ends of the scale; None: chosen for the view.
    pub range: Option<[f64; 2]>,
    /// Equal ratios between neighbouring colours instead of equal differences.
    pub log: bool,
}
