//! Accessors: numbers in buffers (section 3.6.2). Ranges are checked once, numbers read when they are asked
//! for.

use std::borrow::Cow;
use std::collections::HashMap;
use std::rc::Rc;

use glam::DVec3;
use radiosity_photometry::fault::Fault;
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::located::Located;
use radiosity_photometry::text::short;

use super::json::Json;
use super::scheme::{Accessor, BufferView, Root, Sparse, SparsePart};
use crate::tolerances::MOST_ROWS;

/// Most rows that accessors replace in all: each takes several times the memory of a row that is listed.
const MOST_REPLACED: usize = 10_000_000;

const CORRECT: &str = "correct it, or export the model again";

/// A type of components, by the number that stands for it (section 5.1.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Component {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl Component {
    fn of(number: u32) -> Result<Component, Fault> {
        Ok(match number {
            5120 => Component::I8,
            5121 => Component::U8,
            5122 => Component::I16,
            5123 => Component::U16,
            5125 => Component::U32,
            5126 => Component::F32,
            _ => return Err(Fault::new(format!("there is no component type {number}"), CORRECT)),
        })
    }

    fn size(self) -> usize {
        match self {
            Component::I8 | Component::U8 => 1,
            Component::I16 | Component::U16 => 2,
            Component::U32 | Component::F32 => 4,
        }
    }

    /// Divisor of an integer that stands for a part of 1 (section 3.11).
    fn whole(self) -> f64 {
        match self {
            Component::I8 => 127.0,
            Component::U8 => 255.0,
            Component::I16 => 32767.0,
            Component::U16 => 65535.0,
            Component::U32 | Component::F32 => 1.0,
        }
    }

    fn read(self, bytes: &[u8]) -> Option<f64> {
        let two = || bytes.get(..2)?.try_into().ok();
        let four = || bytes.get(..4)?.try_into().ok();
        Some(match self {
            Component::I8 => f64::from(i8::from_le_bytes([*bytes.first()?])),
            Component::U8 => f64::from(*bytes.first()?),
            Component::I16 => f64::from(i16::from_le_bytes(two()?)),
            Component::U16 => f64::from(u16::from_le_bytes(two()?)),
            Component::U32 => f64::from(u32::from_le_bytes(four()?)),
            Component::F32 => f64::from(f32::from_le_bytes(four()?)),
        })
    }
}

