//! Lines of `check` on materials that vary over surfaces, or let light through.

use std::collections::BTreeMap;

use radiosity_scene::{Material, Pattern, Scene, SceneSurface};
use serde_json::{Value, json};

/// A line for each pattern and each transmittance.
pub(crate) fn lines(scene: &Scene) -> Vec<String> {
    let of_material = |(name, material): (&str, &Material)| {
        let patterns = patterns(material).map(|(what, pattern)| {
            let each = |value: &dyn Fn(usize) -> f64| numbers((0..pattern.bands()).map(value));
            let [least, most] = [0, 1].map(|end| each(&|band| pattern.range(band)[end]));
            let (title, mean) = (title(pattern), each(&|band| pattern.mean(band)));
            format!(
                "varies: {what} of {name}: {title}; mean {mean}, from {least} to {most}{}",
                remarks(pattern)
            )
        });
        let transmits = material
            .transmits()
            .then(|| format!("lets through: {name}: {}", numbers(material.transmittance.iter().copied())));
        patterns.chain(transmits).collect::<Vec<_>>()
    };
    materials(scene).into_iter().flat_map(of_material).collect()
}

/// The materials with their patterns as JSON, by name, with all digits.
pub(crate) fn as_json(scene: &Scene) -> Value {
    let pattern = |(what, pattern): (&'static str, &Pattern)| {
        let bands = 0..pattern.bands();
        let own = json!({
            "kind": title(pattern), "grid": pattern.grid(), "degree": pattern.degree(), "mean": pattern.means(),
            "range": bands.map(|band| pattern.range(band)).collect::<Vec<_>>(),
            "picture": pattern.picture().map(|own| &own.path),
            "remarks": pattern.picture().map_or(&[][..], |own| &own.remarks[..]),
        });
        (what.to_owned(), own)
    };
    let material = |(name, own): (&str, &Material)| {
        let told = json!({
            "reflectance": own.reflectance, "transmittance": own.transmittance, "emission": own.emission,
            "varies": patterns(own).map(pattern).collect::<serde_json::Map<_, _>>(),
        });
        (name.to_owned(), told)
    };
    materials(scene).into_iter().map(material).collect::<serde_json::Map<_, _>>().into()
}

/// The materials of the surfaces by name.
fn materials(scene: &Scene) -> BTreeMap<&str, &Material> {
    let named =
        |own: &&SceneSurface| own.radiance.is_none() && own.flux.is_none() && own.emission_factors.is_none();
    // Of surfaces that emit otherwise than their material, the material is told where others have it.
    let (plain, others): (Vec<_>, Vec<_>) = scene.surfaces.iter().partition(named);
    let all = others.into_iter().chain(plain);
    all.filter_map(|own| Some((own.material_name.as_deref()?, &own.material))).collect()
}

fn patterns(material: &Material) -> impl Iterator<Item = (&'static str, &Pattern)> {
    let all = [("reflectance", &material.reflectance_pattern), ("emission", &material.emission_pattern)];
    all.into_iter().filter_map(|(what, pattern)| Some((what, pattern.as_deref()?)))
}

/// Kind and size of a pattern, in words.
fn title(pattern: &Pattern) -> String {
    match (pattern.picture(), pattern.grid(), pattern.degree()) {
        (Some(picture), Some([columns, rows]), _) => {
            format!("picture {}, {columns} × {rows} texels", picture.path)
        }
        (None, Some([columns, rows]), _) => format!("{columns} × {rows} cells"),
        (_, _, degree) => format!("polynomial of degree {}", degree.unwrap_or_default()),
    }
}

fn remarks(pattern: &Pattern) -> String {
    pattern.picture().map(|own| format!(" ({})", own.remarks.join("; "))).unwrap_or_default()
}

/// Numbers with four digits; one where all are the same.
fn numbers(all: impl Iterator<Item = f64>) -> String {
    let mut all: Vec<String> = all.map(rounded).collect();
    if all.iter().all(|own| *own == all[0]) {
        all.truncate(1);
    }
    all.join(", ")
}

/// A number with four digits; 0 for numbers below 1e-8, which is the error of bounds of polynomials.
fn rounded(value: f64) -> String {
    if value.abs() < 1e-8 {
        "0".to_owned()
    } else {
        format!("{value:.3e}").parse::<f64>().unwrap_or(value).to_string()
    }
}
