//! Accessors: numbers in buffers (section 3.6.2). Ranges are checked once, numbers read when they are asked
//! for.

use std::borrow::Cow;
use std::collections::HashMap;
use std::rc::Rc;

use glam::DVec3;
use radiosity_photometry::error::{Refusal, refuse};
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::text::short;

use super::json::{Json, unlisted};
use super::scheme::{Accessor, BufferView, Root, Sparse, SparsePart};
use crate::scalar::Scalar;
use crate::tolerances::MOST_ROWS;

/// Most rows that accessors replace in all: each takes several times the memory of a row that is listed.
const MOST_REPLACED: usize = 10_000_000;

const CORRECT: &str = "correct it, or export the model again";

/// The type of components that a number stands for (section 5.1.3).
fn scalar(number: u32) -> Result<Scalar, Refusal> {
    Ok(match number {
        5120 => Scalar::I8,
        5121 => Scalar::U8,
        5122 => Scalar::I16,
        5123 => Scalar::U16,
        5125 => Scalar::U32,
        5126 => Scalar::F32,
        _ => return refuse(format!("there is no component type {number}"), CORRECT),
    })
}

/// Divisor of an integer that stands for a part of 1 (section 3.11).
fn whole(scalar: Scalar) -> f64 {
    match scalar {
        Scalar::I8 => 127.0,
        Scalar::U8 => 255.0,
        Scalar::I16 => 32767.0,
        Scalar::U16 => 65535.0,
        _ => 1.0,
    }
}

/// Rows of numbers in a buffer.
#[derive(Clone, Debug)]
struct Rows<'b> {
    bytes: &'b [u8],
    stride: usize,
    component: Scalar,
    scale: f64,
}

impl Rows<'_> {
    fn number(&self, row: usize, column: usize) -> Option<f64> {
        let at = row.checked_mul(self.stride)?.checked_add(column * self.component.size())?;
        let value = self.component.read(self.bytes.get(at..)?)? / self.scale;
        // The least integer stands for −1 too.
        Some(if self.scale == 1.0 { value } else { value.max(-1.0) })
    }
}

/// The numbers of an accessor.
#[derive(Clone, Debug)]
pub(super) struct Data<'b> {
    /// Number of rows.
    pub(super) count: usize,
    /// Rows of numbers; none where all numbers are 0.
    rows: Option<Rows<'b>>,
    /// Rows that a sparse accessor replaces.
    replaced: Option<Replaced<'b>>,
}

/// The rows that a sparse accessor replaces.
#[derive(Clone, Debug)]
struct Replaced<'b> {
    /// Number of the row → row among `values`.
    places: HashMap<usize, usize>,
    values: Rows<'b>,
}

/// Rows of numbers in a view.
#[derive(Clone, Copy)]
struct Span {
    /// Index of the view.
    view: usize,
    /// Byte of the view at which they begin.
    offset: usize,
    /// Number of rows.
    count: usize,
    /// Numbers in a row.
    width: usize,
}

impl Data<'_> {
    fn number(&self, row: usize, column: usize) -> Option<f64> {
        if row >= self.count {
            return None;
        }
        if let Some(Replaced { places, values }) = &self.replaced
            && let Some(row) = places.get(&row)
        {
            return values.number(*row, column);
        }
        self.rows.as_ref().map_or(Some(0.0), |rows| rows.number(row, column))
    }

    /// The index in a row.
    pub(super) fn index(&self, row: usize) -> Option<usize> {
        self.number(row, 0).map(|index| index as usize)
    }

    /// The point in a row.
    pub(super) fn point(&self, row: usize) -> Option<DVec3> {
        Some(DVec3::new(self.number(row, 0)?, self.number(row, 1)?, self.number(row, 2)?))
    }
}

/// Use of the numbers of an accessor: points or indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum NumberUse {
    Points,
    Indices,
}

impl NumberUse {
    fn width(self) -> usize {
        match self {
            NumberUse::Points => 3,
            NumberUse::Indices => 1,
        }
    }
}

/// All accessors of a file; each is checked once.
#[derive(Debug)]
pub(super) struct Accessors<'a, 'b> {
    json: &'b Json<'a>,
    root: &'b Root<'a>,
    buffers: &'b [Cow<'a, [u8]>],
    known: HashMap<(usize, NumberUse), Rc<Data<'b>>>,
    replaced: usize,
}

