//! Wishes of the command line.

use std::error::Error;
use std::str::FromStr;

use radiosity::request::view::ViewRequest;

/// Seconds that pixels, and joints, are judged for unless asked for. Chosen: three minutes a scene.
const LONGEST: f64 = 60.0;

/// Pictures that are asked for.
#[derive(Clone, Debug)]
pub(crate) struct Asked {
    /// A scene, built in or a file; None for some that are built in.
    pub(crate) scene: Option<String>,
    pub(crate) view: ViewRequest,
    /// Pixels across and down, of each picture; none for that of the camera.
    pub(crate) sizes: Vec<[u32; 2]>,
    /// Frames of a film; None for a picture.
    pub(crate) frames: Option<usize>,
    /// Seconds of the processor that pixels, and joints, are judged for; 0 for costs alone.
    pub(crate) judge: f64,
}

impl Asked {
    /// The words that were typed.
    pub(crate) fn typed() -> Result<Self, Box<dyn Error>> {
        let view = ViewRequest::default();
        let mut asked = Self { scene: None, view, sizes: Vec::new(), frames: None, judge: LONGEST };
        let mut words = std::env::args().skip(1);
        while let Some(word) = words.next() {
            let mut next = || words.next().ok_or_else(|| format!("{word}: a value is missing"));
            match word.as_str() {
                "--eye" => asked.view.eye = Some(next()?.parse()?),
                "--target" => asked.view.target = Some(next()?.parse()?),
                "--view-up" => asked.view.view_up = Some(next()?.parse()?),
                "--fov" => asked.view.fov = Some(parsed(&next()?)?),
                "--size" => asked.sizes = next()?.split(',').map(size).collect::<Result<_, _>>()?,
                "--frames" => asked.frames = Some(parsed(&next()?)?),
                "--judge" => asked.judge = parsed(&next()?)?,
                _ if word.starts_with('-') => return Err(format!("'{word}' is unknown").into()),
                _ => asked.scene = Some(word),
            }
        }
        Ok(asked)
    }
}

fn parsed<T: FromStr<Err: ToString>>(text: &str) -> Result<T, String> {
    text.parse().map_err(|error: T::Err| format!("'{text}': {}", error.to_string()))
}

/// Two numbers with an x between.
fn size(text: &str) -> Result<[u32; 2], String> {
    let (width, height) =
        text.split_once('x').ok_or_else(|| format!("'{text}' is no size, such as 640x480"))?;
    Ok([parsed(width)?, parsed(height)?])
}
