//! The reader: entities one after another, arrays by going back, includes by going down.

use std::collections::BTreeMap;

use glam::DVec3;
use radiosity_photometry::error::{Refusal, refuse};
use radiosity_photometry::note::Note;
use radiosity_photometry::text::{number, short};

use crate::budget::Budget;
use crate::builder::{Coat, ModelBuilder};
use crate::face_normals::{FaceNormals, Remark};
use crate::includes::Includes;
use crate::lines::Lines;
use crate::mgf::chromaticity::{Chromaticity, MixturePart};
use crate::mgf::contexts::Contexts;
use crate::mgf::shapes::{self, Vertex};
use crate::model::{Model, Shape, Sides};
use crate::tolerances::LONGEST_NAME;
use crate::xform::{Similarity, Transforms};
use radiosity_photometry::files::Files;

/// A transform that was begun and not yet ended.
struct Open<'a> {
    transforms: Transforms,
    /// Index of the instance that is being read.
    instance: usize,
    /// The transform outside it.
    outside: Similarity,
    /// The line behind it, to which an array goes back.
    start: Lines<'a>,
}

/// A value of a context, or why it is none, which counts where a surface has it.
#[derive(Clone, Debug)]
struct Stated<T>(Result<T, Refusal>);

impl<T: Default> Default for Stated<T> {
    fn default() -> Self {
        Self(Ok(T::default()))
    }
}

/// A material: red, green and blue of what it reflects and emits, and its sides.
#[derive(Clone, Debug)]
struct Material {
    reflectance: Stated<[f64; 3]>,
    emission: Stated<[f64; 3]>,
    sides: Sides,
    /// Notes on what is left out of it, by entity; they are told where a surface has it.
    left_out: BTreeMap<String, Note>,
}

impl Default for Material {
    /// Black on both sides.
    fn default() -> Self {
        Self {
            reflectance: Stated::default(),
            emission: Stated::default(),
            sides: Sides::Both,
            left_out: BTreeMap::new(),
        }
    }
}

impl Material {
    /// The coat of a surface that has it.
    ///
    /// # Errors
    /// Values that are faulty.
    fn coat(&self, name: &str) -> Result<Coat, Refusal> {
        let Self { reflectance: Stated(reflectance), emission: Stated(emission), sides, .. } = self;
        let (reflectance, emission) = (reflectance.clone()?, emission.clone()?);
        Ok(Coat { name: name.to_owned(), reflectance, emission, sides: *sides })
    }
}

/// Reader of an MGF file: the model and the contexts up to the line that is read.
pub(super) struct Reader<'a> {
    includes: Includes<'a>,
    model: ModelBuilder,
    vertices: Contexts<Vertex>,
    colours: Contexts<Stated<Chromaticity>>,
    materials: Contexts<Material>,
    objects: Vec<String>,
    placed: Similarity,
    budget: Budget,
}

impl<'a> Reader<'a> {
    /// A reader of the scene that messages call `file`.
    pub(super) fn new(file: &str, files: &'a dyn Files) -> Self {
        Self {
            includes: Includes::new(file, files),
            model: ModelBuilder::default(),
            vertices: Contexts::new("vertex"),
            colours: Contexts::new("colour"),
            materials: Contexts::new("material"),
            objects: Vec::new(),
            placed: Similarity::IDENTITY,
            budget: Budget::default(),
        }
    }

    /// The model that was read.
    pub(super) fn finish(mut self) -> Model {
        // MGF 2.0, entity `ed`: lumens per square metre.
        self.model.unit("lx");
        self.model.finish()
    }

    /// Reads the text of a file.
    ///
    /// # Errors
    /// The first line that cannot be followed.
    pub(super) fn read(&mut self, text: &str) -> Result<(), Refusal> {
        let outer = self.placed;
        let (mut lines, mut open) = (Lines::new(text, |line| line), Vec::new());
        while let Some(line) = lines.next() {
            let words: Vec<&str> = line.text.split_ascii_whitespace().collect();
            let done = self.budget.spend(line.text.len()).and_then(|()| match words[..] {
                [] => Ok(()),
                ["xf", ref arguments @ ..] => self.transform(arguments, &mut lines, &mut open),
                ["i", ref arguments @ ..] => self.include(arguments),
                [entity, ref arguments @ ..] => self.entity(entity, arguments, line.number),
            });
            done.map_err(|refusal| self.refusal(refusal, line.number))?;
        }
        self.end(&open)?;
        self.placed = outer;
        Ok(())
    }

    fn refusal(&self, refusal: Refusal, line: usize) -> Refusal {
        refusal.in_line(self.includes.current(), line)
    }

