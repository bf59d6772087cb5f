//! The formats, by name and by the ending of a file's name.

use std::path::Path;

/// A format that scenes of other programs are in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Materials and Geometry Format, `.mgf`.
    Mgf,
    /// Wavefront OBJ with MTL, `.obj`.
    Obj,
    /// glTF 2.0 or GLB, `.gltf`, `.glb`.
    Gltf,
    /// STL, text or binary, `.stl`.
    Stl,
    /// PLY, text or binary, `.ply`.
    Ply,
    /// Mitsuba 3, `.xml`.
    Mitsuba,
    /// Radiance scene description, `.rad`.
    Rad,
    /// View3D input, `.vs3`.
    Vs3,
}

impl Format {
    /// All formats, in the order of the manual.
    pub const ALL: [Format; 8] = [
        Format::Mgf,
        Format::Obj,
        Format::Gltf,
        Format::Stl,
        Format::Ply,
        Format::Mitsuba,
        Format::Rad,
        Format::Vs3,
    ];

    /// Name of the format on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Format::Mgf => "mgf",
            Format::Obj => "obj",
            Format::Gltf => "gltf",
            Format::Stl => "stl",
            Format::Ply => "ply",
            Format::Mitsuba => "mitsuba",
            Format::Rad => "rad",
            Format::Vs3 => "vs3",
        }
    }

    /// The format that the ending of a file's name tells, in upper or lower case.
    pub fn of(path: &str) -> Option<Format> {
        Some(match ending(path)?.as_str() {
            "glb" => Format::Gltf,
            "xml" => Format::Mitsuba,
            ending => *Format::ALL.iter().find(|format| format.name() == ending)?,
        })
    }

    /// Cure for a file whose ending tells of a format that is none of these.
    pub fn cure_of_others(path: &str) -> Option<&'static str> {
        Some(match ending(path)?.as_str() {
            "ifc" | "ifczip" | "ifcxml" | "rvt" => {
                "export it as .glb or .obj: IfcConvert of IfcOpenShell does, and Blender with Bonsai"
            }
            "dxf" | "dwg" | "step" | "stp" | "iges" | "igs" | "fcstd" => {
                "export its faces as .obj or .stl: FreeCAD does"
            }
            "fbx" | "dae" | "3ds" | "blend" | "skp" | "usd" | "usda" | "usdc" | "usdz" => {
                "export it as .glb or .obj: Blender does"
            }
            _ => return None,
        })
    }
}

/// The ending of a file's name, in lower case.
fn ending(path: &str) -> Option<String> {
    Some(Path::new(path).extension()?.to_string_lossy().to_ascii_lowercase())
}

/// The files of a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Written {
    /// The text of the scene.
    pub text: String,
    /// The text of its materials, where they are a file of their own.
    pub materials: Option<String>,
}
