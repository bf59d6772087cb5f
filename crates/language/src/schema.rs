//! The scene format as a JSON schema (draft 2020-12), for editors and other programs.
//!
//! It tells keys, kinds, counts and ranges. What takes a whole scene to find, such as an outline that crosses
//! itself, only reading tells.

mod terms;
mod shapes;
mod motions;
mod patterns;

use radiosity_scene::animation::MOST_FRAMES;
use radiosity_scene::{
    MAX_ORDER, MAX_PARTS,
    ranges::{MAX_COPIES, MAX_PIXELS},
};
use serde_json::{Map, Value, json};

use terms::{
    by_name, exactly, list, of, or, per_band, positive, ranged, reference, table, text, truth, whole, with,
};

/// The dialect of JSON schemas.
const DIALECT: &str = "https://json-schema.org/draft/2020-12/schema";

/// The schema of a scene in TOML or JSON, or of a list of polygons in JSON.
pub fn schema() -> Value {
    let scene = table("A scene, or a list of polygons for view factors", &[], scene_keys());
    let scene = with(scene, "type", json!(["object", "array"]));
    let scene = with(scene, "items", reference("outline"));
    let scene = with(with(scene, "$schema", DIALECT.into()), "title", "A scene of radiosity".into());
    let definitions: Map<String, Value> =
        definitions().into_iter().map(|(name, value)| (name.to_owned(), value)).collect();
    with(scene, "$defs", definitions.into())
}

fn scene_keys() -> Vec<(&'static str, Value)> {
    let file = text("Path of a scene file, from the folder of this one");
    let files = json!({ "type": "array", "items": file });
    let files =
        json!({ "description": "Files whose content belongs to the scene too", "anyOf": [file, files] });
    let bands = with(
        list("name", "Names of the bands; grey, or r, g, b where lists are given", 1),
        "uniqueItems",
        true.into(),
    );
    let unit =
        with(text("Unit of exitance, irradiance and radiosity, as it is printed"), "maxLength", 16.into());
    let variables = json!({
        "description": "Numbers for formulas, by name", "type": "object",
        "additionalProperties": reference("number"), "propertyNames": { "pattern": "^[\\p{L}_][\\p{L}\\p{N}_]*$" },
    });
    vec![
        ("include", files),
        ("title", text("What the scene is, for people")),
        ("bands", bands),
        ("unit", or(json!("W/m²"), unit)),
        ("variables", variables),
        ("camera", reference("camera")),
        ("sky", reference("sky")),
        ("planes", by_name("Planes of sensors by name", "plane")),
        ("materials", by_name("Materials by name", "material")),
        ("parts", by_name("Parts by name, to be put in many places", "part")),
        ("surfaces", list("surface", "The surfaces", 0)),
        ("luminaires", list("luminaire", "Lamps by their intensity in each direction", 0)),
        ("instances", list("instance", "Instances of parts", 0)),
        ("frames", whole(1, MOST_FRAMES, "How many frames there are")),
        ("fps", or(json!(1), ranged(json!({ "minimum": 1e-6, "maximum": 1e6 }), "Frames in a unit of time"))),
        ("motion", list("motion", "What moves, each along a path", 0)),
    ]
}

fn definitions() -> Vec<(&'static str, Value)> {
    let formula = json!({
        "description": "A formula of numbers and variables, such as \"=width/2 - 0.1\"", "type": "string",
        "pattern": "^=",
    });
    let mut all = vec![
        ("formula", formula),
        ("number", ranged(json!({ "minimum": -1e30, "maximum": 1e30 }), "A number or a formula")),
        ("point", exactly(3, "number", "x, y, z")),
        ("vector", exactly(3, "number", "x, y, z")),
        ("camera", camera()),
        ("sky", sky()),
        ("plane", plane()),
        ("material", material()),
        ("pattern", patterns::pattern()),
        ("transform", transform()),
        ("surface", surface()),
        ("luminaire", luminaire()),
        ("part", part()),
        ("instance", instance()),
        ("array", array()),
        ("motion", motions::motion()),
    ];
    all.extend(shapes::parts());
    all.extend(shapes::all());
    all
}

fn camera() -> Value {
    let pixels = |what: &str| or(json!(512), whole(1, MAX_PIXELS, &format!("{what} of the picture, pixels")));
    let fov = json!({ "exclusiveMinimum": 0, "exclusiveMaximum": 180 });
    let keys = vec![
        ("eye", of("point", "Where the camera is")),
        ("target", of("point", "What is in the middle of the picture")),
        ("up", or(json!([0, 0, 1]), of("vector", "What is up in the picture"))),
        ("fov", or(json!(40), ranged(fov, "Angle from the lower to the upper border, degrees"))),
        ("width", pixels("Width")),
        ("height", pixels("Height")),
    ];
    table("A pinhole camera", &["eye", "target"], keys)
}

