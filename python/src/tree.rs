//! Dictionaries, lists, numbers and arrays of Python → the tree of a scene.
//!
//! Other values stay in the tree as they are: the library refuses them where it reads them, by their names.

use numpy::{
    PyArray2, PyArrayDescrMethods, PyArrayMethods, PyReadonlyArray2, PyUntypedArray, PyUntypedArrayMethods,
};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFloat, PyInt, PyList, PyString, PyTuple};
use radiosity::geom::DVec3;
use radiosity::scene::Tree;

/// More levels than a scene may have: the library refuses what is as deep.
const DEEPEST: usize = 40;

/// Letters of NumPy for arrays whose items are numbers, flags, texts or objects.
const KINDS: &[u8] = b"fiubUO";

/// Faces of a mesh that are surfaces of the same keys, `name-1`, `name-2` and so on.
#[pyclass(frozen, module = "radiosity._radiosity")]
pub(crate) struct Faces {
    name: String,
    /// Key of the shape that each face has.
    shape: String,
    /// Vertices of the mesh (length): an array (v, 3).
    vertices: Py<PyArray2<f64>>,
    /// Indices of vertices: an array (n, k), one row for each face.
    corners: Py<PyArray2<i64>>,
    /// The other keys, which all faces have.
    keys: Py<PyDict>,
}

#[pymethods]
impl Faces {
    #[new]
    fn new(
        name: String,
        shape: String,
        vertices: Py<PyArray2<f64>>,
        corners: Py<PyArray2<i64>>,
        keys: Py<PyDict>,
    ) -> Self {
        Self { name, shape, vertices, corners, keys }
    }
}

impl Faces {
    /// The surfaces, one for each row of corners.
    fn surfaces(&self, py: Python<'_>) -> PyResult<Vec<Tree>> {
        let vertices = self.vertices.bind(py).try_readonly()?;
        let corners = self.corners.bind(py).try_readonly()?;
        let keys = entries(self.keys.bind(py), &mut Vec::new());
        let vertices = vertices.as_array();
        let vertex = |index: &i64| {
            let row = usize::try_from(*index).ok().filter(|row| *row < vertices.nrows())?;
            Some(DVec3::new(vertices[[row, 0]], vertices[[row, 1]], vertices[[row, 2]]))
        };
        let surface = |(number, face): (usize, numpy::ndarray::ArrayView1<'_, i64>)| {
            let outline: Option<Vec<DVec3>> = face.iter().map(vertex).collect();
            let outline = outline.map_or_else(|| Tree::foreign("a corner without a vertex"), Tree::points);
            let name = Tree::text(format!("{}-{number}", self.name));
            let shape = Tree::table([("vertices", outline)]);
            let own = [("name".to_owned(), name)].into_iter().chain(keys.iter().cloned());
            Tree::table(own.chain([(self.shape.clone(), shape)]))
        };
        Ok((1..).zip(corners.as_array().rows()).map(surface).collect())
    }
}

/// The tree of a dictionary.
pub(crate) fn tree(parts: &Bound<'_, PyDict>) -> Tree {
    value(parts, &mut Vec::new())
}

/// The tree of a value; `around` are the containers that it is in.
fn value(given: &Bound<'_, PyAny>, around: &mut Vec<usize>) -> Tree {
    if let Ok(text) = given.cast::<PyString>() {
        return text.to_cow().map_or_else(|_| Tree::foreign("a text that is no Unicode"), Tree::text);
    }
    if let Ok(flag) = given.extract::<bool>() {
        return Tree::flag(flag);
    }
    if let Some(number) = number(given) {
        return Tree::number(number);
    }
    let own = given.as_ptr().addr();
    if around.contains(&own) {
        return Tree::foreign("a list that is in itself");
    }
    if around.len() > DEEPEST {
        return Tree::list([]);
    }
    around.push(own);
    let tree = container(given, around);
    around.pop();
    tree.unwrap_or_else(|| Tree::foreign(kind(given)))
}

