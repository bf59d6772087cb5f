//! Elements: the scene's surfaces cut into pieces that carry polynomials.
//!
//! A planar element is any polygon, without holes and footprints, with polynomials of order N in affine
//! coordinates of its plane; parts that other surfaces lie on ([`radiosity_visibility::covered_parts`]) are
//! elements of their own. A curved element is a rectangle of its surface's parameters, with polynomials in
//! them. Both bases are orthonormal with respect to area ([`basis`]). For quadrature an element is covered by
//! [`patch`]es.
//!
//! In order: [`cells`] and [`columns`] (cuts of the square, columns of tables), [`patch`] and [`frame`]
//! (charts and coordinates), `recurrence`, [`rule`], [`space`], `products` and `spectrum` (polynomials and
//! their rules), [`measure`] and [`basis`] (orthonormal by area), [`parameters`], `element`, [`coating`] (how
//! elements reflect, transmit and emit), [`mesh`] (cells of all surfaces), `discretization`, `dividers` and
//! `resolution` (how a scene is cut), [`sampling`] (sequences of points), and [`Elements`], the noun of the crate.
//!
//! Imports `core`, `geom`, `work`, `scene` and `visibility`.

pub mod cells;
pub mod columns;
pub mod patch;
pub mod frame;
pub(crate) mod recurrence;
pub mod rule;
pub mod space;
pub(crate) mod products;
pub(crate) mod spectrum;
pub mod measure;
pub mod basis;
pub mod parameters;
mod fault;
mod element;
pub mod coating;
pub mod mesh;
mod discretization;
mod dividers;
mod nearness;
mod near_outlines;
mod shaded_parts;
mod resolution;
pub mod sampling;

use std::borrow::Cow;
use std::ops::Range;
use std::sync::Arc;

use radiosity_core::dot;
use radiosity_geom::{Aabb, Bvh, DVec3, LOOSE, PlanarRegion, Rect, Surface, polygon_width, touching};
use radiosity_scene::{Scene, SceneSurface};
use radiosity_visibility::covered_parts::{CoveredPart, CoveredParts, without};
use radiosity_visibility::footprints::bare_shapes;
use radiosity_visibility::tolerances::NARROW_PIECE;
use radiosity_work::interruption::check_interrupt;
use shaded_parts::{ShadedPart, ShadedParts};

use basis::HIGHEST_ORDER;
pub use discretization::{Discretization, Subdivide};
pub use element::flat_patches;
pub use element::{Element, clip_to_cell};
use element::{Part, element};
pub use fault::ElementError;
use mesh::{CellRefinement, Mesh, Tree};
use patch::Patch;
use resolution::{Resolution, near_outlines};
pub use resolution::{shares, usual_mesh};
use space::Space;

/// All elements of a scene, surface by surface.
#[derive(Debug)]
pub struct Elements {
    list: Vec<Element>,
    surfaces: Vec<SurfaceCut>,
    how: Discretization,
    cells: Cells,
}

/// The cells of all surfaces.
#[derive(Clone, Debug)]
struct Cells {
    mesh: Mesh,
    /// Whether the mesh is another than follows from the discretization.
    is_refined: bool,
}

/// The cut of one surface: its cells with the element of each, and the elements of covered and shaded parts.
#[derive(Debug)]
struct SurfaceCut {
    shape: Arc<dyn Surface>,
    /// Diagonal of its bounding box (scene length).
    extent: f64,
    cells: Tree<Option<usize>>,
    /// Elements of the covered and of the shaded parts, ascending.
    covered: Vec<usize>,
    /// The boxes around them.
    places: Bvh,
}

impl Elements {
    /// Cuts `scene` as `how` says, without its footprints ([`radiosity_visibility::footprints`]).
    ///
    /// # Errors
    /// A degree out of range, or a surface without area at the given degree.
    pub fn new(scene: &Scene, how: &Discretization) -> Result<Self, ElementError> {
        Self::cut_into(scene, how, None)
    }

