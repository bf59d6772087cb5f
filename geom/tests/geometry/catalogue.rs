//! The catalogue of view factors, without a facet.

use crate::scenes::view_factors;
use radiosity_geom::{DVec3, Ray, Rect, Surface};

#[test]
fn every_configuration_can_be_expressed() {
    let cases = view_factors();
    assert_eq!(cases.len(), 45);
    for case in &cases {
        let probe = case.surface1.build().is_none();
        assert_eq!(probe, case.id.starts_with("element_"), "{}", case.id);
        assert!(case.surface2.build().is_some_and(|s| s.area() > 0.0), "{}", case.id);
        assert!(case.occluders.iter().all(|part| part.build().is_some()), "{}", case.id);
    }
}

/// Where surface 2 sees nothing but surface 1, reciprocity makes F12 the ratio of the areas.
#[test]
fn areas_are_in_the_ratio_of_the_view_factor() {
    let whole = [
        "paraboloid_interior_to_opening",
        "cone_interior_to_base",
        "hemisphere_to_base",
        "concentric_spheres_outer_to_inner",
    ];
    let cases: Vec<_> = view_factors()
        .into_iter()
        .filter(|case| whole.iter().any(|name| case.id.starts_with(name)))
        .collect();
    assert_eq!(cases.len(), 8);
    for case in cases {
        let [a1, a2] = [&case.surface1, &case.surface2].map(|part| part.build().unwrap().area());
        assert!((a2 / a1 - case.f12).abs() < 1e-14, "{}: {} instead of {}", case.id, a2 / a1, case.f12);
    }
}

/// The fronts face each other: some segment between them leaves one and reaches the other on its front,
/// unless both are one.
#[test]
fn fronts_face_each_other() {
    for case in view_factors() {
        let (Some(a), Some(b)) = (case.surface1.build(), case.surface2.build()) else { continue };
        let places = |s: &dyn Surface| {
            let grid =
                (0..64).map(|k| Rect::FULL.at(f64::from(k % 8) / 4.0 - 0.9, f64::from(k / 8) / 4.0 - 0.9));
            grid.map(|[u, v]| s.jet(u, v))
                .map(|jet| (jet.position, jet.normal))
                .collect::<Vec<(DVec3, DVec3)>>()
        };
        let sees = |(x, n): &(DVec3, DVec3), (y, m): &(DVec3, DVec3)| {
            let d = *y - *x;
            let free = Ray { range: [1e-9, 1.0 - 1e-9], ..Ray::segment(*x, *y) };
            d.length() > 1e-6
                && d.dot(*n) > 0.0
                && d.dot(*m) < 0.0
                && !a.occludes(&free)
                && !b.occludes(&free)
        };
        let (from, to) = (places(&*a), places(&*b));
        assert!(from.iter().any(|x| to.iter().any(|y| sees(x, y))), "{}", case.id);
    }
}
