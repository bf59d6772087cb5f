//! A floor below a lamp, whose light is known: the inverse square.

/// A lamp of the intensity 100 above the middle of a floor: E = 100 / (1 + x² + y²)^{3/2}.
pub(crate) const BELOW_A_LAMP: &str = r#"
bands = ["lm"]
materials.grey = { reflectance = 0.5 }
[[surfaces]]
name = "floor"
material = "grey"
parallelogram = { origin = [-1, -1, 0], edge1 = [2, 0, 0], edge2 = [0, 2, 0] }
[[luminaires]]
name = "lamp"
position = [0, 0, 1]
point = {}
intensity = 100
group = "lamps"
"#;
