//! Transport between curved surfaces against closed forms and independent references.

use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::sync::Arc;

use radiosity::elements::{Discretization, Elements, Subdivide};
use radiosity::kernel::{Accuracy, Blocks};
use radiosity::scene::{Material, Place, Scene, SceneSurface};
use radiosity::visibility::{Shadows, Visibility};
use radiosity_geom::shapes::{Cone, Cylinder, Disk, FULL_TURN, Parallelogram, Sphere, SpherePatch};
use radiosity_geom::{DVec3, Flipped, Surface};

fn scene(shapes: Vec<Arc<dyn Surface>>) -> Scene {
    let surface = |(index, shape): (usize, Arc<dyn Surface>)| SceneSurface {
        name: format!("surface {index}"),
        kind: "test",
        shape,
        material: Material { reflectance: vec![0.5], emission: vec![1.0] },
        material_name: Some("white".to_owned()),
        order: None,
        subdivide: None,
        place: Place { origin: "test".into(), line: 1, column: 1, text: String::new(), width: 1 },
    };
    Scene {
        name: "curved".to_owned(),
        title: None,
        bands: vec!["grey".to_owned()],
        surfaces: shapes.into_iter().enumerate().map(surface).collect(),
        camera: None,
        origin: "test".to_owned(),
    }
}

struct Transport {
    elements: Elements,
    blocks: Blocks,
}

impl Transport {
    fn new(shapes: Vec<Arc<dyn Surface>>, order: usize, cells: usize, eps: f64, shadows: Shadows) -> Self {
        let scene = scene(shapes);
        let visibility = Visibility::new(&scene, shadows);
        let how = Discretization { order, subdivide: Subdivide::Uniform(cells) };
        let elements = Elements::new(&scene, &how).expect("all have area");
        let blocks = Blocks::assemble(&elements, &visibility, Accuracy { eps, shadow_eps: 1e-3 }, &|_, _| {});
        Self { elements, blocks }
    }

    fn unoccluded(shapes: Vec<Arc<dyn Surface>>, order: usize, eps: f64) -> Self {
        Self::new(shapes, order, 1, eps, Shadows::Off)
    }

    /// Form factor from element i to element j: √(A_j / A_i) G_ij^00.
    fn factor(&self, i: usize, j: usize) -> f64 {
        let list = self.elements.list();
        let (row, column) = (i.min(j), i.max(j));
        let found = self.blocks.iter().find(|(r, c, _)| (*r, *c) == (row, column));
        found.map_or(0.0, |(_, _, values)| values[0] * (list[j].area / list[i].area).sqrt())
    }

    /// Largest |c − G c|, c the constant 1, relative to √area: the closure of a closed scene.
    fn closure(&self) -> f64 {
        let constant: Vec<f64> = self.elements.list().iter().flat_map(|e| e.constant.clone()).collect();
        let seen = self.blocks.apply(&constant);
        let least = self.elements.list().iter().map(|e| e.area.sqrt()).fold(f64::INFINITY, f64::min);
        constant.iter().zip(&seen).map(|(c, g)| (c - g).abs()).fold(0.0, f64::max) / least
    }
}

fn inside(surface: impl Surface + 'static) -> Arc<dyn Surface> {
    Arc::new(Flipped::new(Box::new(surface)))
}

fn tube(radius: f64, height: f64, angle: [f64; 2]) -> Cylinder {
    Cylinder::new(DVec3::ZERO, height * DVec3::Z, radius, angle).expect("a tube")
}

fn disk(z: f64, up: bool, radius: f64) -> Disk {
    let normal = if up { DVec3::Z } else { -DVec3::Z };
    Disk::new(z * DVec3::Z, normal, radius, 0.0, FULL_TURN).expect("a disk")
}

fn ball(center: DVec3, radius: f64) -> Sphere {
    Sphere::new(center, radius, DVec3::Z, [-radius, radius], FULL_TURN).expect("a ball")
}

