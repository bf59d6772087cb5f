//! The reader: primitives one after another, commands by going down.

use radiosity_photometry::error::{Refusal, refuse};
use radiosity_photometry::text::short;

use crate::budget::Budget;
use crate::builder::ModelBuilder;
use crate::includes::Includes;
use crate::model::{Model, Shape};
use crate::rad::commands::{self, Frame, Pass, Source};
use crate::rad::materials::{Materials, Meaning};
use crate::rad::scanner::{Item, Primitive, Scanner};
use crate::rad::shapes;
use radiosity_photometry::files::Files;

/// Reader of a scene of Radiance: the model and the modifiers up to the item that is read.
pub(super) struct Reader<'a> {
    includes: Includes<'a>,
    model: ModelBuilder,
    materials: Materials,
    budget: Budget,
}

impl<'a> Reader<'a> {
    /// A reader of the scene that messages call `file`.
    pub(super) fn new(file: &str, files: &'a dyn Files) -> Self {
        Self {
            includes: Includes::new(file, files),
            model: ModelBuilder::default(),
            materials: Materials::default(),
            budget: Budget::default(),
        }
    }

    /// The model that was read.
    pub(super) fn finish(mut self) -> Model {
        // Radiance reference manual, "Materials": radiance in W/(m² sr).
        self.model.unit("W/m²");
        self.model.finish()
    }

    /// Reads the text of a file into a frame.
    ///
    /// # Errors
    /// The first item that cannot be followed.
    pub(super) fn read(&mut self, text: &str, frame: &Frame) -> Result<(), Refusal> {
        let mut scanner = Scanner::new(text);
        loop {
            let before = scanner.left();
            let next = scanner.next().and_then(|next| {
                self.budget.spend(before - scanner.left())?;
                Ok(next)
            });
            let Some((line, item)) = next.map_err(|refusal| self.refusal(refusal, scanner.line()))? else {
                return Ok(());
            };
            let done = match item {
                Item::Command(command) => commands::parse(&command)
                    .and_then(|command| self.pass(&command.source, &command.passes, frame, line)),
                Item::Primitive(primitive) => self.primitive(&primitive, frame, line),
            };
            done.map_err(|refusal| self.refusal(refusal, line))?;
        }
    }

    fn refusal(&self, refusal: Refusal, line: usize) -> Refusal {
        refusal.in_line(self.includes.current(), line)
    }

    fn primitive(&mut self, primitive: &Primitive, frame: &Frame, line: usize) -> Result<(), Refusal> {
        let left_out = match primitive.kind.as_str() {
            "source" => "light from afar (source) is left out",
            "instance" => "instances of octrees are left out",
            "mesh" => "compiled meshes are left out",
            _ => {
                if let Some(shape) = shapes::shape(primitive)? {
                    return self.surface([&primitive.modifier, &primitive.name], &shape, frame, line);
                }
                let note = |text| self.model.note_of(text, line);
                return match self.materials.define(primitive, note)? {
                    true => Ok(()),
                    false => refuse(
                        format!("'{}' is no type of Radiance", short(&primitive.kind)),
                        "correct it; a primitive is modifier, type, name, and three lists with their counts",
                    ),
                };
            }
        };
        self.model.note(left_out, line);
        Ok(())
    }

    /// Adds a surface of a modifier, or of that of the frame, and a name.
    fn surface(
        &mut self,
        [modifier, name]: [&str; 2],
        shape: &Shape,
        frame: &Frame,
        line: usize,
    ) -> Result<(), Refusal> {
        let modifier = match &frame.modifier {
            // One of the open files gives it.
            Some(given) => self.materials.get(given).map_err(|fault| fault.quoting(self.includes.open()))?,
            None => self.materials.get(modifier)?,
        };
        let coat = match &modifier.meaning {
            Meaning::Coat(coat) => coat.clone(),
            Meaning::Absent(note) => {
                self.model.note(*note, line);
                return Ok(());
            }
        };
        self.model.note_coat(&modifier.left_out);
        let mut placed = frame.placed.shape(shape);
        if frame.is_turned {
            placed.turn_over();
        }
        self.model.surface(Some(&format!("{}{name}", frame.prefix)), placed, &coat, line)
    }

    /// Sends what a command starts with through its last pass, and this through those before.
    fn pass(&mut self, source: &Source, passes: &[Pass], frame: &Frame, line: usize) -> Result<(), Refusal> {
        let Some((last, before)) = passes.split_last() else {
            return match source {
                Source::Files(files) => files.iter().try_for_each(|file| self.include(file, frame)),
                Source::Shapes { modifier, name, shapes } => {
                    shapes.iter().try_for_each(|shape| self.surface([modifier, name], shape, frame, line))
                }
            };
        };
        for instance in 0..last.count() {
            self.budget.spend_on_include()?;
            self.pass(source, before, &last.frame(instance, frame)?, line)?;
        }
        Ok(())
    }

    /// Reads another file. Radiance looks for it in the folder that it is started in, which is taken for the
    /// scene's; if it is not there, it is looked for beside the file that names it.
    fn include(&mut self, name: &str, frame: &Frame) -> Result<(), Refusal> {
        let beside = self.includes.beside(name);
        let path = if self.includes.has(name) { name } else { &beside };
        let text = self.includes.enter(path)?;
        self.model.stand_in(self.includes.included());
        self.read(&text, frame)?;
        self.includes.leave();
        self.model.stand_in(self.includes.included());
        Ok(())
    }
}