impl<'a, 'b> Accessors<'a, 'b> {
    /// The accessors of a file.
    pub(super) fn new(json: &'b Json<'a>, root: &'b Root<'a>, buffers: &'b [Cow<'a, [u8]>]) -> Self {
        Accessors { json, root, buffers, known: HashMap::new(), replaced: 0 }
    }

    /// The numbers of an accessor that is named at `from`.
    pub(super) fn data(
        &mut self,
        index: usize,
        kind: NumberUse,
        from: FilePlace,
    ) -> Result<Rc<Data<'b>>, Refusal> {
        if let Some(data) = self.known.get(&(index, kind)) {
            return Ok(Rc::clone(data));
        }
        let (accessor, place): (Accessor, FilePlace) =
            self.json.item(&self.root.accessors, index, "accessor", from)?;
        let data = self.checked(&accessor, kind, place);
        let data = Rc::new(data.map_err(|refusal| refusal.of(&format!("the accessor {index}"), place))?);
        self.known.insert((index, kind), Rc::clone(&data));
        Ok(data)
    }

    fn checked(
        &mut self,
        accessor: &Accessor,
        kind: NumberUse,
        place: FilePlace,
    ) -> Result<Data<'b>, Refusal> {
        let component = scalar(accessor.component_type)?;
        check(accessor, kind, component)?;
        let scale = if accessor.normalized { whole(component) } else { 1.0 };
        let rows = Rows { bytes: &[], stride: 0, component, scale };
        let (offset, count, width) = (accessor.byte_offset, accessor.count, kind.width());
        let own =
            accessor.buffer_view.map(|view| self.rows(&rows, Span { view, offset, count, width }, place));
        let sparse = accessor.sparse.as_ref();
        let replaced = sparse.map(|sparse| self.sparse(sparse, &rows, count, width, place));
        Ok(Data { count, rows: own.transpose()?, replaced: replaced.transpose()? })
    }

    /// The rows that a sparse accessor of `count` rows replaces.
    fn sparse(
        &mut self,
        sparse: &Sparse,
        rows: &Rows<'b>,
        count: usize,
        width: usize,
        place: FilePlace,
    ) -> Result<Replaced<'b>, Refusal> {
        self.replaced = self.replaced.saturating_add(sparse.count);
        if sparse.count > count || self.replaced > MOST_REPLACED {
            return refuse(format!("it replaces {} of {count} rows", sparse.count), CORRECT);
        }
        let SparsePart { buffer_view: view, byte_offset: offset, component_type } = sparse.indices;
        let component = scalar(component_type.unwrap_or(0))?;
        let plain = Rows { bytes: &[], stride: 0, component, scale: 1.0 };
        let indices = self.rows(&plain, Span { view, offset, count: sparse.count, width: 1 }, place)?;
        let SparsePart { buffer_view: view, byte_offset: offset, .. } = sparse.values;
        let values = self.rows(rows, Span { view, offset, count: sparse.count, width }, place)?;
        let mut places = HashMap::new();
        for row in 0..sparse.count {
            let index = indices.number(row, 0).map_or(usize::MAX, |index| index as usize);
            if index >= count {
                // The row is not told: a buffer may be any file.
                return refuse(format!("it replaces a row beyond the {count} that it has"), CORRECT);
            }
            places.insert(index, row);
        }
        Ok(Replaced { places, values })
    }

    /// The rows of a span, if its view has them.
    fn rows(&self, like: &Rows<'b>, span: Span, place: FilePlace) -> Result<Rows<'b>, Refusal> {
        let Span { view, offset, count, width } = span;
        let (view, at): (BufferView, FilePlace) =
            self.json.item(&self.root.buffer_views, view, "buffer view", place)?;
        let bytes = self.bytes(&view).map_err(|refusal| refusal.at(at))?;
        let size = width * like.component.size();
        let stride = view.byte_stride.unwrap_or(size);
        let needed = match count {
            0 => Some(0),
            _ => (count - 1).checked_mul(stride).and_then(|span| span.checked_add(size)),
        };
        let bytes = bytes.get(offset..).filter(|rest| needed.is_some_and(|needed| needed <= rest.len()));
        let Some(bytes) = bytes.filter(|_| stride >= size) else {
            return refuse(
                format!(
                    "{count} rows of {size} bytes, {stride} apart, do not fit behind byte {offset} of a view of {}",
                    view.byte_length
                ),
                CORRECT,
            );
        };
        Ok(Rows { bytes, stride, ..like.clone() })
    }
    /// The bytes of a view.
    fn bytes(&self, view: &BufferView) -> Result<&'b [u8], Refusal> {
        let buffer = self.buffers.get(view.buffer);
        let buffer: &'b [u8] = buffer.ok_or_else(|| unlisted("buffer", view.buffer, self.buffers.len()))?;
        let bytes = buffer.get(view.byte_offset..).and_then(|rest| rest.get(..view.byte_length));
        bytes.ok_or_else(|| {
            let BufferView { byte_length, byte_offset, .. } = view;
            let there = buffer.len();
            Refusal::new(
                format!(
                    "the view spans {byte_length} bytes from byte {byte_offset} on; the buffer has {there}"
                ),
                CORRECT,
            )
        })
    }
}

/// Refuses an accessor that cannot hold what it is used for.
fn check(accessor: &Accessor, kind: NumberUse, component: Scalar) -> Result<(), Refusal> {
    let is_right = match kind {
        NumberUse::Points => accessor.kind == "VEC3" && component != Scalar::U32,
        NumberUse::Indices => {
            accessor.kind == "SCALAR" && matches!(component, Scalar::U8 | Scalar::U16 | Scalar::U32)
        }
    };
    if !is_right {
        let what = if kind == NumberUse::Points { "points" } else { "indices" };
        return refuse(
            format!(
                "{what} cannot be {} of component type {}",
                short(&accessor.kind),
                accessor.component_type
            ),
            "export the model again; points are VEC3 of floats, indices SCALAR of unsigned integers",
        );
    }
    if accessor.count > MOST_ROWS {
        return refuse(format!("it has more than {MOST_ROWS} rows"), "split the model");
    }
    if kind == NumberUse::Points && accessor.buffer_view.is_none() && accessor.sparse.is_none() {
        return refuse(
            "its points are all 0: it has neither a buffer view nor sparse values",
            "export the model without compression",
        );
    }
    Ok(())
}
