//! Emitters as targets of rays from a point.
//!
//! Of the rays from x to emitters, emitter l gets the share p_l, about in proportion to the light that it
//! would send without shadows,
//!
//! ```text
//! p_l ∝ E₀ min(1, A c c' / (π d²)) ,     c ≤ 1, c' ≤ 1: bounds of the cosines at x and at l ,
//! ```
//!
//! and its points y, spread evenly, have the density p_l / A_l. An emitter of share 0 sends nothing to x. Of many
//! emitters, those that are far together are chosen by what their balls send (module `tree`).

mod lamp;
mod tree;

use std::ops::Range;

use radiosity_elements::Element;
use radiosity_elements::coating::Coating;
use radiosity_elements::measure::WeightedNode;
use smallvec::SmallVec;

use crate::receiver_point::ReceiverPoint;
pub(crate) use lamp::Lamp;
use tree::{LampTree, NodePlace, SeenTree};

/// Emitters from which on those that are far together are looked at as one. Chosen: beyond it a look at each takes
/// longer than the ray that it chooses.
const MANY: usize = 128;

/// The emitters of a scene.
#[derive(Debug)]
pub struct Lamps {
    list: Vec<Lamp>,
    /// For each element its place in the list, if it emits.
    places: Vec<Option<u32>>,
    /// Nodes over the list, where it is long.
    tree: Option<LampTree>,
}

/// Shares of the emitters in the rays from one point.
#[derive(Debug)]
pub struct Shares<'a> {
    lamps: &'a Lamps,
    /// The emitters of a tree, where several share a part.
    seen: Option<SeenTree<'a>>,
    /// Parts of the list, one after the other, that cover it. Those of few emitters take no memory of their own,
    /// which each end of a ray would ask for.
    parts: SmallVec<[Part; 16]>,
}

/// Emitters beside each other in the list that have a share together.
#[derive(Clone, Debug)]
struct Part {
    lamps: Range<u32>,
    /// Their node, where there is a tree.
    node: Option<NodePlace>,
    /// Sum of their p_l.
    share: f64,
    /// Sum of the shares up to and with this part.
    end: f64,
}

/// A point of an emitter that a ray is sent to.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// Index of the element that emits.
    pub element: usize,
    /// The point, with its weight.
    pub place: WeightedNode,
    /// Density of such points, p_l / A_l (1 / scene length²).
    pub density: f64,
}

impl Lamps {
    /// The open elements that emit, with one coating and the mean radiosity `scale` per band.
    pub fn new(elements: &[Element], coatings: &[&Coating], scale: &[f64]) -> Self {
        Self::by(elements, |element| brightness(coatings, scale, element))
    }

    /// The open elements of a `brightness` above 0, which is told by their indices.
    pub fn by(elements: &[Element], brightness: impl Fn(usize) -> f64) -> Self {
        let lamp = |element: usize| Lamp::of(elements, element, brightness(element));
        let mut list: Vec<Lamp> = (0..elements.len()).filter_map(lamp).collect();
        let tree = (list.len() > MANY).then(|| LampTree::over(&mut list));
        let mut places = vec![None; elements.len()];
        list.iter().enumerate().for_each(|(place, lamp)| places[lamp.element] = Some(place as u32));
        Self { list, places, tree }
    }

    /// Whether an emitter that may send light to a point is within so many of its radii.
    pub fn is_near(&self, receiver: &ReceiverPoint, radii: f64) -> bool {
        let is_near = |lamp: &Lamp| {
            lamp.center.distance_squared(receiver.position) < (radii * lamp.radius).powi(2)
                && lamp.bound(receiver) > 0.0
        };
        match &self.tree {
            Some(tree) => tree.any_near(&self.list, receiver.position, radii, is_near),
            None => self.list.iter().any(is_near),
        }
    }

