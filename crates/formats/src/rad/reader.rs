//! The reader: primitives one after another, commands by going down.

use radiosity_photometry::error::Refusal;
use radiosity_photometry::fault::Fault;
use radiosity_photometry::text::short;

use crate::budget::Budget;
use crate::builder::ModelBuilder;
use crate::files::Files;
use crate::includes::Includes;
use crate::model::{Model, Shape};
use crate::rad::commands::{self, Frame, Pass, Source};
use crate::rad::materials::{Materials, Meaning};
use crate::rad::scanner::{Item, Primitive, Scanner};
use crate::rad::shapes;

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
            let next = scanner.next().map_err(|fault| self.refusal(fault, scanner.line()))?;
            self.budget
                .spend(before - scanner.left())
                .map_err(|fault| self.refusal(fault, scanner.line()))?;
            match next {
                None => return Ok(()),
                Some((line, Item::Command(command))) => self.command(&command, frame, line)?,
                Some((line, Item::Primitive(primitive))) => {
                    self.primitive(&primitive, frame, line).map_err(|fault| self.refusal(fault, line))?
                }
            }
        }
    }

    fn refusal(&self, fault: Fault, line: usize) -> Refusal {
        fault.in_line(self.includes.current(), line)
    }

    fn primitive(&mut self, primitive: &Primitive, frame: &Frame, line: usize) -> Result<(), Fault> {
        let left_out = match primitive.kind.as_str() {
            "source" => "light from afar (source) is left out",
            "instance" => "instances of octrees are left out",
            "mesh" => "compiled meshes are left out",
            _ => {
                if let Some(shape) = shapes::shape(primitive)? {
                    return self.surface(primitive, shape, frame, line);
                }
                let notes = self.materials.define(primitive)?.ok_or_else(|| {
                    Fault::new(
                        format!("'{}' is no type of Radiance", short(&primitive.kind)),
                        "correct it; a primitive is modifier, type, name, and three lists with their counts",
                    )
                })?;
                for note in notes {
                    self.model.note(note, line);
                }
                return Ok(());
            }
        };
        self.model.note(left_out, line);
        Ok(())
    }

    /// Adds a surface of its modifier, or of that of the frame.
    fn surface(
        &mut self,
        Primitive { modifier, name, .. }: &Primitive,
        shape: Shape,
        frame: &Frame,
        line: usize,
    ) -> Result<(), Fault> {
        let coat = match self.materials.get(frame.modifier.as_ref().unwrap_or(modifier))? {
            Meaning::Coat(coat) => coat.clone(),
            Meaning::Absent(note) => {
                self.model.note(note, line);
                return Ok(());
            }
        };
        let mut placed = frame.placed.shape(&shape);
        if frame.is_turned {
            placed.turn_over();
        }
        self.model.surface(Some(&format!("{}{name}", frame.prefix)), placed, &coat, line)
    }

    fn command(&mut self, command: &str, frame: &Frame, line: usize) -> Result<(), Refusal> {
        let command = commands::parse(command).map_err(|fault| self.refusal(fault, line))?;
        self.pass(&command.source, &command.passes, frame, line)
    }

    /// Sends what a command starts with through its last pass, and this through those before.
    fn pass(&mut self, source: &Source, passes: &[Pass], frame: &Frame, line: usize) -> Result<(), Refusal> {
        let Some((last, before)) = passes.split_last() else {
            return match source {
                Source::Files(files) => files.iter().try_for_each(|file| self.include(file, frame, line)),
                Source::Shapes { modifier, name, shapes } => self
                    .shapes(modifier, name, shapes, frame, line)
                    .map_err(|fault| self.refusal(fault, line)),
            };
        };
        for instance in 0..last.count() {
            let inner = self.budget.spend_on_include().and_then(|()| last.frame(instance, frame));
            let inner = inner.map_err(|fault| self.refusal(fault, line))?;
            self.pass(source, before, &inner, line)?;
        }
        Ok(())
    }

    fn shapes(
        &mut self,
        modifier: &str,
        name: &str,
        shapes: &[Shape],
        frame: &Frame,
        line: usize,
    ) -> Result<(), Fault> {
        let primitive =
            Primitive { modifier: modifier.to_owned(), name: name.to_owned(), ..Primitive::default() };
        shapes.iter().try_for_each(|shape| self.surface(&primitive, shape.clone(), frame, line))
    }

    /// Reads another file. Radiance looks for it in the folder that it is started in, which is taken for the
    /// scene's; if it is not there, it is looked for beside the file that names it.
    fn include(&mut self, name: &str, frame: &Frame, line: usize) -> Result<(), Refusal> {
        let beside = self.includes.beside(name);
        let path = if self.includes.has(name) { name } else { &beside };
        let text = self.includes.enter(path).map_err(|fault| self.refusal(fault, line))?;
        self.read(&text, frame)?;
        self.includes.leave();
        Ok(())
    }
}
