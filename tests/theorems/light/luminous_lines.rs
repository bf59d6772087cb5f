//! The light of luminaires that are lines, against closed forms.

use radiosity::scene::Scene;
use radiosity::solve::Options;
use radiosity_geom::DVec3 as V;
use radiosity_test_support::direct::{ACCURACY, in_the_open};
use radiosity_test_support::scenes::typed;
use radiosity_test_support::solved::outcome_of;

/// A line of 2 m along x at 3 m above the middle of a black floor, which sends I₀ cos γ with I₀ = 100, and
/// what else `more` says.
fn line(more: &str) -> Scene {
    let text = format!(
        "bands = [\"lm\"]\n[materials.black]\nreflectance = 0\n[[surfaces]]\nname = \"floor\"\nmaterial = \"black\"\n\
         parallelogram = {{ origin = [-5, -5, 0], edge1 = [10, 0, 0], edge2 = [0, 10, 0] }}\n\
         [[luminaires]]\nposition = [0, 0, 3]\nspot = {{ exponent = 1 }}\nintensity = 100\nextent = [2, 0]\n{more}"
    );
    typed(&text)
}

/// On a plane at the depth h below, aside by y, with q² = h² + y²: E = I₀/l · h² ∫ dx / (q² + x²)², from one
/// end to the other as the point sees them; ∫ dx / (q² + x²)² = x / (2 q² (q² + x²)) + atan (x/q) / (2 q³).
fn exact(h: f64, y: f64, [start, end]: [f64; 2]) -> f64 {
    let q = h.hypot(y);
    let integral = |x: f64| x / (2.0 * q * q * (q * q + x * x)) + (x / q).atan() / (2.0 * q.powi(3));
    100.0 / 2.0 * h * h * (integral(end) - integral(start))
}

#[test]
fn a_line_gives_a_plane_its_closed_form() {
    let scene = line("");
    let places = [
        (0.0, 0.0, 0.01),
        (1.5, 0.7, 0.5),
        (-4.0, 3.0, 1.0),
        (0.2, 0.0, 2.9),
        (0.9, 0.01, 2.999),
        (3.0, 0.0, 2.99),
    ];
    let points = places.map(|(x, y, z)| (V::new(x, y, z), V::Z));
    for (found, (x, y, z)) in
        in_the_open(&scene, &Options::default(), &points, ACCURACY).into_iter().zip(places)
    {
        let exact = exact(3.0 - z, y, [-1.0 - x, 1.0 - x]);
        assert!((found - exact).abs() < 1e-6 * exact, "{x} {y} {z}: {found}, not {exact}");
    }
    // A sensor that looks along the line sees the part before it: E = I₀/l · h ∫ x dx / r⁴ from there to the
    // end.
    let (h, x) = (1.0, 0.4);
    let seen = in_the_open(&scene, &Options::default(), &[(V::new(x, 0.0, 3.0 - h), V::X)], ACCURACY)[0];
    let exact = 50.0 * h * 0.5 * (1.0 / (h * h) - 1.0 / (h * h + 0.6 * 0.6));
    assert!((seen - exact).abs() < 1e-6 * exact, "{seen} {exact}");
}

/// A screen halfway hides what lies beyond its edge; the edges of shadows are as sharp as the line is long.
#[test]
fn a_screen_hides_a_part_of_a_line() {
    let screen = "[[surfaces]]\nname = \"screen\"\nmaterial = \"black\"\ntwo_sided = true\n\
        parallelogram = { origin = [0.2, -1, 1.5], edge1 = [4, 0, 0], edge2 = [0, 2, 0] }\n";
    let scene = line(screen);
    for x in [-2.0, -0.5, 0.0, 0.45, 0.69, 0.71] {
        let found = in_the_open(&scene, &Options::default(), &[(V::new(x, 0.3, 0.01), V::Z)], ACCURACY)[0];
        // From x over the edge at 0.2 to the height of the line.
        let edge = x + (0.2 - x) * 2.99 / 1.49;
        let exact = exact(2.99, 0.3, [-1.0 - x, edge.clamp(-1.0, 1.0) - x]);
        assert!((found - exact).abs() < 1e-5 * exact.max(1e-2), "{x}: {found}, not {exact}");
    }
}

#[test]
fn a_closed_room_absorbs_the_flux_of_a_line() {
    let text = "bands = [\"lm\"]\n[materials.wall]\nreflectance = 0.5\n[[surfaces]]\nname = \"room\"\nmaterial = \"wall\"\n\
        box = { origin = [0, 0, 0], size = [4, 5, 3], inward = true }\n\
        [[luminaires]]\nposition = [2, 2.5, 2.9]\nflux = 1000\npoint = {}\nextent = [0, 1.5]\n";
    let scene = typed(text);
    let options = Options { shadow_eps: 1e-3, ..Options::default() };
    let checks = outcome_of(&scene, &options).checks;
    assert!((checks.energy_in - 1000.0).abs() < 1e-9, "{checks:?}");
    assert!((checks.energy_absorbed + checks.energy_lost - 1000.0).abs() < 1e-6, "{checks:?}");
    assert!(checks.energy_lost.abs() < 5.0, "{checks:?}");
}
