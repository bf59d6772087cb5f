//! Commands of checks of scenes that are refused.

use super::super::Typed;

pub(super) const ROWS: &[Typed] = &[
    Typed {
        bad: "check lie.ply",
        cured: "check lie.ply --from obj",
        told: &["the file does not begin with 'ply'", "help: name the format that the file has"],
    },
    Typed {
        bad: "check room.ifc",
        cured: "check scene.obj",
        told: &["help: export it as .glb or .obj: IfcConvert of IfcOpenShell does, and Blender with Bonsai"],
    },
    Typed {
        bad: "check room.blend",
        cured: "check scene.obj",
        told: &["help: export it as .glb or .obj: Blender does"],
    },
    Typed {
        bad: "check room.toml --one-sided",
        cured: "check scene.obj --one-sided",
        told: &["is not known for a scene of another program"],
    },
    Typed {
        bad: "check lie.txt --one-sided",
        cured: "check lie.txt --one-sided --from obj",
        told: &[
            "--one-sided: lie.txt is not known for a scene of another program",
            "help: name its format with --from",
        ],
    },
    Typed {
        bad: "check room.toml --one-sided",
        cured: "check room.toml",
        told: &[
            "--one-sided: room.toml is not known for a scene of another program",
            "or leave the option out: a scene of radiosity says this itself",
        ],
    },
    Typed {
        bad: "check scene.ply --materials none.toml",
        cured: "check scene.ply --materials m.toml",
        told: &["none.toml: cannot be read", "help: check the path and its permissions"],
    },
    Typed {
        bad: "check vars.toml --set widht=0.1",
        cured: "check vars.toml --set width=0.1",
        told: &[r#"help: did you mean "width"? variables of this scene: width"#],
    },
    Typed {
        bad: "check room.toml --set width=0.1",
        cured: "check vars.toml --set width=0.1",
        told: &[
            r#"the scene has no variables, yet "width" is set"#,
            "help: define it: [variables] with width = 2.5",
        ],
    },
    Typed {
        bad: "check odd.json",
        cured: "check even.json",
        told: &["help: JSON wants quotes around every key and a comma between items, none after the last"],
    },
    Typed {
        bad: "check twice.json",
        cured: "check even.json",
        told: &[r#"the key "title" stands twice"#, "help: keep one of them"],
    },
    Typed {
        bad: "check circle.toml",
        cured: "check room.toml",
        told: &["help: take one of these includes out"],
    },
    Typed {
        bad: "check both.toml",
        cured: "check alike.toml",
        told: &["of this file are not those of the other files", "or alike in all"],
    },
    Typed {
        bad: "check both.toml",
        cured: "check room.toml",
        told: &["of this file are not those of the other files", "help: state it in one of the files only"],
    },
    Typed {
        bad: "check list.csv",
        cured: "check lists.csv",
        told: &[
            "a row takes four fields parted by commas, name,x,y,z, found 3",
            "help: give four fields parted by commas, name,x,y,z",
        ],
    },
    Typed {
        bad: "check empty.toml",
        cured: "check room.toml",
        told: &[
            "the scene has no surface",
            "help: add a [[surfaces]] entry with a name, a material and a shape",
        ],
    },
    Typed { bad: "check cornell-box --set widht=1", cured: "check cornell-box", told: &["help:"] },
    Typed { bad: "check spun.toml", cured: "check moves.toml", told: &["help:"] },
    Typed {
        bad: "check deep.mgf",
        cured: "check shallow.mgf",
        told: &["names of objects in objects are too long together", "help: end objects by o"],
    },
    Typed {
        bad: "check n0.mgf",
        cured: "check shallow.mgf",
        told: &["files are included in one another more than 32 deep", "help: join some of them"],
    },
    Typed {
        bad: "check page.xml",
        cured: "check scene.xml",
        told: &["the file begins with <html>, not with <scene>", r#"or put it into <scene version="3.0.0">"#],
    },
    Typed {
        bad: "check pointed.toml",
        cured: "check boxed.toml",
        told: &["the file states a point", "help: give two sides, e.g. extent = [1.2, 0.3]"],
    },
    Typed {
        bad: "check oval.toml",
        cured: "check boxed.toml",
        told: &["the opening of the file is an ellipse"],
    },
    Typed {
        bad: "check pict.toml",
        cured: "check room.toml",
        told: &[
            "it is a JPEG, not PNG or OpenEXR",
            "help: convert it, e.g. with ImageMagick: magick wood.jpg wood.png",
        ],
    },
    Typed {
        bad: "check far/outside.toml --inside",
        cured: "check room.toml",
        told: &[
            "is outside the folder of the scene, and is not read",
            "help: put a copy of it into the folder of the scene or below",
        ],
    },
    Typed {
        bad: "check far/inner.toml",
        cured: "check room.toml",
        told: &[
            "which is not shown, as it stands in a file outside the folder of the scene",
            "help: look at that place in the file",
        ],
    },
    Typed {
        bad: "check far/unknown.toml",
        cured: "check far/known.toml",
        told: &["unknown material \"whit\"", "help: correct the name; names are not listed"],
    },
];
