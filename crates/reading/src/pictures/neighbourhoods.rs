//! Places beside each other in a picture, for which it is listed once what may stand before each emitter.

use std::collections::BTreeMap;

use radiosity_geom::{Aabb, DVec3};
use radiosity_light::occluders::{Occluders, Site};
use rayon::prelude::*;

use super::eye::SeenPlace;
use super::picture_light::PictureLight;

/// Sides of the squares of the picture whose places on one surface share a list (pixels): lists of the larger ones
/// are narrowed for the smaller ones. Chosen.
const SIDES: [usize; 2] = [32, 8];

/// Places at least that share a list. Chosen: a list takes as long as some dozen of them without.
const FEWEST: usize = 16;

/// Places at least for which a list is narrowed. Chosen: that takes as long as some places with the wider list.
const FEWEST_NARROWED: usize = 4;

/// Lists of what may stand before emitters, for the places of a picture.
pub(crate) struct Neighbourhoods {
    /// Index into the lists of each place that has one.
    of: Vec<Option<usize>>,
    lists: Vec<Occluders>,
}

impl Neighbourhoods {
    /// The lists for `count` places, where `seen` tells what each sees and the pixel it belongs to.
    pub(crate) fn of<'a>(
        light: &PictureLight,
        count: usize,
        seen: impl Fn(usize) -> Option<([usize; 2], &'a SeenPlace)>,
    ) -> Self {
        let mut of = vec![None; count];
        let Some(penumbra) = light.penumbra() else {
            return Self { of, lists: Vec::new() };
        };
        let places: Vec<(usize, [usize; 2], &SeenPlace)> =
            (0..count).filter_map(|place| seen(place).map(|(pixel, seen)| (place, pixel, seen))).collect();
        let large = groups(places.iter().copied(), SIDES[0]);
        let listed: Vec<Vec<(Occluders, Vec<usize>)>> = large
            .par_iter()
            .filter(|group| group.len() >= FEWEST)
            .map(|group| {
                let around = penumbra.around(&SiteHull::of(light, group).site());
                let small = groups(group.iter().copied(), SIDES[1]).into_iter();
                let narrowed = |group: Vec<(usize, [usize; 2], &SeenPlace)>| {
                    let site = SiteHull::of(light, &group);
                    let own = match group.len() < FEWEST_NARROWED {
                        true => around.clone(),
                        false => penumbra.narrowed(&around, &site.site()),
                    };
                    (own, group.into_iter().map(|(place, ..)| place).collect())
                };
                small.map(narrowed).collect()
            })
            .collect();
        let mut lists = Vec::new();
        for (list, group) in listed.into_iter().flatten() {
            group.into_iter().for_each(|place: usize| of[place] = Some(lists.len()));
            lists.push(list);
        }
        Self { of, lists }
    }

    /// Obstacles that may stand between a place and each emitter, where that is listed.
    pub(crate) fn around(&self, place: usize) -> Option<&Occluders> {
        self.of[place].map(|list| &self.lists[list])
    }
}

/// Places of one surface in one square of the picture.
fn groups<'a>(
    places: impl Iterator<Item = (usize, [usize; 2], &'a SeenPlace)>,
    side: usize,
) -> Vec<Vec<(usize, [usize; 2], &'a SeenPlace)>> {
    let mut groups: BTreeMap<([usize; 2], usize), Vec<_>> = BTreeMap::new();
    for one @ (_, pixel, seen) in places {
        groups.entry((pixel.map(|at| at / side), seen.place.surface)).or_default().push(one);
    }
    groups.into_values().collect()
}

/// A hull of places of one surface.
struct SiteHull {
    points: Vec<DVec3>,
    horizon: Option<DVec3>,
    surface: Option<usize>,
}

impl SiteHull {
    /// The hull of these places: a rectangle on a flat surface, else a box.
    fn of(light: &PictureLight, places: &[(usize, [usize; 2], &SeenPlace)]) -> Self {
        let positions = || places.iter().map(|(.., seen)| seen.place.position);
        let surface = places.first().map(|(.., seen)| seen.place.surface);
        let first = places.first().map(|(.., seen)| &light.solution().elements().list()[seen.element]);
        let Some(plane) = first.and_then(|element| element.level) else {
            let points = Aabb::around(positions()).corners().to_vec();
            return Self { points, horizon: None, surface };
        };
        let (along, across) = plane.normal.any_orthonormal_pair();
        let at = |x: DVec3| DVec3::new((x - plane.point).dot(along), (x - plane.point).dot(across), 0.0);
        let flat = Aabb::around(positions().map(at));
        let [low, high] = [flat.min, flat.max];
        let corners = [[low.x, low.y], [high.x, low.y], [high.x, high.y], [low.x, high.y]];
        let points = corners.map(|[x, y]| plane.point + along * x + across * y).to_vec();
        Self { points, horizon: Some(plane.normal), surface }
    }

    fn site(&self) -> Site<'_> {
        Site { points: &self.points, horizon: self.horizon, surface: self.surface }
    }
}