fn sky() -> Value {
    let models = json!({
        "description": "How bright the sky is where", "type": "string", "enum": ["uniform", "overcast", "clear"],
    });
    let ground = json!({ "minimum": 0, "exclusiveMaximum": 1 });
    let elevation = json!({ "exclusiveMinimum": 0, "maximum": 90 });
    let sun = vec![
        ("elevation", ranged(elevation, "Above the horizon, degrees")),
        ("azimuth", of("number", "From north over east, degrees")),
        ("illuminance", or(json!(0), per_band(at_least_zero(), "Across its beam"))),
    ];
    let keys = vec![
        ("model", models),
        ("illuminance", per_band(at_least_zero(), "Of level ground under the sky, the sun left out")),
        ("ground", or(json!(0.2), ranged(ground, "Reflectance of the ground"))),
        ("up", or(json!([0, 0, 1]), of("vector", "Where the zenith is"))),
        ("north", or(json!([0, 1, 0]), of("vector", "Where north is"))),
        ("sun", table("Where the sun is, and how bright", &["elevation", "azimuth"], sun)),
    ];
    table("The sky behind openings", &["model", "illuminance"], keys)
}

fn glass() -> Value {
    let index = json!({ "minimum": 1, "maximum": 3 });
    let transmittance = json!({ "exclusiveMinimum": 0, "maximum": 1 });
    let keys = vec![
        ("panes", or(json!(1), whole(1, 4, "Panes"))),
        ("index", or(json!(1.52), ranged(index, "Index of refraction"))),
        ("transmittance", ranged(transmittance, "Part of the light along the normal that is let through")),
    ];
    table("Glass in an opening to the sky", &[], keys)
}

fn plane() -> Value {
    let one = positive("A length");
    let two = with(exactly(2, "number", "Along each edge"), "items", one.clone());
    let spacing = json!({
        "description": "Largest distance of sensors, for both edges or along each",
        "anyOf": [one["anyOf"][0], one["anyOf"][1], two],
    });
    let keys = vec![
        ("origin", of("point", "A corner")),
        ("edges", exactly(2, "vector", "Two edges; sensors receive along the first × the second")),
        ("spacing", spacing),
    ];
    table("A plane of sensors", &["origin", "edges", "spacing"], keys)
}

fn material() -> Value {
    let reflectance = json!({ "minimum": 0, "exclusiveMaximum": 1 });
    let transmittance =
        per_band(reflectance.clone(), "Diffuse transmittance τ of two-sided surfaces, ρ + τ < 1");
    let emission =
        patterns::or_pattern(per_band(at_least_zero(), "Exitance of the surface's own light, W/m²"));
    let keys = vec![
        (
            "reflectance",
            patterns::or_pattern(per_band(
                reflectance,
                "Reflectance ρ, for all bands, of each, or as it varies",
            )),
        ),
        ("emission", or(json!(0), emission)),
        ("transmittance", or(json!(0), transmittance)),
        ("emissivity", emissivity()),
        ("group", text("Light group of its surfaces that name none")),
    ];
    let one = json!([{ "required": ["reflectance"] }, { "required": ["emissivity"] }]);
    with(table("A diffuse material", &[], [keys, condition()].concat()), "anyOf", one)
}

fn emissivity() -> Value {
    let range = json!({ "exclusiveMinimum": 0, "maximum": 1 });
    ranged(range, "Emissivity, of all wavelengths together")
}

/// The temperature or the flux of heat, of which one is given at most.
fn condition() -> Vec<(&'static str, Value)> {
    let kelvin = json!({ "minimum": 0, "maximum": 1e6 });
    let flux = json!({ "minimum": -1e30, "maximum": 1e30 });
    vec![
        ("temperature", ranged(kelvin, "Temperature, K")),
        ("heat_flux", ranged(flux, "Heat that it is given and sends out as radiation, W/m²")),
        ("adiabatic", truth("It sends out as much as it receives")),
    ]
}

fn at_least_zero() -> Value {
    json!({ "minimum": 0, "maximum": 1e30 })
}

fn transform() -> Value {
    let keys = vec![
        ("scale", or(json!(1), positive("Factor on all lengths, about the origin"))),
        ("rotate", exactly(4, "number", "Axis x, y, z through the origin, and degrees about it")),
        ("translate", or(json!([0, 0, 0]), of("vector", "Where it is moved at last"))),
    ];
    table("Scales, then turns, then moves", &[], keys)
}

