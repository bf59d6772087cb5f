//! STL as text: `solid`, `facet normal`, `outer loop`, three times `vertex`, and their ends.

use glam::DVec3;
use radiosity_geom::area_vector;
use radiosity_photometry::error::{Refusal, refuse, refuse_at};
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::text::decoded;
use radiosity_photometry::text::{number, short};

use crate::mesh::{Coat, Mesh};
use crate::model::Sides;

/// Adds the facets of a text.
pub(super) fn read(bytes: &[u8], mesh: &mut Mesh) -> Result<(), Refusal> {
    let text = decoded(bytes)?;
    let mut reader = Reader { mesh, object: None, facet: None };
    let mut last = 1;
    for (index, line) in text.lines().enumerate() {
        if line.trim().is_empty() {
            continue;
        }
        last = index + 1;
        reader.line(line, last).map_err(|fault| fault.at(FilePlace::Line(last)))?;
    }
    match reader.facet {
        Some(_) => refuse_at(
            FilePlace::Line(last),
            "the text ends within a facet",
            "export the model again, or end the facet with 'endloop', 'endfacet'",
        ),
        None => Ok(()),
    }
}

/// A facet that has begun.
struct Facet {
    line: usize,
    normal: DVec3,
    is_looped: bool,
    corners: Vec<DVec3>,
}

struct Reader<'a> {
    mesh: &'a mut Mesh,
    object: Option<usize>,
    facet: Option<Facet>,
}

impl Reader<'_> {
    fn line(&mut self, line: &str, number: usize) -> Result<(), Refusal> {
        let words: Vec<&str> = line.split_whitespace().collect();
        let lower = words.iter().take(2).map(|word| word.to_ascii_lowercase()).collect::<Vec<_>>().join(" ");
        let keyword = lower.split(' ').next().unwrap_or_default();
        match (keyword, &mut self.facet) {
            ("solid", None) => {
                self.object = Some(self.mesh.object(line.trim().get(5..)));
                Ok(())
            }
            ("endsolid", None) => {
                self.object = None;
                Ok(())
            }
            ("facet", None) => self.begin(&words, number),
            ("outer", Some(facet)) if !facet.is_looped && facet.corners.is_empty() => {
                facet.is_looped = true;
                Ok(())
            }
            ("vertex", Some(facet)) if facet.is_looped => {
                facet.corners.push(point(&words[1..], "a vertex")?);
                Ok(())
            }
            ("endloop", Some(facet)) if facet.is_looped => match facet.corners.len() {
                3 => {
                    facet.is_looped = false;
                    Ok(())
                }
                count => refuse(
                    format!("the facet has {count} corners"),
                    "a facet of STL is a triangle: give it three, or split it",
                ),
            },
            ("endfacet", Some(_)) => self.end(),
            _ => refuse(
                format!("'{}' cannot stand here", short(words[0])),
                "export the model again; a facet is 'facet normal', 'outer loop', three 'vertex', 'endloop', \
                 'endfacet'",
            ),
        }
    }

    fn begin(&mut self, words: &[&str], line: usize) -> Result<(), Refusal> {
        let is_stated = words.get(1).is_some_and(|word| word.eq_ignore_ascii_case("normal"));
        let normal = if is_stated { point(&words[2..], "a normal").ok() } else { None };
        let normal = normal.unwrap_or(DVec3::ZERO);
        self.facet = Some(Facet { line, normal, is_looped: false, corners: Vec::new() });
        Ok(())
    }

    fn end(&mut self) -> Result<(), Refusal> {
        let Some(facet) = self.facet.take() else { return Ok(()) };
        let place = FilePlace::Line(facet.line);
        if area_vector(&facet.corners).dot(facet.normal) < 0.0 {
            let text = "normals that contradict the order of corners are left out";
            self.mesh.note_opposed(&facet.corners, text, place);
        }
        let mesh = &mut *self.mesh;
        let object = *self.object.get_or_insert_with(|| mesh.object(None));
        let coat = Coat { object, material: None, sides: Sides::Open };
        mesh.face(facet.corners, coat, place)
    }
}

/// The three numbers of a point or a direction.
fn point(words: &[&str], what: &str) -> Result<DVec3, Refusal> {
    let [x, y, z] = words else {
        return refuse(format!("{what} has {} numbers, it takes three", words.len()), "give it x, y and z");
    };
    Ok(DVec3::new(number(x, "x")?, number(y, "y")?, number(z, "z")?))
}
