//! Constructs of files that scenes of radiosity have not: each is named in a note, and a file without it draws none.

use radiosity_formats::format::Format;
use radiosity_formats::read::read;

use crate::measures::notes;
use crate::memory::Memory;

/// A right text of a format, a part of it and the part with something that is left out, and the note on that.
struct LeftOut {
    format: Format,
    text: &'static str,
    part: &'static str,
    more: &'static str,
    note: &'static str,
}

const PLY: &str = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\n\
                   property float ny\nproperty float nz\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
                   0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n";

const OBJ: &str = "mtllib a.mtl\nusemtl a\ns off\nusemap off\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn 0 0 2\nf 1//1 2/9/2 3//-1\n";

/// A flat plate of two smooth faces, whose parts are not merged.
const PLATE: &str = "s 1\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\no a\nf 1 2 3\no b\nf 1 3 4\n";

const GLTF: &str = r#"{"asset": {"version": "2.0"}, "extensionsUsed": ["KHR_texture_transform"], "scenes": [{"nodes": [0]}],
"nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}, "material": 0}]}],
"materials": [{"pbrMetallicRoughness": {"metallicFactor": 0}}], "skins": [{"joints": [0]}],
"accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
{"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3"}],
"bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 36}],
"buffers": [{"byteLength": 72, "uri": "triangle.bin"}]}"#;

const MITSUBA: &str = "<scene version=\"3.0.0\"><medium type=\"homogeneous\" id=\"fog\"/><bsdf type=\"diffuse\" id=\"b\"/>\
                       <shape type=\"disk\"><ref id=\"b\"/></shape></scene>";

const FAULTY: &str = "faulty colours and materials that no surface has are left out";

const MGF: &str = "v a =\n n 0 0 2\nv b =\n p 1 0 0\nv c =\n p 0 1 0\nc grey =\nm w =\n rd .5\nf a b c\n";

const RAD: &str = "void glow g 0 0 4 1 1 1 0\nvoid plastic w 0 0 5 .5 .5 .5 0 0\nw sphere s 0 0 4 0 0 0 1\n\
                   g sphere lamp 0 0 4 5 0 0 1\n";

const VS3: &str = "F 3\nV 1 0 0 0\nV 2 1 0 0\nV 3 0 1 0\nS 1 1 2 3 0 0 0 0.9 a\nE\n";

const STL: &str = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n";

/// A scene with a mesh whose faces stand for themselves.
const MESHED: &str = "<scene version=\"3.0.0\"><shape type=\"obj\"><string name=\"filename\" value=\"bent.obj\"/>\
                      <boolean name=\"face_normals\" value=\"true\"/></shape></scene>";

const ROUNDED: &str = "normals of vertices are left out: faces are flat";
const OPPOSED: &str = "normals of vertices that point to the back of their face are left out: the order of corners tells the front";
const SMOOTHED: &str = "smoothing groups are left out: faces are flat";
const SPECULAR: &str = "specular reflection is left out";
const TRANSPARENCY: &str = "transparency is left out";

