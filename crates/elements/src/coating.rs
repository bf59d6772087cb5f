//! Coatings: how the elements reflect, transmit and emit, per band.
//!
//! ```text
//! B(x) = E₀(x) + ρ(x) E(x) + τ E'(x) ,     0 ≤ ρ, 0 ≤ τ, ρ + τ < 1
//! ```
//!
//! with the irradiance E' of the other side of a two-sided surface that lets light through. For coefficients
//! in the bases of the elements this is b = e + S h: S is the multiple ρ of the identity where ρ is constant
//! on an element, the matrix ∫ ρ φ_k φ_l dA where it is not, and couples the elements of two sides by τ. G
//! knows nothing of it: a new S needs no new blocks (H. Jang, *Radiosity Methods*, has b = e + S G b).

mod tiles;
mod element_pattern;
mod square_root;
mod varying_reflectance;
mod varying_exitance;
mod transmission;

use std::collections::BTreeMap;
use std::sync::Arc;

use radiosity_core::dot;
use radiosity_geom::Rect;
use radiosity_scene::Scene;
use radiosity_work::interruption::check_interrupt;
use rayon::prelude::*;

use super::element::Element;
use super::parameters::of_node;
use super::patch::{Node, Patch};
use element_pattern::ElementPattern;
use transmission::{Transmission, TransmissionPart};
use varying_exitance::VaryingExitance;
use varying_reflectance::VaryingReflectance;

/// Reflection, transmission and emission of all elements in one band.
#[derive(Clone, Debug, Default)]
pub struct Coating {
    /// ρ per element, in [0, 1); its mean over the element's area where it varies. Light groups share it.
    pub reflectance: Arc<[f64]>,
    /// Emitted exitance per element (W m⁻²); its mean over the element's area where it varies.
    pub exitance: Vec<f64>,
    varying_reflectances: BTreeMap<usize, Arc<VaryingReflectance>>,
    varying_exitances: BTreeMap<usize, Arc<VaryingExitance>>,
    transmissions: BTreeMap<usize, Arc<Transmission>>,
}

/// Cells along each direction of a patch for the mean of what varies: polynomials vary little over a
/// sixteenth of a patch, and the middle of a cell errs by the square of that. With more each element of each
/// band takes longer.
const ALONG: usize = 16;

/// Means over a part of an element.
#[derive(Clone, Copy, Debug)]
pub struct Means {
    /// Mean of E₀ (W m⁻²).
    pub exitance: f64,
    /// Mean of ρ.
    pub reflectance: f64,
}

/// Square root of the reflection of an element.
#[derive(Clone, Copy, Debug)]
pub enum SquareRoot<'a> {
    /// √ρ, where ρ is constant.
    Number(f64),
    /// S^½, row-major and symmetric.
    Matrix(&'a [f64]),
}

impl SquareRoot<'_> {
    /// Writes its product with x into `out`.
    pub fn multiply(self, x: &[f64], out: &mut [f64]) {
        match self {
            SquareRoot::Number(square_root) => {
                out.iter_mut().zip(x).for_each(|(out, x)| *out = square_root * x)
            }
            SquareRoot::Matrix(square_root) => {
                out.fill(0.0);
                add_product(square_root, x, out);
            }
        }
    }
}

impl Coating {
    /// The coating of a scene's elements in band `band`.
    pub fn of(scene: &Scene, elements: &[Element], band: usize) -> Self {
        Self::reflecting(scene, elements, band)
            .emitting(scene, elements, band, &|surface| scene.surfaces[surface].factor())
    }

    /// Coating of the scene where only the members of a light group emit, for None those of no group; the
    /// factor of their group is left out.
    pub fn of_group(scene: &Scene, elements: &[Element], band: usize, group: Option<&str>) -> Self {
        Self::reflecting(scene, elements, band).with_group(scene, elements, band, group)
    }

    /// ρ and E₀ (W m⁻²) that are constant on every element.
    pub fn constant(reflectance: Vec<f64>, exitance: Vec<f64>) -> Self {
        Self { reflectance: reflectance.into(), exitance, ..Self::default() }
    }

