//! Linear algebra over a number field: row reduction and what follows from it.
//!
//! Numbers are polynomials without variables. Matrices are lists of rows of equal length; they are small (a row for
//! each power of a parameter), so nothing here is clever.

use hodograph_algebra::{Poly, budget};

/// The reduced row echelon form of the rows, without zero rows, and the pivot column of each row.
///
/// Gauss–Jordan elimination: O(rows² · columns) operations of the field.
pub(super) fn reduce(mut rows: Vec<Vec<Poly>>) -> (Vec<Vec<Poly>>, Vec<usize>) {
    let columns = rows.first().map_or(0, Vec::len);
    let mut pivots = Vec::new();
    for column in 0..columns {
        let done = pivots.len();
        let Some(found) = (done..rows.len()).find(|&i| !rows[i][column].is_zero()) else { continue };
        rows.swap(done, found);
        budget::spend((rows.len() * columns) as u64);
        let inverse = rows[done][column].inverse();
        for entry in &mut rows[done] {
            *entry = &*entry * &inverse;
        }
        let pivot = rows[done].clone();
        for (i, row) in rows.iter_mut().enumerate() {
            if i == done || row[column].is_zero() {
                continue;
            }
            let factor = row[column].clone();
            for (entry, above) in row.iter_mut().zip(&pivot) {
                if !above.is_zero() {
                    *entry = &*entry - &(&factor * above);
                }
            }
        }
        pivots.push(column);
    }
    rows.truncate(pivots.len());
    (rows, pivots)
}

/// The places of the vectors that are independent of those before them.
pub(super) fn independent(vectors: &[Vec<Poly>]) -> Vec<usize> {
    reduce(transposed(vectors)).1
}

/// For each target, which lies in the span of the independent `vectors`, its coordinates with respect to them.
pub(super) fn coordinates(vectors: &[Vec<Poly>], targets: &[Vec<Poly>]) -> Vec<Vec<Poly>> {
    let rows = transposed(&[vectors, targets].concat());
    let (rows, _) = reduce(rows);
    // The first rows have their pivots in the columns of the vectors; there are no others.
    let column = |place: usize| rows.iter().map(|row| row[vectors.len() + place].clone()).collect();
    (0..targets.len()).map(column).collect()
}

/// Numbers `c` with `Σ c_k · vectors[k] = target`, or `None` if there are none.
///
/// Where they are not unique, those that need not be there are zero, the later ones first.
pub(super) fn combine(vectors: &[Vec<Poly>], target: &[Poly]) -> Option<Vec<Poly>> {
    let (rows, pivots) = reduce(transposed(&[vectors, &[target.to_vec()]].concat()));
    if pivots.last() == Some(&vectors.len()) {
        return None;
    }
    let mut solution = vec![Poly::zero(); vectors.len()];
    for (row, &pivot) in rows.iter().zip(&pivots) {
        solution[pivot] = row[vectors.len()].clone();
    }
    Some(solution)
}

/// A basis of the numbers `c` with `Σ c_k · vectors[k] = 0`.
pub(super) fn relations(vectors: &[Vec<Poly>]) -> Vec<Vec<Poly>> {
    let (rows, pivots) = reduce(transposed(vectors));
    let free = (0..vectors.len()).filter(|k| !pivots.contains(k));
    free.map(|k| {
        let mut relation = vec![Poly::zero(); vectors.len()];
        relation[k] = Poly::one();
        for (row, &pivot) in rows.iter().zip(&pivots) {
            relation[pivot] = -&row[k];
        }
        relation
    })
    .collect()
}