const LEFT_OUT: &[LeftOut] = &[
    LeftOut { format: Format::Ply, text: PLY, part: "0 0 0 0 0 1", more: "0 0 0 0 1 1", note: ROUNDED },
    LeftOut {
        format: Format::Ply,
        text: PLY,
        part: "property float nx\nproperty float ny\n",
        more: "property float s\nproperty float t\n",
        note: "texture coordinates are left out, and what textures they are of",
    },
    LeftOut {
        format: Format::Ply,
        text: PLY,
        part: "property float nx\n",
        more: "property float red\n",
        note: "colours are left out",
    },
    LeftOut { format: Format::Obj, text: OBJ, part: "vn 0 0 2", more: "vn 0 1 2", note: ROUNDED },
    LeftOut {
        format: Format::Obj,
        text: OBJ,
        part: "vn 0 0 1\nvn 0 0 2",
        more: "vn 0 0 -1\nvn 0 0 -2",
        note: OPPOSED,
    },
    LeftOut { format: Format::Obj, text: PLATE, part: "v 0 1 0", more: "v 0 1 1", note: SMOOTHED },
    LeftOut { format: Format::Obj, text: PLATE, part: "v 0 1 0", more: "v 0 1 1\nvn 0 0 1", note: SMOOTHED },
    LeftOut { format: Format::Obj, text: OBJ, part: "a.mtl", more: "filter.mtl", note: TRANSPARENCY },
    LeftOut { format: Format::Obj, text: OBJ, part: "a.mtl", more: "spectral.mtl", note: TRANSPARENCY },
    LeftOut { format: Format::Obj, text: OBJ, part: "a.mtl", more: "xyz.mtl", note: TRANSPARENCY },
    LeftOut { format: Format::Obj, text: OBJ, part: "a.mtl", more: "shiny.mtl", note: SPECULAR },
    LeftOut { format: Format::Obj, text: OBJ, part: "a.mtl", more: "glass.mtl", note: TRANSPARENCY },
    LeftOut { format: Format::Obj, text: OBJ, part: "a.mtl", more: "mirror.mtl", note: SPECULAR },
    LeftOut { format: Format::Obj, text: OBJ, part: "a.mtl", more: "rough.mtl", note: SPECULAR },
    LeftOut { format: Format::Obj, text: OBJ, part: "a.mtl", more: "brushed.mtl", note: SPECULAR },
    LeftOut {
        format: Format::Ply,
        text: PLY,
        part: "property float nx\n",
        more: "property float material_index\n",
        note: "materials by number are left out",
    },
    LeftOut {
        format: Format::Ply,
        text: PLY,
        part: "element vertex",
        more: "comment TextureFile wood.png\nelement vertex",
        note: "textures are left out",
    },
    LeftOut {
        format: Format::Obj,
        text: OBJ,
        part: "usemap off",
        more: "usemap wood",
        note: "textures are left out",
    },
    LeftOut {
        format: Format::Obj,
        text: OBJ,
        part: "s off",
        more: "shadow_obj a.obj",
        note: "objects for shadows and reflections are left out",
    },
    LeftOut { format: Format::Obj, text: OBJ, part: "s off", more: "p 1", note: "points are left out" },
    LeftOut { format: Format::Obj, text: OBJ, part: "s off", more: "l 1 2", note: "lines are left out" },
    LeftOut {
        format: Format::Obj,
        text: OBJ,
        part: "s off",
        more: "call a.obj",
        note: "calls of other files and commands are left out",
    },
    LeftOut {
        format: Format::Obj,
        text: OBJ,
        part: "a.mtl",
        more: "b.mtl",
        note: "the material 'unused', which no face has, is left out: one of its colours cannot be followed",
    },
    LeftOut {
        format: Format::Obj,
        text: OBJ,
        part: "a.mtl",
        more: "c.mtl",
        note: "specular reflection is left out",
    },
    LeftOut {
        format: Format::Gltf,
        text: GLTF,
        part: "KHR_texture_transform",
        more: "KHR_materials_unlit",
        note: "the extension KHR_materials_unlit is left out",
    },
    LeftOut {
        format: Format::Gltf,
        text: GLTF,
        part: "\"metallicFactor\": 0}",
        more: "\"metallicFactor\": 1}, \"extensions\": {\"KHR_materials_specular\": {}, \"KHR_materials_ior\": {\"ior\": 1.4}}",
        note: SPECULAR,
    },
    LeftOut {
        format: Format::Gltf,
        text: GLTF,
        part: "{\"mesh\": 0}",
        more: "{\"mesh\": 0, \"extensions\": {\"EXT_lights_ies\": {\"light\": 0}}}",
        note: "the extension EXT_lights_ies is left out",
    },
    LeftOut {
        format: Format::Gltf,
        text: GLTF,
        part: "[{\"nodes\": [0]}]",
        more: "[{\"nodes\": [0]}, {\"nodes\": []}]",
        note: "scenes of the file other than one are left out",
    },
    LeftOut { format: Format::Gltf, text: GLTF, part: "\"NORMAL\": 1", more: "\"NORMAL\": 0", note: ROUNDED },
    LeftOut {
        format: Format::Gltf,
        text: GLTF,
        part: "{\"mesh\": 0}",
        more: "{\"mesh\": 0, \"skin\": 0}",
        note: "skins are left out: meshes stand as they were modelled",
    },
    LeftOut {
        format: Format::Gltf,
        text: GLTF,
        part: "\"skins\"",
        more: "\"animations\": [{}], \"skins\"",
        note: "animations are left out",
    },
    LeftOut {
        format: Format::Gltf,
        text: GLTF,
        part: "\"material\": 0}",
        more: "\"material\": 0, \"targets\": []}",
        note: "morph targets are left out",
    },
    LeftOut {
        format: Format::Mitsuba,
        text: MITSUBA,
        part: "<ref id=\"b\"/>",
        more: "<ref id=\"b\"/><ref name=\"interior\" id=\"fog\"/>",
        note: "'interior' of <shape type=\"disk\"> is left out",
    },
    LeftOut {
        format: Format::Mitsuba,
        text: MITSUBA,
        part: "<ref id=\"b\"/>",
        more: "<ref id=\"b\"/><medium type=\"homogeneous\" name=\"interior\"/>",
        note: "'interior' of <shape type=\"disk\"> is left out",
    },
    LeftOut {
        format: Format::Mitsuba,
        text: MITSUBA,
        part: "<shape",
        more: "<sensor type=\"perspective\"><ref id=\"fog\"/></sensor><shape",
        note: "the medium around the camera is left out",
    },
    LeftOut {
        format: Format::Mitsuba,
        text: MESHED,
        part: "true",
        more: "false",
        note: "of meshes: smoothing groups are left out: faces are flat",
    },
    LeftOut {
        format: Format::Mgf,
        text: MGF,
        part: "c grey =\n",
        more: "c grey =\n cxy .9 .9\nc\n",
        note: FAULTY,
    },
    LeftOut {
        format: Format::Mgf,
        text: MGF,
        part: "c grey =\n",
        more: "c grey =\n cxy .9 .9\nc mixed =\n cmix 1 grey 1 grey\nm dull =\n rd .5\nc\n",
        note: FAULTY,
    },
    LeftOut { format: Format::Mgf, text: MGF, part: "m w =\n", more: "m u =\n rd -1\nm w =\n", note: FAULTY },
    LeftOut { format: Format::Mgf, text: MGF, part: "n 0 0 2", more: "n 0 1 2", note: ROUNDED },
    LeftOut {
        format: Format::Mgf,
        text: MGF,
        part: " rd .5\n",
        more: " rd .5\n td .2\n",
        note: "diffuse transmission is left out",
    },
    LeftOut {
        format: Format::Mgf,
        text: MGF,
        part: "f a b c\n",
        more: "f a b c\nies lamp.ies\n",
        note: "luminaires with measured light (ies) are left out",
    },
    LeftOut {
        format: Format::Rad,
        text: RAD,
        part: "w sphere",
        more: "void source sun 0 0 4 0 0 1 1\nw sphere",
        note: "light from afar (source) is left out",
    },
    LeftOut {
        format: Format::Rad,
        text: RAD,
        part: "1 1 1 0\n",
        more: "1 1 1 5\n",
        note: "the limit of how far glow shines (maxrad) is left out: it lights all that it faces",
    },
    LeftOut {
        format: Format::Rad,
        text: RAD,
        part: "w sphere",
        more: "void mist m 0 0 0\nm sphere t 0 0 4 9 0 0 1\nw sphere",
        note: "mist is left out",
    },
    LeftOut {
        format: Format::Vs3,
        text: VS3,
        part: "F 3\n",
        more: "F 3\nI 1\n",
        note: "lines that begin with I are left out",
    },
    LeftOut {
        format: Format::Vs3,
        text: VS3,
        part: "F 3\n",
        more: "C encl=1\nF 3\n",
        note: "encl=1, which adjusts view factors to an enclosure, is left out",
    },
    LeftOut {
        format: Format::Stl,
        text: STL,
        part: "normal 0 0 1",
        more: "normal 0 0 -1",
        note: "normals that contradict the order of corners are left out",
    },
];