    /// Entity `xf`: with arguments it begins a transform; without it ends one, or goes back to its next
    /// instance.
    fn transform<'t>(
        &mut self,
        arguments: &[&str],
        lines: &mut Lines<'t>,
        open: &mut Vec<Open<'t>>,
    ) -> Result<(), Refusal> {
        if !arguments.is_empty() {
            let (transforms, outside) = (transforms(arguments)?, self.placed);
            self.placed = transforms.instance(0).then(&outside);
            open.push(Open { transforms, instance: 0, outside, start: *lines });
            return Ok(());
        }
        let Some(last) = open.last_mut() else {
            return refuse("an xf ends no transform", "take it out, or begin one above: xf -t 0 0 1");
        };
        last.instance += 1;
        if last.instance < last.transforms.count() {
            self.placed = last.transforms.instance(last.instance).then(&last.outside);
            *lines = last.start;
        } else {
            self.placed = last.outside;
            open.pop();
        }
        Ok(())
    }

    /// Transforms that are not ended end with their file; of an array nobody knows what it repeats.
    fn end(&mut self, open: &[Open<'_>]) -> Result<(), Refusal> {
        for Open { transforms, start, .. } in open {
            let line = start.number() - 1;
            if transforms.is_array() {
                let cure = "write a line with xf alone behind what it repeats";
                return Err(self.refusal(Refusal::new("an array is not ended", cure), line));
            }
            self.model.note("a transform that is not ended ends with its file", line);
        }
        Ok(())
    }

    /// Entity `i`: another file, once or as an array.
    fn include(&mut self, arguments: &[&str]) -> Result<(), Refusal> {
        let Some((name, arguments)) = arguments.split_first() else {
            return refuse("an include names no file", "write its name behind i");
        };
        let transforms = transforms(arguments)?;
        let path = self.includes.beside(name);
        let outside = self.placed;
        for instance in 0..transforms.count() {
            let text = self.includes.enter(&path)?;
            self.model.stand_in(self.includes.included());
            self.placed = transforms.instance(instance).then(&outside);
            self.read(&text)?;
            self.includes.leave();
            self.model.stand_in(self.includes.included());
            self.budget.spend_on_include()?;
        }
        self.placed = outside;
        Ok(())
    }

    /// Follows an entity other than `xf` and `i`.
    fn entity(&mut self, entity: &str, arguments: &[&str], line: usize) -> Result<(), Refusal> {
        match entity {
            comment if comment.starts_with('#') => Ok(()),
            "v" => self.vertices.switch(arguments),
            "c" => self.colours.switch(arguments),
            "m" => self.materials.switch(arguments),
            "p" | "n" => self.set_vertex(entity, arguments),
            "cxy" | "cspec" | "cct" | "cmix" => self.set_colour(entity, arguments, line),
            "rd" | "ed" => self.set_light(entity, arguments, line),
            "sides" => self.set_sides(arguments),
            "rs" | "td" | "ts" | "ir" => self.leave_out(entity, arguments, line),
            "o" => self.object(arguments, line),
            "ies" => {
                self.model.note("luminaires with measured light (ies) are left out", line);
                Ok(())
            }
            "f" | "fh" | "sph" | "cyl" | "cone" | "ring" | "torus" | "prism" => {
                for shape in self.shapes(entity, arguments, line)? {
                    self.add(&shape, line)?;
                }
                Ok(())
            }
            _ => {
                self.model.note("lines that begin with no word of MGF are left out", line);
                Ok(())
            }
        }
    }

    fn set_vertex(&mut self, entity: &str, arguments: &[&str]) -> Result<(), Refusal> {
        let [x, y, z] = numbers(entity, arguments)?;
        let vertex = self.vertices.current_mut();
        match entity {
            "p" => vertex.point = DVec3::new(x, y, z),
            _ => vertex.normal = DVec3::new(x, y, z),
        }
        Ok(())
    }

    fn set_colour(&mut self, entity: &str, arguments: &[&str], line: usize) -> Result<(), Refusal> {
        let colour = match entity {
            "cxy" => {
                let [x, y] = numbers(entity, arguments)?;
                Chromaticity::of_xy(x, y)
            }
            "cct" => {
                let [kelvin] = numbers(entity, arguments)?;
                Chromaticity::of_black_body(kelvin)
            }
            "cspec" => {
                let values: Vec<f64> = arguments
                    .iter()
                    .map(|word| number(word, "a number of cspec"))
                    .collect::<Result<_, _>>()?;
                let [first, last, ref values @ ..] = values[..] else {
                    return Err(wrong_count("cspec", arguments.len(), "4 or more"));
                };
                Chromaticity::of_spectrum(first, last, values)
            }
            _ => self.mixture(arguments)?,
        };
        *self.colours.current_mut() = self.stated(colour, line);
        Ok(())
    }

    /// The value that a line states. A fault, which is noted where it is found, ends the reading if a surface has it.
    fn stated<T>(&mut self, value: Result<T, Refusal>, line: usize) -> Stated<T> {
        if value.as_ref().is_err_and(|fault| fault.file.is_empty()) {
            self.model.note("faulty colours and materials that no surface has are left out", line);
        }
        Stated(value.map_err(|fault| self.refusal(fault, line)))
    }

    /// The colour of a mixture, or why it is none.
    ///
    /// # Errors
    /// Arguments that are no mixture.
    fn mixture(&self, arguments: &[&str]) -> Result<Result<Chromaticity, Refusal>, Refusal> {
        let mut parts = Vec::new();
        for pair in arguments.chunks(2) {
            let [weight, colour] = *pair else {
                return refuse("a mixture lacks a colour", "write a weight before each colour");
            };
            let weight = number(weight, "a weight")?;
            parts.push((weight, self.colours.get(colour)?));
        }
        let part = |(weight, Stated(colour)): (f64, &Stated<Chromaticity>)| {
            Ok(MixturePart { weight, colour: colour.clone()? })
        };
        let parts: Result<Vec<MixturePart>, Refusal> = parts.into_iter().map(part).collect();
        Ok(parts.and_then(|parts| Chromaticity::of_mixture(&parts)))
    }

    /// Entities `rd` and `ed`: what the current material reflects or emits of the current colour.
    fn set_light(&mut self, entity: &str, arguments: &[&str], line: usize) -> Result<(), Refusal> {
        let [value] = numbers(entity, arguments)?;
        let Stated(colour) = self.colours.current().1;
        let bands = match value < 0.0 {
            true => refuse(format!("{entity} is {value}, below 0"), "write 0 or more"),
            false => colour.clone().map(|colour| colour.bands().map(|band| band * value)),
        };
        let bands = self.stated(bands, line);
        let material = self.materials.current_mut();
        match entity {
            "rd" => material.reflectance = bands,
            _ => material.emission = bands,
        }
        Ok(())
    }

    fn set_sides(&mut self, arguments: &[&str]) -> Result<(), Refusal> {
        let [value] = numbers("sides", arguments)?;
        self.materials.current_mut().sides = match value {
            1.0 => Sides::Front,
            2.0 => Sides::Both,
            _ => return refuse(format!("a material has {value} sides"), "write sides 1 or sides 2"),
        };
        Ok(())
    }

    /// Properties that radiosity does not carry; those that are 0 are not told.
    fn leave_out(&mut self, entity: &str, arguments: &[&str], line: usize) -> Result<(), Refusal> {
        let first = arguments.first().ok_or_else(|| wrong_count(entity, 0, "1 or more"))?;
        if number(first, &format!("a number of {entity}"))? == 0.0 {
            self.materials.current_mut().left_out.remove(entity);
            return Ok(());
        }
        let text = match entity {
            "rs" => "specular reflection is left out",
            "td" => "diffuse transmission is left out",
            "ts" => "specular transmission is left out",
            _ => "indices of refraction are left out",
        };
        let note = self.model.note_of(text, line);
        self.materials.current_mut().left_out.insert(entity.to_owned(), note);
        Ok(())
    }

    fn object(&mut self, arguments: &[&str], line: usize) -> Result<(), Refusal> {
        match *arguments {
            [] => {
                if self.objects.pop().is_none() {
                    self.model.note("an o that ends no object is left out", line);
                }
            }
            [name] => {
                let path = self.objects.last().map_or(name.to_owned(), |outer| format!("{outer}/{name}"));
                if path.len() > LONGEST_NAME {
                    return refuse("names of objects in objects are too long together", "end objects by o");
                }
                self.objects.push(path);
            }
            _ => return Err(wrong_count("o", arguments.len(), "1 name or none")),
        }
        Ok(())
    }

    /// The shapes of a geometric entity, before the transform.
    fn shapes(&mut self, entity: &str, arguments: &[&str], line: usize) -> Result<Vec<Shape>, Refusal> {
        let radius = |word: &str| number(word, "a radius");
        let point = |id: &str| Ok(self.vertices.get(id)?.point);
        let shape = match (entity, arguments) {
            ("f", outline) => {
                let outline = self.vertices(outline)?;
                self.note_normals(&outline, &outline, line);
                shapes::face(points(&outline))?
            }
            ("fh", loops) => {
                let loops = loops.split(|word| *word == "-").map(|ids| self.vertices(ids));
                let loops: Vec<Vec<Vertex>> = loops.collect::<Result<_, _>>()?;
                self.note_normals(&loops[0], &loops.concat(), line);
                shapes::face_with_holes(loops.iter().map(|own| points(own)).collect())?
            }
            ("sph", [center, size]) => shapes::sphere(point(center)?, radius(size)?),
            ("cyl", [base, size, end]) => shapes::cone([point(base)?, point(end)?], [radius(size)?; 2])?,
            ("cone", [base, first, end, second]) => {
                shapes::cone([point(base)?, point(end)?], [radius(first)?, radius(second)?])?
            }
            ("ring", [vertex, inner, outer]) => {
                shapes::ring(*self.vertices.get(vertex)?, radius(inner)?, radius(outer)?)?
            }
            ("torus", [vertex, least, most]) => {
                shapes::torus(*self.vertices.get(vertex)?, radius(least)?, radius(most)?)?
            }
            ("prism", [outline @ .., length]) => {
                let length = number(length, "the length of a prism")?;
                let outline = self.vertices(outline)?;
                // Normals of a prism are those of its mantle.
                if outline.iter().any(|vertex| vertex.normal != DVec3::ZERO) {
                    self.model.note(Remark::Rounded.text(), line);
                }
                return shapes::prism(points(&outline), length);
            }
            (entity, arguments) => {
                return refuse(
                    format!("{entity} does not have {} arguments", arguments.len()),
                    format!("write {}", form(entity)),
                );
            }
        };
        Ok(vec![shape])
    }

    fn vertices(&self, ids: &[&str]) -> Result<Vec<Vertex>, Refusal> {
        ids.iter().map(|id| self.vertices.get(id).copied()).collect()
    }

    /// Notes normals at the vertices of a face that are not those of its outline.
    fn note_normals(&mut self, outline: &[Vertex], vertices: &[Vertex], line: usize) {
        let normals = vertices.iter().map(|vertex| self.placed.direction(vertex.normal)).collect();
        let face = Shape::Polygon { outline: points(outline), holes: Vec::new() };
        let placed = self.placed.shape(&face);
        let (_, &Material { sides, .. }) = self.materials.current();
        self.model.note_normals(&FaceNormals { corners: placed.rings()[0], normals }, sides, line);
    }

    /// Adds a shape where the transform puts it.
    fn add(&mut self, shape: &Shape, line: usize) -> Result<(), Refusal> {
        let (name, material) = self.materials.current();
        let coat = material.coat(name.unwrap_or("unnamed"))?;
        self.model.note_coat(material.left_out.values());
        let name = self.objects.last().map(String::as_str);
        self.model.surface(name, self.placed.shape(shape), &coat, line)
    }
}