    /// The coating of a scene's elements where nothing emits.
    pub fn reflecting(scene: &Scene, elements: &[Element], band: usize) -> Self {
        let varying_reflectances = of_each(elements, &|element| {
            let surface = &scene.surfaces[element.surface];
            let pattern = surface.material.reflectance_pattern.as_ref()?;
            let pattern = ElementPattern::new(element, &surface.shape, pattern, band);
            Some(VaryingReflectance::new(element, pattern))
        });
        let constant = |own: &Element| scene.surfaces[own.surface].material.reflectance[band];
        let mut reflectance: Vec<f64> = elements.iter().map(constant).collect();
        varying_reflectances.iter().for_each(|(index, varying)| reflectance[*index] = varying.mean);
        Self {
            varying_reflectances,
            transmissions: transmissions(scene, elements, band),
            ..Self::constant(reflectance, vec![0.0; elements.len()])
        }
    }

    /// Coating of this reflection and transmission where only the members of a light group emit, for None
    /// those of no group; the factor of their group is left out.
    pub fn with_group(&self, scene: &Scene, elements: &[Element], band: usize, group: Option<&str>) -> Self {
        let factor = |surface: usize| f64::from(u8::from(scene.surfaces[surface].is_in(group)));
        self.clone().emitting(scene, elements, band, &factor)
    }

    /// Coating of this reflection and transmission where a surface emits `factor` times what its material
    /// does.
    fn emitting(
        mut self,
        scene: &Scene,
        elements: &[Element],
        band: usize,
        factor: &(dyn Fn(usize) -> f64 + Sync),
    ) -> Self {
        let exitance =
            |own: &Element| factor(own.surface) * scene.surfaces[own.surface].material.emission[band];
        self.exitance = elements.iter().map(exitance).collect();
        self.varying_exitances = of_each(elements, &|element| {
            let surface = &scene.surfaces[element.surface];
            let factor = factor(element.surface);
            let pattern = surface.material.emission_pattern.as_ref().filter(|_| factor > 0.0)?;
            let pattern = ElementPattern::new(element, &surface.shape, pattern, band);
            Some(VaryingExitance::new(element, pattern, factor))
        });
        self.varying_exitances
            .iter()
            .for_each(|(index, exitance)| self.exitance[*index] = exitance.mean(&elements[*index]));
        self
    }

    /// Coating of this reflection and transmission where nothing emits.
    pub fn unlit(mut self) -> Self {
        self.exitance.fill(0.0);
        self.varying_exitances.clear();
        self
    }

    /// E₀ (W m⁻²) at parameters of an element's surface.
    pub fn exitance_at(&self, element: usize, parameters: [f64; 2]) -> f64 {
        self.varying_exitances
            .get(&element)
            .map_or_else(|| self.exitance[element], |exitance| exitance.at(parameters))
    }

    /// ρ at parameters of an element's surface.
    pub fn reflectance_at(&self, element: usize, parameters: [f64; 2]) -> f64 {
        self.varying_reflectances
            .get(&element)
            .map_or_else(|| self.reflectance[element], |reflectance| reflectance.at(parameters))
    }

    /// About ρ at a node of an element: the mean over some texels where they are many.
    pub fn reflectance_about(&self, element: usize, node: &Node, is_flat: bool) -> f64 {
        let Some(reflectance) = self.varying_reflectances.get(&element) else {
            return self.reflectance[element];
        };
        reflectance.about(of_node(reflectance.shape(), node, is_flat))
    }

    /// Means of E₀ (W m⁻²) and ρ over a patch of an element, the part of it over the parameters `rect`.
    /// Texels count by their share of the parameters; polynomials by their values in the middles of `ALONG`²
    /// cells.
    pub fn means_over(&self, element: usize, patch: &Patch, rect: &Rect) -> Means {
        let of = |element_pattern: &ElementPattern| {
            element_pattern.tiles.over(rect).unwrap_or_else(|| {
                let (mut sum, mut area) = (0.0, 0.0);
                for node in patch.cell_nodes(ALONG) {
                    area += node.area;
                    sum += node.area
                        * element_pattern.at(of_node(element_pattern.shape.as_ref(), &node, patch.is_flat()));
                }
                sum / area
            })
        };
        let exitance = self
            .varying_exitances
            .get(&element)
            .map(|exitance| exitance.factor * of(&exitance.element_pattern));
        let reflectance =
            self.varying_reflectances.get(&element).map(|reflectance| of(&reflectance.element_pattern));
        Means {
            exitance: exitance.unwrap_or(self.exitance[element]),
            reflectance: reflectance.unwrap_or(self.reflectance[element]),
        }
    }

