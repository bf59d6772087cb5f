//! Rooms with partitions and furniture.

use std::f64::consts::TAU;

use radiosity_geom::DVec3;

use crate::interiors::plan::{Cell, Plan, Spot, plan};
use crate::interiors::solid::{Solid, can, footprint, prism};
use crate::interiors::surface::{Shape, Surface};
use radiosity_test_support::random::Random;

/// A closed room with what stands in it, upright at the origin.
#[derive(Clone, Debug)]
pub(crate) struct Interior {
    pub(crate) plan: Plan,
    pub(crate) surfaces: Vec<Surface>,
    pub(crate) solids: Vec<Solid>,
}

/// Radius of the circle that stays free around a thing, over the thing's radius.
const MARGIN: f64 = 1.01;

/// Where a thing stands: the middle of its circle, its radius and the height of the floor.
struct Circle {
    middle: [f64; 2],
    radius: f64,
    floor: f64,
}

impl Interior {
    /// Draws one; without anything curved unless `curved`.
    pub(crate) fn draw(random: &mut Random, curved: bool) -> Self {
        let plan = plan(random);
        let mut own = Self { surfaces: plan.surfaces.clone(), solids: Vec::new(), plan };
        if own.plan.kind == "step" {
            own.solids.push(podium(&own.plan));
        }
        if own.plan.kind == "rectangle" {
            let count = random.pick(&[0, 0, 1, 1, 2]);
            own.part(random, count);
        }
        let mut taken: Vec<Circle> = Vec::new();
        for k in 0..random.pick(&[0, 1, 2, 3, 4, 5, 6]) {
            if let Some(circle) = own.free_circle(random, &taken) {
                own.furnish(random, k, &circle, curved);
                taken.push(circle);
            }
        }
        own
    }

    /// The scene as text.
    pub(crate) fn text(surfaces: &[Surface]) -> String {
        let head = "bands = ['grey']\n[materials.white]\nreflectance = 0.5\nemission = 1\n";
        head.to_owned() + &surfaces.iter().map(Surface::text).collect::<String>()
    }

    /// Whether the point lies in the air of the room.
    pub(crate) fn is_air(&self, x: DVec3) -> bool {
        x.z > 0.0 && x.z < self.plan.height && contains(&self.plan.outline, [x.x, x.y]) && !self.is_solid(x)
    }

    /// Whether the point lies in something.
    pub(crate) fn is_solid(&self, x: DVec3) -> bool {
        self.solids.iter().any(|solid| solid.holds(x))
    }

    /// Partitions from wall to wall and floor to ceiling, a door in each; they split the floor.
    fn part(&mut self, random: &mut Random, count: usize) {
        let [w, d, h] = self.plan.size;
        let mut cells = Vec::new();
        let mut from = 0.0;
        for k in 0..count {
            let thick = random.pick(&[0.0121, 0.1, 0.2]);
            let at = w * (k as f64 + random.between(0.7, 1.3)) / (count as f64 + 1.0);
            let door = random.between(0.0, 1.0) * (d - 1.1) + 0.1;
            let gap = random.pick(&[0.0, 0.0, 0.02]);
            let opening = Opening { low: door, high: door + 0.9, top: 2.1 - gap };
            let name = format!("partition {k}");
            self.surfaces.extend(partition(&name, [at, at + thick], [d, h], &opening));
            let slab = |y0: f64, y1: f64, low: f64| Solid::Prism {
                outline: vec![[at, y0], [at + thick, y0], [at + thick, y1], [at, y1]],
                low,
                high: h,
            };
            self.solids.extend([
                slab(0.0, opening.low, 0.0),
                slab(opening.high, d, 0.0),
                slab(0.0, d, opening.top),
            ]);
            cells.push([from, 0.0, at, d]);
            from = at + thick;
        }
        cells.push([from, 0.0, w, d]);
        self.plan.cells = cells.into_iter().map(|cell| Spot { cell, floor: 0.0 }).collect();
    }

