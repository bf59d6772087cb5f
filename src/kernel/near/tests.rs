use super::*;
use crate::elements::basis::{AreaBasis, Frame};
use crate::elements::patch::Direction;
use crate::kernel::{pair, separated};
use radiosity_geom::DVec3;
use std::time::Instant;

fn quad(o: [f64; 3], s: [f64; 3], t: [f64; 3], n: [f64; 3]) -> Patch {
    let [o, s, t, n] = [o, s, t, n].map(DVec3::from_array);
    Patch::Flat { corners: [o, o + s, o + s + t, o + t], normal: n.normalize() }
}
fn facing(corners: [[f64; 3]; 4], toward: [f64; 3]) -> Patch {
    let corners = corners.map(DVec3::from_array);
    let n = (corners[1] - corners[0]).cross(corners[3] - corners[0]).normalize();
    let n = if n.dot(DVec3::from_array(toward) - corners[0]) < 0.0 { -n } else { n };
    Patch::Flat { corners, normal: n }
}
fn basis(p: &Patch, order: usize) -> AreaBasis {
    let [a, b, _, d] = p.corners();
    AreaBasis::new(order, Frame::bounding(&p.polygon(), [b - a, d - a]), std::slice::from_ref(p)).unwrap()
}
fn split(m: &mut Moments, p: &Patch, q: &Patch, degrees: [usize; 2], eps: f64, cost: &mut f64, dry: bool) {
    let longest = |p: &Patch| {
        let [a, b] = p.extents();
        if a >= b { (Direction::Along, a) } else { (Direction::Across, b) }
    };
    let ((dp, ep), (dq, eq)) = (longest(p), longest(q));
    let gap = pair::gap(p, q);
    if gap >= 0.25 * ep.max(eq) {
        let n = separated::counts(p, q, degrees, gap, eps);
        *cost += n.iter().map(|n| *n as f64).product::<f64>();
        if !dry {
            m.tensor(p, q, n, None);
        }
        return;
    }
    if *cost > 3e7 || gap < 1e-12 {
        *cost = 1e99;
        return;
    }
    if ep >= eq {
        p.halves(dp).iter().for_each(|h| split(m, h, q, degrees, eps, cost, dry));
    } else {
        q.halves(dq).iter().for_each(|h| split(m, p, h, degrees, eps, cost, dry));
    }
}
fn cases() -> Vec<(String, Patch, Patch)> {
    let floor = quad([0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]);
    let mut list = Vec::new();
    for d in [0.1, 0.03, 1e-3, 1e-6, 1e-9] {
        list.push((
            format!("parallel {d}"),
            floor.clone(),
            quad([0., 0., d], [1., 0., 0.], [0., 1., 0.], [0., 0., -1.]),
        ));
        if d < 0.1 {
            list.push((
                format!("overlap {d}"),
                floor.clone(),
                quad([0.3, 0.4, d], [1., 0.2, 0.], [-0.1, 1., 0.], [0., 0., -1.]),
            ));
        }
    }
    for d in [0.05, 1e-4, 1e-9] {
        list.push((
            format!("perp {d}"),
            floor.clone(),
            quad([0., -d, d], [1., 0., 0.], [0., 0., 1.], [0., 1., 0.]),
        ));
    }
    list.push((
        "gap json".into(),
        quad([0., 0.1, 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]),
        quad([0.2, 0., 0.05], [1.2, 0., 0.], [0., 0., 0.75], [0., 1., 0.]),
    ));
    list.push((
        "small 1e-3".into(),
        floor.clone(),
        quad([0.4, 0.4, 1e-3], [0.05, 0., 0.], [0., 0.05, 0.], [0., 0., -1.]),
    ));
    let hinge = |deg: f64, d: f64| {
        let (s, c) = (deg.to_radians().sin(), deg.to_radians().cos());
        facing([[0., 0., d], [1., 0., d], [1., c, d + s], [0., c, d + s]], [0.5, 1e-3 + 0.5 * c, -1.0])
    };
    for (deg, d) in [(1.0, 1e-3), (1.0, 0.05), (10.0, 1e-6), (60.0, 1e-6), (150.0, 1e-6)] {
        let q = hinge(deg, d);
        let q = if deg > 90.0 {
            let Patch::Flat { corners, normal } = q else { unreachable!() };
            Patch::Flat { corners, normal: -normal * (-normal).dot(DVec3::Y).signum() }
        } else {
            q
        };
        list.push((format!("hinge {deg} {d}"), floor.clone(), q));
    }
    for d in [0.05, 1e-6] {
        list.push((
            format!("corner {d}"),
            floor.clone(),
            quad([-d, 0., d], [0., -1., 0.], [0., 0., 1.], [1., 0., 0.]),
        ));
    }
    list.push((
        "wide small 1e-3".into(),
        quad([-5., -5., 0.], [10., 0., 0.], [0., 10., 0.], [0., 0., 1.]),
        quad([0.4, 0.4, 1e-3], [0.05, 0., 0.], [0., 0.05, 0.], [0., 0., -1.]),
    ));
    list.push((
        "strip 1e-4".into(),
        floor.clone(),
        quad([0.2, 0.3, 1e-4], [0.8, 0.01, 0.], [0., 0.002, 0.], [0., 0., -1.]),
    ));
    list.push((
        "side strip 1e-4".into(),
        floor.clone(),
        quad([0.2, 0., 1e-4], [0.8, 0.0, 0.], [0., 0., 0.002], [0., 1., 0.]),
    ));
    list.push((
        "cross 1e-3".into(),
        quad([0., 0., 0.], [1., 0., 0.], [0., 0.1, 0.], [0., 0., 1.]),
        quad([0.4, -0.5, 1e-3], [0.1, 0.02, 0.], [0.02, 1., 0.], [0., 0., -1.]),
    ));
    list.push((
        "sharp 1e-3".into(),
        facing([[0., 0., 0.], [1., 0., 0.], [1., 0.02, 0.], [1., 0.02, 0.]], [0., 0., 1.]),
        facing([[0., 0., 1e-3], [1., 0., 0.001], [1., 0.01, 0.02], [1., 0.01, 0.02]], [0., 0., -1.]),
    ));
    list.push((
        "touch edge 1".into(),
        floor.clone(),
        quad([0., 0., 0.], [1., 0., 0.], [0., 0., 1.], [0., 1., 0.]),
    ));
    list.push((
        "touch edge 1000".into(),
        floor.clone(),
        quad([0., 0., 0.], [1., 0., 0.], [0., 0., 1e-3], [0., 1., 0.]),
    ));
    list.push(("touch hinge 1deg".into(), floor.clone(), hinge(1.0, 0.0)));
    list.push((
        "touch vertex".into(),
        floor.clone(),
        quad([0., 0., 0.], [0., -1., 0.], [0., 0., 1.], [1., 0., 0.]),
    ));
    list.push((
        "touch vertex 100".into(),
        floor.clone(),
        quad([0., 0., 0.], [0., -0.01, 0.], [0., 0., 0.01], [1., 0., 0.]),
    ));
    list.push((
        "touch sharp".into(),
        facing([[0., 0., 0.], [1., 0., 0.], [1., 0.0175, 0.], [1., 0.0175, 0.]], [0., 0., 1.]),
        facing([[0., 0., 0.], [1., 0., 0.], [1., 0., 0.0175], [1., 0., 0.0175]], [0.9, 1e-2, 0.]),
    ));
    list.push((
        "triangles 1e-3".into(),
        facing([[0., 0., 0.], [1., 0., 0.], [0.3, 0.9, 0.], [0.3, 0.9, 0.]], [0., 0., 1.]),
        facing([[0.1, 0.2, 1e-3], [1.1, 0., 1e-3], [0.5, 1.1, 1e-3], [0.5, 1.1, 1e-3]], [0., 0., -1.]),
    ));
    list
}

