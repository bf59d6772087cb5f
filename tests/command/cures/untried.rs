//! Messages with cures of which no row of a table is, and why.

use super::messages::Stated;

/// A message that no row draws.
pub(super) struct Untried {
    /// Words of it.
    pub(super) words: &'static str,
    /// Read by people, who judge it.
    #[expect(dead_code, reason = "it is for people")]
    pub(super) why: Why,
}

/// Why a message is no row.
pub(super) enum Why {
    /// It takes an input of millions of parts.
    Large,
    /// It takes a lack of memory, time, threads or programs, or an interruption.
    Machine,
    /// It takes several processes.
    Ranks,
    /// Programs in Rust and Python alone draw it; the command refuses it before, or cannot say it.
    Code,
    /// It takes a run of seconds.
    Long,
    /// It takes larger errors of transfers than any small scene is known to leave.
    Errors,
    /// It takes files of bits, which tests of the readers change byte by byte.
    Bits,
    /// It is a part of other messages, or has no cure.
    Part,
}

impl Untried {
    pub(super) fn names(&self, stated: &Stated) -> bool {
        stated.texts.iter().any(|text| text.contains(self.words))
    }
}

pub(super) const UNTRIED: &[Untried] = &[
    Untried { words: "characters are followed, arrays", why: Why::Large },
    Untried { words: "{MOST_SURFACES} surfaces or", why: Why::Large },
    Untried { words: "the buffers have more than", why: Why::Large },
    Untried { words: "the JSON is longer than", why: Why::Large },
    Untried { words: "triangles, primitives and nodes", why: Why::Large },
    Untried { words: "{MOST_SURFACES} faces or", why: Why::Large },
    Untried { words: "a text with its parameters is longer", why: Why::Large },
    Untried { words: "elements are in one another more than", why: Why::Large },
    Untried { words: "{MOST_ELEMENTS} elements or", why: Why::Large },
    Untried { words: "more than {DEEPEST} folders", why: Why::Large },
    Untried { words: "the scene is longer than", why: Why::Large },
    Untried { words: "more than {MOST_QUOTES} quotes", why: Why::Large },
    Untried { words: "namespaces are declared", why: Why::Large },
    Untried { words: "the file has too many elements", why: Why::Large },
    Untried { words: "join shapes to meshes", why: Why::Large },
    Untried { words: "more than {MOST_VERTICES} vertices", why: Why::Large },
    Untried { words: "the material files are longer", why: Why::Large },
    Untried { words: "the faces have more than", why: Why::Large },
    Untried { words: "the names behind -n", why: Why::Large },
    Untried { words: "there are more than {MOST_VERTICES} of a kind", why: Why::Large },
    Untried { words: "cut curved surfaces into fewer pieces", why: Why::Large },
    Untried { words: "ask for fewer with", why: Why::Large },
    Untried { words: "the next finer elements would be too many", why: Why::Large },
    Untried { words: "films other than .gif and .apng", why: Why::Machine },
    Untried { words: "take a lower ", why: Why::Machine },
    Untried { words: ", leave out ", why: Why::Machine },
    Untried { words: ", or allow more with ", why: Why::Machine },
    Untried { words: "there is no memory or no time to cut", why: Why::Machine },
    Untried { words: "the next finer run", why: Why::Machine },
    Untried { words: "the run was stopped", why: Why::Machine },
    Untried { words: "wait until that run has ended", why: Why::Machine },
    Untried { words: "cannot start {threads} threads", why: Why::Machine },
    Untried { words: "ask for one of these, or", why: Why::Machine },
    Untried { words: "the solver cg", why: Why::Machine },
    Untried { words: "without a wanted accuracy", why: Why::Machine },
    Untried { words: "one element a surface", why: Why::Machine },
    Untried { words: "what would fit", why: Why::Machine },
    Untried { words: "start anew in another folder", why: Why::Machine },
    Untried { words: "not enough memory: {what} need", why: Why::Machine },
    Untried { words: "a wanted accuracy", why: Why::Machine },
    Untried { words: "is another build of this program than rank 0", why: Why::Ranks },
    Untried { words: "allow it to read its own file", why: Why::Ranks },
    Untried { words: "was started with other arguments", why: Why::Ranks },
    Untried { words: "several processes were started", why: Why::Ranks },
    Untried { words: "run one process, or record", why: Why::Ranks },
    Untried { words: "choose a file that is not there yet, or remove", why: Why::Machine },
    Untried { words: "reads another scene here than rank 0", why: Why::Ranks },
    Untried { words: "the outline of surface {:?} crosses itself", why: Why::Code },
    Untried { words: "this format is only read", why: Why::Code },
    Untried { words: "mend the file, or let it be repaired", why: Why::Code },
    Untried { words: "a scene made in code has no text", why: Why::Code },
    Untried { words: "change it there", why: Why::Code },
    Untried { words: "read the scene from its file", why: Why::Code },
    Untried { words: "a scene built in code is solved where", why: Why::Code },
    Untried { words: "counts points, and", why: Why::Code },
    Untried { words: "leave one of them out; ", why: Why::Code },
    Untried { words: "masks are of direct light", why: Why::Code },
    Untried { words: "were sent: give them more time with", why: Why::Machine },
    Untried { words: "give rays more time with", why: Why::Machine },
    Untried { words: "heat is computed at one degree", why: Why::Code },
    Untried { words: "take a degree, such as", why: Why::Code },
    Untried { words: "unknown motion", why: Why::Code },
    Untried { words: "rename one of the two", why: Why::Code },
    Untried { words: "rename one of them in the scene", why: Why::Code },
    Untried { words: "add frames = 1 and a [[motion]]", why: Why::Code },
    Untried { words: "movers are placed, yet", why: Why::Code },
    Untried { words: "leave its factors empty", why: Why::Code },
    Untried { words: "nothing that moves with it emits", why: Why::Code },
    Untried { words: "give a unit quaternion", why: Why::Code },
    Untried { words: "give a direction above the horizon, or leave", why: Why::Code },
    Untried { words: "the sun is not above the horizon", why: Why::Code },
    Untried { words: "place it a millionth", why: Why::Code },
    Untried { words: "leave the transmittance of the material out: heat meets", why: Why::Code },
    Untried { words: "older programs made them again", why: Why::Code },
    Untried { words: "MGF has no words for a torus", why: Why::Code },
    Untried { words: "rays cannot do better", why: Why::Long },
    Untried { words: " below 1e-5 sends no more", why: Why::Long },
    Untried { words: "begin with a higher ", why: Why::Long },
    Untried { words: ", or a smaller ", why: Why::Errors },
    Untried { words: "look for surfaces that pass through each other", why: Why::Errors },
    Untried { words: "subdivide these surfaces, or ask for less", why: Why::Errors },
    Untried { words: "rays leave an unknown error", why: Why::Errors },
    Untried { words: "this is no GLB", why: Why::Bits },
    Untried { words: "its header says {length}", why: Why::Bits },
    Untried { words: "the first chunk is not JSON", why: Why::Bits },
    Untried { words: "the file ends within a chunk", why: Why::Bits },
    Untried { words: "the JSON is not UTF-8", why: Why::Bits },
    Untried { words: "put it beside the model, or export a GLB", why: Why::Bits },
    Untried { words: "write channels R, G and B, or Y, of", why: Why::Bits },
    Untried { words: "it has no channels R, G and B", why: Why::Bits },
    Untried { words: "it has no texels", why: Why::Bits },
    Untried { words: "texels, more than 65536", why: Why::Bits },
    Untried { words: "it is damaged or cut off", why: Why::Bits },
    Untried { words: "{} is transparent", why: Why::Bits },
    Untried { words: "write the picture with finite numbers", why: Why::Bits },
    Untried { words: "an OpenEXR picture is linear", why: Why::Bits },
    Untried { words: "not PNG or OpenEXR", why: Why::Bits },
    Untried { words: "the file ends after {} bytes", why: Why::Bits },
    Untried { words: "triangles are announced", why: Why::Bits },
    Untried { words: "a coordinate of this triangle", why: Why::Bits },
    Untried { words: "it is coloured, and there are", why: Why::Bits },
    Untried { words: "the opening of the file is a ball", why: Why::Bits },
    Untried { words: "solve the scene again with this program, or read", why: Why::Bits },
    Untried { words: "the file is damaged or was changed", why: Why::Bits },
    Untried { words: "the symmetry Isym = {isym} ends", why: Why::Bits },
    Untried { words: "there are fewer than two vertical angles", why: Why::Bits },
    Untried { words: "WRITE_DOCUMENTS=1", why: Why::Part },
    Untried { words: "a String takes all text", why: Why::Part },
    Untried { words: "the included file '{}': {}", why: Why::Part },
    Untried { words: "the mtllib '{}'", why: Why::Part },
];