    /// Cuts `scene` into the cells of `mesh`, whatever `how` says of them, without its footprints.
    ///
    /// # Errors
    /// As for [`Elements::new`].
    pub fn of_mesh(scene: &Scene, how: &Discretization, mesh: Mesh) -> Result<Self, ElementError> {
        Self::cut_into(scene, how, Some(mesh))
    }

    /// The elements of this cut on the surfaces of `scene`, which are those of the scene that was cut, some
    /// of them moved; elements of surfaces that rest are copied.
    ///
    /// # Errors
    /// As for [`Elements::new`].
    pub fn moved(&self, scene: &Scene) -> Result<Self, ElementError> {
        let mesh = self.cells.mesh.clone();
        let is_refined = mesh != usual_mesh(scene, &self.how);
        Self::cut(
            scene,
            &self.how,
            Cells { mesh, is_refined },
            bare_shapes(scene),
            &CoveredParts::new(scene),
            Some(self),
        )
    }

    fn cut_into(scene: &Scene, how: &Discretization, mesh: Option<Mesh>) -> Result<Self, ElementError> {
        if !how.layers.is_valid() {
            return Err(ElementError::Layers { layers: how.layers });
        }
        let usual = usual_mesh(scene, how);
        let is_refined = mesh.as_ref().is_some_and(|mesh| *mesh != usual);
        let mesh = mesh.unwrap_or(usual);
        let cells = Cells { mesh, is_refined };
        Self::cut(scene, how, cells, bare_shapes(scene), &CoveredParts::new(scene), None)
    }

    /// Cuts `shapes` into cells; elements of shapes that are those of `before`, and that
    /// nothing covers, are copied.
    fn cut(
        scene: &Scene,
        how: &Discretization,
        cells: Cells,
        shapes: Vec<Arc<dyn Surface>>,
        covered_parts: &CoveredParts,
        before: Option<&Self>,
    ) -> Result<Self, ElementError> {
        let shaded_parts = shaded_parts(scene, how, &shapes, covered_parts);
        let mut list = Vec::new();
        let mut surfaces = Vec::new();
        for (index, (surface, shape)) in scene.surfaces.iter().zip(shapes).enumerate() {
            let own: Vec<&CoveredPart> = covered_parts.of_surface(index).collect();
            let shaded = shaded_parts.of_surface(index);
            let is_bare = own.is_empty() && shaded.is_empty();
            if let Some(copy) =
                before.filter(|_| is_bare).and_then(|before| before.copied(index, &shape, &mut list))
            {
                surfaces.push(copy);
                continue;
            }
            let tree = &cells.mesh.surfaces()[index];
            let order = tree.values().into_iter().max().copied().unwrap_or(0);
            if order > HIGHEST_ORDER {
                return Err(ElementError::Order { order });
            }
            let holes: Vec<&Vec<DVec3>> = own
                .iter()
                .flat_map(|part| &part.pieces)
                .chain(shaded.iter().flat_map(|part| &part.pieces))
                .collect();
            let pieces =
                Pieces::new(shape.region().map_or_else(Vec::new, |region| open_pieces(region, &holes)));
            let mut maker = ElementMaker { index, surface, space: how.space, is_bare, list: &mut list };
            let elements = tree.map(&Rect::FULL, &mut |rect, order| {
                check_interrupt();
                let pieces = pieces.over(shape.as_ref(), rect);
                let part =
                    Part { shape: &shape, pieces: &pieces, rect: *rect, contact: None, shaded_by: None };
                maker.made(part, *order)
            })?;
            let mut covered = Vec::new();
            let whole = Part { shape: &shape, pieces: &[], rect: Rect::FULL, contact: None, shaded_by: None };
            for CoveredPart { pieces, contact, .. } in &own {
                let part = Part { pieces, contact: Some(*contact), ..whole };
                covered.extend(maker.made(part, order)?);
            }
            for ShadedPart { pieces, over } in shaded {
                let part = Part { pieces, shaded_by: Some(*over), ..whole };
                covered.extend(maker.made(part, 0)?);
            }
            let places =
                Bvh::build(&covered.iter().map(|index| around_cover(&list[*index])).collect::<Vec<_>>());
            let extent = shape.bounds(&Rect::FULL).diagonal();
            surfaces.push(SurfaceCut { shape: Arc::clone(&shape), extent, cells: elements, covered, places });
        }
        Ok(Self { list, surfaces, how: *how, cells })
    }

