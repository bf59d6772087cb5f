//! Coats: elements that reflect alike in every band.
//!
//! Light that was reflected exactly once is linear in the reflectance of what reflected it. Kept apart by
//! coats, it is known for other reflectances as well.

use std::collections::BTreeMap;

use radiosity_elements::coating::Coating;

/// Most coats: each keeps as many numbers as the light of all. Chosen.
const MOST: usize = 8;

/// Largest change of one reflectance against that of another for which light is not gathered anew: where a
/// coat gains so much, what gathering neglected of it grows as much. Chosen; mean irradiances of the Cornell
/// box, repainted within this range, then differ from those of a new solution by less than half the accuracy
/// of shadows (`cargo test --release --test theorems light::models`).
const SPREAD: f64 = 4.0;

/// The coat of each element.
#[derive(Clone, Debug)]
pub(crate) struct Coats {
    of_element: Vec<usize>,
    count: usize,
}

impl Coats {
    /// Elements of the same reflectances have the same coat, and so do all on which it varies; the last one
    /// holds all that would be too many. Those `apart` have one each, after all others.
    pub(crate) fn of(coatings: &[&Coating], apart: &[usize]) -> Self {
        let elements = coatings.first().map_or(0, |coating| coating.reflectance.len());
        let mut known = BTreeMap::new();
        let coat = |element: usize| {
            let is_patterned = coatings.iter().any(|coating| coating.varies(element));
            let own = coatings.iter().filter(|_| !is_patterned);
            let reflectances: Vec<u64> = own.map(|coating| coating.reflectance[element].to_bits()).collect();
            let next = known.len();
            *known.entry(reflectances).or_insert(next.min(MOST - 1))
        };
        let mut of_element: Vec<usize> = (0..elements).map(coat).collect();
        let count = of_element.iter().max().map_or(0, |last| last + 1);
        apart.iter().zip(count..).for_each(|(element, coat)| of_element[*element] = coat);
        Self { of_element, count: count + apart.len() }
    }

    /// Number of coats.
    pub(crate) fn count(&self) -> usize {
        self.count
    }

    /// The coat of an element.
    pub(crate) fn of_element(&self, element: usize) -> usize {
        self.of_element[element]
    }

    /// For each coat its reflectances by `new` coatings over those by `old` ones, band by band. None where
    /// the elements of a coat differ, where some change too much against others, and where other patterns
    /// vary.
    pub(crate) fn change(&self, old: &[&Coating], new: &[&Coating]) -> Option<Vec<Vec<f64>>> {
        if old.iter().zip(new).any(|(old, new)| !old.varies_as(new)) {
            return None;
        }
        let mut factors = vec![vec![None; old.len()]; self.count];
        for (element, coat) in self.of_element.iter().enumerate() {
            for (band, factor) in factors[*coat].iter_mut().enumerate() {
                let own = ratio(new[band].reflectance[element], old[band].reflectance[element])?;
                if own != 1.0 && old[band].transmittance(element) > 0.0 {
                    return None;
                }
                if factor.replace(own).is_some_and(|known| known != own) {
                    return None;
                }
            }
        }
        let factors: Vec<Vec<f64>> =
            factors.iter().map(|coat| coat.iter().map(|factor| factor.unwrap_or(1.0)).collect()).collect();
        (0..old.len()).all(|band| is_moderate(&factors, band)).then_some(factors)
    }
}

/// The factor from one reflectance to another; None from black to any other.
fn ratio(new: f64, old: f64) -> Option<f64> {
    match (new, old) {
        _ if new == old => Some(1.0),
        (_, 0.0) => None,
        _ => Some(new / old),
    }
}

/// Whether the factors of a band are near each other.
fn is_moderate(factors: &[Vec<f64>], band: usize) -> bool {
    let of_band = || factors.iter().map(|coat| coat[band]);
    let (least, most) = (of_band().fold(f64::INFINITY, f64::min), of_band().fold(0.0, f64::max));
    most <= SPREAD * least
}
