//! Commands in a Radiance scene that are followed without running them: `!xform` and `!genbox`, also piped to
//! `xform`.
//!
//! Sources: Radiance, manual pages `xform(1)` and `genbox(1)`.

use glam::DVec3;
use radiosity_photometry::error::{Refusal, refuse};
use radiosity_photometry::text::{number, short};

use crate::model::Shape;
use crate::rad::shapes::genbox;
use crate::tolerances::LONGEST_NAME;
use crate::xform::{Similarity, Transforms};

/// A command: its source, and the `xform`s that its output goes through, the first first.
#[derive(Debug)]
pub(super) struct Command {
    /// Source of the surfaces.
    pub(super) source: Source,
    /// The `xform`s that the surfaces go through, the first first.
    pub(super) passes: Vec<Pass>,
}

/// Source of the surfaces of a command.
#[derive(Debug)]
pub(super) enum Source {
    /// Paths of scene files.
    Files(Vec<String>),
    /// Surfaces of a modifier and a name.
    Shapes {
        /// Name of the modifier.
        modifier: String,
        /// Name of the surfaces.
        name: String,
        /// Shapes of the surfaces.
        shapes: Vec<Shape>,
    },
}

/// An `xform`: transforms, what is put before names, another modifier, whether fronts are turned over.
#[derive(Debug)]
pub(super) struct Pass {
    transforms: Transforms,
    prefix: Option<String>,
    modifier: Option<String>,
    is_turned: bool,
}

/// Transform of surfaces, and changes of their fronts, names and modifiers.
#[derive(Clone, Debug)]
pub(super) struct Frame {
    /// Transform from the surfaces' coordinates to the scene's.
    pub(super) placed: Similarity,
    /// Whether the fronts of the surfaces are turned over.
    pub(super) is_turned: bool,
    /// Prefix of the surfaces' names, with a dot at its end, or empty.
    pub(super) prefix: String,
    /// The modifier that all surfaces have instead of their own.
    pub(super) modifier: Option<String>,
}

impl Default for Frame {
    /// The frame that changes nothing.
    fn default() -> Self {
        Self { placed: Similarity::IDENTITY, is_turned: false, prefix: String::new(), modifier: None }
    }
}

/// Most stages of a command, each of which places those before it, so that their products are bounded.
const MOST_STAGES: usize = 32;

impl Pass {
    /// Number of instances that the `xform` makes.
    pub(super) fn count(&self) -> usize {
        self.transforms.count()
    }

    /// The frame of an instance inside another frame.
    pub(super) fn frame(&self, instance: usize, outer: &Frame) -> Result<Frame, Refusal> {
        let prefix = match (&self.prefix, self.transforms.is_array()) {
            (Some(prefix), false) => format!("{}{prefix}.", outer.prefix),
            (Some(prefix), true) => format!("{}{prefix}.{instance}.", outer.prefix),
            (None, true) => format!("{}a{instance}.", outer.prefix),
            (None, false) => outer.prefix.clone(),
        };
        if prefix.len() > LONGEST_NAME {
            return refuse("the names behind -n are too long together", "write shorter ones");
        }
        Ok(Frame {
            placed: self.transforms.instance(instance).then(&outer.placed),
            is_turned: outer.is_turned != self.is_turned,
            prefix,
            modifier: outer.modifier.clone().or_else(|| self.modifier.clone()),
        })
    }
}