    /// A circle on a floor apart from those taken, if one is found soon.
    fn free_circle(&self, random: &mut Random, taken: &[Circle]) -> Option<Circle> {
        for _ in 0..20 {
            let cells = &self.plan.cells;
            let Spot { cell, floor } = cells[(random.between(0.0, cells.len() as f64)) as usize];
            let radius = random.between(0.15, 0.7);
            let Some(middle) = place(random, cell, MARGIN * radius) else { continue };
            let apart = |other: &Circle| {
                let [dx, dy] = [0, 1].map(|k| other.middle[k] - middle[k]);
                dx.hypot(dy) > MARGIN * (radius + other.radius)
            };
            if taken.iter().all(apart) {
                return Some(Circle { middle, radius, floor });
            }
        }
        None
    }

    /// Something in a circle.
    fn furnish(&mut self, random: &mut Random, index: usize, circle: &Circle, curved: bool) {
        let room = self.plan.height - circle.floor;
        match random.pick(if curved { &[0, 1, 2, 3] } else { &[0, 0, 1, 4] }) {
            0 => self.stand(random, index, circle, room),
            1 => self.hover(random, index, circle),
            2 => self.ball(random, index, circle),
            3 => self.can(random, index, circle),
            _ => self.stack(random, index, circle, room),
        }
    }

    /// A box on the floor, with or without a bottom.
    fn stand(&mut self, random: &mut Random, index: usize, circle: &Circle, room: f64) {
        let height = room * random.between(0.1, 0.9);
        let outline = footprint(random, circle.middle, circle.radius);
        let open: &[usize] = random.pick(&[&[], &[4]]);
        self.add_prism(&format!("box {index}"), outline, [circle.floor, circle.floor + height], open);
    }

    /// A box in the air, sometimes hardly.
    fn hover(&mut self, random: &mut Random, index: usize, circle: &Circle) {
        let outline = footprint(random, circle.middle, circle.radius);
        let room = self.plan.height - circle.floor;
        let choices = [random.between(0.05, 0.4), random.power(-5.0, -1.5)];
        let lift = room * random.pick(&choices);
        let low = circle.floor + lift;
        self.add_prism(&format!("box {index}"), outline, [low, low + 0.4 * room], &[]);
    }

    /// A box on a box; without a bottom only where nothing of it hangs over.
    fn stack(&mut self, random: &mut Random, index: usize, circle: &Circle, room: f64) {
        let middle = circle.floor + 0.3 * room;
        let lower = footprint(random, circle.middle, circle.radius);
        let within = inradius(&lower, circle.middle);
        self.add_prism(&format!("box {index}"), lower, [circle.floor, middle], &[4]);
        let hangs_over = random.pick(&[true, false]);
        let most = if hangs_over { circle.radius } else { within };
        let radius = random.between(0.2, 0.9) * most;
        let upper = footprint(random, circle.middle, radius);
        let open: &[usize] = if hangs_over { &[] } else { random.pick(&[&[], &[4]]) };
        self.add_prism(&format!("upper box {index}"), upper, [middle, middle + 0.2 * room], open);
    }

    fn ball(&mut self, random: &mut Random, index: usize, circle: &Circle) {
        let radius = circle.radius.min(0.4 * (self.plan.height - circle.floor));
        let choices = [0.0, 0.1 * radius, random.power(-6.0, -1.0)];
        let lift = random.pick(&choices);
        let center = DVec3::new(circle.middle[0], circle.middle[1], circle.floor + radius + lift);
        self.surfaces
            .push(Surface { name: format!("ball {index}"), shape: Shape::Sphere { center, radius } });
        self.solids.push(Solid::Ball { center, radius });
    }

