//! Cures of the faults of a scene, in words.

use radiosity_work::wording::{Wording, command, option, set, words};

use crate::{error::Fault, nearest::nearest};

impl Fault {
    /// Advice that mends the fault; none where the message already says so.
    pub fn advice(&self) -> Option<Wording> {
        Some(match self {
            Fault::UnknownParameter { known, .. } if known.is_empty() => {
                words("this scene has no parameters; ") + command("scenes") + " lists those that have"
            }
            Fault::FixedVariable { name } => {
                words("give the scene itself with ")
                    + set("set", format!("{name}=…"))
                    + ", not a solution of it"
            }
            Fault::UnknownPlane { name, known } if known.is_empty() => {
                words(format!("define it: [planes.{name}] with origin, edges and spacing; or type it: "))
                    + set("plane", "\"origin; edge; edge; spacing\"")
            }
            Fault::Unreadable { .. } => {
                words("check the path and its permissions; ")
                    + command("scenes")
                    + " lists scenes that need no file"
            }
            Fault::NeedsRepairs { .. } => {
                words("mend the file, or let repairs be made by leaving out ") + option("strict")
            }
            Fault::NoMaterials => {
                command("view-factors")
                    + " and "
                    + command("check")
                    + " need none; for light write a TOML scene, where each surface has a shape and a material"
            }
            Fault::Bare => {
                command("view-factors")
                    + " and "
                    + command("check")
                    + " need none; for light give them in a file, "
                    + set("materials", "materials.toml")
                    + ", such as [materials.\"*\"] with reflectance = 0.5"
            }
            Fault::NoEmitter => {
                words(
                    "give a material an emission above 0, e.g. emission = 10, and use it on a surface, or add ",
                ) + "[[luminaires]], or a [sky] and a window with opening = true; for a file of another program, in a file for "
                    + option("materials")
                    + "; "
                    + command("heat")
                    + " takes temperatures instead"
            }
            other => return other.plain_advice().map(words),
        })
    }

    /// The advice as the command line words it.
    pub fn cure(&self) -> Option<String> {
        self.advice().map(|advice| advice.to_string())
    }

