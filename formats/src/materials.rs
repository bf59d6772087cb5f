//! Side files: materials by name, for models whose own materials are missing or are not what they should be.
//!
//! A side file is TOML. Every table is a material; what it does not state stays as the model has it:
//!
//! ```toml
//! [wall]
//! reflectance = 0.8             # of all bands, or of each: [0.8, 0.7, 0.6]
//! emission = 0                  # exitance, likewise
//! two_sided = true              # for all surfaces of it
//!
//! ["*"]                         # the material of surfaces that have none
//! reflectance = 0.5
//!
//! [surfaces]                    # materials of surfaces, of the model or of this file
//! desk = "wood"
//! "lamp-*" = "glowing"          # of all whose names begin so; exact names and longer beginnings go first
//! ```
//!
//! A model of one band becomes one of red, green and blue if the file states three values. A material named `surfaces`
//! cannot be stated.

mod stated;
mod names;

use std::cmp::Reverse;
use std::collections::{HashMap, HashSet};

use crate::error::Refusal;
use crate::fault::Fault;
use crate::model::{Material, Model, Sides};
use crate::names::UniqueNames;
use crate::text::short;
use names::closest;
use stated::{Lined, Stated, Values};

/// The table of the material of surfaces that have none, and the name that it gets.
const REST: &str = "*";
const DEFAULT: &str = "default";

/// Gives a model the materials that the side file `file` of this text states. Returns lines that say what was replaced.
///
/// # Errors
/// Text that is no TOML, keys and names that are not known, values out of range, lists of another length than the bands.
/// The model is then as it was.
pub fn apply(text: &str, file: &str, model: &mut Model) -> Result<Vec<String>, Refusal> {
    let stated = Stated::of(text, file)?;
    let mut changed = Change { model: model.clone(), file, lines: Vec::new() };
    changed.bands(&stated)?;
    changed.materials(&stated)?;
    changed.surfaces(&stated)?;
    changed.rest(&stated)?;
    changed.sides(&stated);
    *model = changed.model;
    Ok(changed.lines)
}

/// A model that is being changed.
struct Change<'a> {
    model: Model,
    file: &'a str,
    lines: Vec<String>,
}