/// The notes of a text, each of which stands for one thing.
fn noted(format: Format, text: &str) -> Vec<String> {
    let numbers =
        |rows: [[f32; 3]; 3]| rows.into_iter().flatten().flat_map(f32::to_le_bytes).collect::<Vec<u8>>();
    let corners = numbers([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    let normals = numbers([[0.0, 0.0, 1.0]; 3]);
    let unused = "newmtl a\nKd .5\nnewmtl unused\nKd 1 1 -1\n";
    let files = Memory::of([
        ("triangle.bin", [corners, normals].concat()),
        (
            "a.mtl",
            b"newmtl a\nKd .5\nKs 0 0 0\nillum 3\nTf 1 1 1\nPc 0\nPcr .03\naniso 0\nanisor 1\n".to_vec(),
        ),
        ("filter.mtl", b"newmtl a\nKd .5\nTf .5 .5 .5\n".to_vec()),
        ("spectral.mtl", b"newmtl a\nKd .5\nTf spectral glass.rfl\n".to_vec()),
        ("xyz.mtl", b"newmtl a\nKd .5\nTf xyz .5 .6 .5\n".to_vec()),
        ("shiny.mtl", b"newmtl a\nKd .5\nKs spectral tin.rfl\nillum 2\n".to_vec()),
        ("glass.mtl", b"newmtl a\nKd .5\nillum 7\n".to_vec()),
        ("mirror.mtl", b"newmtl a\nKd .5\nillum 3\n".to_vec()),
        ("rough.mtl", b"newmtl a\nKd .5\nPcr .03\n".to_vec()),
        ("brushed.mtl", b"newmtl a\nKd .5\naniso .5\n".to_vec()),
        ("bent.obj", PLATE.replace("v 0 1 0", "v 0 1 1").into_bytes()),
        ("b.mtl", unused.as_bytes().to_vec()),
        ("c.mtl", b"newmtl a\nKd .5\nPc 1\n".to_vec()),
    ]);
    let model =
        read(format, "a", text.as_bytes(), &files).unwrap_or_else(|refusal| panic!("{refusal}\n{text}"));
    assert!(model.notes.iter().all(|note| note.count == 1), "{:?}", model.notes);
    notes(&model).into_iter().map(str::to_owned).collect()
}

#[test]
fn what_is_left_out_is_named() {
    for LeftOut { format, text, part, more, note } in LEFT_OUT {
        assert_eq!(noted(*format, text), [""; 0], "{text}");
        assert!(text.contains(part), "{part:?} is not in\n{text}");
        assert_eq!(noted(*format, &text.replacen(part, more, 1)), [*note], "{more}");
    }
}

/// A colour that is none counts where it is used.
#[test]
fn colours_that_are_none_are_refused_where_they_are_used() {
    let files = Memory::of([("b.mtl", &b"newmtl a\nKd 1 1 -1\n"[..])]);
    let refusal = read(Format::Obj, "a.obj", OBJ.replace("a.mtl", "b.mtl").as_bytes(), &files);
    assert!(refusal.is_err_and(|refusal| refusal.to_string() == "b.mtl:2: Kd is -1, below 0"));
    let used = MGF.replace("c grey =\n", "c grey =\n cxy .9 .9\n");
    let refusal = read(Format::Mgf, "a.mgf", used.as_bytes(), &files);
    assert!(refusal.is_err_and(|refusal| refusal.to_string().starts_with("a.mgf:8: no colour has")));
    let mixed = MGF.replace("c grey =\n", "c grey =\n cxy .9 .9\nc mixed =\n cmix 1 grey\n");
    let refusal = read(Format::Mgf, "a.mgf", mixed.as_bytes(), &files);
    assert!(refusal.is_err_and(|refusal| refusal.to_string().starts_with("a.mgf:8: no colour has")));
    let dark = MGF.replace(" rd .5", " rd -1");
    let refusal = read(Format::Mgf, "a.mgf", dark.as_bytes(), &files);
    assert!(refusal.is_err_and(|refusal| refusal.to_string() == "a.mgf:9: rd is -1, below 0"));
}

/// Notes name the file in which their lines are, and so do surfaces.
#[test]
fn notes_have_the_file_of_their_line() {
    let scenes = [
        (Format::Mgf, "i b.mgf\nies lamp.ies\n", "b.mgf", format!("{MGF}rs .5 0\nf a b c\n")),
        (
            Format::Rad,
            "!xform b.rad\nvoid source sun 0 0 4 0 0 1 1\n",
            "b.rad",
            format!("{RAD}void mist m 0 0 0\nm sphere t 0 0 4 9 0 0 1\n"),
        ),
        (
            Format::Mitsuba,
            "<scene version=\"3.0.0\"><include filename=\"b.xml\"/><thing/></scene>",
            "b.xml",
            "<shape type=\"disk\" odd=\"1\"/>".to_owned(),
        ),
    ];
    for (format, text, name, included) in scenes {
        let model = read(format, "a", text.as_bytes(), &Memory::of([(name, included.into_bytes())]));
        let model = model.unwrap_or_else(|refusal| panic!("{refusal}"));
        let files: Vec<Option<&str>> = model.notes.iter().map(|note| note.file.as_deref()).collect();
        assert!(files.len() == 2 && files.contains(&Some(name)), "{:?}", model.notes);
        assert!(files.iter().any(|file| file.is_none_or(|file| file == "a")), "{:?}", model.notes);
        assert_eq!(model.surfaces[0].file.as_deref(), Some(name));
    }
}

/// Statements that add nothing, and materials that no surface has, leave nothing out.
#[test]
fn what_adds_nothing_is_not_named() {
    let files = Memory::of([
        ("a.mtl", &b"newmtl a\nKd .5\nKs .5 .5 .5\nillum 1\n"[..]),
        ("b.mtl", b"newmtl a\nKd .5\nillum 0\nKs 1 1 1\nTf xyz 1 1 1\n"),
        ("c.mtl", b"newmtl a\nKd .5\nnewmtl unused\nKd .5\nKs 1 1 1\n"),
    ]);
    let notes_of = |format, text: &str| {
        let model = read(format, "a", text.as_bytes(), &files).unwrap_or_else(|refusal| panic!("{refusal}"));
        notes(&model).into_iter().map(str::to_owned).collect::<Vec<_>>()
    };
    for name in ["a.mtl", "b.mtl", "c.mtl"] {
        assert_eq!(notes_of(Format::Obj, &OBJ.replace("a.mtl", name)), [""; 0], "{name}");
    }
    let unused = "void glow g 0 0 4 1 1 1 5\nvoid glass p 0 0 3 .9 .9 .9\nvoid plastic w 0 0 5 .5 .5 .5 0 0\n\
                  void plastic q 0 0 5 .5 .5 .5 .1 0\nw sphere s 0 0 4 0 0 0 1\n";
    assert_eq!(notes_of(Format::Rad, unused), [""; 0]);
    let used = format!("{unused}void alias r g\nr sphere t 0 0 4 5 0 0 1\ng sphere u 0 0 4 9 0 0 1\n");
    let limit = "the limit of how far glow shines (maxrad) is left out: it lights all that it faces";
    assert_eq!(notes_of(Format::Rad, &used), [limit]);
    let pattern = "void brightfunc p 2 a b 0 0\np plastic w 0 0 5 .5 .5 .5 0 0\nw sphere s 0 0 4 0 0 0 1\n";
    assert_eq!(notes_of(Format::Rad, pattern), ["patterns and textures are left out"]);
    assert_eq!(notes_of(Format::Mgf, &MGF.replace("m w =\n", "m u =\n rs .5 0\n td .1\nm w =\n")), [""; 0]);
    assert_eq!(notes_of(Format::Mgf, &MGF.replace(" rd .5\n", " rd .5\n rs .5 0\n rs 0 0\n")), [""; 0]);
}

/// The two faces of a sheet share their corners and what the file states there; a face alone has a wrong normal.
#[test]
fn a_sheet_of_two_faces_has_normals_of_one() {
    let obj = "s 1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\n";
    let stl = |faces: &[&str]| {
        let facet = |corners: &&str| format!("facet normal 0 0 1\nouter loop\n{corners}endloop\nendfacet\n");
        format!("solid a\n{}endsolid a\n", faces.iter().map(facet).collect::<String>())
    };
    let (front, back) =
        ("vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n", "vertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\n");
    let mgf = |faces: &str, sides: &str| {
        format!(
            "v a =\n n 0 0 1\nv b =\n p 1 0 0\n n 0 0 1\nv c =\n p 0 1 0\n n 0 0 1\nm w =\n rd .5\n sides {sides}\n{faces}"
        )
    };
    let contradict = "normals that contradict the order of corners are left out";
    let cases = [
        (Format::Obj, format!("{obj}f 1//1 2//1 3//1\nf 3//1 2//1 1//1\n"), None),
        (Format::Obj, format!("{obj}f 1 2 3\nf 3 2 1\n"), None),
        (Format::Obj, format!("{obj}f 3//1 2//1 1//1\n"), Some(OPPOSED)),
        (Format::Stl, stl(&[front, back]), None),
        (Format::Stl, stl(&[back]), Some(contradict)),
        (Format::Mgf, mgf("f a b c\nf c b a\n", "1"), None),
        (Format::Mgf, mgf("xf -mx\nf a b c\nf c b a\nxf\n", "1"), None),
        (Format::Mgf, mgf("xf -mx\nf a b c\nxf\n", "1"), None),
        (Format::Mgf, mgf("f c b a\n", "1"), Some(OPPOSED)),
        (Format::Mgf, mgf("f c b a\n", "2"), None),
    ];
    for (format, text, note) in cases {
        let model =
            read(format, "a", text.as_bytes(), &Memory::default()).unwrap_or_else(|fault| panic!("{fault}"));
        assert_eq!(notes(&model), note.into_iter().collect::<Vec<_>>(), "{text}");
    }
}

/// Extensions that nobody knows and that the file does not list are named where they are used.
#[test]
fn extensions_are_named_wherever_they_are_used() {
    let own = "\"extensions\": {\"ACME_odd\": {}}";
    let parts = [
        ("\"scenes\": [{", "\"scenes\": [{"),
        ("\"meshes\": [{", "\"meshes\": [{"),
        ("\"bufferViews\": [{", "\"bufferViews\": [{"),
        ("\"materials\": [{", "\"materials\": [{"),
        ("\"nodes\": [{\"mesh\"", "\"nodes\": [{\"mesh\""),
        ("\"skins\"", "\"cameras\": [{}], \"skins\""),
        ("\"skins\"", "\"textures\": [{}], \"skins\""),
    ];
    for (part, more) in parts {
        assert!(GLTF.contains(part), "{part}");
        let text = match more.split_once("[{}]") {
            Some((before, after)) => GLTF.replacen(part, &format!("{before}[{{{own}}}]{after}"), 1),
            None => {
                let at = part.find('{').expect("it has one") + 1;
                GLTF.replacen(part, &format!("{}{own}, {}", &part[..at], &part[at..]), 1)
            }
        };
        assert_eq!(noted(Format::Gltf, &text), ["the extension ACME_odd is left out"], "{text}");
        let listed = text.replace("KHR_texture_transform", "ACME_odd");
        assert_eq!(noted(Format::Gltf, &listed), ["the extension ACME_odd is left out"], "{listed}");
    }
}

/// The mirror part of specular glossiness is taken off the diffuse part, as the extension states it.
#[test]
fn specular_glossiness_leaves_the_rest_to_diffuse_reflection() {
    let with = |members: &str| {
        let extension = format!(
            "\"extensions\": {{\"KHR_materials_pbrSpecularGlossiness\": {{{members}}}}}, \"pbrMetallicRoughness\""
        );
        GLTF.replace("\"pbrMetallicRoughness\"", &extension)
    };
    let numbers =
        [0.0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0];
    let files =
        Memory::of([("triangle.bin", numbers.into_iter().flat_map(f32::to_le_bytes).collect::<Vec<u8>>())]);
    let diffuse = "\"diffuseFactor\": [0.5, 0.5, 0.5, 1]";
    for (members, reflectance, note) in [
        (format!("{diffuse}, \"specularFactor\": [0, 0, 0]"), 0.5, None),
        (format!("{diffuse}, \"specularFactor\": [0.04, 0.02, 0]"), 0.48, None),
        (format!("{diffuse}, \"specularFactor\": [0.2, 0.6, 0]"), 0.2, Some(SPECULAR)),
        (diffuse.to_owned(), 0.0, Some(SPECULAR)),
    ] {
        let text = with(&members);
        let model =
            read(Format::Gltf, "a", text.as_bytes(), &files).unwrap_or_else(|fault| panic!("{fault}"));
        assert!(
            (model.materials[0].reflectance[0] - reflectance).abs() < 1e-12,
            "{members}: {:?}",
            model.materials
        );
        assert_eq!(notes(&model), note.into_iter().collect::<Vec<_>>(), "{members}");
    }
}

/// A texture that tells the mirror part leaves it unknown: what is taken for it is told.
#[test]
fn mirrors_that_a_texture_tells_are_told() {
    let extension = "\"extensions\": {\"KHR_materials_pbrSpecularGlossiness\": {\"specularGlossinessTexture\": {\"index\": 0}}}, \"pbrMetallicRoughness\"";
    let text = GLTF.replace("\"pbrMetallicRoughness\"", extension);
    let told = noted(Format::Gltf, &text);
    let kept = "the part that a specularGlossinessTexture reflects as a mirror does is taken for 0, and all of the diffuse colour is kept";
    assert_eq!(told, [SPECULAR, "textures are left out", kept], "{told:?}");
}

/// Notes on materials of an OBJ have the file and the line of the statement.
#[test]
fn notes_on_materials_have_their_file_and_line() {
    let files = Memory::of([("a.mtl", &b"newmtl a\nKd .5\nKs 1 1 1\nmap_Kd a.png\nnewmtl b\nKd -1\n"[..])]);
    let model = read(Format::Obj, "a.obj", OBJ.as_bytes(), &files).unwrap_or_else(|fault| panic!("{fault}"));
    let places: Vec<_> = model.notes.iter().map(|note| (note.file.as_deref(), note.place)).collect();
    let at = |line| (Some("a.mtl"), Some(radiosity_photometry::file_place::FilePlace::Line(line)));
    assert_eq!(places, [at(4), at(3), at(6)]);
}
