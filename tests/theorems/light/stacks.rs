//! Sensors on faces that lie on each other: they belong to the uppermost face on their side.
//!
//! A convex room with walls of different exitance is black, so that E is known: with θ between the normals of the
//! sensor and of the face that it stands on, which reflects ρ,
//!
//! ```text
//! E(n) = 1/π ∫_{above} M(ω) (n·ω) dω + ρ E(face) (1 − cos θ)/2 .
//! ```

#![expect(clippy::print_stdout, reason = "how far readings are off is printed with --nocapture")]

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use radiosity::geom::shapes::{Cylinder, Disk, Parallelogram, Polygon, Sphere};
use radiosity::geom::{DVec3, Surface};
use radiosity::reading::probe::{Probe, probe};
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::solve::gather::gather_method::GatherMethod;
use radiosity::{Options, Scene, SceneBuilder, Work};
use radiosity_test_support::random::Random;
use radiosity_test_support::scenes::{material, typed};
use radiosity_test_support::solved::solved_of;

const HALF: DVec3 = DVec3::new(2.0, 1.8, 1.5);

/// Exitance of the walls at −x, x, −y, y, −z, z.
const WALLS: [f64; 6] = [40.0, 90.0, 60.0, 20.0, 70.0, 150.0];

/// Reflectance of the faces of stacks.
const GREY: f64 = 0.3;

/// Gaps between faces on each other (scene length).
const GAPS: [f64; 10] = [0.0, 1e-12, 1e-11, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3];

/// Least distance of sensors from the edges of all faces (scene length): more than ten gaps.
const FROM_EDGES: f64 = 0.08;

/// Height over a face at which a sensor stands in the open (scene length).
const ABOVE: f64 = 2e-3;

/// Accuracy of what is gathered.
const EPS: f64 = 2e-3;

/// Share by which readings may differ from those above, and from what is known.
const SHARE: f64 = 0.02;

/// Wall k of the room.
fn wall(k: usize) -> Parallelogram {
    let mut sides = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| 2.0 * axis.dot(HALF) * axis);
    sides.rotate_left(k / 2);
    let [out, first, second] = sides;
    let wall = match k % 2 {
        0 => Parallelogram::new(-HALF, first, second),
        _ => Parallelogram::new(out - HALF, second, first),
    };
    wall.expect("a wall")
}

/// A face of a stack.
#[derive(Clone, Debug)]
struct Face {
    outline: Outline,
    /// Height over the stack's origin along its axis.
    height: f64,
    /// Whether its front looks along the axis.
    is_up: bool,
    is_two_sided: bool,
}

/// Outline of a face, in the coordinates of the stack.
#[derive(Clone, Debug)]
enum Outline {
    /// A rectangle by its ends along both axes.
    Rectangle([[f64; 2]; 2]),
    /// That rectangle without its last quarter.
    Angle([[f64; 2]; 2]),
    /// A disk by its middle and radius.
    Disk([f64; 2], f64),
    /// Part of a cylinder about the second axis, its radius below the origin, by its ends along that axis and half
    /// its angle.
    Bent([f64; 2], f64),
}

/// Radius of cylinders.
const RADIUS: f64 = 0.7;

impl Outline {
    /// How far inside a place is.
    fn depth(&self, [x, y]: [f64; 2]) -> f64 {
        let within = |[low, high]: [f64; 2], at: f64| (at - low).min(high - at);
        match self {
            Self::Rectangle([along, across]) => within(*along, x).min(within(*across, y)),
            Self::Angle([along, across]) => {
                let whole = within(*along, x).min(within(*across, y));
                let [middle, level] = [*along, *across].map(|[low, high]| 0.5 * (low + high));
                whole.min((middle - x).max(level - y))
            }
            Self::Disk([middle, level], radius) => radius - (x - middle).hypot(y - level),
            Self::Bent(across, angle) => within(*across, y).min((angle - (x / RADIUS).abs()) * RADIUS),
        }
    }
}

/// Faces on each other.
struct Stack {
    origin: DVec3,
    /// Unit vectors along both axes, and the axis of heights.
    frame: [DVec3; 3],
    faces: Vec<Face>,
}