/// The adjugate of a square matrix of polynomials, and its determinant: the inverse is their quotient.
///
/// Matrices of numbers are inverted by elimination; others by cofactors, which is done up to 4 rows (`None` beyond).
pub(super) fn adjugate(matrix: &[Vec<Poly>]) -> Option<(Vec<Vec<Poly>>, Poly)> {
    let size = matrix.len();
    if matrix.iter().flatten().all(Poly::is_constant) {
        let unit = |i: usize| (0..size).map(move |j| if i == j { Poly::one() } else { Poly::zero() });
        let rows = matrix.iter().enumerate().map(|(i, row)| row.iter().cloned().chain(unit(i)).collect());
        let (rows, pivots) = reduce(rows.collect());
        let regular = pivots.iter().copied().eq(0..size);
        return regular.then(|| (rows.into_iter().map(|row| row[size..].to_vec()).collect(), Poly::one()));
    }
    if size > 4 {
        return None;
    }
    let signed = |i: usize, j: usize| {
        let minor = determinant(&minor(matrix, j, i));
        if (i + j).is_multiple_of(2) { minor } else { -minor }
    };
    let adjugate = (0..size).map(|i| (0..size).map(|j| signed(i, j)).collect()).collect();
    let determinant = determinant(matrix);
    (!determinant.is_zero()).then_some((adjugate, determinant))
}

/// The determinant by expansion along the first row.
fn determinant(matrix: &[Vec<Poly>]) -> Poly {
    let Some(first) = matrix.first() else { return Poly::one() };
    let terms = first.iter().enumerate().filter(|(_, entry)| !entry.is_zero());
    let terms = terms.map(|(column, entry)| {
        let term = entry * &determinant(&minor(matrix, 0, column));
        if column.is_multiple_of(2) { term } else { -term }
    });
    terms.sum()
}

/// The matrix without a row and a column.
fn minor(matrix: &[Vec<Poly>], row: usize, column: usize) -> Vec<Vec<Poly>> {
    let without = |line: &Vec<Poly>| {
        line.iter().enumerate().filter(|(j, _)| *j != column).map(|(_, entry)| entry.clone()).collect()
    };
    matrix.iter().enumerate().filter(|(i, _)| *i != row).map(|(_, line)| without(line)).collect()
}

fn transposed(vectors: &[Vec<Poly>]) -> Vec<Vec<Poly>> {
    let length = vectors.first().map_or(0, Vec::len);
    (0..length).map(|i| vectors.iter().map(|vector| vector[i].clone()).collect()).collect()
}

#[cfg(test)]
mod tests {
    use hodograph_algebra::{Poly, integer};

    use super::{combine, coordinates, independent, reduce, relations};

    fn rows(entries: &[&[i64]]) -> Vec<Vec<Poly>> {
        entries.iter().map(|row| row.iter().map(|&entry| Poly::integer(entry)).collect()).collect()
    }

    #[test]
    fn reduced_forms_and_ranks() {
        let matrix = rows(&[&[0, 2, 4], &[1, 1, 1], &[1, 2, 3]]);
        assert_eq!(reduce(matrix.clone()), (rows(&[&[1, 0, -1], &[0, 1, 2]]), vec![0, 1]));
        assert_eq!(independent(&matrix), [0, 1]);
        assert!(independent(&[]).is_empty());
    }

    #[test]
    fn combinations_and_relations() {
        let vectors = rows(&[&[1, 0, 1], &[0, 1, 1], &[1, 1, 2]]);
        let target = [Poly::integer(3), Poly::integer(4), Poly::integer(7)];
        let found = combine(&vectors, &target).map(|c| c.iter().map(Poly::to_string).collect::<Vec<_>>());
        assert_eq!(found, Some(vec!["3".to_string(), "4".to_string(), "0".to_string()]));
        assert_eq!(combine(&vectors, &[Poly::one(), Poly::zero(), Poly::zero()]), None);
        assert_eq!(relations(&vectors), rows(&[&[-1, -1, 1]]));
        assert_eq!(
            coordinates(&vectors[..2], &[target.to_vec(), vectors[2].clone()]),
            rows(&[&[3, 4], &[1, 1]])
        );
    }

    #[test]
    fn radicals_are_numbers_too() {
        let root = Poly::sqrt_of(&integer(2));
        let matrix = vec![vec![root.clone(), Poly::integer(2)], vec![Poly::one(), root]];
        assert_eq!(independent(&matrix), [0]);
    }
}
