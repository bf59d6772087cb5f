//! Nodes of VTK's Lagrange cells, evenly spaced, in VTK's order: corners, then the inner nodes of the sides,
//! then those of the interior.

/// Coordinates of the nodes of the triangle (0, 0), (1, 0), (0, 1); the interior is numbered like a triangle
/// whose degree is less by 3.
pub(super) fn triangle(degree: usize) -> Vec<[f64; 2]> {
    let mut places = Vec::new();
    let (mut inset, mut rest) = (0, degree);
    loop {
        let own: Vec<[usize; 2]> = match rest {
            0 => vec![[0, 0]],
            n => {
                let sides = [[n, 0], [0, n]];
                let corners = [[0, 0]].into_iter().chain(sides);
                let low = (1..n).map(|k| [k, 0]);
                let long = (1..n).map(|k| [n - k, k]);
                let left = (1..n).map(|k| [0, n - k]);
                corners.chain(low).chain(long).chain(left).collect()
            }
        };
        places.extend(own.into_iter().map(|at| at.map(|k| (k + inset) as f64 / degree as f64)));
        if rest < 3 {
            return places;
        }
        inset += 1;
        rest -= 3;
    }
}

/// Coordinates of the nodes of the unit square, `degree` along both sides; sides and interior run along
/// ascending coordinates, the first fastest.
pub(super) fn quadrilateral(degree: usize) -> Vec<[f64; 2]> {
    let n = degree;
    let corners = [[0, 0], [n, 0], [n, n], [0, n]];
    let sides = [
        (1..n).map(|k| [k, 0]).collect::<Vec<_>>(),
        (1..n).map(|k| [n, k]).collect(),
        (1..n).map(|k| [k, n]).collect(),
        (1..n).map(|k| [0, k]).collect(),
    ];
    let interior = (1..n).flat_map(|j| (1..n).map(move |i| [i, j]));
    let places = corners.into_iter().chain(sides.into_iter().flatten()).chain(interior);
    places.map(|at| at.map(|k| k as f64 / degree as f64)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_node_is_there_once() {
        for degree in 1..=20 {
            for (nodes, count) in [
                (triangle(degree), (degree + 1) * (degree + 2) / 2),
                (quadrilateral(degree), (degree + 1) * (degree + 1)),
            ] {
                let mut steps: Vec<[i64; 2]> =
                    nodes.iter().map(|at| at.map(|x| (x * degree as f64).round() as i64)).collect();
                steps.sort_unstable();
                steps.dedup();
                assert_eq!([nodes.len(), steps.len()], [count; 2], "degree {degree}");
            }
            assert!(triangle(degree).iter().all(|[s, t]| s + t < 1.0 + 1e-15));
        }
    }

    /// The numbering that VTK's test of its cubic triangle and quadrilateral draws.
    #[test]
    fn cubic_cells_are_numbered_as_in_vtk() {
        let thirds = |nodes: Vec<[f64; 2]>| -> Vec<[i64; 2]> {
            nodes.iter().map(|at| at.map(|x| (3.0 * x).round() as i64)).collect()
        };
        let expected = [[0, 0], [3, 0], [0, 3], [1, 0], [2, 0], [2, 1], [1, 2], [0, 2], [0, 1], [1, 1]];
        assert_eq!(thirds(triangle(3)), expected);
        let sides = [[1, 0], [2, 0], [3, 1], [3, 2], [1, 3], [2, 3], [0, 1], [0, 2]];
        let interior = [[1, 1], [2, 1], [1, 2], [2, 2]];
        let corners = [[0, 0], [3, 0], [3, 3], [0, 3]];
        assert_eq!(thirds(quadrilateral(3)), [&corners[..], &sides, &interior].concat());
    }
}