impl Stack {
    fn random(random: &mut Random) -> Self {
        let origin = random.vector(-0.3, 0.3);
        let frame = match random.below(2) {
            0 => [DVec3::X, DVec3::Y, DVec3::Z],
            _ => {
                let up = random.direction();
                let along = up.any_orthonormal_vector();
                [along, up.cross(along), up]
            }
        };
        let is_bent = random.below(4) == 0;
        let mut height = 0.0;
        let mut faces: Vec<Face> = Vec::new();
        for _ in 0..2 + random.below(2) {
            let mut ends = || [random.between(-0.6, -0.12), random.between(0.12, 0.6)];
            let (along, across) = (ends(), ends());
            let middle = [random.between(-0.05, 0.05), random.between(-0.05, 0.05)];
            let outline = match random.below(4) {
                _ if is_bent => Outline::Bent(across, random.between(0.3, 1.2)),
                0 => Outline::Disk(middle, random.between(0.2, 0.5)),
                1 => Outline::Angle([along, across]),
                _ => Outline::Rectangle([along, across]),
            };
            let is_round = |outline: &Outline| matches!(outline, Outline::Disk(..) | Outline::Bent(..));
            let below = faces.last().is_some_and(|face| is_round(&face.outline));
            // What is curved has to be some millionths of its size before another.
            let least = if below || is_round(&outline) { 7 } else { 0 };
            height += random.pick(&GAPS[least..]);
            let (is_up, is_two_sided) = (random.below(2) == 0, random.below(2) == 0);
            faces.push(Face { outline, height, is_up, is_two_sided });
        }
        // In any order.
        let turn = random.below(faces.len());
        faces.rotate_left(turn);
        if random.below(2) == 0 {
            faces.reverse();
        }
        Self { origin, frame, faces }
    }

    fn at(&self, [x, y]: [f64; 2], height: f64) -> DVec3 {
        let [along, across, up] = self.frame;
        self.origin + x * along + y * across + height * up
    }

    fn shape(&self, face: &Face) -> Arc<dyn Surface> {
        let [along, across, up] = self.frame;
        let at = |x: f64, y: f64| self.at([x, y], face.height);
        match face.outline {
            Outline::Rectangle([[left, right], [low, high]]) => {
                let [edge, other] = [(right - left) * along, (high - low) * across];
                Arc::new(Parallelogram::new(at(left, low), edge, other).expect("a rectangle"))
            }
            Outline::Angle([[left, right], [low, high]]) => {
                let (x, y) = (0.5 * (left + right), 0.5 * (low + high));
                let corners = [[left, low], [right, low], [right, y], [x, y], [x, high], [left, high]]
                    .map(|[x, y]| at(x, y));
                Arc::new(Polygon::new(corners.to_vec(), Vec::new()).expect("an angle"))
            }
            Outline::Disk([x, y], radius) => {
                Arc::new(Disk::new(at(x, y), up, radius, 0.0, [0.0, TAU]).expect("a disk"))
            }
            Outline::Bent([low, high], angle) => {
                let base = self.at([0.0, low], -RADIUS);
                let radius = RADIUS + face.height;
                let axis = (high - low) * across;
                // From the angle that looks up.
                let whole = Cylinder::new(base, axis, radius, [0.0, TAU]).expect("a cylinder");
                let up = PI * (1.0 + whole.project(base + 0.5 * axis + radius * up).u);
                Arc::new(Cylinder::new(base, axis, radius, [up - angle, up + angle]).expect("a part"))
            }
        }
    }

    /// The point over a place at a height along the normal there, and that normal.
    fn place(&self, is_bent: bool, [x, y]: [f64; 2], height: f64) -> [DVec3; 2] {
        let [along, across, up] = self.frame;
        if !is_bent {
            return [self.at([x, y], height), up];
        }
        let (sin, cos) = (x / RADIUS).sin_cos();
        let normal = sin * along + cos * up;
        [self.origin - RADIUS * up + y * across + (RADIUS + height) * normal, normal]
    }

    fn is_bent(&self) -> bool {
        self.faces.iter().any(|face| matches!(face.outline, Outline::Bent(..)))
    }

    /// The scene of the stack in its room; None where it is refused.
    fn scene(&self) -> Option<Scene> {
        let mut scene = SceneBuilder::new("stack", ["grey"]);
        let grey = scene.material("grey", material(GREY, 0.0));
        for (k, glow) in WALLS.iter().enumerate() {
            let glow = scene.material(format!("wall {k}"), material(0.0, *glow));
            scene.surface(format!("wall {k}"), wall(k), &glow);
        }
        for (k, face) in self.faces.iter().enumerate() {
            let draft = scene.surface(format!("face {k}"), self.shape(face), &grey);
            if !face.is_up {
                draft.flip();
            }
            if face.is_two_sided {
                draft.two_sided();
            }
        }
        scene.build().inspect_err(|error| println!("{error}")).ok()
    }
}