impl Change<'_> {
    fn refusal<T>(&self, at: &Lined<T>, cause: String, cure: &str) -> Refusal {
        Fault::new(cause, cure).in_line(self.file, at.line)
    }

    /// Three bands instead of one, if the file states three values; lists of other lengths are refused.
    fn bands(&mut self, stated: &Stated) -> Result<(), Refusal> {
        let lists = || {
            stated.materials.iter().flat_map(|(_, values)| [&values.reflectance, &values.emission]).flatten()
        };
        if self.model.bands.len() == 1 && lists().any(|list| list.value.len() == 3) {
            self.model.bands = ["r", "g", "b"].map(str::to_owned).to_vec();
            for material in &mut self.model.materials {
                for values in [&mut material.reflectance, &mut material.emission] {
                    *values = spread(values, 3);
                }
            }
            self.lines.push("the model has the bands r, g and b instead of one".to_owned());
        }
        let bands = self.model.bands.len();
        match lists().find(|list| list.value.len() != 1 && list.value.len() != bands) {
            None => Ok(()),
            Some(list) => Err(self.refusal(
                list,
                format!(
                    "the list has {} values, the model {bands} bands: {}",
                    list.value.len(),
                    self.model.bands.join(", ")
                ),
                "write one value, or one for each band",
            )),
        }
    }

    /// Replaces the values of materials that the model has, and adds those that surfaces are given.
    fn materials(&mut self, stated: &Stated) -> Result<(), Refusal> {
        let given: HashSet<&str> = stated.surfaces.iter().map(|(_, material)| material.as_str()).collect();
        let known = self.known();
        for (name, values) in stated.materials.iter().filter(|(name, _)| name.value != REST) {
            match known.get(&name.value) {
                Some(index) => self.replace(*index, values),
                None if given.contains(name.value.as_str()) => self.add(name, &name.value, values)?,
                None => {
                    let known = self.model.materials.iter().map(|material| material.name.as_str());
                    let near = closest(&name.value, known);
                    return Err(self.refusal(
                        name,
                        format!("the model has no material '{}'{near}", short(&name.value)),
                        "correct the name, or give the material to surfaces under [surfaces]",
                    ));
                }
            }
        }
        Ok(())
    }

    fn replace(&mut self, index: usize, values: &Values) {
        let bands = self.model.bands.len();
        let material = &mut self.model.materials[index];
        let fields = [
            ("reflectance", &mut material.reflectance, &values.reflectance),
            ("emission", &mut material.emission, &values.emission),
        ];
        for (what, own, new) in fields {
            let Some(new) = new else { continue };
            let old = std::mem::replace(own, spread(&new.value, bands));
            let line = format!(
                "material '{}': {what} {} instead of {}",
                short(&material.name),
                told(own),
                told(&old)
            );
            self.lines.push(line);
        }
    }

    /// Adds a material, which must state its reflectance.
    fn add(&mut self, at: &Lined<String>, name: &str, values: &Values) -> Result<(), Refusal> {
        let bands = self.model.bands.len();
        let Some(reflectance) = &values.reflectance else {
            return Err(self.refusal(
                at,
                format!("the new material '{}' has no reflectance", short(name)),
                "write reflectance = 0.8 below it",
            ));
        };
        let emission = values.emission.as_ref().map_or(vec![0.0], |emission| emission.value.clone());
        let material = Material {
            name: name.to_owned(),
            reflectance: spread(&reflectance.value, bands),
            emission: spread(&emission, bands),
        };
        let line = format!("material '{}' is new: reflectance {}", short(name), told(&material.reflectance));
        self.lines.push(line);
        self.model.materials.push(material);
        Ok(())
    }

    /// Gives surfaces the materials that are stated for their names: exact names first, then the longest beginnings.
    fn surfaces(&mut self, stated: &Stated) -> Result<(), Refusal> {
        let mut claims: Vec<(usize, &Lined<String>)> =
            stated.surfaces.iter().map(|(name, _)| name).enumerate().collect();
        claims.sort_by_key(|(_, name)| Reverse((!name.value.ends_with('*'), name.value.len())));
        let found = self.found(&claims)?;
        let materials = self.of_surfaces(stated)?;
        let mut counts = vec![0; claims.len()];
        let mut is_given = vec![false; self.model.surfaces.len()];
        for (claim, index) in found {
            if !std::mem::replace(&mut is_given[index], true) {
                counts[claim] += 1;
                self.model.surfaces[index].material = Some(materials[claim]);
            }
        }
        for ((name, material), count) in stated.surfaces.iter().zip(counts) {
            let have = if count == 1 { "surface has" } else { "surfaces have" };
            let line = format!("'{}': {count} {have} the material '{}'", short(&name.value), short(material));
            self.lines.push(line);
        }
        Ok(())
    }

    /// The surfaces that claims are about, claim after claim, each as the claim's number and its own.
    fn found(&self, claims: &[(usize, &Lined<String>)]) -> Result<Vec<(usize, usize)>, Refusal> {
        let surfaces = || self.model.surfaces.iter().map(|surface| surface.name.as_str()).enumerate();
        let exact: HashMap<&str, usize> = surfaces().map(|(index, name)| (name, index)).collect();
        let mut found = Vec::new();
        for (claim, name) in claims {
            let before = found.len();
            match (exact.get(name.value.as_str()), name.value.strip_suffix('*')) {
                (Some(index), _) => found.push((*claim, *index)),
                (None, Some(beginning)) => {
                    let meant = surfaces().filter(|(_, name)| name.starts_with(beginning));
                    found.extend(meant.map(|(index, _)| (*claim, index)));
                }
                (None, None) => {}
            }
            if found.len() == before {
                let near = closest(&name.value, surfaces().map(|(_, name)| name));
                let cause = format!("the model has no surface '{}'{near}", short(&name.value));
                return Err(self.refusal(name, cause, "correct the name, or take the line out"));
            }
        }
        Ok(found)
    }

    /// The index of the material of each line under `[surfaces]`.
    fn of_surfaces(&self, stated: &Stated) -> Result<Vec<usize>, Refusal> {
        let known = self.known();
        let index = |(at, name): &(Lined<String>, String)| {
            known.get(name).copied().ok_or_else(|| {
                let near = closest(name, self.model.materials.iter().map(|material| material.name.as_str()));
                let cause = format!("there is no material '{}'{near}", short(name));
                self.refusal(at, cause, "correct the name, or state the material in a table of its own")
            })
        };
        stated.surfaces.iter().map(index).collect()
    }

    /// The materials by their names.
    fn known(&self) -> HashMap<String, usize> {
        let materials = self.model.materials.iter().enumerate();
        materials.map(|(index, material)| (material.name.clone(), index)).collect()
    }

    /// Gives surfaces without a material the one of the table `"*"`.
    fn rest(&mut self, stated: &Stated) -> Result<(), Refusal> {
        let Some((name, values)) = stated.materials.iter().find(|(name, _)| name.value == REST) else {
            return Ok(());
        };
        let count = self.model.surfaces.iter().filter(|surface| surface.material.is_none()).count();
        if count == 0 {
            self.lines.push("'*' is not used: every surface has a material".to_owned());
            return Ok(());
        }
        let mut names = UniqueNames::default();
        for material in &self.model.materials {
            names.take(&material.name);
        }
        self.add(name, &names.take(DEFAULT), values)?;
        let last = self.model.materials.len() - 1;
        for surface in self.model.surfaces.iter_mut().filter(|surface| surface.material.is_none()) {
            surface.material = Some(last);
            surface.sides = sides(values.two_sided).unwrap_or(surface.sides);
        }
        self.lines.push(format!(
            "surfaces without a material: {count} have '{}'",
            short(&self.model.materials[last].name)
        ));
        Ok(())
    }

    /// Makes surfaces two-sided or not, as their materials are stated.
    fn sides(&mut self, stated: &Stated) {
        let stated: HashMap<&str, Sides> = stated
            .materials
            .iter()
            .filter_map(|(name, values)| Some((name.value.as_str(), sides(values.two_sided)?)))
            .collect();
        let of_material: Vec<Option<Sides>> =
            self.model.materials.iter().map(|material| stated.get(material.name.as_str()).copied()).collect();
        let mut counts = vec![0; of_material.len()];
        for surface in &mut self.model.surfaces {
            let Some(index) = surface.material else { continue };
            let Some(sides) = of_material[index].filter(|sides| *sides != surface.sides) else { continue };
            surface.sides = sides;
            counts[index] += 1;
        }
        for (index, count) in counts.into_iter().enumerate().filter(|(_, count)| *count > 0) {
            let what = if of_material[index] == Some(Sides::Both) { "two-sided" } else { "one-sided" };
            let are = if count == 1 { "surface is" } else { "surfaces are" };
            self.lines.push(format!(
                "material '{}': {count} {are} {what}",
                short(&self.model.materials[index].name)
            ));
        }
    }
}

