//! A solution as an unstructured grid of VTK (`.vtu`), which ParaView opens.
//!
//! Irradiance and radiosity are polynomials on every element, and VTK's Lagrange cells are polynomials
//! through values at nodes: the grid holds the light itself, not samples of it. With L_a the polynomial that
//! is 1 at node a and 0 at all others, and ξ the cell's own coordinates,
//!
//! ```text
//! x(ξ) = Σ_a x_a L_a(ξ) ,     E(ξ) = Σ_a E_a L_a(ξ) .
//! ```
//!
//! | element | cells | degree |
//! | --- | --- | --- |
//! | flat | Lagrange triangles; quadrilaterals for patches that are parallelograms | total degree of the polynomials |
//! | curved | Lagrange quadrilaterals over rectangles of the parameters | at least the order |
//!
//! E(ξ) is exact to rounding in both. So is x(ξ) on flat elements and on polynomial patches of that degree;
//! other curved elements take a higher degree or several cells (`vtu/bending.rs`), and the grid states how
//! far x(ξ) is from the surface at equal parameters. Each cell has points of its own: light jumps between
//! elements.
//!
//! Reference: VTK's XML formats, <https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html>.

mod nodes;
mod bending;
mod xml;
mod error;
mod cell;

use std::io::{self, Write};

use radiosity_elements::Element;
use radiosity_elements::parameters::parameters;
use radiosity_scene::Scene;
use radiosity_solve::solution::{Solution, SurfacePlace};

use cell::{Cell, Corner};
pub use error::VtuError;
use xml::{Document, Numbers};

/// Highest degree of a cell: with even nodes rounding grows by a factor of 3·10⁴ at degree 20, and by 10⁹ at
/// 40.
const HIGHEST_DEGREE: usize = 20;

/// A solution as cells of VTK.
#[derive(Debug)]
pub struct Grid<'a> {
    scene: &'a Scene,
    solution: &'a Solution,
    cells: Vec<GridCell>,
    points: Points,
    deviation: f64,
}

/// A cell of the grid.
#[derive(Clone, Copy, Debug)]
struct GridCell {
    /// Index of its element.
    element: usize,
    /// VTK's type.
    kind: u8,
    /// End of its points among those of all cells.
    end: usize,
}

/// Numbers at points, one after the other.
#[derive(Debug, Default)]
struct Points {
    positions: Vec<f64>,
    normals: Vec<f64>,
    parameters: Vec<f64>,
    /// Irradiance, band after band (W m⁻²).
    irradiance: Vec<Vec<f64>>,
    /// Radiosity, band after band (W m⁻²).
    radiosity: Vec<Vec<f64>>,
}