    /// Advice for faults that no option and no verb mends.
    fn plain_advice(&self) -> Option<String> {
        Some(match self {
            Fault::Shape(_) => return None,
            Fault::Foreign { cure, .. } if cure.is_empty() => return None,
            Fault::Foreign { cure, .. } => cure.clone(),
            Fault::UnknownScene { name, known } => {
                choose(name, known.iter().copied(), "built-in scenes")
                    + "; a scene file is given by its path, ending in .toml or .json"
            }
            Fault::UnknownParameter { name, known } => {
                choose(name, known.iter().copied(), "parameters of this scene")
            }
            Fault::UnknownKey { key, known } => choose(key, known.iter().copied(), "known keys"),
            Fault::NoVariables { name } => format!(
                "define it: [variables] with {name} = 2.5, and write \"={name}\" in place of a number; light groups are set \
                 where light is computed"
            ),
            Fault::UnknownVariable { name, known } if known.is_empty() => {
                format!("define it: [variables] with {name} = 2.5")
            }
            Fault::UnknownVariable { name, known } => {
                choose(name, known.iter().map(String::as_str), "variables of this scene")
            }
            Fault::UnknownSetting { name, variables, groups } => {
                let names = variables.iter().chain(groups.iter()).map(String::as_str);
                let near =
                    nearest(name, names).map(|near| format!("did you mean {near:?}? ")).unwrap_or_default();
                let groups = if groups.is_empty() { "none".to_owned() } else { groups.join(", ") };
                format!("{near}variables of this scene: {}; light groups: {groups}", variables.join(", "))
            }
            Fault::UnknownFunction { name, known } => choose(name, known.iter().copied(), "functions"),
            Fault::UnknownSky { name, known } => choose(name, known.iter().copied(), "models of the sky"),
            Fault::UnknownFace { name, known } => choose(name, known.iter().copied(), "faces of a box"),
            Fault::UnknownPart { name, known } if known.is_empty() => {
                format!("define it: [parts.{name}] with a list of surfaces, [[parts.{name}.surfaces]]")
            }
            Fault::UnknownPart { name, known } => {
                choose(name, known.iter().map(String::as_str), "parts of this scene")
            }
            Fault::UnknownMaterial { name, known } if known.is_empty() => {
                format!("define it: [materials.{name}] with reflectance = 0.5")
            }
            Fault::UnknownMaterial { name, known } => {
                choose(name, known.iter().map(String::as_str), "materials of this scene")
            }
            Fault::UnknownSurface { name, known } => {
                choose(name, known.iter().map(String::as_str), "surfaces of this scene")
            }
            Fault::UnknownInstance { known, .. } if known.is_empty() => {
                "the scene has no instances: name its surfaces, surfaces = [\"lamp\"]".to_owned()
            }
            Fault::UnknownInstance { name, known } => {
                choose(name, known.iter().map(String::as_str), "instances of this scene")
            }
            Fault::UnknownLuminaire { known, .. } if known.is_empty() => {
                "the scene has no luminaires: lamps that are surfaces move by surfaces = [\"lamp\"]"
                    .to_owned()
            }
            Fault::UnknownLuminaire { name, known } => {
                choose(name, known.iter().map(String::as_str), "luminaires of this scene")
            }
            Fault::UnknownCurve { name } => choose(name, ["line", "spline"], "curves"),
            Fault::NoSuchFrame { last, .. } => format!("choose one from 0 to {last}"),
            Fault::MovesInto { other, .. } => format!(
                "lead the path a millionth of its size or more past {other:?}, or start and end it elsewhere"
            ),
            Fault::UnknownGroup { name, known } if known.is_empty() => format!(
                "this scene has no light groups: give surfaces that emit, or their material, group = {name:?}, and \
                 solve it again"
            ),
            Fault::UnknownGroup { name, known } => {
                choose(name, known.iter().map(String::as_str), "light groups of this scene")
            }
            Fault::UnknownPlane { name, known } => {
                choose(name, known.iter().map(String::as_str), "planes of this scene")
            }
            Fault::TooManySensors { least, .. } => {
                format!("choose a larger spacing: {least:.1e} for both edges makes few enough")
            }
            Fault::MissingKey { key } => format!("add `{key} = …`{}", example(key)),
            Fault::WrongCount { expected, .. } => format!("give {expected}"),
            Fault::OutOfRange { range, what, .. } => out_of_range(what, range),
            Fault::PatternRange { value, .. } if *value < 0.0 => {
                "add a constant to the pattern, or choose another one, so that it is nowhere below 0"
                    .to_owned()
            }
            // The largest value, e.g. 1 for white, becomes that of a bright paint, 0.9 at most.
            Fault::PatternRange { value, .. } => format!(
                "scale the pattern down: factor = {:.2}, times the factor that it may have already; white paint has ρ = 0.85 or so",
                (0.9 / value).min(0.9)
            ),
            Fault::BadPicture { cure, .. } => cure.to_string(),
            Fault::UnknownWord { what, name, known } => {
                choose(name, known.iter().copied(), &format!("known words for {what}"))
            }
            Fault::DuplicateName { first: Some(line), .. } => {
                format!("rename this one or the first, which stands on {line}")
            }
            Fault::DuplicateName { first: None, .. } => "rename one of the two".to_owned(),
            Fault::Coincident { other } => format!(
                "remove one of the two, move them apart by a millionth of their size or more, or cut a hole into {other:?} where this one \
                 lies; \
                 for both sides of one surface use two_sided = true"
            ),
            plain => plain_cure(plain).to_owned(),
        })
    }
}