    /// The cut of a surface, if it has this shape and nothing covers it; its elements are appended to `list`.
    fn copied(
        &self,
        surface: usize,
        shape: &Arc<dyn Surface>,
        list: &mut Vec<Element>,
    ) -> Option<SurfaceCut> {
        let cut = self.surfaces.get(surface)?;
        if !Arc::ptr_eq(&cut.shape, shape) || !cut.covered.is_empty() {
            return None;
        }
        let own = self.of_surface(surface);
        let start = list.len();
        list.extend_from_slice(&self.list[own.clone()]);
        let place = |element: &Option<usize>| element.map(|element| element - own.start + start);
        let cells = cut.cells.map::<_, ElementError>(&Rect::FULL, &mut |_, element| Ok(place(element)));
        let cells = cells.expect("nothing can fail");
        let (covered, places) = (Vec::new(), Bvh::build(&[]));
        Some(SurfaceCut { shape: Arc::clone(shape), extent: cut.extent, cells, covered, places })
    }

    /// The mesh, if it is another than follows from the discretization.
    pub fn refined_mesh(&self) -> Option<&Mesh> {
        self.cells.is_refined.then_some(&self.cells.mesh)
    }

    /// The mesh after what `refinement` says of each element; covered and shaded parts stay.
    pub fn refined(&self, refinement: &[CellRefinement]) -> Mesh {
        let leaves: Vec<Vec<Option<usize>>> =
            self.surfaces.iter().map(|cut| cut.cells.values().into_iter().copied().collect()).collect();
        self.cells.mesh.refined(&|surface, leaf| {
            leaves[surface][leaf].map_or(CellRefinement::Keep, |element| refinement[element])
        })
    }

    /// Cut of the scene, and the polynomials of the elements.
    pub fn discretization(&self) -> &Discretization {
        &self.how
    }

    /// The elements, in the order of their surfaces.
    pub fn list(&self) -> &[Element] {
        &self.list
    }

    /// Indices of the elements of one surface.
    pub fn of_surface(&self, surface: usize) -> Range<usize> {
        let start = self.list.partition_point(|element| element.surface < surface);
        let end = self.list.partition_point(|element| element.surface <= surface);
        start..end
    }

    /// The element of a surface that holds the parameters (u, v); None inside a hole that fills a cell.
    pub fn at(&self, surface: usize, [u, v]: [f64; 2]) -> Option<usize> {
        let cut = &self.surfaces[surface];
        if let Some(covered) = self.covered_at(cut, [u, v]) {
            return Some(covered);
        }
        *cut.cells.at([u, v])
    }

    /// The element beyond the seam at (u, v), further by 1e-9 along `step`; None at the border of the
    /// surface, inside its holes and where another surface lies on it.
    pub fn across_seam(&self, surface: usize, [u, v]: [f64; 2], step: [f64; 2]) -> Option<usize> {
        let beyond = [u + 1e-9 * step[0], v + 1e-9 * step[1]];
        let shape = self.shape(surface);
        let cut = &self.surfaces[surface];
        if [[u, v], beyond].iter().any(|place| self.covered_at(cut, *place).is_some()) {
            return None;
        }
        let covered = shape.region().is_none_or(|region| region.contains(shape.jet(u, v).position));
        if covered && beyond.iter().all(|x| *x < 1.0) { self.at(surface, beyond) } else { None }
    }