impl<'a> Grid<'a> {
    /// The cells of `solution`, whose elements are those of `scene`.
    ///
    /// # Errors
    /// Light that is no polynomial, because it goes through shadow masks; polynomials of a higher degree than
    /// 20.
    pub fn new(scene: &'a Scene, solution: &'a Solution) -> Result<Self, VtuError> {
        if solution.masked().is_some() {
            return Err(VtuError::Masked);
        }
        let per_band = || vec![Vec::new(); solution.bands().len()];
        let points = Points { irradiance: per_band(), radiosity: per_band(), ..Points::default() };
        let mut grid = Self { scene, solution, cells: Vec::new(), points, deviation: 0.0 };
        for (index, element) in solution.elements().list().iter().enumerate() {
            let highest = element.basis.total_degree();
            if element.plane.is_some() && highest > HIGHEST_DEGREE {
                let surface = scene.surfaces[element.surface].name.clone();
                return Err(VtuError::Degree { surface, degree: highest, highest: HIGHEST_DEGREE });
            }
            let (cells, deviation) = cell::of(element);
            grid.deviation = grid.deviation.max(deviation);
            cells.iter().for_each(|cell| grid.add(index, cell));
        }
        Ok(grid)
    }

    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.cells.len()
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        self.points.positions.len() / 3
    }

    /// Greatest distance found between a point of a cell and the point of the surface with the same
    /// parameters (scene length), half-way between the nodes.
    pub fn deviation(&self) -> f64 {
        self.deviation
    }

    fn add(&mut self, element: usize, cell: &Cell) {
        let owner = &self.solution.elements().list()[element];
        for corner in cell.nodes() {
            self.add_point(element, owner, &corner);
        }
        self.cells.push(GridCell { element, kind: cell.kind(), end: self.points() });
    }

    fn add_point(&mut self, index: usize, element: &Element, node: &Corner) {
        let shape = self.solution.elements().shape(element.surface);
        let parameters = node.parameters.unwrap_or_else(|| parameters(shape, node.position));
        let place = SurfacePlace { surface: element.surface, parameters, position: node.position };
        let bands = self.solution.bands();
        let mut irradiance = vec![0.0; bands.len()];
        self.solution.irradiance_bands(index, &place, &mut irradiance);
        let mut beyond = vec![0.0; bands.len()];
        if let Some((behind, place)) = self.solution.behind(index, &place) {
            self.solution.irradiance_bands(behind, &place, &mut beyond);
        }
        let points = &mut self.points;
        points.positions.extend((node.position + self.scene.middle).to_array());
        points.normals.extend(node.normal.to_array());
        points.parameters.extend(parameters);
        for (k, (band, irradiance)) in bands.iter().zip(irradiance).enumerate() {
            points.irradiance[k].push(irradiance);
            points.radiosity[k].push(band.coating.radiosity(index, parameters, irradiance, beyond[k]));
        }
    }

    /// Writes the file: XML with numbers in base64, as VTK writes them.
    ///
    /// # Errors
    /// Errors of writing to `out`.
    pub fn write(&self, out: impl Write) -> io::Result<()> {
        let mut document = Document::begin(out)?;
        self.write_fields(&mut document)?;
        document.open(&format!(
            "Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\"",
            self.points(),
            self.cells()
        ))?;
        self.write_point_data(&mut document)?;
        self.write_cell_data(&mut document)?;
        document.open("Points")?;
        document.array("Points", 3, Numbers::Float64(&self.points.positions))?;
        document.close("Points")?;
        self.write_cells(&mut document)?;
        document.close("Piece")?;
        document.end()
    }

    /// Writes the fields of the whole grid: names of the scene, its surfaces and bands, unit, residuals,
    /// deviation.
    fn write_fields(&self, document: &mut Document<impl Write>) -> io::Result<()> {
        let Scene { surfaces, bands, unit, name, .. } = self.scene;
        document.open("FieldData")?;
        document.strings("scene", [name.as_str()])?;
        document.strings("surfaces", surfaces.iter().map(|surface| surface.name.as_str()))?;
        document.strings("bands", bands.iter().map(String::as_str))?;
        document.strings("unit of irradiance and radiosity", [unit.as_str()])?;
        let residuals: Vec<f64> =
            self.solution.bands().iter().map(|band| band.coefficients.residual).collect();
        document.array("residual", 1, Numbers::Float64(&residuals))?;
        document.array("geometric deviation", 1, Numbers::Float64(&[self.deviation]))?;
        document.close("FieldData")
    }

    fn write_point_data(&self, document: &mut Document<impl Write>) -> io::Result<()> {
        let Points { normals, parameters, irradiance, radiosity, .. } = &self.points;
        let bands = &self.scene.bands;
        document.open("PointData Normals=\"normal\"")?;
        for (quantity, values) in [("irradiance", irradiance), ("radiosity", radiosity)] {
            for (band, values) in bands.iter().zip(values) {
                document.array(&format!("{quantity} {band}"), 1, Numbers::Float64(values))?;
            }
        }
        document.array("normal", 3, Numbers::Float64(normals))?;
        document.array("parameters", 2, Numbers::Float64(parameters))?;
        document.close("PointData")
    }

    fn write_cell_data(&self, document: &mut Document<impl Write>) -> io::Result<()> {
        let list = self.solution.elements().list();
        let elements = || self.cells.iter().map(|cell| cell.element);
        let surfaces: Vec<i64> = elements().map(|element| list[element].surface as i64).collect();
        let areas: Vec<f64> = elements().map(|element| list[element].area).collect();
        let elements: Vec<i64> = elements().map(|element| element as i64).collect();
        document.open("CellData")?;
        document.array("surface", 1, Numbers::Int64(&surfaces))?;
        document.array("element", 1, Numbers::Int64(&elements))?;
        document.array("element area", 1, Numbers::Float64(&areas))?;
        document.close("CellData")
    }

    fn write_cells(&self, document: &mut Document<impl Write>) -> io::Result<()> {
        let connectivity: Vec<i64> = (0..self.points() as i64).collect();
        let ends: Vec<i64> = self.cells.iter().map(|cell| cell.end as i64).collect();
        let types: Vec<u8> = self.cells.iter().map(|cell| cell.kind).collect();
        document.open("Cells")?;
        document.array("connectivity", 1, Numbers::Int64(&connectivity))?;
        document.array("offsets", 1, Numbers::Int64(&ends))?;
        document.array("types", 1, Numbers::UInt8(&types))?;
        document.close("Cells")
    }
}
