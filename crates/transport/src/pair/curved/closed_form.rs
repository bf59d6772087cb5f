//! Elements that touch, or come near each other, where no rule for a common edge or corner covers that, and
//! what each point of one sees of the other one is known in closed form.
//!
//! A ball, a can or a cone that lies on a floor, or stands in the midst of it, meets it in a point or along a
//! line where the kernel is singular; so do pipes side by side. What a point sees of
//!
//! * a polygon, under any polynomial ([`Inner::Flat`]);
//! * a part of a cylinder, a cone, a disk or a ring, or a whole ball, that carries a constant
//!   ([`Inner::Swept`], [`Inner::Ball`]),
//!
//! is smooth up to the contact. The outer integral is that over the parts of the other element, in cells that
//! shrink toward the contact where they have to.
//!
//! Error. Three times the errors of all parts together, which are allowed a quarter of that of the block.
//! Sums of few points tell beforehand how much the block is: coarse estimates of touching parts may meet the
//! peak of the kernel, or miss it.

use radiosity_elements::Element;
use radiosity_elements::patch::{Node, Patch};
use radiosity_geom::{DVec3, Plane, distance_to_segment, sides};
use radiosity_kernel::PairKind;
use radiosity_kernel::contact::gap::{gap, point_to_polygon};
use radiosity_kernel::contact::orientation::{Facing, facing};
use radiosity_kernel::contact::patches::Contact;
use radiosity_kernel::estimates::entry_norm::EntryNorm;
use radiosity_kernel::irradiance::swept::Swept;
use radiosity_kernel::rules::far::SMALLEST_RATIO;
use radiosity_kernel::rules::horizon;
use radiosity_kernel::rules::horizon::{Cut, Inner, Side};
use radiosity_kernel::rules::zone::Zone;
use radiosity_work::interruption::check_interrupt;
use smallvec::SmallVec;

use crate::pair::job::Job;

/// Share of the block's error for all outer parts together.
const SHARE: f64 = 0.25;

/// Error over that which the outer rules tell: two of them may miss the same of a kink. Measured on balls and
/// cans at the borders of floors: up to 2.1.
const MISSED: f64 = 3.0;

/// Share of the block's error for the inner integrals, of polynomials.
const INNER_SHARE: f64 = 0.05;

/// Finest and coarsest error of these: rounding, and a rule of few points.
const FINEST: f64 = 1e-13;
const COARSEST: f64 = 1e-2;

/// Points along and across of the last rule that is tried on a part, for degree 0.
const POINTS: usize = 16;

/// Cosine of the angle between the normals at a common point below which parts touch tangentially (18°):
/// there the integrand of the rules of common edges and corners is nearly as singular as before.
const TANGENTIAL: f64 = -0.95;

/// Places on sides of curved parts where contacts are looked for, and a step from there to the next point.
const SAMPLES: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];
const STEP: f64 = 0.02;

/// Height of that point over a flat part, over the step's length, below which the side leaves along the part:
/// the rule of a common corner takes directions for apart. An arc of a right angle has 0.016.
const ALONG: f64 = 0.1;

/// How two parts lie to each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Meeting {
    Away,
    Apart,
    /// Near, or touching in a way that no rule covers.
    Near,
    /// At a common edge or corner that a rule covers.
    ByRule,
}

/// An element of which it is known what each point sees.
enum Seen<'a> {
    Polygon,
    Swept(Swept, Option<Plane>),
    Ball(Zone<'a>),
}

impl<'a> Seen<'a> {
    fn of(element: &'a Element, parts: &[Patch], eps: f64) -> Option<Self> {
        if element.plane.is_some() && parts.iter().all(Patch::is_flat) {
            return Some(Self::Polygon);
        }
        let Some(Patch::Curved { surface, .. }) = element.patches.first() else { return None };
        if element.basis.len() > 1 || !element.is_cell() {
            return None;
        }
        if let Some(swept) = Swept::of(&**surface, &element.rect) {
            return Some(Self::Swept(swept, element.level));
        }
        Zone::of(element, eps).filter(|zone| zone.is_whole() && !zone.is_hollow()).map(Self::Ball)
    }

    fn inner<'b>(&'b self, parts: &'b [Patch], eps: f64) -> Inner<'b> {
        match self {
            Self::Polygon => Inner::Flat(parts, eps),
            Self::Swept(swept, plane) => Inner::Swept(swept, *plane),
            Self::Ball(zone) => Inner::Ball(zone),
        }
    }
}