#[test]
#[ignore]
fn table() {
    let filter = std::env::var("CASE").unwrap_or_default();
    let orders: Vec<usize> =
        std::env::var("ORDERS").unwrap_or("4".into()).split(',').map(|x| x.parse().unwrap()).collect();
    for (name, p, q) in cases() {
        if !name.contains(&filter) {
            continue;
        }
        for &order in &orders {
            let (a, b) = (basis(&p, order), basis(&q, order));
            let run = |eps: f64| {
                let t = Instant::now();
                let mut m = Moments::new(&a, &b);
                let plan = Plan::new(&m, &p, &q, eps);
                let tp = t.elapsed();
                plan.integrate(&mut m);
                let leaves = plan.leaves.len();
                let outer: usize = plan
                    .leaves
                    .iter()
                    .map(|l| match l.rule {
                        Rule::Polar(p) => p[0].1 * p[1].1,
                        _ => 0,
                    })
                    .sum();
                let (samples, side) = (m.samples, plan.outer);
                (
                    m.into_block(),
                    samples,
                    plan.cost,
                    leaves,
                    outer,
                    side,
                    tp.as_secs_f64(),
                    t.elapsed().as_secs_f64(),
                )
            };
            let reference = run(1e-14).0;
            let big = reference.iter().fold(0.0f64, |m, x| m.max(x.abs()));
            println!("{name} N={order} G00={:.15} max={big:.4}", reference[0]);
            for eps in std::env::var("EPS")
                .unwrap_or("1e-2,1e-4,1e-8,1e-12".into())
                .split(',')
                .map(|x| x.parse::<f64>().unwrap())
            {
                let (g, samples, cost, leaves, outer, side, tp, tt) = run(eps);
                let err = g.iter().zip(&reference).fold(0.0f64, |m, (x, y)| m.max((x - y).abs())) / big;
                let mut old = 0.0;
                let mut m = Moments::new(&a, &b);
                split(&mut m, &p, &q, [order; 2], eps, &mut old, true);
                let t = Instant::now();
                let mut told = f64::NAN;
                let mut eold = f64::NAN;
                if old < 2e6 {
                    old = 0.0;
                    split(&mut m, &p, &q, [order; 2], eps, &mut old, false);
                    told = t.elapsed().as_secs_f64();
                    eold =
                        m.into_block().iter().zip(&reference).fold(0.0f64, |m, (x, y)| m.max((x - y).abs()))
                            / big;
                }
                println!(
                    "  eps {eps:.0e}: err {err:.1e} samples {samples:.2e} cost {cost:.1e} leaves {leaves} outer {outer} {side:?} plan {:.2}ms total {:.2}ms | split {old:.1e} err {eold:.1e} {:.2}ms",
                    tp * 1e3,
                    tt * 1e3,
                    told * 1e3
                );
            }
        }
    }
}
