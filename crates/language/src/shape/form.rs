//! The trait of the shapes of a scene file.

use std::fmt::Debug;

use radiosity_formats::model::Shape;
use radiosity_geom::{Motion, Placed, ShapeError, Surface};

/// A shape as typed, before its numbers are known to make a surface.
pub(super) trait Form: Debug {
    /// The surfaces it makes, one but for `box` and `patches`, put where `motion` says.
    fn surfaces(&self, motion: &Motion) -> Built;

    /// Shapes of these surfaces in a model of another program; None if models have no such shape.
    fn models(&self, _motion: &Motion) -> Modelled {
        Ok(None)
    }

    /// The name of the surface at `index` of these, where the shape is called `base`.
    fn name(&self, base: &str, _index: usize) -> String {
        base.to_owned()
    }
}

/// Surfaces of one shape, or the fault that keeps it from being built.
pub(super) type Built = Result<Vec<Box<dyn Surface>>, ShapeError>;

/// Shapes of a model, none where it has no such shape, or the fault that keeps them from being built.
pub(super) type Modelled = Result<Option<Vec<Shape>>, ShapeError>;

/// A list of a single surface.
pub(super) fn one(surface: impl Surface + 'static) -> Built {
    Ok(vec![Box::new(surface)])
}

/// A single surface, moved as a whole: the angle 0 of a turned shape goes with it.
pub(super) fn moved(surface: impl Surface + 'static, motion: &Motion) -> Built {
    match *motion == Motion::IDENTITY {
        true => one(surface),
        false => one(Placed::new(Box::new(surface), *motion)),
    }
}
