//! Faults of Mitsuba scenes.

use super::super::{Changed, Row};

pub(super) const CHANGED: Changed = Changed {
    scene: "scene.xml",
    changed: "scene.xml",
    arguments: &[],
    files: &[
        (
            "scene.xml",
            r#"<scene version="3.0.0">
<sensor type="perspective"><float name="fov" value="40"/><transform name="to_world"><lookat origin="0, 0, 4" target="0, 0, 0" up="0, 1, 0"/></transform><film type="hdrfilm"><integer name="width" value="80"/><integer name="height" value="60"/></film></sensor>
<bsdf type="diffuse" id="white"><rgb name="reflectance" value="0.5, 0.5, 0.5"/></bsdf>
<shape type="rectangle" id="floor"><ref id="white"/></shape>
<shape type="disk" id="lamp"><transform name="to_world"><translate z="3"/></transform><boolean name="flip_normals" value="true"/><emitter type="area"><rgb name="radiance" value="1, 1, 1"/></emitter></shape>
<!-- more -->
</scene>
"#,
        ),
        (
            "scene.ply",
            r"ply
format ascii 1.0
comment a square
element vertex 4
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
1 1 0
0 1 0
4 0 1 2 3
",
        ),
        (
            "part.xml",
            r#"<scene version="3.0.0"><shape type="sphere"><transform name="to_world"><translate x="9"/></transform></shape></scene>"#,
        ),
    ],
    rows: ROWS,
};

