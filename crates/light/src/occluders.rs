//! Occluder lists: the surfaces that may stand between a site (a point or a piece of surface) and each
//! element.
//!
//! An obstacle hides no part of an element from the site if it lies outside the box around both, wholly below
//! the site's horizon, or wholly behind the element's plane; or if it lies within a whole ball, and the site and the
//! element without. A whole ball between site and element hides all. What remains is tested cell by cell.

use std::iter;

use radiosity_elements::Element;
use radiosity_geom::{Aabb, COINCIDENT, DVec3, Plane};
use radiosity_visibility::{Place, Visibility};

/// A point or a small piece of surface that receives light.
#[derive(Clone, Copy, Debug)]
pub struct Site<'a> {
    /// Points whose convex hull contains it.
    pub points: &'a [DVec3],
    /// Unit normal of a plane above which all points of the site receive light, if there is one.
    pub horizon: Option<DVec3>,
    /// Index of the surface it lies on, if any.
    pub surface: Option<usize>,
}

impl<'a> Site<'a> {
    /// An element as a receiver.
    pub fn of(element: &'a Element) -> Self {
        let horizon = element.plane.map(|plane| plane.normal);
        Self { points: &element.hull, horizon, surface: Some(element.surface) }
    }
}

/// Sender of light to a site: an element, or a whole surface.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sender {
    /// Index of its surface.
    pub surface: usize,
    /// Its plane, if it is flat.
    pub plane: Option<Plane>,
    /// Its bounding box.
    pub bounds: Aabb,
}

/// The obstacles between a site and each of several elements.
#[derive(Clone, Debug)]
pub struct Occluders {
    /// Indices of all surfaces that may hide any of the elements, ascending.
    pub(crate) obstacles: Vec<usize>,
    /// Indices into `obstacles`, element after element.
    places: Vec<usize>,
    /// The range in `places` of each element; None where the element is out of sight.
    ranges: Vec<Option<(usize, usize)>>,
}

impl Occluders {
    /// The occluders between a site and each of `senders`.
    pub(crate) fn new(
        visibility: &Visibility,
        senders: impl Iterator<Item = Sender> + Clone,
        site: &Site,
    ) -> Self {
        let around = Aabb::around(site.points.iter().copied());
        let everywhere = senders.clone().fold(around, |bounds, sender| bounds.union(sender.bounds));
        let obstacles = visibility.reaching_into(&everywhere, site.surface.is_none());
        Self::among(obstacles, visibility, senders, site)
    }

    /// The occluders between a site and one sender; before a point without most of those beside the cone around the
    /// sender.
    pub(crate) fn before_one(visibility: &Visibility, sender: Sender, site: &Site) -> Self {
        let [x] = site.points else { return Self::new(visibility, iter::once(sender), site) };
        let obstacles = visibility.reaching_before(*x, &sender.bounds, site.surface.is_none());
        Self::among(obstacles, visibility, iter::once(sender), site)
    }