/// An uppermost face: its number, if its front is.
#[derive(Clone, Copy, Debug)]
struct Named(Option<usize>);

/// Height between faces that are read into one plane, or set apart (scene length).
const ONE: f64 = 1e-7;

impl Stack {
    /// Ways to read it: by cells what is bounded by straight lines, as anything else takes them seconds.
    fn methods(&self) -> &'static [GatherMethod] {
        let is_round = |face: &Face| matches!(face.outline, Outline::Disk(..) | Outline::Bent(..));
        let is_straight = !self.faces.iter().any(is_round);
        if is_straight { &[GatherMethod::Cells, GatherMethod::Rays] } else { &[GatherMethod::Rays] }
    }
}

/// A sensor on a stack.
#[derive(Clone, Debug)]
struct Sensor {
    on: Probe,
    /// Over that, in the open.
    above: Probe,
    /// Whether it is tilted against its face: from above it sees that by polynomials that know no edges of covers.
    is_tilted: bool,
    /// Irradiance; None where the stack is bent towards the sensor.
    exact: Option<f64>,
    /// The face that it belongs to, if that is plain.
    face: Option<Named>,
}

impl Stack {
    /// A sensor at a random place on a random side.
    fn sensor(&self, random: &mut Random) -> Option<Sensor> {
        let at = [random.between(-0.5, 0.5), random.between(-0.5, 0.5)];
        let depths = || self.faces.iter().map(|face| face.outline.depth(at));
        if depths().any(|depth| depth.abs() < FROM_EDGES) {
            return None;
        }
        let side = random.pick(&[-1.0, 1.0]);
        let covering = (0..self.faces.len()).filter(|k| self.faces[*k].outline.depth(at) > 0.0);
        let height = |k: &usize| side * self.faces[*k].height;
        let top = covering.clone().max_by(|a, b| height(a).total_cmp(&height(b)))?;
        let height = self.faces[top].height;
        let is_alone = covering.clone().all(|k| k == top || (self.faces[k].height - height).abs() > ONE);
        let is_front = self.faces[top].is_two_sided || self.faces[top].is_up == (side > 0.0);
        let [position, up] = self.place(self.is_bent(), at, height);
        let up = side * up;
        let any = random.unit();
        // Over a bent face more is seen than on it; of faces in one plane it is not plain which is seen.
        let is_level = self.is_bent() || !is_alone;
        let tilt = if is_level { 0.0 } else { random.pick(&[0.0, 0.0, any, 1.3]) };
        let aside = random.direction().reject_from(up).normalize();
        let normal = (tilt.cos() * up + tilt.sin() * aside).normalize();
        let above = position + ABOVE * up;
        let own = if is_front { GREY * over(position, up, up) } else { 0.0 };
        let exact = over(position, normal, up) + 0.5 * (1.0 - up.dot(normal)) * own;
        Some(Sensor {
            on: Probe { position, normal },
            above: Probe { position: above, normal },
            is_tilted: tilt > 0.0,
            exact: (side > 0.0 || !self.is_bent()).then_some(exact),
            face: is_alone.then_some(Named(is_front.then_some(top))),
        })
    }
}

/// Light from the walls above the plane through a point across `up`, at a sensor with the unit normal `n`: by the
/// rule of midpoints over directions that are spread by their cosine.
fn over(x: DVec3, n: DVec3, up: DVec3) -> f64 {
    const ALONG: usize = 96;
    let (first, second) = n.any_orthonormal_pair();
    let place = |k: usize| (k as f64 + 0.5) / ALONG as f64;
    let directions = (0..ALONG * ALONG).map(|k| {
        let (out, (sin, cos)) = (place(k / ALONG).sqrt(), (TAU * place(k % ALONG)).sin_cos());
        out * (cos * first + sin * second) + (1.0 - out * out).sqrt() * n
    });
    let met = directions.filter(|direction| direction.dot(up) > 0.0).map(|direction| {
        let away = |axis: usize| {
            let to = if direction[axis] > 0.0 { HALF[axis] } else { -HALF[axis] };
            (to - x[axis]) / direction[axis]
        };
        let axis = [0, 1, 2].into_iter().min_by(|a, b| away(*a).total_cmp(&away(*b))).expect("three axes");
        WALLS[2 * axis + usize::from(direction[axis] > 0.0)]
    });
    met.sum::<f64>() / (ALONG * ALONG) as f64
}