const ROWS: &[Row] = &[
    Row { part: "</scene>\n", bad: "", cured: "</scene>\n", told: &["this is no XML", "help: correct it"] },
    Row {
        part: r#"<scene version="3.0.0">"#,
        bad: r#"<!DOCTYPE scene [<!ENTITY l "white">]><scene version="3.0.0">"#,
        cured: r#"<scene version="3.0.0">"#,
        told: &["the file declares its own entities", "help: write their texts in their places"],
    },
    Row {
        part: r#"<scene version="3.0.0">
"#,
        bad: r#"<html>
<scene version="3.0.0">
"#,
        cured: r#"<scene version="3.0.0">
"#,
        told: &["this is no XML", "help: correct it"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<bsdf type="twosided" id="sheet"/><shape type="sphere"><transform name="to_world"><translate x="9"/></transform><ref id="sheet"/></shape>"#,
        cured: r#"<bsdf type="twosided" id="sheet"><ref id="white"/></bsdf><shape type="sphere"><transform name="to_world"><translate x="9"/></transform><ref id="sheet"/></shape>"#,
        told: &["the bsdf of type 'twosided' has no bsdf in it", "help: write one in it, or a <ref> to one"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><bsdf type="blendbsdf"><float name="weight" value="0.5"/><ref id="white"/></bsdf></shape>"#,
        cured: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><bsdf type="blendbsdf"><float name="weight" value="0.5"/><ref id="white"/><ref id="white"/></bsdf></shape>"#,
        told: &["the blend has one bsdf", "help: write two bsdfs in it"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><bsdf type="twosided" id="a"><ref id="a"/></bsdf></shape>"#,
        cured: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><bsdf type="twosided" id="a"><ref id="white"/></bsdf></shape>"#,
        told: &["bsdfs are in one another more than 16 deep, or in a circle", "help: take some out"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><bsdf type="diffuse"><texture type="checkerboard" name="reflectance" id="t"><ref name="color0" id="t"/></texture></bsdf></shape>"#,
        cured: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><bsdf type="diffuse"><rgb name="reflectance" value="0.3"/></bsdf></shape>"#,
        told: &["textures are in one another more than 16 deep, or in a circle", "help: take some out"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><bsdf type="diffuse"><rgb name="reflectance" value="-0.3"/></bsdf></shape>"#,
        cured: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><bsdf type="diffuse"><rgb name="reflectance" value="0.3"/></bsdf></shape>"#,
        told: &["reflectance is below 0", "help: write 0 or more"],
    },
    Row {
        part: "<!-- more -->",
        bad: r##"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><bsdf type="diffuse"><rgb name="reflectance" value="#12"/></bsdf></shape>"##,
        cured: r##"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><bsdf type="diffuse"><rgb name="reflectance" value="#808080"/></bsdf></shape>"##,
        told: &["'#12' is no colour", "help: write six digits: #rrggbb"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><bsdf type="diffuse"><rgb name="reflectance" value="0.1 0.2"/></bsdf></shape>"#,
        cured: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><bsdf type="diffuse"><rgb name="reflectance" value="0.1 0.2 0.3"/></bsdf></shape>"#,
        told: &["value of <rgb> has 2 numbers", "help: write three numbers"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><bsdf type="diffuse"><rgb name="reflectance"/></bsdf></shape>"#,
        cured: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><bsdf type="diffuse"><rgb name="reflectance" value="0.3"/></bsdf></shape>"#,
        told: &["<rgb> has no value", r#"help: write value="…" in it"#],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><bsdf type="diffuse"><spectrum type="regular" name="reflectance"><string name="values" value="0.1 0.2"/></spectrum></bsdf></shape>"#,
        cured: "",
        told: &[
            "the spectrum has no wavelength_min or no wavelength_max",
            "help: write both as <float>, in nm",
        ],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><bsdf type="diffuse"><spectrum type="irregular" name="reflectance"><string name="wavelengths" value="400 700"/><string name="values" value="0.1"/></spectrum></bsdf></shape>"#,
        cured: "",
        told: &["the spectrum has 2 wavelengths and 1 values", "help: write a value for each wavelength"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><bsdf type="diffuse"><spectrum type="irregular" name="reflectance"><string name="wavelengths" value="400 700"/></spectrum></bsdf></shape>"#,
        cured: "",
        told: &["the spectrum has no values", r#"help: write <string name="values" value="…"/> in it"#],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><bsdf type="diffuse"><spectrum name="reflectance" value="400:0.5, 0.6"/></bsdf></shape>"#,
        cured: "",
        told: &["the spectrum holds '0.6'", "or pairs: 400:0.5, 700:0.6"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><bsdf type="diffuse"><spectrum name="reflectance" value="700:0.5, 400:0.6"/></bsdf></shape>"#,
        cured: "",
        told: &[
            "the spectrum has no values, or its wavelengths do not grow",
            "help: write pairs in the order of their wavelengths",
        ],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><emitter type="area"><texture type="bitmap" name="radiance"/></emitter></shape>"#,
        cured: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><emitter type="area"><rgb name="radiance" value="1"/></emitter></shape>"#,
        told: &[
            "the radiance is of type 'bitmap', whose mean is not known",
            r#"help: write it as <rgb name="radiance" value="…"/>"#,
        ],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<bsdf type="diffuse" id="white"/>"#,
        cured: r#"<bsdf type="diffuse" id="grey"/><shape type="sphere"><transform name="to_world"><translate x="9"/></transform><ref id="grey"/></shape>"#,
        told: &["the id 'white' is given twice, first in line 3", "help: give one of the two another id"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><ref id="whit"/></shape>"#,
        cured: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><ref id="white"/></shape>"#,
        told: &["nothing has the id 'whit'", "help: correct the id"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><ref id="grey"/></shape>"#,
        cured: r#"<bsdf type="diffuse" id="grey"/><shape type="sphere"><transform name="to_world"><translate x="9"/></transform><ref id="grey"/></shape>"#,
        told: &["nothing has the id 'grey'", "or give it to something"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="ply"><transform name="to_world"><translate x="9"/></transform></shape>"#,
        cured: r#"<shape type="ply"><transform name="to_world"><translate x="9"/></transform><string name="filename" value="scene.ply"/></shape>"#,
        told: &["the shape names no file", r#"help: write <string name="filename" value="…"/> in it"#],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="ply"><transform name="to_world"><translate x="9"/></transform><string name="filename" value="none.ply"/></shape>"#,
        cured: r#"<shape type="ply"><transform name="to_world"><translate x="9"/></transform><string name="filename" value="scene.ply"/></shape>"#,
        told: &["the mesh 'none.ply' cannot be read", "help: put it beside the scene"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="ply"><transform name="to_world"><translate x="9"/></transform><string name="filename" value="none.ply"/></shape>"#,
        cured: "",
        told: &["the mesh 'none.ply' cannot be read", "or take the shape out"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<default value="1"/>"#,
        cured: r#"<default name="a" value="1"/>"#,
        told: &["a <default> has no name or no value", r#"help: write <default name="…" value="…"/>"#],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<default name="" value="1"/>"#,
        cured: r#"<default name="a" value="1"/>"#,
        told: &["a parameter has no name", r#"help: write name="…" in <default>"#],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<default name="aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa" value="1"/>"#,
        cured: "",
        told: &["is longer than 100 or its value than 10000 bytes", "help: write the value in its place"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><float name="radius" value="$r"/></shape>"#,
        cured: r#"<default name="r" value="1"/><shape type="sphere"><transform name="to_world"><translate x="9"/></transform><float name="radius" value="$r"/></shape>"#,
        told: &["the parameter $r has no value", r#"help: write <default name="r" value="…"/> above"#],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><float name="radius" value="$r"/></shape>"#,
        cured: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><float name="radius" value="2"/></shape>"#,
        told: &["the parameter $r has no value", "or the value in its place"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="cube"><transform name="to_world"><scale z="0"/><translate x="9"/></transform></shape>"#,
        cured: r#"<shape type="rectangle"><transform name="to_world"><translate x="9"/></transform></shape>"#,
        told: &["the transform makes the cube flat", "help: write it as a rectangle"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="disk"><transform name="to_world"><scale x="2"/><translate x="9"/></transform></shape>"#,
        cured: r#"<shape type="disk"><transform name="to_world"><scale value="2"/><translate x="9"/></transform></shape>"#,
        told: &["the transform makes the disk an ellipse", "help: scale it alike in all directions"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="cylinder"><point name="p1" value="0 0 0"/><transform name="to_world"><translate x="9"/></transform></shape>"#,
        cured: r#"<shape type="cylinder"><point name="p1" value="0 0 1"/><transform name="to_world"><translate x="9"/></transform></shape>"#,
        told: &["the cylinder has no length", "help: part p0 and p1"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="cylinder"><transform name="to_world"><scale x="2"/><translate x="9"/></transform></shape>"#,
        cured: r#"<shape type="cylinder"><transform name="to_world"><scale value="2"/><translate x="9"/></transform></shape>"#,
        told: &[
            "the transform makes the cylinder oblique or not round",
            "help: scale it alike in all directions",
        ],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><scale x="2"/><translate x="9"/></transform></shape>"#,
        cured: r#"<shape type="sphere"><transform name="to_world"><scale value="2"/><translate x="9"/></transform></shape>"#,
        told: &["the transform makes the sphere an ellipsoid", "help: scale it alike in all directions"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><scale x="2"/><translate x="9"/></transform></shape>"#,
        cured: r#"<shape type="ply"><transform name="to_world"><scale x="2"/><translate x="9"/></transform><string name="filename" value="scene.ply"/></shape>"#,
        told: &["the transform makes the sphere an ellipsoid", r#"or write it as a mesh (type="ply")"#],
    },
    Row {
        part: r#"<shape type="rectangle" id="floor"><ref id="white"/></shape>
<shape type="disk" id="lamp"><transform name="to_world"><translate z="3"/></transform><boolean name="flip_normals" value="true"/><emitter type="area"><rgb name="radiance" value="1, 1, 1"/></emitter></shape>
"#,
        bad: "",
        cured: r#"<shape type="rectangle" id="floor"><ref id="white"/></shape>
<shape type="disk" id="lamp"><transform name="to_world"><translate z="3"/></transform><boolean name="flip_normals" value="true"/><emitter type="area"><rgb name="radiance" value="1, 1, 1"/></emitter></shape>
"#,
        told: &["the scene holds no shapes that are known", "help: add shapes"],
    },
    Row {
        part: r#"<lookat origin="0, 0, 4" target="0, 0, 0" up="0, 1, 0"/>"#,
        bad: r#"<scale value="0"/>"#,
        cured: r#"<lookat origin="0, 0, 4" target="0, 0, 0" up="0, 1, 0"/>"#,
        told: &["the transform leaves the camera no direction", "help: write a <lookat> in it"],
    },
    Row {
        part: r#"name="width" value="80""#,
        bad: r#"name="width" value="0.5""#,
        cured: r#"name="width" value="80""#,
        told: &["the width of the film is 0.5", "help: write a whole number from 1 to 65536"],
    },
    Row {
        part: r#"name="fov" value="40""#,
        bad: r#"name="fov" value="180""#,
        cured: r#"name="fov" value="40""#,
        told: &["fov is 180", "help: write an angle above 0 and below 180 degrees"],
    },
    Row {
        part: r#"<float name="fov" value="40"/>"#,
        bad: r#"<float name="fov" value="40"/><string name="fov_axis" value="w"/>"#,
        cured: r#"<float name="fov" value="40"/><string name="fov_axis" value="y"/>"#,
        told: &["fov_axis is 'w'", "help: write x, y, smaller, larger or diagonal"],
    },
    Row {
        part: r#"<float name="fov" value="40"/>"#,
        bad: r#"<string name="focal_length" value="0mm"/>"#,
        cured: r#"<string name="focal_length" value="50mm"/>"#,
        told: &["focal_length is not above 0", "help: write a length in millimetres: 50mm"],
    },
    Row {
        part: r#"value="true""#,
        bad: r#"value="yes""#,
        cured: r#"value="true""#,
        told: &["flip_normals is 'yes'", r#"help: write value="true" or value="false""#],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="instance"><ref id="floor"/></shape>"#,
        cured: r#"<shape type="shapegroup" id="group"><shape type="sphere"><transform name="to_world"><translate x="9"/></transform></shape></shape><shape type="instance"><ref id="group"/></shape>"#,
        told: &[
            "the instance is of something else than a shapegroup",
            r#"help: name a <shape type="shapegroup">"#,
        ],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="shapegroup" id="group"><shape type="instance"><ref id="group"/></shape></shape><shape type="instance"><ref id="group"/></shape>"#,
        cured: r#"<shape type="shapegroup" id="group"><shape type="sphere"><transform name="to_world"><translate x="9"/></transform></shape></shape><shape type="instance"><ref id="group"/></shape>"#,
        told: &[
            "a shapegroup holds an instance or a shapegroup",
            "help: take it out of the group: Mitsuba follows none",
        ],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><ref id="white"/><bsdf type="diffuse"/></shape>"#,
        cured: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform><ref id="white"/></shape>"#,
        told: &["the shape has two of <bsdf>", "help: take one out"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><point name="to_world" value="9"/></shape>"#,
        cured: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform></shape>"#,
        told: &["to_world is a <point>", r#"help: write <transform name="to_world"> with steps in it"#],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><scale value="1e300"/><scale value="1e300"/></transform></shape>"#,
        cured: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform></shape>"#,
        told: &["the transform leads beyond all numbers", "help: write smaller numbers"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><shift x="9"/></transform></shape>"#,
        cured: r#"<shape type="sphere"><transform name="to_world"><translate x="9"/></transform></shape>"#,
        told: &[
            "<shift> is no step of a transform",
            "help: write translate, rotate, scale, lookat or matrix",
        ],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><rotate x="1" angle="1 2"/><translate x="9"/></transform></shape>"#,
        cured: r#"<shape type="sphere"><transform name="to_world"><rotate x="1" angle="90"/><translate x="9"/></transform></shape>"#,
        told: &["the angle is not one number", r#"help: write angle="90", in degrees"#],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><rotate angle="90"/><translate x="9"/></transform></shape>"#,
        cured: r#"<shape type="sphere"><transform name="to_world"><rotate x="1" angle="90"/><translate x="9"/></transform></shape>"#,
        told: &["the axis of the rotation is 0", r#"help: write an axis: x="1""#],
    },
    Row {
        part: r#"target="0, 0, 0""#,
        bad: r#"target="0, 0, 4""#,
        cured: r#"target="0, 0, 0""#,
        told: &["the view has no direction", "help: put target elsewhere than origin"],
    },
    Row {
        part: r#" up="0, 1, 0""#,
        bad: r#" up="0, 0, 1""#,
        cured: "",
        told: &["the view looks along its up", "or leave it out"],
    },
    Row {
        part: r#" up="0, 1, 0""#,
        bad: r#" up="0, 0, 1""#,
        cured: r#" up="1, 0, 0""#,
        told: &["the view looks along its up", "help: write another up"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><matrix value="1 0 0"/><translate x="9"/></transform></shape>"#,
        cured: r#"<shape type="sphere"><transform name="to_world"><matrix value="1 0 0 0 1 0 0 0 1"/><translate x="9"/></transform></shape>"#,
        told: &["a matrix has 3 numbers", "help: write 9 or 16, row after row"],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<shape type="sphere"><transform name="to_world"><matrix value="1 0 0 9 0 1 0 0 0 0 1 0 1 0 0 1"/></transform></shape>"#,
        cured: r#"<shape type="sphere"><transform name="to_world"><matrix value="1 0 0 9 0 1 0 0 0 0 1 0 0 0 0 1"/></transform></shape>"#,
        told: &[
            "the matrix is a perspective: its last row is not 0 0 0 1",
            "help: write a matrix of rotations, scales and translations",
        ],
    },
    Row {
        part: "<!-- more -->",
        bad: "<path/>",
        cured: r#"<path value="."/>"#,
        told: &["a <path> has no value", r#"help: write <path value="…"/>"#],
    },
    Row {
        part: "<!-- more -->",
        bad: "<include/>",
        cured: r#"<include filename="part.xml"/>"#,
        told: &["an <include> names no file", r#"help: write filename="…" in it"#],
    },
    Row {
        part: "<!-- more -->",
        bad: r#"<include filename="none.xml"/>"#,
        cured: r#"<include filename="part.xml"/>"#,
        told: &["the included file 'none.xml' cannot be read", "help: put it beside the scene"],
    },
];