    /// The shares of all emitters in the rays from a point.
    pub fn seen_from(&self, receiver: &ReceiverPoint) -> Shares<'_> {
        let Some(tree) = &self.tree else { return self.shares(|lamp| lamp.bound(receiver)) };
        let seen = SeenTree { tree, list: &self.list, receiver: *receiver };
        let part = |(node, share)| Part { lamps: seen.lamps(node), node: Some(node), share, end: 0.0 };
        let parts = seen.nodes().map(part).collect();
        Shares::of(self, parts, Some(seen))
    }

    /// The shares of emitters in the rays from a receiver, in proportion to the most that each sends to one of its
    /// points, of those whose elements, by their indices, `are_wanted`.
    pub fn seen_among(&self, points: &[ReceiverPoint], are_wanted: impl Fn(usize) -> bool) -> Shares<'_> {
        let most = |lamp: &Lamp| points.iter().map(|point| lamp.bound(point)).fold(0.0, f64::max);
        self.shares(|lamp| if are_wanted(lamp.element) { most(lamp) } else { 0.0 })
    }

    /// The shares of emitters in the rays from a point, of those whose brightness and form factor, if nothing hides
    /// them, `are_wanted`.
    pub fn seen_where(&self, receiver: &ReceiverPoint, are_wanted: impl Fn(f64, f64) -> bool) -> Shares<'_> {
        self.shares(|lamp| {
            let bound = lamp.bound(receiver);
            if are_wanted(lamp.brightness, bound / lamp.brightness) { bound } else { 0.0 }
        })
    }

    /// The emitters with what each has a share in proportion to.
    fn shares(&self, of: impl Fn(&Lamp) -> f64) -> Shares<'_> {
        let part = |(place, lamp): (u32, &Lamp)| Part {
            lamps: place..place + 1,
            node: None,
            share: of(lamp),
            end: 0.0,
        };
        Shares::of(self, (0..).zip(&self.list).map(part).collect(), None)
    }
}

/// Mean over the bands of the exitance of an element over the band's scale.
pub(crate) fn brightness(coatings: &[&Coating], scale: &[f64], element: usize) -> f64 {
    let relative = coatings.iter().zip(scale).map(|(coating, scale)| coating.exitance[element] / scale);
    relative.sum::<f64>() / scale.len() as f64
}

impl<'a> Shares<'a> {
    /// The emitters with what each part has a share in proportion to.
    fn of(lamps: &'a Lamps, mut parts: SmallVec<[Part; 16]>, seen: Option<SeenTree<'a>>) -> Self {
        let all: f64 = parts.iter().map(|part| part.share).sum();
        if all > 0.0 {
            parts.iter_mut().for_each(|part| part.share /= all);
        }
        let mut end = 0.0;
        for part in &mut parts {
            end += part.share;
            part.end = end;
        }
        Self { lamps, seen, parts }
    }

    /// Whether no emitter sends light to the point.
    pub fn is_empty(&self) -> bool {
        self.parts.last().is_none_or(|part| part.end <= 0.0)
    }

    /// Density of the targets on an element (1 / scene length²); 0 where it is no target.
    pub fn density(&self, element: usize) -> f64 {
        let Some(place) = self.lamps.places[element] else { return 0.0 };
        let part = &self.parts[self.parts.partition_point(|part| part.lamps.end <= place)];
        self.share(part, place) / self.lamps.list[place as usize].area
    }

    /// p_l of the emitter at a place of the list, in its part.
    fn share(&self, part: &Part, place: u32) -> f64 {
        match (&self.seen, part.node) {
            (Some(seen), Some(node)) if part.share > 0.0 => part.share * seen.share_of(node, place),
            _ => part.share,
        }
    }