/// Sensors of a stack, at most.
const SENSORS: usize = 4;

/// Reads sensors on so many random stacks; the numbers of stacks and sensors, and what is off.
fn read(seed: u64, stacks: usize) -> (usize, usize, Vec<String>) {
    let mut random = Random(seed);
    let (mut built, mut count, mut off) = (0, 0, Vec::new());
    for number in 0..stacks {
        let stack = Stack::random(&mut random);
        let sensors: Vec<Sensor> =
            (0..10 * SENSORS).filter_map(|_| stack.sensor(&mut random)).take(SENSORS).collect();
        let Some(scene) = stack.scene() else { continue };
        let middle = scene.middle;
        let solved = solved_of(scene, Options::default());
        let probes: Vec<Probe> = sensors.iter().flat_map(|sensor| [sensor.on, sensor.above]).collect();
        built += 1;
        for by in stack.methods() {
            let reader =
                Reader::by(*by, &solved.outcome.solution, solved.visibility(), ReadMode::Gather, EPS);
            let readings = probe(&reader, &probes, middle, &Work::alone()).expect("all light is gathered");
            for (sensor, readings) in sensors.iter().zip(readings.chunks(2)) {
                count += 1;
                let [on, above] = [&readings[0], &readings[1]].map(|reading| reading.irradiance[0]);
                let name = readings[0].on.as_ref().map(|on| solved.scene.surfaces[on.surface].name.clone());
                let is_near = |right: f64| (on - right).abs() <= SHARE * right;
                let is_face = |face: usize| {
                    let names = [format!("face {face}"), format!("face {face}:back")];
                    name.as_ref().is_some_and(|name| names.contains(name))
                };
                let is_named = sensor.face.is_none_or(|Named(face)| face.map_or(name.is_none(), is_face));
                if !(sensor.is_tilted || is_near(above)) || !sensor.exact.is_none_or(is_near) || !is_named {
                    off.push(format!(
                        "stack {number} {by:?}: {on} for {above}, {:?}, on {name:?} for {:?}\n{:?}\n{:?}",
                        sensor.exact, sensor.face, sensor.on, stack.faces
                    ));
                }
            }
        }
    }
    (built, count, off)
}

fn assert_right(seed: u64, stacks: usize) {
    let (built, count, off) = read(seed, stacks);
    println!("{count} readings on {built} of {stacks} stacks, {} off", off.len());
    off.iter().for_each(|line| println!("{line}"));
    assert!(off.is_empty() && 10 * built > 9 * stacks && count > 4 * stacks, "{} of {count}", off.len());
}

#[test]
fn sensors_on_stacks_belong_to_the_uppermost_face() {
    assert_right(1, 12);
}

#[test]
#[ignore = "takes minutes"]
fn sensors_on_a_thousand_stacks_belong_to_the_uppermost_face() {
    assert_right(2, 1000);
}

/// Exitance of the black walls of a room (W m⁻²).
const EXITANCE: f64 = 100.0;

/// Two black sheets of one side, the second a gap outside the first, in a black room of [`EXITANCE`], with sensors
/// on the back of one and the share of their hemisphere that the room fills.
struct Backs {
    name: &'static str,
    sheets: [Arc<dyn Surface>; 2],
    is_flipped: bool,
    seen: Vec<(Probe, f64)>,
}

/// Angles of sensors about an axis, off the corners of any mesh.
const ANGLES: [f64; 3] = [0.12, 0.35, -0.57];

impl Backs {
    /// Inside a pipe: with z over its diameter to an open end, that fills
    ///
    /// ```text
    /// F = (z² + 1/2) / √(z² + 1) − z .
    /// ```
    fn in_pipe(gap: f64) -> Self {
        let length = 0.9;
        let pipe = |radius: f64| {
            let base = DVec3::new(0.2, 0.1, -0.4);
            Arc::new(Cylinder::new(base, length * DVec3::Z, radius, [0.0, TAU]).expect("a pipe"))
        };
        let end = |z: f64| {
            let z = z / (2.0 * RADIUS);
            (z * z + 0.5) / (z * z + 1.0).sqrt() - z
        };
        let at = |angle: f64| {
            let z = 0.5 + 0.3 * angle;
            let out = DVec3::new(angle.cos(), angle.sin(), 0.0);
            let position = DVec3::new(0.2, 0.1, -0.4 + z) + RADIUS * out;
            (Probe { position, normal: -out }, end(z) + end(length - z))
        };
        let sheets: [Arc<dyn Surface>; 2] = [pipe(RADIUS), pipe(RADIUS + gap)];
        Self { name: "pipe", sheets, is_flipped: false, seen: ANGLES.map(at).to_vec() }
    }