/// Cures that do not depend on what was typed.
fn plain_cure(fault: &Fault) -> &'static str {
    match fault {
        Fault::ParameterRange { .. } => "choose a value in that range",
        Fault::VariableAndGroup { .. } => "rename one of them in the scene",
        Fault::PartCycle { .. } => "take one of these instances out",
        Fault::TooDeep { .. } => "make fewer levels",
        Fault::TooManySurfaces { .. } => "make fewer copies",
        Fault::UnreadableInclude { .. } => "check the path, which starts from the folder of this file",
        Fault::NoIncludes { .. } => "read the scene from its file, such as `radiosity check room.toml`",
        Fault::IncludeCycle { .. } => "take one of these includes out",
        Fault::OtherThan { .. } => "state it in one of the files only, or alike in all",
        Fault::VariableCycle { .. } => "give one of them a number",
        Fault::BadVariableName { .. } => "choose another name, such as width or lamp_2",
        Fault::FormulaSyntax { .. } => {
            "write it such as \"=2 * (width - 0.1)\": numbers, variables, + - * /, parentheses, pi, and \
             sin, cos, tan (of degrees), sqrt, abs, min, max"
        }
        Fault::NoValue { .. } => "change the formula, or the variables in it",
        Fault::Syntax { language: "JSON", .. } => {
            "JSON wants quotes around every key and a comma between items, none after the last"
        }
        Fault::Syntax { .. } => {
            "TOML wants `key = value`, texts in quotes, and lists in brackets with commas"
        }
        Fault::RepeatedKey { .. } | Fault::GroupSetTwice { .. } => "keep one of them",
        Fault::MissingShape => "add one, e.g. quad = { vertices = [[0,0,0],[1,0,0],[1,1,0],[0,1,0]] }",
        Fault::Exclusive { .. } => "leave one of them out",
        Fault::FluxAndEmission { is_patterned: true, .. } => {
            "leave the flux out, and scale the pattern by its `factor`: the mean exitance is the flux over the area"
        }
        Fault::OneSided { .. } => "add two_sided = true to the surface",
        Fault::OtherTransmittance { .. } => {
            "give both materials the same transmittance: a diffuse sheet lets through as much either way"
        }
        Fault::FluxAndEmission { .. } => {
            "leave the flux out, or give the surface a material of the same reflectance without emission"
        }
        Fault::TwoShapes { .. } => "make two surfaces, one for each shape",
        Fault::WrongType { expected, .. } => match *expected {
            "a number" => "write it without quotes, e.g. 0.5",
            "a list" => "write it in brackets, e.g. [0, 0, 1]",
            "a text in quotes" => "write it in quotes, e.g. \"white\"",
            _ => "write a value of that kind",
        },
        Fault::NotFinite { .. } => "write a finite number, e.g. 0.5; nan and inf are none",
        Fault::NotWhole { .. } => "give 0, 1, 2, …",
        Fault::EmptyText => "write at least one letter",
        Fault::NoSuchPoint { .. } => "count the points from 0, the last index is one less than their number",
        Fault::BadCamera { .. } => "move the eye, the target or the up vector",
        Fault::BadPlane { .. } => {
            "give two edges, vectors along two sides of the plane, each with a length and not parallel to the other"
        }
        Fault::NoDistribution => {
            "add point = {} for the same intensity all around, spot = { angle = 40, edge = 5 }, or photometry = \"lamp.ies\""
        }
        Fault::BadExtent { problem: "both sides are 0" | "the file states a point" } => {
            "give two sides, e.g. extent = [1.2, 0.3], of which one may be 0 for a line, or a diameter, e.g. extent = 0.2; or leave \
             the extent out for a point"
        }
        Fault::BadExtent { problem: "there is no photometric file" } => {
            "give its sides, e.g. extent = [1.2, 0.3], or its diameter, e.g. extent = 0.2"
        }
        Fault::BadExtent { problem: "its intensity falls to nothing within half a degree" } => {
            "give the spot an edge of 1 degree or more, or its table an angle at which it is dark; or leave the extent out for a point"
        }
        Fault::BadExtent { .. } => {
            "give the rectangle or the disk across the aim that comes nearest, e.g. extent = [1.2, 0.3] or extent = 0.2, or leave the \
             extent out for a point"
        }
        Fault::SunBelow => "give a direction above the horizon, or leave the sun out",
        Fault::BadOpening { problem: "there is no sky" } => {
            "add [sky] with model = \"overcast\" and illuminance = 10000, or leave `opening` and `glass` out"
        }
        Fault::BadOpening { problem: "it is curved" } => "make it of flat surfaces",
        Fault::BadOpening { problem: "it has two sides" } => "leave two_sided out: its front faces the room",
        Fault::BadOpening { .. } => {
            "leave the flux out, and give it a material without emission: the sky is its light"
        }
        Fault::NoOpening => "give a window opening = true, its front to the room, or leave the sky out",
        Fault::NothingMoves => {
            "say what moves: [[motion]] with surfaces = [\"lamp\"], instances, luminaires or camera = true; or leave frames and \
             motions out"
        }
        Fault::MovesAway { .. } => {
            "keep the path near the scene: beyond four million times its size a shape has too few digits"
        }
        Fault::NoPath => {
            "add translate = { points = [[0, 0, 0], [1, 0, 0]] }, rotate = { center = [0, 0, 2], axis = [0, 0, 1], angles = [0, 90] }, \
             or both"
        }
        Fault::NotRigid => "leave scale out; what moves keeps its size and shape",
        Fault::TimesFall { .. } => "give times of which each is larger than the one before",
        Fault::NoCamera => "add [camera] with eye and target, or leave camera out",
        Fault::MovesTwice { .. } => "take it out of one of the two; a path may turn and translate at once",
        Fault::NoFrames => "leave the frame out, or add frames = 50 and [[motion]] to the scene",
        Fault::NoDirection { what: "axis" } => "give the direction of the axis, e.g. [0, 0, 1]",
        Fault::NoDirection { what: "along" } => "give a direction across the aim, e.g. [1, 0, 0]",
        Fault::NoDirection { what: "north" } => {
            "give a direction that is not along `up`, e.g. [0, 1, 0] where `up` is [0, 0, 1]"
        }
        Fault::NoDirection { what: "up" } => "give the direction to the zenith, e.g. [0, 0, 1]",
        Fault::NoDirection { .. } => "give a direction, e.g. [0, 0, -1], which is down",
        Fault::BadUnit { .. } => "write a short text, e.g. \"lx\" or \"W/m²\"",
        Fault::EmptyScene => "add a [[surfaces]] entry with a name, a material and a shape",
        _ => "",
    }
}