    /// The element of the part on which another surface lies at the parameters (u, v).
    fn covered_at(&self, cut: &SurfaceCut, [u, v]: [f64; 2]) -> Option<usize> {
        let position = (!cut.covered.is_empty()).then(|| cut.shape.jet(u, v).position)?;
        let holds = |index: &usize| {
            let element = &self.list[*index];
            element.covers(position, touching(element.extent, 0.0))
        };
        let near = cut.places.search(|bounds| bounds.contains(position)).map(|place| cut.covered[place]);
        near.filter(holds).min()
    }

    /// Number of surfaces, those without elements included.
    pub fn surfaces(&self) -> usize {
        self.surfaces.len()
    }

    /// Diagonal of the bounding box of a surface (scene length).
    pub fn extent(&self, surface: usize) -> f64 {
        self.surfaces[surface].extent
    }

    /// The shape of a surface.
    pub fn shape(&self, surface: usize) -> &dyn Surface {
        self.surfaces[surface].shape.as_ref()
    }

    /// Disjoint patches that cover the part of element `element` over the parameters `rect`.
    pub fn patches_over(&self, element: usize, rect: &Rect) -> Vec<Patch> {
        let element = &self.list[element];
        element.patches_over(self.shape(element.surface), rect)
    }

    /// Coefficients c of the constant 1, element by element.
    pub fn constant(&self) -> Vec<f64> {
        self.list.iter().flat_map(|element| &element.constant).copied().collect()
    }

    /// Mean over each element of what these coefficients stand for.
    pub fn means(&self, coefficients: &[f64]) -> Vec<f64> {
        let mut rest = coefficients;
        let mean = |element: &Element| {
            let (own, others) = rest.split_at(element.constant.len());
            rest = others;
            dot(own, &element.constant) / element.area
        };
        self.list.iter().map(mean).collect()
    }

    /// Where the coefficients of each element start, and their number.
    pub fn starts(&self) -> Vec<usize> {
        starts(&self.list)
    }

    /// Number of coefficients per band of all elements together.
    pub fn coefficients(&self) -> usize {
        self.list.iter().map(|element| element.basis.len()).sum()
    }
}

/// The box around the element of a covered part, and around all points that count as on it.
fn around_cover(element: &Element) -> Aabb {
    element.bounds().inflate(LOOSE * element.extent)
}

/// Convex pieces of a flat surface, which are found by place.
struct Pieces {
    list: Vec<Vec<DVec3>>,
    /// The boxes around them.
    places: Bvh,
}

impl Pieces {
    fn new(list: Vec<Vec<DVec3>>) -> Self {
        let bounds = |piece: &Vec<DVec3>| Aabb::around(piece.iter().copied());
        let places = Bvh::build(&list.iter().map(bounds).collect::<Vec<_>>());
        Self { list, places }
    }

    /// The pieces that may reach over the parameters `rect` of their surface, in order.
    fn over(&self, shape: &dyn Surface, rect: &Rect) -> Cow<'_, [Vec<DVec3>]> {
        if self.list.len() < 2 || *rect == Rect::FULL {
            return Cow::Borrowed(&self.list);
        }
        let bounds = shape.bounds(rect);
        let near = self.places.near(&bounds.inflate(touching(bounds.diagonal(), 0.0)));
        Cow::Owned(near.into_iter().map(|piece| self.list[piece].clone()).collect())
    }
}

/// Makes the elements of one surface.
struct ElementMaker<'a> {
    index: usize,
    surface: &'a SceneSurface,
    space: Space,
    /// Whether no part of it is covered or shaded.
    is_bare: bool,
    list: &'a mut Vec<Element>,
}

