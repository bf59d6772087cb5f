//! Models written as MGF and read again.

use glam::DVec3;
use proptest::prelude::*;
use radiosity_formats::mgf;
use radiosity_formats::model::{Material, Model, Shape, Sides, Surface};
use radiosity_test_support::random::seeded;

use crate::memory::Memory;
use crate::mgf_and_radiance::mgf::ALL;
use crate::promises::parts;

fn again(model: &Model) -> Model {
    let text = mgf::write::write(model).expect("MGF has words for it");
    mgf::read("again.mgf", text.as_bytes(), &Memory::default())
        .unwrap_or_else(|refusal| panic!("{refusal}\n{text}"))
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * (1.0 + a.abs())
}

fn assert_same(model: &Model, other: &Model) {
    assert_eq!(model.bands, other.bands);
    assert_eq!(model.surfaces.len(), other.surfaces.len());
    for (own, other_surface) in model.surfaces.iter().zip(&other.surfaces) {
        assert_eq!((&own.name, own.sides), (&other_surface.name, other_surface.sides));
        assert_eq!(std::mem::discriminant(&own.shape), std::mem::discriminant(&other_surface.shape));
        let (a, b) = (parts(&own.shape), parts(&other_surface.shape));
        assert_eq!(a.2, b.2);
        assert!(
            a.0.iter().zip(&b.0).all(|(p, q)| (*p - *q).length() <= 1e-12 * (1.0 + p.length())),
            "{own:?}"
        );
        assert!(a.1.iter().zip(&b.1).all(|(x, y)| near(*x, *y)), "{own:?}");
        let [material, other_material] = [(model, own), (other, other_surface)]
            .map(|(model, surface)| &model.materials[surface.material.expect("one")]);
        assert_eq!(material.name, other_material.name);
        let values = |material: &Material| [material.reflectance.clone(), material.emission.clone()].concat();
        assert!(
            values(material).iter().zip(values(other_material)).all(|(x, y)| near(*x, y)),
            "{material:?}"
        );
    }
}

#[test]
fn a_room_of_all_entities_is_the_same_again() {
    let model = mgf::read("room.mgf", ALL.as_bytes(), &Memory::default()).expect("it is right");
    assert_same(&model, &again(&model));
}

#[test]
fn names_that_mgf_cannot_write_are_mended_and_stay_unique() {
    let surface = |name: &str| Surface {
        name: name.to_owned(),
        material: None,
        shape: Shape::Sphere { center: DVec3::ZERO, radius: 1.0, inward: false },
        sides: Sides::Front,
        file: None,
        place: None,
    };
    let model = Model {
        title: Some("two\nlines \\".to_owned()),
        bands: vec!["grey".to_owned()],
        surfaces: vec![surface("a b"), surface("a_b"), surface("c\\"), surface("#é")],
        ..Model::default()
    };
    let read = again(&model);
    let names: Vec<&str> = read.surfaces.iter().map(|surface| surface.name.as_str()).collect();
    assert_eq!(names, ["a_b", "a_b-2", "c_", "#é"]);
    assert!(read.surfaces.iter().all(|surface| surface.sides == Sides::Front));
    assert_eq!(read.materials[0].reflectance, [0.0]);
}

#[test]
fn what_mgf_has_no_words_for_is_refused() {
    let mut model = Model { bands: vec!["a".to_owned(), "b".to_owned()], ..Model::default() };
    let refusal = mgf::write::write(&model).expect_err("two bands");
    assert!(refusal.cause.contains("2 bands") && !refusal.cure.is_empty());
    model.bands.pop();
    model.surfaces.push(Surface {
        name: "knot".to_owned(),
        material: None,
        shape: Shape::Torus { center: DVec3::ZERO, axis: DVec3::Z, major: 1.0, minor: 2.0, inward: false },
        sides: Sides::Open,
        file: None,
        place: None,
    });
    let refusal = mgf::write::write(&model).expect_err("a torus that overlaps itself");
    assert!(refusal.cause.contains("knot") && !refusal.cure.is_empty());
}

fn points(count: usize) -> impl Strategy<Value = Vec<DVec3>> {
    prop::collection::vec(prop::array::uniform3(-10.0..10.0f64).prop_map(DVec3::from_array), count)
}

fn shape() -> impl Strategy<Value = Shape> {
    let lengths = prop::array::uniform2(0.1..5.0f64);
    (0..8_u8, points(9), lengths, any::<bool>()).prop_map(|(kind, p, [a, b], inward)| {
        let (small, large) = (a.min(b), a.max(b) + 0.1);
        match kind {
            0 => Shape::Polygon { outline: p[..3].to_vec(), holes: vec![] },
            1 => Shape::Polygon { outline: p[..5].to_vec(), holes: vec![p[5..8].to_vec()] },
            // A square with one corner lifted, somewhere.
            2 => Shape::Quad([
                p[0],
                p[0] + 3.0 * DVec3::X,
                p[0] + DVec3::new(3.0, 3.0, small),
                p[0] + 3.0 * DVec3::Y,
            ]),
            3 => Shape::Disk {
                center: p[0],
                normal: p[1],
                radius: large,
                inner: if inward { 0.0 } else { small },
            },
            4 => Shape::Cylinder { base: p[0], axis: p[1], radius: a, inward },
            5 => Shape::Cone {
                base: p[0],
                axis: p[1],
                radii: [if a > 4.0 { 0.0 } else { large }, small],
                inward,
            },
            6 => Shape::Sphere { center: p[0], radius: a, inward },
            _ => Shape::Torus { center: p[0], axis: p[1], major: large, minor: small, inward },
        }
    })
}

proptest! {
    #![proptest_config(seeded(256, 27))]

    #[test]
    fn any_model_is_the_same_again(
        shapes in prop::collection::vec((shape(), any::<bool>(), any::<bool>()), 1..6),
        colours in prop::array::uniform2(prop::array::uniform3(0.0..1.0f64)),
    ) {
        let name = |k: usize| format!("material {k}").replace(' ', ".");
        let material = |k: usize| Material {
            name: name(k),
            reflectance: colours[k].to_vec(),
            emission: colours[1 - k].map(|band| 1000.0 * band).to_vec(),
        };
        let model = Model {
            bands: ["r", "g", "b"].map(str::to_owned).to_vec(),
            materials: vec![material(0), material(1)],
            surfaces: shapes.into_iter().enumerate().map(|(k, (shape, single, second))| Surface {
                name: format!("s{k}"),
                material: Some(usize::from(second)),
                shape,
                sides: if single { Sides::Front } else { Sides::Both },
                file: None, place: None,
            }).collect(),
            ..Model::default()
        };
        assert_same(&model, &again(&model));
    }
}

#[test]
fn numbers_of_grey_models_are_the_same_to_the_last_digit() {
    let text = "m a =\n rd 0.123456789012345\n ed 626.5\nv a =\n p 0.1 0.2 0.30000000000000004\nsph a 1e-7\n";
    let model = mgf::read("a.mgf", text.as_bytes(), &Memory::default()).expect("it is right");
    assert_eq!(model.materials, again(&model).materials);
    assert_eq!(model.surfaces[0].shape, again(&model).surfaces[0].shape);
}