    /// The target that three numbers in [0, 1) choose; there is an emitter.
    pub fn target(&self, [choice, s, t]: [f64; 3]) -> Target {
        let most = self.parts[self.parts.len() - 1].end;
        let found = self.parts.partition_point(|part| part.end <= choice * most);
        // Rounding may lead beyond the last one that has a share.
        let index = (0..=found.min(self.parts.len() - 1)).rev().find(|index| self.parts[*index].share > 0.0);
        let index = index.or_else(|| self.parts.iter().position(|part| part.share > 0.0)).unwrap_or(0);
        let part = &self.parts[index];
        // Rounding may lead beyond the part.
        let rest = ((choice * most - (part.end - part.share)) / part.share).clamp(0.0, 1.0 - f64::EPSILON);
        let place = match (&self.seen, part.node) {
            (Some(seen), Some(node)) => seen.chosen(node, rest),
            _ => part.lamps.start,
        };
        let lamp = &self.lamps.list[place as usize];
        Target {
            element: lamp.element,
            place: lamp.area_map.point([s, t]),
            density: self.share(part, place) / lamp.area,
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use radiosity_elements::{Discretization, Elements};
    use radiosity_geom::DVec3;
    use radiosity_geom::shapes::Parallelogram;
    use radiosity_scene::{Material, SceneBuilder};

    use super::*;

    /// 20 × 20 lamps that shine down from a height of 3, and as many that shine up from a depth of 1.
    fn elements() -> Elements {
        let mut builder = SceneBuilder::new("lamps", ["grey"]);
        let lamp = builder.material("lamp", Material::new(vec![0.0], vec![1.0]).expect("a lamp"));
        for k in 0..800 {
            let (row, column, is_low) = (k / 20 % 20, k % 20, k >= 400);
            let corner = DVec3::new(f64::from(column), f64::from(row), if is_low { -1.0 } else { 3.0 });
            let [a, b] = if is_low { [DVec3::X, DVec3::Y] } else { [DVec3::Y, DVec3::X] };
            let shape = Parallelogram::new(corner, 0.3 * a, 0.3 * b).expect("a lamp");
            builder.surface(format!("lamp{k}"), Arc::new(shape), &lamp);
        }
        let scene = builder.build().expect("a scene");
        Elements::new(&scene, &Discretization::uniform(0, 1)).expect("elements")
    }

    fn receivers() -> Vec<ReceiverPoint> {
        let places = [[9.7, 9.1, 0.0], [0.2, 19.0, 2.95], [30.0, 4.0, 1.0], [5.5, 5.5, -0.9]];
        let normals = [DVec3::Z, DVec3::NEG_X, DVec3::new(0.6, 0.0, 0.8), DVec3::NEG_Z];
        places
            .into_iter()
            .flat_map(|place| normals.map(|normal| ReceiverPoint::on(usize::MAX, DVec3::from(place), normal)))
            .collect()
    }

    /// ∫ q dA = 1 over all emitters, each has a share where it may send light, and the points that are chosen have the
    /// density that is told.
    #[test]
    fn many_emitters_have_shares_that_sum_to_one() {
        let elements = elements();
        let list = elements.list();
        let lamps = Lamps::by(list, |element| 1.0 + (element % 7) as f64);
        assert!(lamps.tree.is_some());
        for receiver in receivers() {
            let shares = lamps.seen_from(&receiver);
            let bounds: Vec<f64> = lamps.list.iter().map(|lamp| lamp.bound(&receiver)).collect();
            if shares.is_empty() {
                assert!(bounds.iter().all(|bound| *bound == 0.0));
                continue;
            }
            let share = |lamp: &Lamp| shares.density(lamp.element) * lamp.area;
            let all: f64 = lamps.list.iter().map(share).sum();
            assert!((all - 1.0).abs() < 1e-12, "{all}");
            for (lamp, bound) in lamps.list.iter().zip(&bounds) {
                assert!(*bound == 0.0 || share(lamp) > 0.0, "{} gets nothing of {bound}", lamp.element);
            }
            let count = 40_000;
            let mut met = vec![0; list.len()];
            for k in 0..count {
                let target = shares.target([(f64::from(k) + 0.5) / f64::from(count), 0.5, 0.5]);
                assert_eq!(target.density, shares.density(target.element));
                met[target.element] += 1;
            }
            for lamp in &lamps.list {
                let expected = share(lamp) * f64::from(count);
                assert!((f64::from(met[lamp.element]) - expected).abs() <= 2.0, "{expected}");
            }
        }
    }

    /// The power of the dim ones is lost beside that of the bright one in sums over all: shares are numbers, and the
    /// points that are chosen have a density.
    #[test]
    fn dim_emitters_beside_a_bright_one_have_shares() {
        let elements = elements();
        let lamps = Lamps::by(elements.list(), |element| if element == 0 { 1.0 } else { 1e-20 });
        for receiver in receivers() {
            let shares = lamps.seen_from(&receiver);
            let densities: Vec<f64> = lamps.list.iter().map(|lamp| shares.density(lamp.element)).collect();
            assert!(densities.iter().all(|density| density.is_finite()), "{receiver:?}");
            for k in 0..if shares.is_empty() { 0 } else { 100 } {
                let target = shares.target([(f64::from(k) + 0.5) / 100.0, 0.5, 0.5]);
                assert!(target.density > 0.0 && target.density == shares.density(target.element));
            }
        }
    }

    /// The second moment of a choice is below that of even shares where 1/d² varies from m to M = (1.25/0.75)² m,
    /// which is (m + M)²/(4 m M) = 1.29 at most (Kantorovich's inequality).
    #[test]
    fn many_emitters_get_about_what_they_send() {
        let elements = elements();
        let lamps = Lamps::by(elements.list(), |_| 1.0);
        let receiver = ReceiverPoint::on(usize::MAX, DVec3::new(9.7, 9.1, 0.0), DVec3::Z);
        let shares = lamps.seen_from(&receiver);
        let bounds: Vec<f64> = lamps.list.iter().map(|lamp| lamp.bound(&receiver)).collect();
        let all: f64 = bounds.iter().sum();
        let weight = |(lamp, bound): (&Lamp, &f64)| {
            let share = shares.density(lamp.element) * lamp.area;
            if *bound > 0.0 { (bound / all).powi(2) / share } else { 0.0 }
        };
        let second: f64 = lamps.list.iter().zip(&bounds).map(weight).sum();
        assert!((1.0..1.29).contains(&second), "{second}");
        assert!(shares.parts.len() < lamps.list.len() / 3, "{}", shares.parts.len());
    }
}
