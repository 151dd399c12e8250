//! Singular values of small matrices, by Hestenes' one-sided rotations.

/// Most sweeps; ten are plenty for matrices of a few columns.
const SWEEPS: usize = 60;

/// A matrix of rows taken apart: directions of the unknowns and how strongly each is felt, the strongest first.
#[derive(Clone, Debug)]
pub(super) struct Singular {
    /// Singular values, descending.
    pub values: Vec<f64>,
    /// Directions, unit vectors, in the same order.
    pub directions: Vec<Vec<f64>>,
}

/// Takes a matrix of `columns` columns apart.
pub(super) fn singular(rows: &[Vec<f64>], columns: usize) -> Singular {
    let mut felt: Vec<Vec<f64>> = (0..columns).map(|c| rows.iter().map(|row| row[c]).collect()).collect();
    let mut directions: Vec<Vec<f64>> = (0..columns)
        .map(|c| (0..columns).map(|k| if k == c { 1.0 } else { 0.0 }).collect())
        .collect();
    for _ in 0..SWEEPS {
        let mut turned = false;
        for p in 0..columns {
            for q in p + 1..columns {
                let (a, b, c) = (
                    dot(&felt[p], &felt[p]),
                    dot(&felt[q], &felt[q]),
                    dot(&felt[p], &felt[q]),
                );
                if c.abs() <= 1e-15 * (a * b).sqrt() {
                    continue;
                }
                turned = true;
                let zeta = (b - a) / (2.0 * c);
                let tangent = zeta.signum() / (zeta.abs() + (1.0 + zeta * zeta).sqrt());
                let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
                rotate(&mut felt, p, q, cosine, cosine * tangent);
                rotate(&mut directions, p, q, cosine, cosine * tangent);
            }
        }
        if !turned {
            break;
        }
    }
    let norm = |c: &usize| dot(&felt[*c], &felt[*c]).sqrt();
    let mut order: Vec<usize> = (0..columns).collect();
    order.sort_by(|a, b| norm(b).total_cmp(&norm(a)));
    Singular {
        values: order.iter().map(norm).collect(),
        directions: order.iter().map(|c| directions[*c].clone()).collect(),
    }
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn rotate(vectors: &mut [Vec<f64>], p: usize, q: usize, cosine: f64, sine: f64) {
    for k in 0..vectors[p].len() {
        let (x, y) = (vectors[p][k], vectors[q][k]);
        vectors[p][k] = cosine * x - sine * y;
        vectors[q][k] = sine * x + cosine * y;
    }
}

/// Reduced row echelon form: the same space of directions by vectors with as many zeros as can be.
pub(super) fn reduced(mut rows: Vec<Vec<f64>>, columns: usize) -> Vec<Vec<f64>> {
    let mut rank = 0;
    for column in 0..columns {
        let best = (rank..rows.len()).max_by(|a, b| rows[*a][column].abs().total_cmp(&rows[*b][column].abs()));
        let Some(best) = best.filter(|b| rows[*b][column].abs() > NOTHING) else {
            continue;
        };
        rows.swap(rank, best);
        let pivot = rows[rank].clone();
        for (k, row) in rows.iter_mut().enumerate() {
            let factor = if k == rank {
                1.0 - 1.0 / pivot[column]
            } else {
                row[column] / pivot[column]
            };
            row.iter_mut().zip(&pivot).for_each(|(x, p)| *x -= factor * p);
        }
        rank += 1;
    }
    rows.truncate(rank);
    for row in &mut rows {
        row.iter_mut().filter(|x| x.abs() < NOTHING).for_each(|x| *x = 0.0);
    }
    rows
}

/// What is taken for zero among components of unit vectors that were found by differences.
pub(super) const NOTHING: f64 = 1e-4;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_matrix_is_put_together_again() {
        let rows = vec![
            vec![1.0, 2.0, 3.0],
            vec![-4.0, 0.5, 1.0],
            vec![2.0, 2.0, -1.0],
            vec![0.0, 1.0, 1.0],
        ];
        let found = singular(&rows, 3);
        assert!(found.values.windows(2).all(|w| w[0] >= w[1]));
        // the sum of squares is that of the elements, and every direction is felt as strongly as told
        let squares: f64 = rows.iter().flatten().map(|x| x * x).sum();
        assert!((found.values.iter().map(|s| s * s).sum::<f64>() - squares).abs() < 1e-12 * squares);
        for (value, direction) in found.values.iter().zip(&found.directions) {
            let felt: f64 = rows.iter().map(|row| dot(row, direction)).map(|x| x * x).sum();
            assert!((felt.sqrt() - value).abs() < 1e-12);
            assert!((dot(direction, direction) - 1.0).abs() < 1e-12);
        }
        assert!(dot(&found.directions[0], &found.directions[1]).abs() < 1e-12);
    }

    #[test]
    fn what_is_not_felt_has_a_singular_value_of_zero() {
        let found = singular(&[vec![1.0, 2.0, 0.0]], 3);
        assert!((found.values[0] - 5f64.sqrt()).abs() < 1e-15);
        assert!(found.values[1] < 1e-15 && found.values[2] < 1e-15);
        let row = found.directions[0].clone();
        assert_eq!(reduced(vec![row], 3), [[1.0, 2.0, 0.0]]);
    }

    #[test]
    fn a_reduced_form_names_single_unknowns() {
        let reduced = reduced(vec![vec![0.6, 0.8, 0.0], vec![0.8, -0.6, 0.0]], 3);
        assert_eq!(reduced.len(), 2);
        for (row, expected) in reduced.iter().zip([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]) {
            assert!(row.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{row:?}");
        }
    }
}