fn points(vertices: &[Vertex]) -> Vec<DVec3> {
    vertices.iter().map(|vertex| vertex.point).collect()
}

/// The transforms that all of `arguments` make.
fn transforms(arguments: &[&str]) -> Result<Transforms, Refusal> {
    let (transforms, read) = Transforms::parse(arguments)?;
    match arguments.get(read) {
        None => Ok(transforms),
        Some(word) => refuse(
            format!("'{}' is no part of a transform", short(word)),
            "write -t, -rx, -ry, -rz, -s, -mx, -my, -mz, -i or -a with their numbers",
        ),
    }
}

/// The `N` numbers behind an entity.
fn numbers<const N: usize>(entity: &str, arguments: &[&str]) -> Result<[f64; N], Refusal> {
    let words: [&str; N] =
        arguments.try_into().map_err(|_| wrong_count(entity, arguments.len(), &N.to_string()))?;
    let mut values = [0.0; N];
    for (value, word) in values.iter_mut().zip(words) {
        *value = number(word, &format!("a number of {entity}"))?;
    }
    Ok(values)
}

/// Syntax of a geometric entity, for messages.
fn form(entity: &str) -> &'static str {
    match entity {
        "sph" => "sph vertex radius",
        "cyl" => "cyl vertex radius vertex",
        "cone" => "cone vertex radius vertex radius",
        "ring" => "ring vertex inner-radius outer-radius",
        "torus" => "torus vertex least-radius greatest-radius",
        _ => "prism vertex vertex vertex … length",
    }
}

fn wrong_count(entity: &str, found: usize, expected: &str) -> Refusal {
    Refusal::new(
        format!("{entity} has {found} arguments, {expected} are needed"),
        "write them on one line, or end lines with a backslash",
    )
}
