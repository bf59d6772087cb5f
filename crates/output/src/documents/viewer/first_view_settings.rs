//! The first view of a page: camera, exposure, quantity and colours.

use radiosity_scene::Camera;

use radiosity_reading::pictures::pixel_grid::PixelGrid;
use radiosity_reading::quantity::Quantity;

/// The first view of a page.
#[derive(Clone, Debug, PartialEq)]
pub struct FirstViewSettings {
    /// Camera of the first view.
    pub camera: Camera,
    /// Points of a pixel at which it is sampled, once the picture stands still.
    pub grid: PixelGrid,
    /// Factor on radiosities before they become colours, in proportion up to white; None: as it is chosen for
    /// pictures, with a soft approach to white.
    pub exposure: Option<f64>,
    /// Quantity that is shown.
    pub shown: Quantity,
    /// False colours instead of a photograph.
    pub false_colours: Option<FirstViewColours>,
}

/// False colours to begin with.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FirstViewColours {
    /// Index of the band; None for the mean of all.
    pub band: Option<usize>,
    /// Ends of the scale; None: chosen for the view.
    pub range: Option<[f64; 2]>,
    /// Whether neighbouring colours differ by equal ratios instead of equal differences.
    pub log: bool,
}
