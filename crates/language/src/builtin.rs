//! The scenes that live in the binary, so that a first run needs no file.
//!
//! Each is the text of a scene file, most of them a file in `crates/language/scenes/`. Where such a text says
//! `$name`, the value of the parameter `name` goes; the few texts that follow a rule (points of a table, rows
//! of columns) are written by code.

mod teapot;
mod arcs;
mod temple;

use radiosity_scene::{Fault, FaultKind, HeatSetting};
use radiosity_work::wording::{command, words};

/// A scene that lives in the binary.
#[derive(Debug)]
pub struct Builtin {
    /// Name of the scene, which users type instead of a path.
    pub name: &'static str,
    /// Parameters that the scene takes.
    pub parameters: &'static [Parameter],
    text: Text,
}

/// A number that a built-in scene lets be set.
#[derive(Debug)]
pub struct Parameter {
    /// Name of the parameter.
    pub name: &'static str,
    /// Value of the parameter unless it is set.
    pub default: f64,
    /// Least and largest value.
    pub range: [f64; 2],
    /// Whether the parameter is a whole number.
    pub whole: bool,
    /// Meaning of the parameter, with the unit.
    pub meaning: &'static str,
}

/// Source of the text of a scene.
#[derive(Debug)]
enum Text {
    /// One file, or two that make one text, with `$name` where the value of a parameter goes.
    File(&'static str),
    /// A function of the values of the parameters.
    Written(fn(&[f64]) -> String),
}

/// Reflectance of everything that reflects; a room of 0.99 still has a balance that can be computed.
const REFLECTANCE: Parameter = Parameter {
    name: "reflectance",
    default: 0.5,
    range: [0.0, 0.99],
    whole: false,
    meaning: "reflectance of every surface that has one",
};

/// Reflectance of the walls of rooms where other things have their own.
const WALLS: Parameter = Parameter {
    name: "walls",
    default: 0.7,
    range: [0.0, 0.95],
    whole: false,
    meaning: "reflectance of the grey walls, floor and ceiling",
};

/// Every built-in scene, the simplest of each kind first.
pub(super) static ALL: [Builtin; 16] = [
    Builtin {
        name: "cornell-box",
        parameters: &[],
        text: Text::File(include_str!("../scenes/cornell-box.toml")),
    },
    Builtin {
        name: "empty-box",
        parameters: &[REFLECTANCE],
        text: Text::File(include_str!("../scenes/empty-box.toml")),
    },
    Builtin {
        name: "occluder-box",
        parameters: &[
            REFLECTANCE,
            Parameter {
                name: "height",
                default: 0.5,
                range: [0.05, 0.95],
                whole: false,
                meaning: "height of the panel above the floor, metres",
            },
            Parameter {
                name: "side",
                default: 0.4,
                range: [0.01, 0.9],
                whole: false,
                meaning: "side of the panel, metres",
            },
        ],
        text: Text::File(include_str!("../scenes/occluder-box.toml")),
    },
    Builtin {
        name: "two-boxes",
        parameters: &[
            WALLS,
            Parameter {
                name: "boxes",
                default: 0.6,
                range: [0.0, 0.95],
                whole: false,
                meaning: "reflectance of the two boxes",
            },
        ],
        text: Text::File(include_str!("../scenes/two-boxes.toml")),
    },
    Builtin {
        name: "teapot",
        parameters: &[
            Parameter {
                name: "height",
                default: 1.0,
                range: [0.5, 2.0],
                whole: false,
                meaning: "factor on the heights of the pot; 1.3 gives Newell's proportions",
            },
            Parameter {
                name: "pot",
                default: 0.7,
                range: [0.0, 0.95],
                whole: false,
                meaning: "reflectance of the pot",
            },
        ],
        text: Text::Written(|values| teapot::text(values[0], values[1])),
    },
    Builtin {
        name: "temple",
        parameters: &[Parameter {
            name: "bays",
            default: 9.0,
            range: [3.0, 20.0],
            whole: true,
            meaning: "bays of the nave; one column less stands on either side",
        }],
        text: Text::Written(|values| temple::text(values[0] as usize)),
    },
    Builtin {
        name: "furnace-cube",
        parameters: &[REFLECTANCE],
        text: Text::File(include_str!("../scenes/furnace-cube.toml")),
    },
    Builtin {
        name: "furnace-sphere",
        parameters: &[REFLECTANCE],
        text: Text::File(include_str!("../scenes/furnace-sphere.toml")),
    },
    Builtin {
        name: "parallel-squares",
        parameters: &[
            Parameter {
                name: "distance",
                default: 1.0,
                range: [1e-3, 1e3],
                whole: false,
                meaning: "distance of the unit squares, metres",
            },
            REFLECTANCE,
        ],
        text: Text::File(include_str!("../scenes/parallel-squares.toml")),
    },
    Builtin {
        name: "hinge-squares",
        parameters: &[
            Parameter {
                name: "angle",
                default: 90.0,
                range: [1.0, 180.0],
                whole: false,
                meaning: "angle between the unit squares, degrees; 180 is flat",
            },
            REFLECTANCE,
        ],
        text: Text::File(include_str!("../scenes/hinge-squares.toml")),
    },
    Builtin {
        name: "oven",
        parameters: &[
            Parameter {
                name: "heater",
                default: 1400.0,
                range: [300.0, 3000.0],
                whole: false,
                meaning: "temperature of the heating panels, kelvin",
            },
            Parameter {
                name: "slab",
                default: 900.0,
                range: [0.0, 3000.0],
                whole: false,
                meaning: "temperature of the slab, kelvin",
            },
        ],
        text: Text::File(include_str!("../scenes/oven.toml")),
    },
    Builtin {
        name: "blue-panel",
        parameters: &[
            WALLS,
            Parameter {
                name: "height",
                default: 2.1,
                range: [0.5, 2.9],
                whole: false,
                meaning: "height of the panel above the floor, metres",
            },
        ],
        text: Text::File(include_str!("../scenes/blue-panel.toml")),
    },
    Builtin {
        name: "sliding-light",
        parameters: &[WALLS],
        text: Text::File(include_str!("../scenes/sliding-light.toml")),
    },
    Builtin {
        name: "billiard",
        parameters: &[Parameter {
            name: "swing",
            default: 22.0,
            range: [1.0, 35.0],
            whole: false,
            meaning: "how far the lamp swings to either side, degrees",
        }],
        text: Text::File(concat!(
            include_str!("../scenes/billiard-swing.toml"),
            include_str!("../scenes/billiard-room.toml")
        )),
    },
    Builtin {
        name: "billiard-slide",
        parameters: &[Parameter {
            name: "slide",
            default: 0.6,
            range: [0.05, 1.2],
            whole: false,
            meaning: "how far the lamp slides to either side, metres",
        }],
        text: Text::File(concat!(
            include_str!("../scenes/billiard-slide.toml"),
            include_str!("../scenes/billiard-room.toml")
        )),
    },
    Builtin {
        name: "cathedral",
        parameters: &[Parameter {
            name: "bays",
            default: 4.0,
            range: [3.0, 12.0],
            whole: true,
            meaning: "bays of the nave; one column less stands on either side",
        }],
        text: Text::File(include_str!("../scenes/cathedral.toml")),
    },
];

/// The built-in scene called `name`.
pub(super) fn named(name: &str) -> Option<&'static Builtin> {
    ALL.iter().find(|scene| scene.name == name)
}

