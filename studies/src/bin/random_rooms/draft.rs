//! The text of a scene while it is drawn, what is in it, and where sensors may stand.

use std::collections::BTreeSet;
use std::fmt::Write;

use glam::DVec3;

/// A scene that grows.
#[derive(Clone, Debug, Default)]
pub(crate) struct Draft {
    pub(crate) title: String,
    /// Lowest and highest corners of what is no air.
    pub(crate) solids: Vec<[DVec3; 2]>,
    /// Sensors that are to stand at certain places, with their normals.
    pub(crate) wanted: Vec<[DVec3; 2]>,
    /// Files beside the scene: their names and texts.
    pub(crate) tables: Vec<(String, String)>,
    kinds: BTreeSet<&'static str>,
    sky: String,
    body: String,
    count: usize,
}

impl Draft {
    /// Notes that the scene has a thing of this kind.
    pub(crate) fn has(&mut self, kind: &'static str) {
        self.kinds.insert(kind);
    }

    /// Kinds of things in the scene.
    pub(crate) fn kinds(&self) -> String {
        self.kinds.iter().copied().collect::<Vec<_>>().join(", ")
    }

    /// Outside is this sky, by its keys.
    pub(crate) fn sky(&mut self, keys: String) {
        self.sky = keys;
    }

    /// A material of its own by its keys: its name.
    pub(crate) fn material(&mut self, keys: &str) -> String {
        self.count += 1;
        let name = format!("m{}", self.count);
        writeln!(self.body, "[materials.{name}]\n{keys}").expect("a text grows");
        name
    }

    /// A diffuse material: its name.
    pub(crate) fn paint(&mut self, reflectance: f64) -> String {
        self.material(&format!("reflectance = {reflectance:.3}"))
    }

    /// A surface by its name, material, further keys and shape.
    pub(crate) fn surface(&mut self, name: &str, material: &str, keys: &str, shape: &str) {
        let head = format!("[[surfaces]]\nname = \"{name}\"\nmaterial = \"{material}\"\n{keys}");
        writeln!(self.body, "{head}{}{shape}", if keys.is_empty() { "" } else { "\n" })
            .expect("a text grows");
    }

    /// A luminaire by its keys.
    pub(crate) fn luminaire(&mut self, keys: &str) {
        writeln!(self.body, "[[luminaires]]\n{keys}").expect("a text grows");
    }

    /// The scene's text.
    pub(crate) fn text(&self) -> String {
        let sky = if self.sky.is_empty() { String::new() } else { format!("[sky]\n{}\n", self.sky) };
        format!("title = \"{}\"\nbands = [\"lm\"]\nunit = \"lx\"\n{sky}{}", self.title, self.body)
    }
}

/// A parallelogram whose front is edge1 × edge2.
pub(crate) fn parallelogram(origin: DVec3, edge1: DVec3, edge2: DVec3) -> String {
    let [o, a, b] = [origin, edge1, edge2].map(|own| own.to_array());
    format!("parallelogram = {{ origin = {o:?}, edge1 = {a:?}, edge2 = {b:?} }}")
}

/// A box along the axes, faces that are left out.
pub(crate) fn cuboid(origin: DVec3, size: DVec3, open: &str) -> String {
    let [o, s] = [origin, size].map(|own| own.to_array());
    format!("box = {{ origin = {o:?}, size = {s:?}, open = [{open}] }}")
}