    fn balls(gap: f64, from: f64) -> [Arc<dyn Surface>; 2] {
        [RADIUS, RADIUS + gap].map(|radius| {
            let ball = Sphere::new(DVec3::ZERO, radius, DVec3::Z, [from * radius, radius], [0.0, TAU]);
            let ball: Arc<dyn Surface> = Arc::new(ball.expect("a part of a ball"));
            ball
        })
    }

    /// On a ball, upright or tilted by this angle: half of the hemisphere and of its cosine.
    fn on_bowl(gap: f64, tilt: f64) -> Self {
        let at = |angle: f64| {
            let out = DVec3::new(angle.cos() * angle.sin(), angle.sin().powi(2), angle.cos());
            let aside = out.any_orthonormal_vector();
            let normal = tilt.cos() * out + tilt.sin() * aside;
            (Probe { position: (RADIUS + gap) * out, normal }, 0.5 * (1.0 + tilt.cos()))
        };
        let sheets = Self::balls(gap, -0.3);
        Self { name: "on a bowl", sheets, is_flipped: true, seen: ANGLES.map(at).to_vec() }
    }

    /// In a bowl: a part of a ball fills of all hemispheres within as much as of the ball.
    fn in_bowl(gap: f64) -> Self {
        let from = -0.3;
        let at = |angle: f64| {
            let out = DVec3::new(angle.cos() * angle.sin(), angle.sin().powi(2), angle.cos());
            (Probe { position: RADIUS * out, normal: -out }, 0.5 * (1.0 + from))
        };
        Self {
            name: "in a bowl",
            sheets: Self::balls(gap, from),
            is_flipped: false,
            seen: ANGLES.map(at).to_vec(),
        }
    }

    fn scene(&self) -> Scene {
        let mut scene = SceneBuilder::new("backs", ["grey"]);
        let black = scene.material("black", material(0.0, 0.0));
        let glow = scene.material("glow", material(0.0, EXITANCE));
        for k in 0..6 {
            scene.surface(format!("wall {k}"), wall(k), &glow);
        }
        for (k, sheet) in self.sheets.iter().enumerate() {
            let draft = scene.surface(format!("sheet {k}"), Arc::clone(sheet), &black);
            if self.is_flipped {
                draft.flip();
            }
        }
        scene.build().expect("a room")
    }
}

#[test]
fn sensors_on_the_backs_of_bent_sheets_read_what_is_before_them() {
    // The smaller gap is less than chords of a coarse mesh of the sheet behind rise over it.
    let [wide, narrow] = [1e-4, 3e-6];
    let on_bowl = Backs::on_bowl(wide, 0.6);
    for backs in [Backs::in_pipe(wide), Backs::in_pipe(narrow), Backs::in_bowl(narrow), on_bowl] {
        let scene = backs.scene();
        let middle = scene.middle;
        let solved = solved_of(scene, Options::default());
        let probes: Vec<Probe> = backs.seen.iter().map(|(probe, _)| *probe).collect();
        for by in [GatherMethod::Cells, GatherMethod::Rays] {
            let reader = Reader::by(by, &solved.outcome.solution, solved.visibility(), ReadMode::Gather, EPS);
            let readings = probe(&reader, &probes, middle, &Work::alone()).expect("all light is gathered");
            for (reading, (_, share)) in readings.iter().zip(&backs.seen) {
                let (read, right) = (reading.irradiance[0], share * EXITANCE);
                let at = reading.probe.position;
                assert!(reading.on.is_none(), "{} {by:?}: on a front at {at}", backs.name);
                assert!(
                    (read / right - 1.0).abs() < 0.01,
                    "{} {by:?}: {read} for {right} at {at}",
                    backs.name
                );
            }
        }
    }
}

/// Irradiance in a furnace whose walls reflect a half and emit 1.
const FURNACE: f64 = 2.0;