impl ElementMaker<'_> {
    /// Appends the element of a part to the list; its index, or None where the part is empty.
    fn made(&mut self, part: Part, order: usize) -> Result<Option<usize>, ElementError> {
        let is_whole = part.rect == Rect::FULL && self.is_bare;
        let found = match element(self.index, self.surface, part, self.space, order) {
            // Beside a cut or a covered part the rest may be a sliver, for which a constant is enough.
            Err(ElementError::Thin { .. }) if !is_whole => {
                element(self.index, self.surface, part, self.space, 0)
            }
            found => found,
        };
        let found = found?;
        let place = found.is_some().then_some(self.list.len());
        self.list.extend(found);
        Ok(place)
    }
}

/// Convex pieces of a flat surface outside of convex `holes`.
fn open_pieces(region: &PlanarRegion, holes: &[&Vec<DVec3>]) -> Vec<Vec<DVec3>> {
    let whole = region.convex_pieces().to_vec();
    let open = without(whole, holes.iter().copied(), region.normal());
    open.into_iter()
        .filter(|piece| holes.is_empty() || polygon_width(piece) > NARROW_PIECE * region.extent())
        .collect()
}

/// The shapes of all surfaces, footprints with them.
fn whole_shapes(scene: &Scene) -> Vec<Arc<dyn Surface>> {
    scene.surfaces.iter().map(|surface| Arc::clone(&surface.shape)).collect()
}

/// The shaded parts of all surfaces; none where a number of elements is asked for.
fn shaded_parts(
    scene: &Scene,
    how: &Discretization,
    shapes: &[Arc<dyn Surface>],
    covered_parts: &CoveredParts,
) -> ShadedParts {
    let follows_light = how.subdivide.follows_light();
    if !follows_light {
        return ShadedParts::default();
    }
    ShadedParts::of(scene, shapes, covered_parts, &near_outlines(scene, how))
}

/// Where the coefficients of each element start, and their number.
pub fn starts(list: &[Element]) -> Vec<usize> {
    let mut starts = vec![0];
    starts.extend(list.iter().scan(0, |start, element| {
        *start += element.basis.len();
        Some(*start)
    }));
    starts
}

/// Upper bounds of what a surface is cut into.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CutSize {
    /// Number of elements, cells in holes included.
    pub elements: u64,
    /// Number of functions on each element.
    pub functions: u64,
}

impl CutSize {
    /// Whether the surface is one element that carries a constant.
    pub fn is_whole(&self) -> bool {
        self.elements == 1 && self.functions == 1
    }
}

/// Upper bounds of the elements and functions that [`Elements::new`] makes of each surface, without making
/// them.
pub fn cut_sizes(scene: &Scene, how: &Discretization) -> Vec<CutSize> {
    let resolution = Resolution::new(scene, how);
    let covered_parts = CoveredParts::new(scene);
    let shaded_parts = shaded_parts(scene, how, &whole_shapes(scene), &covered_parts);
    let size = |(index, surface): (usize, &SceneSurface)| {
        let [along, across] = resolution.breaks(index, surface).map(|breaks| (breaks.len() - 1) as u64);
        let covered = (covered_parts.of_surface(index).len() + shaded_parts.of_surface(index).len()) as u64;
        let functions = how.space.count(resolution.order(index, surface)) as u64;
        CutSize { elements: along * across + covered, functions }
    };
    scene.surfaces.iter().enumerate().map(size).collect()
}

/// Upper bounds of the elements of each surface of a mesh, and about the functions on each.
pub fn mesh_sizes(scene: &Scene, how: &Discretization, mesh: &Mesh) -> Vec<CutSize> {
    let covered_parts = CoveredParts::new(scene);
    let shaded_parts = shaded_parts(scene, how, &whole_shapes(scene), &covered_parts);
    let size = |(index, tree): (usize, &Tree<usize>)| {
        let orders = tree.values();
        let squares: usize = orders.iter().map(|order| how.space.count(**order).pow(2)).sum();
        let functions = (squares as f64 / orders.len() as f64).sqrt().ceil() as u64;
        let covered = covered_parts.of_surface(index).len() + shaded_parts.of_surface(index).len();
        CutSize { elements: (orders.len() + covered) as u64, functions }
    };
    mesh.surfaces().iter().enumerate().map(size).collect()
}