fn surface() -> Value {
    let parts =
        with(exactly(2, "number", "Elements along u and v"), "items", whole(1, MAX_PARTS, "Elements"));
    let mut keys = vec![
        ("name", text("Its name, given once in the scene")),
        ("material", text("The name of its material")),
        ("back_material", text("The name of the material of its back, where it is two-sided")),
        ("group", text("Its light group")),
        (
            "flux",
            per_band(at_least_zero(), "Flux that it emits, W or lm, instead of its material's emission"),
        ),
        ("opening", truth("It sends the light of the sky behind it")),
        ("glass", glass()),
        ("order", whole(0, MAX_ORDER, "Degree of the polynomials")),
        ("subdivide", parts),
        ("two_sided", truth("The back emits and receives as well")),
        ("flip", truth("Turns the front over")),
        ("transform", reference("transform")),
    ];
    keys.extend(condition());
    let shapes: Vec<&str> = shapes::all().into_iter().map(|(key, _)| key).collect();
    keys.extend(shapes.iter().map(|key| (*key, reference(key))));
    let one: Vec<Value> = shapes.iter().map(|key| json!({ "required": [key] })).collect();
    with(table("A surface, with exactly one shape", &[], keys), "oneOf", one.into())
}

fn luminaire() -> Value {
    let angle = json!({ "exclusiveMinimum": 0, "exclusiveMaximum": 360 });
    let edge = json!({ "minimum": 0, "maximum": 179 });
    let exponent = json!({ "minimum": 0, "maximum": 10000 });
    let spot = vec![
        ("angle", ranged(angle, "Angle across the cone, to half the peak, degrees")),
        ("edge", or(json!(0), ranged(edge, "Angle over which the peak falls to nothing, degrees"))),
        ("exponent", ranged(exponent, "Exponent n of the cosine, instead of angle and edge")),
    ];
    let keys = vec![
        ("name", text("Its name, given once in its list")),
        ("position", of("point", "Where it is")),
        ("aim", or(json!([0, 0, -1]), of("vector", "Where it aims"))),
        ("along", of("vector", "The direction of the plane C = 0 of its photometric file")),
        ("extent", extent()),
        ("flux", per_band(at_least_zero(), "All its light, W or lm")),
        (
            "intensity",
            per_band(at_least_zero(), "The peak of its intensity, W/sr or cd, instead of the flux"),
        ),
        ("dimming", or(json!(1), ranged(at_least_zero(), "Factor on its light"))),
        ("group", text("Its light group")),
        ("point", table("The same intensity all around", &[], Vec::new())),
        ("spot", table("A cone of light, or a power of the cosine", &[], spot)),
        ("photometry", text("Path of a photometric file, .ies or .ldt, from the folder of this one")),
    ];
    let one = json!([
        { "required": ["point"] }, { "required": ["spot"] }, { "required": ["photometry"] },
    ]);
    with(table("A lamp by its intensity in each direction", &["position"], keys), "oneOf", one)
}

fn extent() -> Value {
    let diameter = positive("Diameter of a disk");
    let side = ranged(at_least_zero(), "Side along C = 0, then along C = 90; one of 0 makes a line");
    let sides = with(exactly(2, "number", "Sides"), "items", side);
    json!({
        "description": "What its light comes out of, across the aim: a disk, a rectangle, a line, or the opening of its photometric file",
        "anyOf": [diameter["anyOf"][0], diameter["anyOf"][1], sides, { "const": "file" }],
    })
}

fn part() -> Value {
    let keys = vec![
        ("surfaces", list("surface", "Its surfaces", 0)),
        ("luminaires", list("luminaire", "Its luminaires", 0)),
        ("instances", list("instance", "Instances of other parts in it", 0)),
    ];
    table("A group of surfaces and luminaires that instances put somewhere", &[], keys)
}

fn instance() -> Value {
    let keys = vec![
        ("part", text("The name of the part")),
        ("name", text("Its name, given once in its list")),
        ("transform", reference("transform")),
        ("array", reference("array")),
    ];
    table("A part put somewhere", &["part"], keys)
}

fn array() -> Value {
    let count = whole(1, MAX_COPIES, "Copies along a step");
    let counts = json!({ "type": "array", "items": count, "minItems": 1, "maxItems": 3 });
    let steps = json!({ "type": "array", "items": reference("vector"), "minItems": 1, "maxItems": 3 });
    let count = json!({
        "description": "Copies along each step", "anyOf": [count["anyOf"][0], count["anyOf"][1], counts],
    });
    let step = json!({ "description": "From one copy to the next", "anyOf": [reference("vector"), steps] });
    table("Copies in rows", &["count", "step"], vec![("count", count), ("step", step)])
}