#[test]
fn mats_in_the_plane_of_a_floor_reflect_in_any_order() {
    let middle = DVec3::new(0.1, -0.2, -HALF.z);
    let mat = |side: f64| {
        Parallelogram::new(middle - 0.5 * side * (DVec3::X + DVec3::Y), side * DVec3::X, side * DVec3::Y)
    };
    // A large mat under a small one.
    let mats = || [1.2, 0.7].map(|side| mat(side).expect("a rectangle"));
    let shapes = || (0..6).map(wall).chain(mats());
    for order in [
        [0, 1, 2, 3, 4, 5, 6, 7],
        [7, 6, 5, 4, 3, 2, 1, 0],
        [6, 0, 1, 2, 3, 4, 5, 7],
        [7, 0, 1, 2, 3, 4, 5, 6],
    ] {
        let mut scene = SceneBuilder::new("mats", ["grey"]);
        let grey = scene.material("grey", material(0.5, 1.0));
        for place in order {
            let shape = shapes().nth(place).expect("eight shapes");
            scene.surface(format!("surface {place}"), shape, &grey);
        }
        let scene = scene.build().expect("a room");
        let (middle_of_scene, solved) = (scene.middle, solved_of(scene, Options::default()));
        let places = [middle, middle + DVec3::new(0.5, 0.0, 0.0), middle + DVec3::new(0.9, 0.0, 0.0)];
        let probes: Vec<Probe> = places
            .iter()
            .flat_map(|place| [(*place, DVec3::Z), (*place + 0.1 * DVec3::Z, -DVec3::Z)])
            .map(|(position, normal)| Probe { position, normal })
            .collect();
        for by in [GatherMethod::Cells, GatherMethod::Rays] {
            let reader = Reader::by(by, &solved.outcome.solution, solved.visibility(), ReadMode::Gather, EPS);
            let readings =
                probe(&reader, &probes, middle_of_scene, &Work::alone()).expect("all light is gathered");
            for (reading, surface) in readings.iter().step_by(2).zip([7, 6, 4]) {
                let on = reading.on.as_ref().expect("a face");
                assert_eq!(solved.scene.surfaces[on.surface].name, format!("surface {surface}"), "{order:?}");
            }
            for reading in &readings {
                let read = reading.irradiance[0];
                assert!(
                    (read / FURNACE - 1.0).abs() < 0.01,
                    "{order:?} {by:?}: {read} at {:?}",
                    reading.probe
                );
            }
        }
    }
}

/// Readings of sensors, upright and tilted, at these y before a sheet or a pane to a sky that they look at, in a room.
fn before(sky: &str, what: &str, heights: &[f64]) -> Vec<f64> {
    let scene = typed(&format!(
        r#"
bands = ["lm"]
{sky}
materials.wall = {{ reflectance = 0.5 }}
materials.glow = {{ reflectance = 0.2, emission = 3000 }}
[[surfaces]]
name = "room"
material = "wall"
box = {{ origin = [-2, -1, -1], size = [4, 4, 3], inward = true }}
[[surfaces]]
name = "faced"
{what}"#
    ));
    let middle = scene.middle;
    let solved = solved_of(scene, Options::default());
    let place = |height: f64| DVec3::new(0.1, height, 0.2);
    let normals = [-DVec3::Y, DVec3::new(0.6, -0.8, 0.0)];
    let at = |height: &f64| normals.map(|normal| Probe { position: place(*height), normal });
    let probes: Vec<Probe> = heights.iter().flat_map(at).collect();
    let by = GatherMethod::Cells;
    let reader = Reader::by(by, &solved.outcome.solution, solved.visibility(), ReadMode::Gather, EPS);
    let readings = probe(&reader, &probes, middle, &Work::alone()).expect("all light is gathered");
    readings.iter().map(|reading| reading.irradiance[0]).collect()
}

#[test]
fn sensors_close_to_what_they_face_read_what_those_farther_off_do() {
    let sheet = "material = \"glow\"\nparallelogram = { origin = [-1, 0, -0.5], edge1 = [0, 0, 1], edge2 = [2, 0, 0] }";
    let pane = "material = \"wall\"\nglass = { panes = 1 }\n\
        parallelogram = { origin = [-1, -1, -0.5], edge1 = [0, 0, 1], edge2 = [2, 0, 0] }";
    let heights = [1e-4, 1e-5, 4e-6, 1.5e-6];
    let sky = "sky = { model = \"overcast\", illuminance = 10000, ground = 0.2 }";
    for (sky, what, level) in [("", sheet, 0.0), (sky, pane, -1.0)] {
        let read = before(sky, what, &heights.map(|height| level + height));
        for pair in read.chunks(2).skip(1) {
            for (near, far) in pair.iter().zip(&read[..2]) {
                assert!(*far > 100.0 && (near / far - 1.0).abs() < 0.01, "{what}: {read:?}");
            }
        }
    }
}