    /// B = E₀ + ρ E + τ E' (W m⁻²) at parameters of an element's surface, under the irradiance E here and E'
    /// on the other side (W m⁻²).
    pub fn radiosity(&self, element: usize, parameters: [f64; 2], irradiance: f64, behind: f64) -> f64 {
        let own = self.exitance_at(element, parameters);
        own + self.reflectance_at(element, parameters) * irradiance + self.transmittance(element) * behind
    }

    /// τ of an element.
    pub fn transmittance(&self, element: usize) -> f64 {
        self.transmissions.get(&element).map_or(0.0, |transmission| transmission.transmittance)
    }

    /// The largest ρ + τ of an element.
    pub fn most(&self, element: usize) -> f64 {
        let reflectance = self.varying_reflectances.get(&element).map(|reflectance| reflectance.most());
        reflectance.unwrap_or(self.reflectance[element]) + self.transmittance(element)
    }

    /// ρ² + τ² of an element, by which squared errors of irradiance count in radiosity; the square of its
    /// mean where ρ varies.
    pub fn squared(&self, element: usize) -> f64 {
        self.reflectance[element].powi(2) + self.transmittance(element).powi(2)
    }

    /// The element of the other side at parameters of an element that lets light through.
    pub fn behind(&self, element: usize, parameters: [f64; 2]) -> Option<usize> {
        self.transmissions.get(&element)?.behind(parameters)
    }

    /// The element of the other side at a node of an element that lets light through.
    pub fn behind_node(&self, element: usize, node: &Node, is_flat: bool) -> Option<usize> {
        let transmission = self.transmissions.get(&element)?;
        transmission.behind(of_node(transmission.shape.as_ref(), node, is_flat))
    }

    /// The elements of the other side that light comes through to an element.
    pub fn all_behind(&self, element: usize) -> impl Iterator<Item = usize> {
        self.parts(element).map(|part| part.behind)
    }

    fn parts(&self, element: usize) -> impl Iterator<Item = &TransmissionPart> {
        self.transmissions.get(&element).into_iter().flat_map(|transmission| &transmission.parts)
    }

    /// Whether any surface lets light through.
    pub fn transmits(&self) -> bool {
        !self.transmissions.is_empty()
    }

    /// Whether an element reflects or transmits.
    pub fn scatters(&self, element: usize) -> bool {
        self.reflectance[element] > 0.0 || self.transmittance(element) > 0.0
    }

    /// Whether reflectance and transmittance are those of another coating on all elements but for constant ρ.
    pub fn varies_as(&self, other: &Self) -> bool {
        let same_reflectances = self.varying_reflectances.len() == other.varying_reflectances.len()
            && self
                .varying_reflectances
                .iter()
                .zip(&other.varying_reflectances)
                .all(|((i, own), (k, theirs))| i == k && own.is_as(theirs));
        let transmits = |own: &Self| {
            own.transmissions
                .iter()
                .map(|(index, transmission)| (*index, transmission.transmittance))
                .collect::<Vec<_>>()
        };
        same_reflectances && transmits(self) == transmits(other)
    }

    /// Whether ρ varies over an element.
    pub fn varies(&self, element: usize) -> bool {
        self.varying_reflectances.contains_key(&element)
    }

    /// Whether the elements emit as those of another coating.
    pub fn emits_as(&self, other: &Self) -> bool {
        let varying_exitances = || self.varying_exitances.iter().zip(&other.varying_exitances);
        self.exitance == other.exitance
            && self.varying_exitances.len() == other.varying_exitances.len()
            && varying_exitances()
                .all(|((i, own), (k, theirs))| i == k && own.coefficients == theirs.coefficients)
    }