#[test]
fn explore() {
    let run = |name: &str, shapes: &dyn Fn() -> Vec<Arc<dyn Surface>>, value: &dyn Fn(&Transport) -> f64| {
        let list = |k: &str, d: &str| {
            std::env::var(k)
                .unwrap_or(d.to_owned())
                .split(',')
                .map(|x| x.parse::<f64>().unwrap())
                .collect::<Vec<_>>()
        };
        for order in list("ORDERS", "0,3") {
            let order = order as usize;
            for eps in list("EPS", "1e-2,1e-4,1e-8,1e-12") {
                let start = std::time::Instant::now();
                let t = Transport::unoccluded(shapes(), order, eps);
                println!(
                    "{name} order {order} eps {eps:e}: error {:.2e} reached {:.1e} unresolved {} samples {:.2e} {:.3}s",
                    value(&t),
                    t.blocks.accuracy_reached,
                    t.blocks.pairs.unresolved,
                    t.blocks.samples as f64,
                    start.elapsed().as_secs_f64()
                );
            }
        }
    };
    let which = std::env::var("WHICH").unwrap_or_default();
    if which.contains('a') {
        run("quarter self", &|| vec![inside(tube(1.0, 1.0, [0.0, FRAC_PI_2]))], &|t| {
            t.factor(0, 0) - 0.06092228186821454
        });
        run(
            "cube sphere",
            &|| SpherePatch::cube(DVec3::ZERO, 1.0).unwrap().into_iter().map(inside).collect(),
            &|t| t.closure(),
        );
    }
    if which.contains('b') {
        run("sphere", &|| vec![inside(ball(DVec3::ZERO, 1.0))], &|t| t.closure());
    }
    if which.contains('c') {
        run(
            "can",
            &|| {
                vec![
                    inside(tube(1.0, 2.0, FULL_TURN)),
                    Arc::new(disk(0.0, true, 1.0)),
                    Arc::new(disk(2.0, false, 1.0)),
                ]
            },
            &|t| t.closure(),
        );
    }
    if which.contains('d') {
        run(
            "cone",
            &|| {
                vec![
                    inside(Cone::new(DVec3::ZERO, DVec3::Z, 1.0, 0.0, FULL_TURN).unwrap()),
                    Arc::new(disk(0.0, true, 1.0)),
                ]
            },
            &|t| {
                println!(
                    "   lid {:.1e} self {:.1e}",
                    t.factor(1, 0) - 1.0,
                    t.factor(0, 0) - (1.0 - 0.5f64.sqrt())
                );
                t.closure()
            },
        );
    }
    if which.contains('e') {
        // Sphere of radius r at distance d from a disk of radius a: F = ½ (1 − 1/√(1 + a²/d²)).
        let exact = 0.5 * (1.0 - 1.0 / (1.0f64 + 1.0 / 4.0).sqrt());
        run(
            "sphere disk",
            &|| vec![Arc::new(ball(DVec3::ZERO, 0.5)), Arc::new(disk(2.0, false, 1.0))],
            &|t| t.factor(0, 1) - exact,
        );
    }
    if which.contains('f') {
        run("concentric", &|| vec![Arc::new(ball(DVec3::ZERO, 1.0)), inside(ball(DVec3::ZERO, 2.0))], &|t| {
            t.factor(1, 0) - 0.25
        });
    }
    if which.contains('g') {
        // plate below a cylinder, width from the crossed strings only for infinite: compare with finest.
        let plate = || -> Arc<dyn Surface> {
            Arc::new(Parallelogram::new(DVec3::new(-1.0, -2.0, 0.0), 2.0 * DVec3::X, 3.0 * DVec3::Y).unwrap())
        };
        run(
            "plate cylinder",
            &|| {
                vec![
                    plate(),
                    Arc::new(
                        Cylinder::new(DVec3::new(0.0, -0.5, 1.0), 0.5 * DVec3::Y, 0.5, FULL_TURN).unwrap(),
                    ),
                ]
            },
            &|t| t.factor(1, 0),
        );
    }
    let _ = (PI, TAU);
}