    /// The occluders among `obstacles`, which are all that may stand there.
    fn among(
        mut obstacles: Vec<usize>,
        visibility: &Visibility,
        senders: impl Iterator<Item = Sender>,
        site: &Site,
    ) -> Self {
        let Site { points: site, horizon, surface } = *site;
        let around = Aabb::around(site.iter().copied());
        let ground = horizon.map(|normal| Plane { point: lowest(site, normal), normal });
        let reaches_over = |points: &[DVec3], plane: Option<Plane>| {
            plane.is_none_or(|plane| points.iter().any(|x| is_over(*x, &plane)))
        };
        let rises = |hull: &[DVec3]| reaches_over(hull, ground);
        let is_before = |points: &[DVec3], sender: &Sender| reaches_over(points, sender.plane);
        let own = |other: usize, surface: usize| {
            other == visibility.sheet(surface) && !visibility.hides_itself(surface)
        };
        let within =
            |sender: &Sender| surface == Some(sender.surface) && visibility.is_hollow(sender.surface);
        let is_of_body = |other: usize, surface: usize| visibility.are_of_one_body(other, surface);
        let is_ground =
            |other: usize| surface.is_some_and(|surface| own(other, surface) || is_of_body(other, surface));
        obstacles.retain(|other| !is_ground(*other) && rises(visibility.hull(*other)));
        let holds_site = |other: &usize| match surface {
            Some(surface) => visibility.encloses(*other, surface),
            None => visibility.contains(*other, site),
        };
        let here = Place { points: site, surface };
        let mut places = Vec::new();
        let ranges = senders.map(|sender| {
            let corners = sender.bounds.corners();
            let there = Place { points: &corners, surface: Some(sender.surface) };
            if !rises(&corners) || !is_before(site, &sender) || visibility.are_parted(&here, &there) {
                return None;
            }
            let shaft = around.union(sender.bounds);
            let stands = |place: &usize| {
                let hull = visibility.hull(obstacles[*place]);
                let reaches = visibility.bounds_of(obstacles[*place]).overlaps(&shaft);
                let itself = obstacles[*place] == visibility.sheet(sender.surface) && within(&sender);
                let touches = || is_of_body(obstacles[*place], sender.surface);
                let holds_both = || {
                    visibility.encloses(obstacles[*place], sender.surface) && holds_site(&obstacles[*place])
                };
                reaches
                    && is_before(hull, &sender)
                    && !itself
                    && !own(obstacles[*place], sender.surface)
                    && !touches()
                    && !holds_both()
                    && !visibility.is_shut_away(obstacles[*place], [&here, &there])
            };
            let start = places.len();
            places.extend((0..obstacles.len()).filter(stands));
            Some((start, places.len()))
        });
        let ranges = ranges.collect();
        Self { obstacles, places, ranges }
    }

    /// Nothing between a site and one element in sight.
    pub(crate) fn nothing() -> Self {
        Self { obstacles: Vec::new(), places: Vec::new(), ranges: vec![Some((0, 0))] }
    }

    /// The occluders without those that certainly miss the shaft between the site and an element; `hulls` has
    /// the hull points of each element.
    pub(crate) fn narrowed(&self, visibility: &Visibility, hulls: &[&[DVec3]], site: &Site) -> Self {
        let mut kept = Vec::with_capacity(self.places.len());
        let ranges = self.ranges.iter().zip(hulls).map(|(range, hull)| {
            let (first, last) = (*range)?;
            let start = kept.len();
            let reaches = |obstacle: &usize| visibility.reaches(*obstacle, site.points, hull);
            kept.extend(self.places[first..last].iter().map(|place| self.obstacles[*place]).filter(reaches));
            Some((start, kept.len()))
        });
        let ranges = ranges.collect();
        let mut obstacles = kept.clone();
        obstacles.sort_unstable();
        obstacles.dedup();
        let place = |obstacle: &usize| obstacles.partition_point(|other| other < obstacle);
        Self { places: kept.iter().map(place).collect(), ranges, obstacles }
    }

    /// The occluders of one element alone.
    pub(crate) fn alone(&self, element: usize) -> Self {
        let Some(places) = self.before(element) else {
            return Self { ranges: vec![None], ..Self::nothing() };
        };
        let obstacles: Vec<usize> = places.iter().map(|place| self.obstacles[*place]).collect();
        let count = obstacles.len();
        Self { obstacles, places: (0..count).collect(), ranges: vec![Some((0, count))] }
    }

    /// Whether nothing stands between the site and any element in sight.
    pub(crate) fn is_clear(&self) -> bool {
        self.places.is_empty()
    }

    /// Indices into `obstacles` of the occluders of an element; None where the element is out of sight.
    pub(crate) fn before(&self, element: usize) -> Option<&[usize]> {
        self.ranges[element].map(|(start, end)| &self.places[start..end])
    }
}

/// The first of the points that are lowest along `direction`.
fn lowest(points: &[DVec3], direction: DVec3) -> DVec3 {
    let lower = |a: &&DVec3, b: &&DVec3| a.dot(direction).total_cmp(&b.dot(direction));
    points.iter().min_by(lower).copied().expect("a site has points")
}

/// Whether `x` is above a plane by more than [`COINCIDENT`] times its distance from the point of that.
fn is_over(x: DVec3, plane: &Plane) -> bool {
    plane.height(x) > COINCIDENT * x.distance(plane.point)
}