    /// Square root of the reflection of an element, without what the element transmits.
    pub fn square_root(&self, element: usize) -> SquareRoot<'_> {
        match self.varying_reflectances.get(&element) {
            Some(reflectance) => SquareRoot::Matrix(reflectance.square_root()),
            None => SquareRoot::Number(self.reflectance[element].sqrt()),
        }
    }

    /// e, the coefficients of the emitted exitance, element by element; `ones` are those of the constant 1,
    /// and `starts` says where those of each element begin.
    pub fn emitted(&self, starts: &[usize], ones: &[f64]) -> Vec<f64> {
        let mut all = Vec::with_capacity(ones.len());
        for (element, ends) in starts.windows(2).enumerate() {
            match self.varying_exitances.get(&element) {
                Some(exitance) => all.extend(&exitance.coefficients),
                None => all.extend(ones[ends[0]..ends[1]].iter().map(|c| c * self.exitance[element])),
            }
        }
        all
    }

    /// S h for coefficients h, element by element; `starts` says where those of each begin.
    pub fn reflected(&self, starts: &[usize], irradiance: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; irradiance.len()];
        for (element, range) in starts.windows(2).map(|ends| ends[0]..ends[1]).enumerate() {
            let own = &mut out[range.clone()];
            match self.varying_reflectances.get(&element) {
                Some(reflectance) => add_product(&reflectance.matrix, &irradiance[range], own),
                None => {
                    let rho = self.reflectance[element];
                    own.iter_mut().zip(&irradiance[range]).for_each(|(out, h)| *out = rho * h);
                }
            }
            for part in self.parts(element) {
                add_product(&part.matrix, &irradiance[starts[part.behind]..starts[part.behind + 1]], own);
            }
        }
        out
    }

    /// S^½ x for coefficients x, element by element, of what reflects; not of what transmits.
    pub fn halved(&self, starts: &[usize], x: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; x.len()];
        for (element, range) in starts.windows(2).map(|ends| ends[0]..ends[1]).enumerate() {
            self.square_root(element).multiply(&x[range.clone()], &mut out[range]);
        }
        out
    }

    /// Adds to `rows`, which has as many columns as G, what the element `element` makes of the rows
    /// `incident` of the element `from`: S_element,from times them.
    pub fn add_reflected_rows(
        &self,
        [element, from]: [usize; 2],
        incident: &[f64],
        columns: usize,
        rows: &mut [f64],
    ) {
        let mut add = |k: usize, l: usize, factor: f64| {
            let line = &incident[l * columns..][..columns];
            rows[k * columns..][..columns].iter_mut().zip(line).for_each(|(out, x)| *out += factor * x);
        };
        if element == from {
            match self.varying_reflectances.get(&element) {
                Some(reflectance) => each_entry(&reflectance.matrix, incident.len() / columns, &mut add),
                None => (0..incident.len() / columns).for_each(|k| add(k, k, self.reflectance[element])),
            }
        }
        for part in self.parts(element) {
            if part.behind == from {
                each_entry(&part.matrix, incident.len() / columns, &mut add);
            }
        }
    }

    /// Coating of this emission where nothing is reflected or let through.
    pub fn black(&self) -> Self {
        Self {
            reflectance: vec![0.0; self.reflectance.len()].into(),
            varying_reflectances: BTreeMap::new(),
            transmissions: BTreeMap::new(),
            ..self.clone()
        }
    }
}

/// Calls `visit` with the row, the column and the value of every entry of a row-major matrix of so many
/// columns.
fn each_entry(matrix: &[f64], columns: usize, visit: &mut impl FnMut(usize, usize, f64)) {
    matrix.iter().enumerate().for_each(|(place, value)| visit(place / columns, place % columns, *value));
}

/// Adds M x to `out`, M row-major.
fn add_product(matrix: &[f64], x: &[f64], out: &mut [f64]) {
    for (out, row) in out.iter_mut().zip(matrix.chunks_exact(x.len())) {
        *out += dot(row, x);
    }
}

/// Values that `make` gives for elements, by index of the element; elements without a value are left out.
fn of_each<T: Send + Sync>(
    elements: &[Element],
    make: &(dyn Fn(&Element) -> Option<T> + Sync),
) -> BTreeMap<usize, Arc<T>> {
    let made = elements.par_iter().enumerate();
    made.filter_map(|(index, element)| {
        check_interrupt();
        Some((index, Arc::new(make(element)?)))
    })
    .collect()
}

/// Transmissions of the elements of surfaces that let light through, by index of the element.
fn transmissions(scene: &Scene, elements: &[Element], band: usize) -> BTreeMap<usize, Arc<Transmission>> {
    let mut transmissions = BTreeMap::new();
    for (index, element) in elements.iter().enumerate() {
        let surface = &scene.surfaces[element.surface];
        let transmittance = surface.material.transmittance[band];
        let Some(other) = surface.other_side.filter(|_| transmittance > 0.0) else { continue };
        let start = elements.partition_point(|element| element.surface < other);
        let end = elements.partition_point(|element| element.surface <= other);
        let shape = Arc::clone(&surface.shape);
        let part =
            |behind| TransmissionPart::new(element, behind, &elements[behind], shape.as_ref(), transmittance);
        let parts: Vec<TransmissionPart> = (start..end).filter_map(part).collect();
        transmissions.insert(index, Arc::new(Transmission { shape, transmittance, parts }));
    }
    transmissions
}