/// Reads a command, without its exclamation mark.
///
/// # Errors
/// Any command but `xform` with files and `genbox` of sharp edges, through `xform` or not.
pub(super) fn parse(command: &str) -> Result<Command, Refusal> {
    if command.matches('|').count() >= MOST_STAGES {
        return refuse(
            format!("a command has more than {MOST_STAGES} stages"),
            "join some of them: one xform takes several transforms",
        );
    }
    let mut stages = command.split('|').map(words);
    let first = stages.next().unwrap_or_default();
    let first: Vec<&str> = first.iter().map(String::as_str).collect();
    let (source, mut passes) = match first[..] {
        ["xform", ref arguments @ ..] => {
            let (pass, files) = xform(arguments)?;
            if files.is_empty() {
                return refuse("an xform names no file", "name one behind its transforms");
            }
            (Source::Files(files), vec![pass])
        }
        ["genbox" | "genrbox", ref arguments @ ..] => (boxed(arguments)?, Vec::new()),
        _ => return Err(not_followed(command)),
    };
    for stage in stages {
        let stage: Vec<&str> = stage.iter().map(String::as_str).collect();
        match stage[..] {
            ["xform", ref arguments @ ..] => {
                let (pass, files) = xform(arguments)?;
                if !files.is_empty() {
                    return Err(not_followed(command));
                }
                passes.push(pass);
            }
            _ => return Err(not_followed(command)),
        }
    }
    Ok(Command { source, passes })
}

fn not_followed(command: &str) -> Refusal {
    Refusal::new(
        format!("the command '!{}' is not run", short(command.trim())),
        "run it yourself and put what it prints in its place (Radiance: xform -e scene.rad > whole.rad)",
    )
}

/// The words of a command; quotes hold blanks together.
fn words(text: &str) -> Vec<String> {
    let (mut words, mut quote, mut word) = (Vec::new(), None, None::<String>);
    for c in text.chars() {
        match quote {
            Some(open) if c == open => quote = None,
            None if c == '"' || c == '\'' => {
                quote = Some(c);
                word.get_or_insert_default();
            }
            None if c.is_ascii_whitespace() => words.extend(word.take()),
            _ => word.get_or_insert_default().push(c),
        }
    }
    words.extend(word);
    words
}

/// Reads the arguments of `xform`: its options, the transforms, the files.
fn xform(arguments: &[&str]) -> Result<(Pass, Vec<String>), Refusal> {
    let mut rest = arguments;
    let (mut prefix, mut modifier, mut is_turned) = (None::<String>, None, false);
    loop {
        rest = match *rest {
            ["-n", name, ref rest @ ..] => {
                prefix = Some(prefix.map_or(name.to_owned(), |outer| format!("{outer}.{name}")));
                rest
            }
            ["-m", name, ref rest @ ..] => {
                modifier.get_or_insert(name.to_owned());
                rest
            }
            ["-I", ref rest @ ..] => {
                is_turned = !is_turned;
                rest
            }
            ["-e" | "-c", ref rest @ ..] => rest,
            _ => break,
        };
    }
    let (transforms, read) = Transforms::parse(rest)?;
    let files = &rest[read..];
    if let Some(flag) = files.iter().find(|word| word.starts_with('-')) {
        return refuse(
            format!("xform {} is not followed", short(flag)),
            "write -n, -m, -I, -e or -c first, then -t, -rx, -ry, -rz, -s, -mx, -my, -mz, -i or -a, then files",
        );
    }
    let files = files.iter().map(|file| (*file).to_owned()).collect();
    Ok((Pass { transforms, prefix, modifier, is_turned }, files))
}

/// Reads the arguments of `genbox`.
fn boxed(arguments: &[&str]) -> Result<Source, Refusal> {
    let [modifier, name, x, y, z, ref options @ ..] = *arguments else {
        return refuse("a genbox lacks arguments", "write genbox material name x y z");
    };
    if let Some(option) = options.iter().find(|option| **option != "-i") {
        return refuse(
            format!("genbox {} is not followed", short(option)),
            "take rounded and bevelled edges out, or put what genbox prints in its place",
        );
    }
    let corner = DVec3::new(number(x, "a size")?, number(y, "a size")?, number(z, "a size")?);
    if corner.min_element() <= 0.0 {
        return refuse("a box has no volume", "write three sizes above 0");
    }
    let mut shapes = genbox(corner);
    if !options.is_empty() {
        shapes.iter_mut().for_each(Shape::turn_over);
    }
    Ok(Source::Shapes { modifier: modifier.to_owned(), name: name.to_owned(), shapes })
}
