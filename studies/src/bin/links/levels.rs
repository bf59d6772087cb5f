//! Nested levels of elements, and links of polynomials between elements of one level.

use std::collections::HashSet;
use std::f64::consts::PI;
use std::time::Instant;

use radiosity::elements::{Discretization, Element, Elements};
use radiosity::kernel::{Accuracy, Blocks};
use radiosity::transport::{Demand, assemble};
use radiosity::visibility::{Shadows, Visibility};
use radiosity::{Scene, Work};

use crate::scales::Scales;

/// Accuracies of blocks and of shadows in them. Chosen: below the errors of the links.
const ACCURACY: Accuracy = Accuracy { eps: 1e-4, shadow_eps: 1e-3 };

/// All levels of a scene.
pub(crate) struct Levels {
    pub elements: Vec<Elements>,
    /// Push and pull between the levels.
    pub scales: Scales,
    /// Parts of each element in the next level.
    parts: Vec<Vec<Vec<usize>>>,
    visibility: Visibility,
}

/// Links of polynomials, with their blocks.
pub(crate) struct Linked {
    /// The blocks of each level.
    blocks: Vec<Blocks>,
    /// Number of links with light.
    pub links: usize,
    /// Numbers in their blocks.
    pub numbers: usize,
    /// Seconds for the blocks.
    pub seconds: f64,
}

impl Levels {
    /// `count` levels, from whole surfaces on, each with all sides halved.
    pub(crate) fn nested(scene: &Scene, order: usize, count: usize) -> Self {
        let cuts = (0..count).map(|level| Discretization::uniform(order, 1 << level));
        Self::new(scene, &cuts.collect::<Vec<_>>())
    }

    /// Levels that are cut so, each into parts of the one before.
    pub(crate) fn new(scene: &Scene, cuts: &[Discretization]) -> Self {
        let cut = |how| Elements::new(scene, how).expect("surfaces have area");
        let elements: Vec<Elements> = cuts.iter().map(cut).collect();
        let scales = Scales::new(&elements);
        let parts = elements.windows(2).map(|pair| parts(&pair[0], &pair[1])).collect();
        Self {
            elements,
            scales,
            parts,
            visibility: Visibility::new(scene, Shadows::Auto, ACCURACY.shadow_eps),
        }
    }

    /// The elements that carry unknowns.
    pub(crate) fn leaves(&self) -> &Elements {
        self.elements.last().expect("there is a level")
    }

    /// Links of at most `eps` by `estimate`, which tells of two elements what their link misses.
    pub(crate) fn linked(&self, eps: f64, estimate: impl Fn(&Element, &Element) -> f64) -> Linked {
        let last = self.elements.len() - 1;
        let count = self.elements[0].list().len();
        let mut open: Vec<[usize; 2]> = (0..count).flat_map(|p| (p..count).map(move |q| [p, q])).collect();
        let (mut blocks, mut seconds) = (Vec::new(), 0.0);
        for (level, elements) in self.elements.iter().enumerate() {
            let list = elements.list();
            let may_stay = |[p, q]: &[usize; 2]| level == last || estimate(&list[*p], &list[*q]) <= eps;
            let (kept, split): (Vec<_>, Vec<_>) = open.into_iter().partition(may_stay);
            let wanted: HashSet<[usize; 2]> = kept.into_iter().collect();
            let is_wanted = |p, q| wanted.contains(&[p, q]);
            let begun = Instant::now();
            let demand = Demand::all(elements, &self.visibility, ACCURACY).of(&is_wanted);
            blocks.push(assemble(demand, None, &Work::alone()));
            seconds += begun.elapsed().as_secs_f64();
            open = split.into_iter().flat_map(|pair| self.pairs(level, pair)).collect();
        }
        let links = blocks.iter().map(|blocks| blocks.iter().count()).sum();
        let numbers = blocks.iter().map(Blocks::stored_numbers).sum();
        Linked { blocks, links, numbers, seconds }
    }

    /// The pairs of the parts of two elements of a level, each once.
    fn pairs(&self, level: usize, [p, q]: [usize; 2]) -> Vec<[usize; 2]> {
        let [own, others] = [p, q].map(|index| &self.parts[level][index]);
        let all = own.iter().flat_map(|a| others.iter().map(|b| [*a, *b]));
        all.filter(|[a, b]| p != q || a <= b).map(|[a, b]| [a.min(b), a.max(b)]).collect()
    }
}

impl Linked {
    /// y = G x on the leaves.
    pub(crate) fn apply(&self, levels: &Levels, x: &[f64]) -> Vec<f64> {
        let sent = levels.scales.pull(x);
        let mut received = Vec::with_capacity(sent.len());
        for blocks in &self.blocks {
            let start = received.len();
            received.extend(blocks.apply(&sent[start..start + blocks.dim()]));
        }
        levels.scales.push(received)
    }
}

fn parts(coarse: &Elements, fine: &Elements) -> Vec<Vec<usize>> {
    let mut parts = vec![Vec::new(); coarse.list().len()];
    for (index, element) in fine.list().iter().enumerate() {
        if let Some(parent) = coarse.at(element.surface, element.rect.center()) {
            parts[parent].push(index);
        }
    }
    parts
}

/// Form factor from the second element to the first, from above, and the sum of their radii over their
/// distance, at most 1; zero where one lies behind the other.
pub(crate) fn form_factor(p: &Element, q: &Element) -> [f64; 2] {
    if std::ptr::eq(p, q) {
        return [if p.plane.is_some() { 0.0 } else { 1.0 }, 1.0];
    }
    let [centers, others] = [[p, q], [q, p]].map(|pair| pair.map(|element| element.bounds().center()));
    let distance = centers[0].distance(others[0]);
    let height = |k: usize| {
        let (own, other) = ([p, q][k], [q, p][k]);
        own.plane.map(|plane| {
            other.hull.iter().map(|x| (x - plane.point).dot(plane.normal)).fold(f64::NEG_INFINITY, f64::max)
        })
    };
    let mut cosines = 1.0;
    for height in [height(0), height(1)].into_iter().flatten() {
        if height <= 1e-9 * (p.extent + q.extent) {
            return [0.0; 2];
        }
        cosines *= (height / distance).min(1.0);
    }
    let radii = 0.5 * (p.extent + q.extent);
    let factor = cosines * p.area / (PI * distance.powi(2) + p.area.max(q.area));
    [factor, (radii / distance).min(1.0)]
}