/// The tree of a dictionary, a list or an array.
fn container(given: &Bound<'_, PyAny>, around: &mut Vec<usize>) -> Option<Tree> {
    if let Ok(dictionary) = given.cast::<PyDict>() {
        let has_names = dictionary.keys().iter().all(|key| key.cast::<PyString>().is_ok());
        return has_names.then(|| Tree::table(entries(dictionary, around)));
    }
    if let Ok(items) = given.cast::<PyList>() {
        return Some(list(items.iter(), around));
    }
    if let Ok(items) = given.cast::<PyTuple>() {
        return Some(list(items.iter(), around));
    }
    let array = given.cast::<PyUntypedArray>().ok().filter(|array| KINDS.contains(&array.dtype().kind()))?;
    match points(array) {
        Some(points) => Some(Tree::points(points)),
        None => Some(value(&array.call_method0("tolist").ok()?, around)),
    }
}

fn entries(dictionary: &Bound<'_, PyDict>, around: &mut Vec<usize>) -> Vec<(String, Tree)> {
    dictionary.iter().map(|(key, item)| (key.to_string(), value(&item, around))).collect()
}

/// A list; faces in it are surfaces of it.
fn list<'py>(items: impl Iterator<Item = Bound<'py, PyAny>>, around: &mut Vec<usize>) -> Tree {
    let mut trees = Vec::new();
    for item in items {
        match item.cast::<Faces>().ok().map(|faces| faces.get().surfaces(item.py())) {
            None => trees.push(value(&item, around)),
            Some(Ok(surfaces)) => trees.extend(surfaces),
            Some(Err(error)) => trees.push(Tree::foreign(error.to_string())),
        }
    }
    Tree::list(trees)
}

/// A number of Python or of NumPy, if it is one and real; whole numbers beyond the range of floating point
/// are infinite.
fn number(given: &Bound<'_, PyAny>) -> Option<f64> {
    if let Ok(number) = given.cast::<PyFloat>() {
        return Some(number.value());
    }
    if given.cast::<PyInt>().is_ok() {
        let infinite = || if given.lt(0).unwrap_or(false) { f64::NEG_INFINITY } else { f64::INFINITY };
        return Some(given.extract().unwrap_or_else(|_| infinite()));
    }
    let generic = given.py().import("numpy").ok()?.getattr("generic").ok()?;
    let is_scalar = given.is_instance(&generic).unwrap_or(false);
    let kind: String =
        given.getattr("dtype").ok().filter(|_| is_scalar)?.getattr("kind").ok()?.extract().ok()?;
    if ["f", "i", "u"].contains(&kind.as_str()) { given.extract().ok() } else { None }
}

/// The rows of an array (k, 3) of floating point in any order in memory. Classes that are more than arrays,
/// such as masked ones, say themselves what their items are.
fn points(array: &Bound<'_, PyUntypedArray>) -> Option<Vec<DVec3>> {
    let array = array.cast_exact::<PyUntypedArray>().ok().filter(|array| array.is_aligned())?;
    let rows: PyReadonlyArray2<'_, f64> = array.cast::<PyArray2<f64>>().ok()?.try_readonly().ok()?;
    let rows = rows.as_array();
    let is_list = rows.ncols() == 3;
    is_list.then(|| rows.rows().into_iter().map(|row| DVec3::new(row[0], row[1], row[2])).collect())
}

/// Description of a value that no scene has, for messages.
fn kind(given: &Bound<'_, PyAny>) -> String {
    if given.is_none() {
        return "None".to_owned();
    }
    if given.cast::<PyDict>().is_ok() {
        return "a dictionary of keys that are no texts".to_owned();
    }
    let class = given.get_type().name().map_or_else(|_| "…".to_owned(), |name| name.to_string());
    match given.cast::<PyUntypedArray>() {
        Ok(array) => format!("an array of {}", array.dtype()),
        Err(_) => format!("an object of the class {class}"),
    }
}