/// An outer element with its parts, and an inner one.
struct Sides<'a, 'b> {
    /// Place of the outer element in the pair.
    outer: usize,
    seen: Seen<'a>,
    parts: [&'b [Patch]; 2],
}

impl<'a> Job<'a> {
    /// Adds what parts exchange of which some are near each other, where a closed form knows what one sees of
    /// the other element; returns the parts of the second that are left to other rules, with all of the
    /// first. `least` bounds the scale of errors from below.
    pub(super) fn by_closed_form(&mut self, parts: [&[Patch]; 2], least: f64) -> Vec<Patch> {
        let Some(sides) = self.sides(parts) else { return parts[1].to_vec() };
        let [outer, inner] = [sides.parts[sides.outer], sides.parts[1 - sides.outer]];
        let meetings: Vec<Meeting> = outer.iter().map(|part| self.meeting(part, inner)).collect();
        let is_mixed = sides.outer == 0 && meetings.contains(&Meeting::ByRule);
        if is_mixed || !meetings.contains(&Meeting::Near) {
            return parts[1].to_vec();
        }
        let of = |wanted: &[Meeting]| -> Vec<Patch> {
            let kept = outer.iter().zip(&meetings).filter(|(_, meeting)| wanted.contains(meeting));
            kept.map(|(part, _)| part.clone()).collect()
        };
        self.near(&sides, &of(&[Meeting::Near, Meeting::Apart]), least);
        of(&[Meeting::ByRule])
    }

