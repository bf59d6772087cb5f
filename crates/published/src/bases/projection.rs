//! The functions of a surface as polynomials on its elements.
//!
//! ```text
//! T_ka = ∫ φ_k f_a dA ,     M_ab = Σ_k T_ka T_kb = ∫ f_a f_b dA
//! ```
//!
//! with the orthonormal polynomials φ_k of all elements together; the second equation holds where the
//! polynomials hold the functions. Gauss rules on the patches of each element, exact for products of
//! polynomials on flat ones.

use radiosity_core::dot;
use radiosity_elements::Element;
use radiosity_elements::columns::add_scaled;
use radiosity_elements::frame::duals;
use radiosity_elements::patch::Node;
use radiosity_elements::rule::UnitRule;
use radiosity_geom::{DVec3, Surface};

use super::functions::SurfaceFunctions;

/// Points per direction beyond the order of an element: what functions and area elements need that are no
/// polynomials of that order. Chosen.
const MORE_POINTS: usize = 8;

/// The functions of a surface as polynomials on some of its elements.
#[derive(Clone, Debug)]
pub struct Projection {
    /// T, function by function: coefficients in the orthonormal bases, element by element (length).
    pub(super) columns: Vec<Vec<f64>>,
}

impl Projection {
    /// Projection of `functions` of the surface `shape` onto its `elements`.
    pub fn new(functions: &dyn SurfaceFunctions, shape: &dyn Surface, elements: &[&Element]) -> Self {
        let chart = Chart::of(shape);
        let mut columns = vec![Vec::new(); functions.count()];
        for element in elements {
            let sums = Sums::of(functions, &chart, element);
            columns.iter_mut().zip(sums.orthonormal(element)).for_each(|(column, own)| column.extend(own));
        }
        Self { columns }
    }

    /// The mass matrix M (length²), row by row; symmetric.
    pub fn mass(&self) -> Vec<Vec<f64>> {
        let row = |a: &Vec<f64>| self.columns.iter().map(|b| dot(a, b)).collect();
        self.columns.iter().map(row).collect()
    }
}

/// The parameters of nodes.
enum Chart {
    /// Affine in the plane: the point of parameters (0, 0), and the gradients of both.
    Flat { middle: DVec3, gradients: [DVec3; 2] },
    /// Given by the node itself.
    Curved,
}

impl Chart {
    fn of(shape: &dyn Surface) -> Self {
        if shape.region().is_none() {
            return Self::Curved;
        }
        let jet = shape.jet(0.0, 0.0);
        Self::Flat { middle: jet.position, gradients: duals([jet.du, jet.dv]) }
    }

    fn parameters(&self, node: &Node) -> [f64; 2] {
        match self {
            Self::Flat { middle, gradients } => {
                gradients.map(|gradient| (node.position - middle).dot(gradient))
            }
            Self::Curved => node.parameters.to_array(),
        }
    }
}

/// ∫ R_l f_a dA over one element, function by function.
struct Sums(Vec<Vec<f64>>);

impl Sums {
    fn of(functions: &dyn SurfaceFunctions, chart: &Chart, element: &Element) -> Self {
        let (count, basis) = (functions.count(), &element.basis);
        let mut sums = vec![vec![0.0; basis.len()]; count];
        let (mut raw, mut values) = (vec![0.0; basis.len()], vec![0.0; count]);
        let rule = UnitRule::of(basis.order() + MORE_POINTS);
        for patch in &element.patches {
            for ((s, ws), (t, wt)) in rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t))) {
                let node = patch.node(s, t);
                basis.raw(basis.frame().coordinates(&node), &mut raw);
                functions.values(chart.parameters(&node), &mut values);
                let present = sums.iter_mut().zip(&values).filter(|(_, value)| **value != 0.0);
                present.for_each(|(sums, value)| add_scaled(sums, ws * wt * node.area * value, &raw));
            }
        }
        Self(sums)
    }

    /// ∫ φ_k f_a dA with φ_k = Σ_l T_kl R_l.
    fn orthonormal(self, element: &Element) -> impl Iterator<Item = Vec<f64>> {
        let basis = &element.basis;
        let rows = basis.transform().chunks_exact(basis.len());
        self.0.into_iter().map(move |sums| rows.clone().map(|row| dot(row, &sums)).collect())
    }
}