/// Advice on an unknown name: the nearest known name, if one is near, and the list of all.
fn choose<'a>(name: &str, known: impl IntoIterator<Item = &'a str>, what: &str) -> String {
    let known: Vec<&str> = known.into_iter().collect();
    let list = format!("{what}: {}", known.join(", "));
    match nearest(name, known.iter().copied()) {
        Some(near) => format!("did you mean {near:?}? {list}"),
        None => list,
    }
}

/// An example of a missing key.
fn example(key: &str) -> &'static str {
    match key {
        "material" => ", the name of one of [materials.…]",
        "reflectance" => {
            ", a number or one per band, 0 ≤ ρ < 1; 0 is black; or, for heat alone, `emissivity = …`, 0 < ε ≤ 1"
        }
        "eye" | "target" | "position" | "origin" | "edge1" | "edge2" | "center" | "base" | "normal"
        | "axis" | "direction" => ", three numbers in brackets",
        "vertices" => ", a list of points, each three numbers in brackets",
        "edges" => ", two vectors, each three numbers in brackets",
        "image" => {
            " for a picture, `cells = …` for rows of numbers or `polynomial = …` for terms [i, j, c] of u^i v^j"
        }
        "part" => ", the name of one of [parts.…]",
        "count" => ", a number, or up to three in brackets",
        "step" => ", a vector, or one for each number of count",
        "frames" => ", how many frames there are, e.g. 50; it stands above the first header in brackets",
        "points" => {
            ", how far it has moved from where it rests, at least two points, each three numbers in brackets"
        }
        "angles" => ", degrees, at least two numbers in brackets",
        "spacing" => ", a length, or one along each edge",
        "size" => ", three lengths in brackets; or give two corners",
        "curve" => ", four control points, each three numbers in brackets",
        "sun" => ", where the sun is: { elevation = 40, azimuth = 180 }",
        "illuminance" => ", of level ground under the sky, in lx",
        "elevation" | "azimuth" => ", in degrees",
        "model" => ": uniform, overcast or clear",
        "flux" => ", in W or lm, all of it together; or its peak, `intensity = …`, in W/sr or cd",
        "radius" | "radius1" | "radius2" | "major" | "minor" => ", a length",
        "patches" => ", a list of patches, each 16 indices of points, counted from 0",
        "weights" => ", four rows of four numbers above 0",
        _ => "",
    }
}

fn out_of_range(what: &str, range: &str) -> String {
    match what {
        "the reflectance" => {
            "choose a value in that range; a surface that loses nothing (ρ = 1) has no balance in a \
                              closed room, 0.999 comes close"
                .to_owned()
        }
        "the emissivity" => {
            "choose a value in that range; a surface that neither absorbs nor emits has adiabatic = true"
                .to_owned()
        }
        "the temperature" => {
            "write it in kelvin, which are degrees Celsius + 273.15: 20 °C is temperature = 293.15".to_owned()
        }
        "the elevation of the sun" => {
            "choose a value in that range; a sun at or below the horizon sends no light: leave it out".to_owned()
        }
        "the illuminance of the sky" => {
            "give what level ground gets from the sky without the sun, e.g. 10000 lx; at night leave the sky and its \
             openings out"
                .to_owned()
        }
        _ => format!("choose a value with {range}"),
    }
}