    /// The sides of the integrals. Balls that carry a constant are inner ones, as they have no border;
    /// before other elements polygons are.
    fn sides<'b>(&self, parts: [&'b [Patch]; 2]) -> Option<Sides<'a, 'b>> {
        let [first, second] = self.elements.map(|element| element.surface);
        // The two sides of a ball touch everywhere.
        let balls = [first, second].map(|surface| self.visibility.ball(surface));
        if first == second || balls[0].is_some() && balls[0] == balls[1] {
            return None;
        }
        let seen = |index: usize| Seen::of(self.elements[index], parts[index], self.budget.accuracy.eps);
        let side = |inner: usize| Some(Sides { outer: 1 - inner, seen: seen(inner)?, parts });
        let is_ball = |sides: &Sides| matches!(sides.seen, Seen::Ball(_)) && self.lies_outside(sides);
        let is_polygon = |sides: &Sides| matches!(sides.seen, Seen::Polygon);
        let ball = side(1).filter(is_ball).or_else(|| side(0).filter(is_ball));
        ball.or_else(|| side(1).filter(is_polygon)).or_else(|| side(0)).or_else(|| side(1))
    }

    /// Whether no flat part of the outer element reaches into an inner ball.
    fn lies_outside(&self, Sides { outer, seen, parts }: &Sides) -> bool {
        let Seen::Ball(zone) = seen else { return false };
        let (center, radius) = (zone.center(), zone.radius());
        let is_apart = |part: &Patch| point_to_polygon(center, &part.polygon()) >= radius - self.tolerance;
        parts[*outer].iter().all(|part| !part.is_flat() || is_apart(part))
    }

    fn meeting(&self, part: &Patch, others: &[Patch]) -> Meeting {
        check_interrupt();
        others.iter().map(|other| self.meeting_with(part, other)).max().unwrap_or(Meeting::Away)
    }

    fn meeting_with(&self, part: &Patch, other: &Patch) -> Meeting {
        if facing(part, other, false, 0.0) == Facing::Away {
            return Meeting::Away;
        }
        let extent = part.longest().1.min(other.longest().1);
        let contact = Contact::of(part, other, self.tolerance);
        match contact {
            Contact::Apart(_) if gap(part, other) >= SMALLEST_RATIO * extent => Meeting::Apart,
            Contact::Apart(_) | Contact::Tip(_) => Meeting::Near,
            _ if self.touch_tangentially([part, other]) || self.touch_tangentially([other, part]) => {
                Meeting::Near
            }
            _ if self.stands_on([part, other], &contact) || self.stands_on([other, part], &contact) => {
                Meeting::Near
            }
            _ => Meeting::ByRule,
        }
    }

    /// Whether a side of a curved part meets a flat one inside of its border, as that of a can which stands
    /// on a floor, or leaves a place on it along its plane, as the rim of a disk that stands on a floor.
    fn stands_on(&self, [part, other]: [&Patch; 2], contact: &Contact) -> bool {
        if part.is_flat() || !other.is_flat() || matches!(contact, Contact::Edge { .. }) {
            return false;
        }
        let polygon = other.polygon();
        let distance = |x: DVec3| point_to_polygon(x, &polygon);
        let normal = other.node(0.5, 0.5).normal;
        let height = |x: DVec3| normal.dot(x - polygon[0]).abs();
        let is_amid = |x: DVec3| sides(&polygon).all(|side| distance_to_segment(x, side) > self.tolerance);
        let cuts: SmallVec<[f64; 2]> = match contact {
            Contact::Cut(cuts) => cuts.iter().flatten().map(|cut| cut.at).collect(),
            _ => SmallVec::new(),
        };
        let is_met = |side: &dyn Fn(f64) -> DVec3, t: f64| {
            let x = side(t);
            let leaves = |next: f64| {
                let step = height(side(next));
                step > self.tolerance && step <= ALONG * side(next).distance(x)
            };
            let steps = [t - STEP, t + STEP].into_iter().filter(|next| (0.0..=1.0).contains(next));
            distance(x) <= self.tolerance && (is_amid(x) || steps.clone().any(leaves))
        };
        let at = |s: f64, t: f64| part.node(s, t).position;
        let all: [&dyn Fn(f64) -> DVec3; 4] =
            [&|s| at(s, 0.0), &|t| at(1.0, t), &|s| at(s, 1.0), &|t| at(0.0, t)];
        all.into_iter().any(|side| SAMPLES.iter().chain(&cuts).any(|t| is_met(side, *t)))
    }

    /// Whether a corner of a curved part lies on another one, with its normal against that one's.
    fn touch_tangentially(&self, [part, other]: [&Patch; 2]) -> bool {
        let corners =
            |patch: &Patch| [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(s, t)| patch.node(s, t));
        let touches = |x: DVec3, y: DVec3| x.distance(y) <= self.tolerance;
        corners(part).iter().any(|x| {
            let on_plane = other.is_flat()
                && x.normal.dot(other.node(0.5, 0.5).normal) < TANGENTIAL
                && point_to_polygon(x.position, &other.polygon()) <= self.tolerance;
            let at_corner = |y: &Node| x.normal.dot(y.normal) < TANGENTIAL && touches(x.position, y.position);
            on_plane || corners(other).iter().any(at_corner)
        })
    }

    /// Adds outer parts that may touch the inner element.
    fn near(&mut self, sides: &Sides, outer: &[Patch], least: f64) {
        self.kind = self.kind.max(PairKind::Contact);
        let rough = |part: &Patch| self.norm.first_entry(&self.sum(sides, part, f64::INFINITY, 0).moments);
        self.budget.scale = outer.iter().map(rough).sum::<f64>().max(least);
        let tolerance = SHARE * self.budget.may_err() / outer.len() as f64;
        for (place, part) in outer.iter().enumerate() {
            let budget = self.budget.left_for_horizons() / (outer.len() - place) as u64;
            let cut = self.sum(sides, part, tolerance, budget);
            self.take(Cut { error: MISSED * cut.error, ..cut });
        }
    }

    /// The integral over an outer part, to an error of `tolerance` in the block's entries.
    fn sum(&self, Sides { outer, seen, parts }: &Sides, part: &Patch, tolerance: f64, budget: u64) -> Cut {
        let [own, other] = [*outer, 1 - outer].map(|index| self.elements[index]);
        let points = [POINTS + self.degrees[*outer].div_ceil(2); 2];
        let side = Side { patch: part, basis: &own.basis, points, ball: None };
        // An error of the irradiance everywhere on the part.
        let eps = INNER_SHARE * self.budget.may_err() * (other.area / own.area).sqrt();
        let inner = seen.inner(parts[1 - outer], eps.clamp(FINEST, COARSEST));
        let norm = EntryNorm::of([&own.basis, &other.basis]);
        let cut = horizon::integrate(&side, &other.basis, &inner, &norm, tolerance, budget);
        if *outer == 0 {
            return cut;
        }
        let [rows, columns] = [other, own].map(|element| element.basis.len());
        let moments = (0..rows * columns).map(|k| cut.moments[k % columns * rows + k / columns]).collect();
        Cut { moments, ..cut }
    }
}