/// Rows of numbers in a buffer.
#[derive(Clone, Debug)]
struct Rows<'b> {
    bytes: &'b [u8],
    stride: usize,
    component: Component,
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
    ) -> Result<Rc<Data<'b>>, Located> {
        if let Some(data) = self.known.get(&(index, kind)) {
            return Ok(Rc::clone(data));
        }
        let (accessor, place): (Accessor, FilePlace) =
            self.json.item(&self.root.accessors, index, "accessor", from)?;
        let located =
            |Fault { cause, cure }| Located::new(place, format!("the accessor {index}: {cause}"), cure);
        let data = Rc::new(self.checked(&accessor, kind, place).map_err(|wrong| match wrong {
            Wrong::Here(fault) => located(fault),
            Wrong::There(located) => located,
        })?);
        self.known.insert((index, kind), Rc::clone(&data));
        Ok(data)
    }

    fn checked(&mut self, accessor: &Accessor, kind: NumberUse, place: FilePlace) -> Result<Data<'b>, Wrong> {
        let component = Component::of(accessor.component_type)?;
        let is_right = match kind {
            NumberUse::Points => accessor.kind == "VEC3" && component != Component::U32,
            NumberUse::Indices => {
                accessor.kind == "SCALAR"
                    && matches!(component, Component::U8 | Component::U16 | Component::U32)
            }
        };
        if !is_right {
            let what = if kind == NumberUse::Points { "points" } else { "indices" };
            return Err(Fault::new(
                format!(
                    "{what} cannot be {} of component type {}",
                    short(&accessor.kind),
                    accessor.component_type
                ),
                "export the model again; points are VEC3 of floats, indices SCALAR of unsigned integers",
            )
            .into());
        }
        if accessor.count > MOST_ROWS {
            return Err(Fault::new(format!("it has more than {MOST_ROWS} rows"), "split the model").into());
        }
        if kind == NumberUse::Points && accessor.buffer_view.is_none() && accessor.sparse.is_none() {
            return Err(Fault::new(
                "its points are all 0: it has neither a buffer view nor sparse values",
                "export the model without compression",
            )
            .into());
        }
        let scale = if accessor.normalized { component.whole() } else { 1.0 };
        let rows = Rows { bytes: &[], stride: 0, component, scale };
        let own = accessor
            .buffer_view
            .map(|view| {
                let (offset, count) = (accessor.byte_offset, accessor.count);
                self.rows(&rows, Span { view, offset, count, width: kind.width() }, place)
            })
            .transpose()?;
        let replaced = match &accessor.sparse {
            Some(sparse) => Some(self.sparse(sparse, &rows, accessor.count, kind.width(), place)?),
            None => None,
        };
        Ok(Data { count: accessor.count, rows: own, replaced })
    }

    /// The rows that a sparse accessor of `count` rows replaces.
    fn sparse(
        &mut self,
        sparse: &Sparse,
        rows: &Rows<'b>,
        count: usize,
        width: usize,
        place: FilePlace,
    ) -> Result<Replaced<'b>, Wrong> {
        self.replaced = self.replaced.saturating_add(sparse.count);
        if sparse.count > count || self.replaced > MOST_REPLACED {
            return Err(Fault::new(format!("it replaces {} of {count} rows", sparse.count), CORRECT).into());
        }
        let SparsePart { buffer_view: view, byte_offset: offset, component_type } = sparse.indices;
        let component = Component::of(component_type.unwrap_or(0))?;
        let plain = Rows { bytes: &[], stride: 0, component, scale: 1.0 };
        let indices = self.rows(&plain, Span { view, offset, count: sparse.count, width: 1 }, place)?;
        let SparsePart { buffer_view: view, byte_offset: offset, .. } = sparse.values;
        let values = self.rows(rows, Span { view, offset, count: sparse.count, width }, place)?;
        let mut places = HashMap::new();
        for row in 0..sparse.count {
            let index = indices.number(row, 0).map_or(usize::MAX, |index| index as usize);
            if index >= count {
                return Err(Fault::new(
                    format!("it replaces the row {index}; it has {count}, from 0 on"),
                    CORRECT,
                )
                .into());
            }
            places.insert(index, row);
        }
        Ok(Replaced { places, values })
    }

    /// The rows of a span, if its view has them.
    fn rows(&self, like: &Rows<'b>, span: Span, place: FilePlace) -> Result<Rows<'b>, Wrong> {
        let Span { view, offset, count, width } = span;
        let (view, at): (BufferView, FilePlace) =
            self.json.item(&self.root.buffer_views, view, "buffer view", place)?;
        let Some(buffer) = self.buffers.get(view.buffer) else {
            return Err(Wrong::There(Located::new(
                at,
                format!("the buffer {} is named, {} are listed, from 0 on", view.buffer, self.buffers.len()),
                CORRECT,
            )));
        };
        let bytes = buffer.get(view.byte_offset..).and_then(|rest| rest.get(..view.byte_length));
        let Some(bytes) = bytes else {
            return Err(Wrong::There(Located::new(
                at,
                format!(
                    "the view spans {} bytes from byte {} on; the buffer has {}",
                    view.byte_length,
                    view.byte_offset,
                    buffer.len()
                ),
                CORRECT,
            )));
        };
        let size = width * like.component.size();
        let stride = view.byte_stride.unwrap_or(size);
        let needed = match count {
            0 => Some(0),
            _ => (count - 1).checked_mul(stride).and_then(|span| span.checked_add(size)),
        };
        let bytes = bytes.get(offset..).filter(|rest| needed.is_some_and(|needed| needed <= rest.len()));
        let Some(bytes) = bytes.filter(|_| stride >= size) else {
            return Err(Fault::new(
                format!(
                    "{count} rows of {size} bytes, {stride} apart, do not fit behind byte {offset} of a view of {}",
                    view.byte_length
                ),
                CORRECT,
            )
            .into());
        };
        Ok(Rows { bytes, stride, ..like.clone() })
    }
}

/// Fault of an accessor, or of a view that it names.
enum Wrong {
    Here(Fault),
    There(Located),
}

impl From<Fault> for Wrong {
    fn from(fault: Fault) -> Self {
        Wrong::Here(fault)
    }
}

impl From<Located> for Wrong {
    fn from(located: Located) -> Self {
        Wrong::There(located)
    }
}