impl Builtin {
    /// The TOML text with parameters set by name, the last setting of each, the others at their defaults.
    pub(super) fn text(&self, settings: &[(&str, f64)]) -> Result<String, Fault> {
        let mut values: Vec<f64> = self.parameters.iter().map(|parameter| parameter.default).collect();
        for (name, value) in settings {
            let place = self.parameters.iter().position(|parameter| parameter.name == *name);
            let place = place.ok_or_else(|| self.unknown(name))?;
            values[place] = self.parameters[place].checked(*value)?;
        }
        Ok(match self.text {
            Text::File(text) => self.filled(text, &values),
            Text::Written(write) => write(&values),
        })
    }

    /// `text` with every `$name` replaced by its value.
    fn filled(&self, text: &str, values: &[f64]) -> String {
        let replace = |text: String, (parameter, value): (&Parameter, &f64)| {
            text.replace(&format!("${}", parameter.name), &format!("{value:?}"))
        };
        self.parameters.iter().zip(values).fold(text.to_owned(), replace)
    }

    fn unknown(&self, name: &str) -> Fault {
        let known: Vec<String> = self.parameters.iter().map(|parameter| parameter.name.to_owned()).collect();
        let none = words("this scene has no parameters; ") + command("scenes") + " lists those that have";
        let cause = format!("there is no parameter {name:?}");
        let unknown = || Fault::unknown_or(cause, name, known, "parameters of this scene", none);
        HeatSetting::misplaced(name).unwrap_or_else(unknown)
    }
}

impl Parameter {
    fn checked(&self, value: f64) -> Result<f64, Fault> {
        let [least, most] = self.range;
        if self.whole && value.fract() != 0.0 {
            return Err(Fault::not_whole(value));
        }
        match (least..=most).contains(&value) {
            true => Ok(value),
            false => {
                let name = self.name;
                let cause = format!("the parameter {name} is {value}, outside {least} ≤ {name} ≤ {most}");
                Err(Fault::new(FaultKind::OutOfRange, cause, "choose a value in that range"))
            }
        }
    }
}