#[cfg(test)]
mod tests {
    use radiosity_scene::Source;

    use super::cells::Layers;
    use super::*;

    fn graded_box() -> Elements {
        let scene = radiosity_language::builtin("empty-box").expect("it is built in");
        let layers = Layers { count: 2, ratio: 0.25 };
        let how = Discretization { order: 1, space: Space::Total, subdivide: Subdivide::Uniform(1), layers };
        Elements::new(&scene, &how).expect("walls have area")
    }

    #[test]
    fn places_are_found_in_graded_elements_and_across_their_seams() {
        let elements = graded_box();
        assert_eq!(elements.of_surface(0), 0..25);
        for (index, element) in elements.list().iter().enumerate() {
            let [u, v] = element.rect.center();
            assert_eq!(elements.at(element.surface, [u, v]), Some(index));
            let right = elements.across_seam(element.surface, [element.rect.u[1], v], [1.0, 0.0]);
            assert_eq!(right.is_some(), element.rect.u[1] < 1.0);
            let neighbour = right.map_or(element.rect.u[1], |other| elements.list()[other].rect.u[0]);
            assert_eq!(neighbour, element.rect.u[1]);
        }
    }

    #[test]
    fn graded_elements_cover_their_surface() {
        let area: f64 = graded_box().list().iter().map(|element| element.area).sum();
        assert!((area - 6.0).abs() < 1e-13, "{area}");
    }

    /// A floor of the shape of an L with walls at the inner sides, turned, of corners in single precision: beside its
    /// cuts along these walls slivers are left.
    fn two_wings(turn: f64) -> Scene {
        let (sin, cos) = turn.sin_cos();
        let turned = |[x, y]: [f64; 2], z: f64| {
            [x * cos - y * sin, x * sin + y * cos, z].map(|coordinate| f64::from(coordinate as f32))
        };
        let plan = [[0.0, 0.0], [7.3, 0.0], [7.3, 2.9], [3.1, 2.9], [3.1, 6.7], [0.0, 6.7]];
        let surface = |name: &str, vertices: &[[f64; 3]]| {
            format!("{{ name = {name:?}, material = \"grey\", polygon = {{ vertices = {vertices:?} }} }},\n")
        };
        let wall = |[a, b]: [[f64; 2]; 2]| [turned(a, 0.0), turned(a, 3.0), turned(b, 3.0), turned(b, 0.0)];
        let surfaces = [
            surface("floor", &plan.map(|place| turned(place, 0.0))),
            surface("south", &wall([plan[2], plan[3]])),
            surface("east", &wall([plan[3], plan[4]])),
        ];
        let text = format!(
            "bands = [\"grey\"]\nmaterials = {{ grey = {{ reflectance = 0.5 }} }}\nsurfaces = [\n{}]\n",
            surfaces.concat()
        );
        radiosity_language::read(&Source::new("wings.toml", &text)).expect("it is a scene")
    }

    #[test]
    fn slivers_beside_a_cut_are_elements() {
        for turn in 0..40 {
            let scene = two_wings(0.1 * f64::from(turn));
            let how = Discretization {
                order: 3,
                space: Space::Total,
                subdivide: Subdivide::Auto { occluded: true, near_layers: false },
                layers: Layers::NONE,
            };
            let elements = Elements::new(&scene, &how).unwrap_or_else(|error| panic!("{turn}: {error}"));
            let area: f64 = elements.of_surface(0).map(|index| elements.list()[index].area).sum();
            assert!((area / scene.surfaces[0].shape.area() - 1.0).abs() < 1e-12, "{turn}: {area}");
        }
    }
}