    /// A can in the air, upright or lying.
    fn can(&mut self, random: &mut Random, index: usize, circle: &Circle) {
        let room = self.plan.height - circle.floor;
        let choices = [random.between(0.05, 0.3), random.power(-5.0, -1.5)];
        let lift = room * random.pick(&choices);
        let lies = random.pick(&[true, false]);
        let [x, y] = circle.middle;
        let (base, axis, radius) = if lies {
            let angle = random.between(0.0, TAU);
            let along = DVec3::new(angle.cos(), angle.sin(), 0.0);
            let radius = (0.5 * circle.radius).min(0.3 * room);
            let middle = DVec3::new(x, y, circle.floor + lift + radius);
            let half = 0.8 * circle.radius;
            (middle - half * along, 2.0 * half * along, radius)
        } else {
            let height = random.between(0.2, 0.6) * room;
            (DVec3::new(x, y, circle.floor + lift), height * DVec3::Z, circle.radius)
        };
        self.surfaces.extend(can(&format!("can {index}"), base, axis, radius));
        self.solids.push(Solid::Can { base, axis, radius });
    }

    fn add_prism(&mut self, name: &str, outline: Vec<[f64; 2]>, [low, high]: [f64; 2], open: &[usize]) {
        self.surfaces.extend(prism(name, &outline, low, high, open));
        self.solids.push(Solid::Prism { outline, low, high });
    }
}

/// Distance of the nearest side of a convex outline from a point inside it.
fn inradius(outline: &[[f64; 2]], [x, y]: [f64; 2]) -> f64 {
    let distance = |k: usize| {
        let ([a, b], [c, d]) = (outline[k], outline[(k + 1) % outline.len()]);
        ((c - a) * (y - b) - (d - b) * (x - a)) / (c - a).hypot(d - b)
    };
    (0..outline.len()).map(distance).fold(f64::INFINITY, f64::min)
}

/// The body below the upper floor.
fn podium(plan: &Plan) -> Solid {
    let Spot { cell: [x0, y0, x1, y1], floor } = plan.cells[1];
    Solid::Prism { outline: vec![[x0, y0], [x1, y0], [x1, y1], [x0, y1]], low: 0.0, high: floor }
}

/// A point of the cell that far from its sides.
fn place(random: &mut Random, [x0, y0, x1, y1]: Cell, margin: f64) -> Option<[f64; 2]> {
    let fits = x1 - x0 > 2.0 * margin && y1 - y0 > 2.0 * margin;
    fits.then(|| [random.between(x0 + margin, x1 - margin), random.between(y0 + margin, y1 - margin)])
}

/// The opening of a door: its sides and its top (metres).
struct Opening {
    low: f64,
    high: f64,
    top: f64,
}

/// A partition between two planes of x, from wall to wall: its two faces, both jambs and the lintel.
fn partition(name: &str, [x0, x1]: [f64; 2], [depth, height]: [f64; 2], door: &Opening) -> Vec<Surface> {
    let Opening { low, high, top } = *door;
    let face = |x: f64| {
        let outline = [
            [0.0, 0.0],
            [low, 0.0],
            [low, top],
            [high, top],
            [high, 0.0],
            [depth, 0.0],
            [depth, height],
            [0.0, height],
        ];
        outline.map(|[y, z]| DVec3::new(x, y, z)).to_vec()
    };
    let across = |a: [f64; 2], b: [f64; 2]| {
        let corner = |x: f64, [y, z]: [f64; 2]| DVec3::new(x, y, z);
        vec![corner(x0, a), corner(x0, b), corner(x1, b), corner(x1, a)]
    };
    let back = face(x0).into_iter().rev().collect();
    vec![
        Surface::polygon(format!("{name} front"), face(x1)),
        Surface::polygon(format!("{name} back"), back),
        Surface::polygon(format!("{name} jamb 0"), across([low, 0.0], [low, top])),
        Surface::polygon(format!("{name} lintel"), across([low, top], [high, top])),
        Surface::polygon(format!("{name} jamb 1"), across([high, top], [high, 0.0])),
    ]
}

/// Whether a point lies inside a polygon (even and odd crossings).
pub(crate) fn contains(outline: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let crosses = |k: &usize| {
        let ([a, b], [c, d]) = (outline[*k], outline[(k + 1) % outline.len()]);
        (b > y) != (d > y) && x < a + (c - a) * (y - b) / (d - b)
    };
    (0..outline.len()).filter(crosses).count() % 2 == 1
}