/// The sides of surfaces of a material.
fn sides(is_two_sided: Option<bool>) -> Option<Sides> {
    is_two_sided.map(|is_two_sided| if is_two_sided { Sides::Both } else { Sides::Front })
}

/// One value for all bands; those of all bands as they are.
fn spread(values: &[f64], bands: usize) -> Vec<f64> {
    match values {
        [one] => vec![*one; bands],
        all => all.to_vec(),
    }
}

/// Values as lines tell them: one number if all are the same.
fn told(values: &[f64]) -> String {
    match values {
        [first, rest @ ..] if rest.iter().all(|value| value == first) => first.to_string(),
        _ => format!("{values:?}"),
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::model::{Shape, Surface};
    use crate::place::Place;

    fn surface(name: &str, material: Option<usize>) -> Surface {
        let outline = vec![DVec3::ZERO, DVec3::X, DVec3::Y];
        let shape = Shape::Polygon { outline, holes: Vec::new() };
        Surface { name: name.to_owned(), material, shape, sides: Sides::Front, place: None }
    }

    /// A grey model of two materials and four surfaces, the last without a material.
    fn grey() -> Model {
        let material = |name: &str, emission: f64| Material {
            name: name.to_owned(),
            reflectance: vec![0.5],
            emission: vec![emission],
        };
        Model {
            bands: vec!["grey".to_owned()],
            materials: vec![material("wall", 0.0), material("lamp", 3.0)],
            surfaces: vec![
                surface("floor", Some(0)),
                surface("desk-1", Some(0)),
                surface("desk-2", Some(1)),
                surface("bare", None),
            ],
            ..Model::default()
        }
    }

    fn applied(text: &str) -> (Model, Vec<String>) {
        let mut model = grey();
        let lines = apply(text, "side.toml", &mut model).unwrap_or_else(|refusal| panic!("{refusal}"));
        (model, lines)
    }

    #[test]
    fn what_is_not_stated_stays() {
        let (model, lines) = applied("[wall]\nreflectance = 0.8\n[lamp]\nemission = 7\ntwo_sided = true\n");
        assert_eq!((&model.materials[0].reflectance, &model.materials[0].emission), (&vec![0.8], &vec![0.0]));
        assert_eq!((&model.materials[1].reflectance, &model.materials[1].emission), (&vec![0.5], &vec![7.0]));
        let sides: Vec<Sides> = model.surfaces.iter().map(|surface| surface.sides).collect();
        assert_eq!(sides, [Sides::Front, Sides::Front, Sides::Both, Sides::Front]);
        let told = [
            "material 'wall': reflectance 0.8 instead of 0.5",
            "material 'lamp': emission 7 instead of 3",
            "material 'lamp': 1 surface is two-sided",
        ];
        assert_eq!(lines, told);
        assert_eq!(applied(""), (grey(), Vec::new()));
    }

    #[test]
    fn a_grey_model_gets_colours() {
        let (model, lines) = applied("[wall]\nreflectance = [0.1, 0.2, 0.3]\n[lamp]\nemission = 1\n");
        assert_eq!(model.bands, ["r", "g", "b"]);
        assert_eq!(model.materials[0].reflectance, [0.1, 0.2, 0.3]);
        assert_eq!(
            (&model.materials[0].emission, &model.materials[1].emission),
            (&vec![0.0; 3], &vec![1.0; 3])
        );
        assert_eq!(lines[1], "material 'wall': reflectance [0.1, 0.2, 0.3] instead of 0.5");
    }

    #[test]
    fn surfaces_get_materials_by_name() {
        let text = "[wood]\nreflectance = 0.3\n[surfaces]\n\"desk-*\" = \"wood\"\n\"*\" = \"lamp\"\ndesk-2 = \"wall\"\n";
        let (model, lines) = applied(text);
        let materials: Vec<Option<usize>> = model.surfaces.iter().map(|surface| surface.material).collect();
        assert_eq!(materials, [Some(1), Some(2), Some(0), Some(1)]);
        let told = [
            "material 'wood' is new: reflectance 0.3",
            "'desk-*': 1 surface has the material 'wood'",
            "'*': 2 surfaces have the material 'lamp'",
            "'desk-2': 1 surface has the material 'wall'",
        ];
        assert_eq!(lines, told);
    }

    #[test]
    fn surfaces_without_a_material_get_the_rest() {
        let (model, lines) = applied("[\"*\"]\nreflectance = 0.4\ntwo_sided = true\n");
        assert_eq!((model.surfaces[3].material, model.surfaces[3].sides), (Some(2), Sides::Both));
        assert_eq!(
            (model.materials[2].name.as_str(), model.materials[2].emission.as_slice()),
            ("default", &[0.0][..])
        );
        assert_eq!(lines[1], "surfaces without a material: 1 have 'default'");
        let (_, lines) = applied("[\"*\"]\nreflectance = 0.4\n[surfaces]\nbare = \"wall\"\n");
        assert!(lines.contains(&"'*' is not used: every surface has a material".to_owned()), "{lines:?}");
    }

    #[test]
    fn broken_side_files_are_refused_and_change_nothing() {
        let told = [
            ("[wall", 1, "this is no TOML"),
            ("\n[wal]\nreflectance = 1", 2, "the model has no material 'wal'; 'wall' is closest"),
            ("[ceiling]", 1, "the model has no material 'ceiling'"),
            ("wall = 0.5", 1, "'wall' is no table"),
            ("[wall]\nreflectance = 1.5", 2, "reflectance is 1.5"),
            ("[wall]\nemission = -1", 2, "emission is -1"),
            ("[wall]\nemission = inf", 2, "neither a number nor a list"),
            ("[wall]\nemission = []", 2, "neither a number nor a list"),
            ("[wall]\nemission = [1, \"a\"]", 2, "neither a number nor a list"),
            ("[wall]\n\nreflectance = [0.1, 0.2]", 3, "the list has 2 values, the model 1 bands"),
            (
                "[wall]\nreflectance = [1, 1, 1]\nemission = [1, 1]",
                3,
                "the list has 2 values, the model 3 bands",
            ),
            ("[wall]\ntwo_sided = 1", 2, "two_sided is neither true nor false"),
            ("[wall]\nreflectence = 1", 2, "materials have no 'reflectence'"),
            ("[surfaces]\nflor = \"wall\"", 2, "the model has no surface 'flor'; 'floor' is closest"),
            ("[surfaces]\n\"x*\" = \"wall\"", 2, "the model has no surface 'x*'"),
            ("[surfaces]\nfloor = \"wahl\"", 2, "there is no material 'wahl'; 'wall' is closest"),
            ("[surfaces]\nfloor = 3", 2, "the material of 'floor' is no name"),
            ("[wood]\n[surfaces]\nfloor = \"wood\"", 1, "the new material 'wood' has no reflectance"),
            ("[\"*\"]\nemission = 1", 1, "the new material 'default' has no reflectance"),
        ];
        for (text, line, cause) in told {
            let mut model = grey();
            let refusal = apply(text, "side.toml", &mut model).expect_err(text);
            assert!(refusal.cause.contains(cause), "{text}: {refusal}");
            assert_eq!(
                (refusal.place, refusal.file.as_str()),
                (Some(Place::Line(line)), "side.toml"),
                "{text}"
            );
            assert!(!refusal.cure.is_empty() && model == grey(), "{text}");
        }
    }
}
