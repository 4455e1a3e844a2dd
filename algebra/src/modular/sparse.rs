//! Sparse interpolation of gcds whose monomials are known.

use super::field::{PrimeField, Residue};
use super::multivariate::{Layout, Multivariate, powers};
use super::univariate::Univariate;
use crate::budget;

/// The monomials of a gcd, as one image showed them, ready to find the coefficients of further images.
///
/// Zippel's idea (*Probabilistic algorithms for sparse polynomials*, 1979): where the monomials are known, the
/// coefficients solve linear systems, with one equation for each image in the first variable x alone. The other
/// variables are replaced by the powers of one point, so that the systems are transposed Vandermonde ones, whose inverse
/// is computed once. Where the leading coefficient in x has several terms, the images in x are known up to its values
/// only, and one block of coefficients is found together with it (de Kleine, Monagan, Wittkopf, *Algorithms for the
/// non-monic case of the sparse modular GCD algorithm*, 2005).
#[derive(Clone, Debug)]
pub(crate) struct Skeleton {
    /// The monomials by descending power of x.
    blocks: Vec<Block>,
    /// The values at the point of the operands' monomials, with their power of x.
    operands: [Vec<(usize, Residue)>; 2],
    /// How many images in x one interpolation takes.
    count: usize,
}

/// The monomials of the gcd with the same power of x.
#[derive(Clone, Debug)]
struct Block {
    degree: usize,
    words: Vec<u128>,
    /// The values of the monomials without x at the point.
    nodes: Vec<Residue>,
    /// The inverse of the matrix of the powers 1, 2, … of the nodes.
    inverse: Vec<Vec<Residue>>,
}

impl Skeleton {
    /// Prepares the interpolation of gcds with the monomials of `image`, of operands with the monomials `words`.
    ///
    /// `point` has a value for each variable. `None` if the nodes coincide or the gcd is free of the first variable.
    pub(crate) fn new(
        field: &PrimeField,
        layout: &Layout,
        image: &Multivariate,
        words: [&[u128]; 2],
        point: &[Residue],
    ) -> Option<Self> {
        let all =
            words.iter().flat_map(|words| words.iter()).chain(image.terms().iter().map(|(word, _)| word));
        let mut highest = vec![0; layout.len()];
        for &word in all {
            highest.iter_mut().enumerate().for_each(|(i, most)| *most = layout.exponent(word, i).max(*most));
        }
        let tables: Vec<Vec<Residue>> =
            (0..layout.len()).map(|i| powers(field, point[i], highest[i])).collect();
        let value = |word: u128| {
            let powers = (1..layout.len()).map(|i| tables[i][layout.exponent(word, i) as usize]);
            powers.fold(field.one(), |product, power| field.mul(product, power))
        };
        let degree = |word: u128| layout.exponent(word, 0) as usize;
        let groups = image.terms().chunk_by(|a, b| degree(a.0) == degree(b.0));
        let block = |group: &[(u128, Residue)]| {
            let words: Vec<u128> = group.iter().map(|term| term.0).collect();
            Block::new(field, degree(words[0]), words.iter().map(|&word| value(word)).collect(), words)
        };
        let blocks = groups.map(block).collect::<Option<Vec<Block>>>()?;
        let leading = blocks.first().filter(|block| block.degree > 0)?.words.len();
        let largest = blocks[1..].iter().map(|block| block.words.len()).max().unwrap_or(0);
        let smallest = blocks[1..].iter().map(|block| block.words.len()).min();
        let coupled = if leading == 1 { 0 } else { smallest? + leading - 1 };
        let operands = words.map(|words| words.iter().map(|&word| (degree(word), value(word))).collect());
        // One more image than there are unknowns shows when the monomials are not those of the gcd.
        Some(Self { blocks, operands, count: largest.max(coupled) + 1 })
    }

    /// An estimate of the work for one image, in the units of [`budget`].
    pub(crate) fn cost(&self) -> u64 {
        let [a, b] = &self.operands;
        let degree = |terms: &[(usize, Residue)]| terms.iter().map(|term| term.0).max().unwrap_or(0);
        let solving: usize = self.blocks.iter().map(|block| block.words.len().pow(2)).sum();
        let coupled = if self.blocks[0].words.len() > 1 { self.count.pow(3) / 3 } else { 0 };
        (self.count * (a.len() + b.len() + degree(a) * degree(b)) + solving + coupled) as u64
    }

    /// The gcd, with leading coefficient 1, of the operands with these coefficients for their monomials; `None` if it
    /// does not have the expected monomials, or is not determined by its images in x up to their leading coefficient.
    pub(crate) fn image(&self, field: &PrimeField, coefficients: [&[Residue]; 2]) -> Option<Multivariate> {
        budget::spend(self.cost());
        let leading = &self.blocks[0];
        let images = self.univariate_images(field, coefficients)?;
        let coupled = if leading.words.len() == 1 {
            vec![field.one()]
        } else {
            self.leading_coefficients(field, &images)?
        };
        // The values of the leading coefficient at the powers of the point turn monic images into those of the gcd.
        let scales = weighted_power_sums(field, &coupled, &leading.nodes, self.count);
        let mut terms: Vec<(u128, Residue)> = leading.words.iter().copied().zip(coupled).collect();
        for block in &self.blocks[1..] {
            let values: Vec<Residue> = images
                .iter()
                .zip(&scales)
                .map(|(image, &scale)| field.mul(coefficient(image, block.degree), scale))
                .collect();
            let solution = block.solve(field, &values);
            if weighted_power_sums(field, &solution, &block.nodes, self.count) != values {
                return None;
            }
            terms.extend(block.words.iter().copied().zip(solution));
        }
        Some(Multivariate::new(field, terms))
    }

    /// The monic gcds in x at the powers 1, …, `count` of the point.
    fn univariate_images(
        &self,
        field: &PrimeField,
        coefficients: [&[Residue]; 2],
    ) -> Option<Vec<Univariate>> {
        let mut current = coefficients.map(<[Residue]>::to_vec);
        let degrees = [0, 1].map(|k: usize| {
            let present = self.operands[k].iter().zip(coefficients[k]).filter(|(_, value)| !value.is_zero());
            present.map(|((degree, _), _)| *degree).max().unwrap_or(0)
        });
        let mut images = Vec::with_capacity(self.count);
        for _ in 0..self.count {
            let [a, b] = [0, 1].map(|k: usize| {
                let mut image = vec![Residue::ZERO; degrees[k] + 1];
                for (value, &(degree, node)) in current[k].iter_mut().zip(&self.operands[k]) {
                    if !value.is_zero() {
                        *value = field.mul(*value, node);
                        image[degree] = field.add(image[degree], *value);
                    }
                }
                Univariate::new(image)
            });
            let image = a.gcd(field, &b);
            if a.degree() != degrees[0] || b.degree() != degrees[1] || image.degree() != self.blocks[0].degree
            {
                return None;
            }
            // Powers of x without monomials must not occur.
            let expected = |degree: usize| self.blocks.iter().any(|block| block.degree == degree);
            let mut occurring = image.coefficients().iter().enumerate().filter(|(_, value)| !value.is_zero());
            if !occurring.all(|(degree, _)| expected(degree)) {
                return None;
            }
            images.push(image);
        }
        Some(images)
    }

    /// The coefficients of the leading power of x, the first of which is 1, from the smallest other block:
    /// Σ c_w w(βʲ) = g_j·(w₀(βʲ) + Σ l_w w(βʲ)) for all j, where g_j is the coefficient in the monic image.
    fn leading_coefficients(&self, field: &PrimeField, images: &[Univariate]) -> Option<Vec<Residue>> {
        let leading = &self.blocks[0];
        let block = self.blocks[1..].iter().min_by_key(|block| block.words.len())?;
        let unknowns = block.words.len() + leading.words.len() - 1;
        let (mut own, mut other) = (block.nodes.clone(), leading.nodes.clone());
        let mut rows = Vec::with_capacity(images.len());
        for image in images {
            let value = coefficient(image, block.degree);
            let mut row = own.clone();
            row.extend(other[1..].iter().map(|&power| field.neg(field.mul(value, power))));
            row.push(field.mul(value, other[0]));
            rows.push(row);
            own.iter_mut().zip(&block.nodes).for_each(|(power, &node)| *power = field.mul(*power, node));
            other.iter_mut().zip(&leading.nodes).for_each(|(power, &node)| *power = field.mul(*power, node));
        }
        let solution = solve(field, rows, unknowns)?;
        Some([field.one()].into_iter().chain(solution[block.words.len()..].iter().copied()).collect())
    }
}

impl Block {
    /// Inverts the transposed Vandermonde matrix of the nodes; `None` if two of them are equal.
    fn new(field: &PrimeField, degree: usize, nodes: Vec<Residue>, words: Vec<u128>) -> Option<Self> {
        let linear = |node: Residue| Univariate::new(vec![field.neg(node), field.one()]);
        let one = Univariate::constant(field.one());
        let vanishing = nodes.iter().fold(one, |product, &node| product.mul(field, &linear(node)));
        let row = |&node: &Residue| {
            let (quotient, _) = vanishing.divide(field, &linear(node))?;
            let scale = field.invert(field.mul(node, quotient.evaluate(field, node)))?;
            Some(quotient.scale(field, scale).coefficients().to_vec())
        };
        let inverse = nodes.iter().map(row).collect::<Option<Vec<_>>>()?;
        Some(Self { degree, words, nodes, inverse })
    }

    /// The coefficients cᵢ with Σ cᵢ·nodeᵢʲ = values[j − 1], from as many values as there are nodes.
    fn solve(&self, field: &PrimeField, values: &[Residue]) -> Vec<Residue> {
        let product = |row: &Vec<Residue>| {
            let products = row.iter().zip(values).map(|(&entry, &value)| field.mul(entry, value));
            products.fold(Residue::ZERO, |sum, product| field.add(sum, product))
        };
        self.inverse.iter().map(product).collect()
    }
}

fn coefficient(image: &Univariate, degree: usize) -> Residue {
    image.coefficients().get(degree).copied().unwrap_or_default()
}

/// The sums Σ weightᵢ·nodeᵢʲ for j = 1, …, `count`.
fn weighted_power_sums(
    field: &PrimeField,
    weights: &[Residue],
    nodes: &[Residue],
    count: usize,
) -> Vec<Residue> {
    let mut current = weights.to_vec();
    let next = |_| {
        let mut sum = Residue::ZERO;
        for (value, &node) in current.iter_mut().zip(nodes) {
            *value = field.mul(*value, node);
            sum = field.add(sum, *value);
        }
        sum
    };
    (0..count).map(next).collect()
}

/// The unique solution of a linear system, whose rows end with the right-hand side; `None` if there is not exactly one.
fn solve(field: &PrimeField, mut rows: Vec<Vec<Residue>>, unknowns: usize) -> Option<Vec<Residue>> {
    for column in 0..unknowns {
        let pivot = (column..rows.len()).find(|&i| !rows[i][column].is_zero())?;
        rows.swap(column, pivot);
        let inverse = field.invert(rows[column][column])?;
        let row: Vec<Residue> = rows[column].iter().map(|&value| field.mul(value, inverse)).collect();
        for (i, other) in rows.iter_mut().enumerate() {
            let factor = other[column];
            if i != column && !factor.is_zero() {
                for (target, &value) in other[column..].iter_mut().zip(&row[column..]) {
                    *target = field.sub(*target, field.mul(factor, value));
                }
            }
        }
        rows[column] = row;
    }
    let consistent = rows[unknowns..].iter().all(|row| row[unknowns].is_zero());
    consistent.then(|| rows[..unknowns].iter().map(|row| row[unknowns]).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modular::multivariate::Points;

    fn layout() -> Layout {
        Layout::new(&[7, 7, 7]).unwrap()
    }

    fn polynomial(field: &PrimeField, terms: &[([u32; 3], i64)]) -> Multivariate {
        let terms = terms.iter().map(|(exponents, value)| (layout().pack(exponents), field.residue(*value)));
        Multivariate::new(field, terms.collect())
    }

    fn product(field: &PrimeField, a: &Multivariate, b: &Multivariate) -> Multivariate {
        let pairs =
            a.terms().iter().flat_map(|x| b.terms().iter().map(move |y| (x.0 + y.0, field.mul(x.1, y.1))));
        Multivariate::new(field, pairs.collect())
    }

    /// What the skeleton of `monomials` finds for the gcd of two operands.
    fn interpolate(
        field: &PrimeField,
        monomials: &Multivariate,
        operands: [&Multivariate; 2],
    ) -> Option<Multivariate> {
        let words = operands.map(|poly| poly.terms().iter().map(|term| term.0).collect::<Vec<_>>());
        let values = operands.map(|poly| poly.terms().iter().map(|term| term.1).collect::<Vec<_>>());
        let point = Points::new(field).take(3);
        let skeleton = Skeleton::new(field, &layout(), monomials, [&words[0], &words[1]], &point)?;
        skeleton.image(field, [&values[0], &values[1]])
    }

    fn check(gcd: &[([u32; 3], i64)], determined: bool) {
        let field = PrimeField::sequence().next().unwrap();
        let gcd = polynomial(&field, gcd);
        let a = polynomial(&field, &[([2, 0, 1], 3), ([0, 1, 0], 1), ([0, 0, 0], -7)]);
        let b = polynomial(&field, &[([1, 0, 0], 1), ([0, 2, 1], 5), ([0, 0, 2], 1)]);
        let (x, y) = (product(&field, &gcd, &a), product(&field, &gcd, &b));
        let found = interpolate(&field, &gcd, [&x, &y]);
        assert_eq!(found, determined.then(|| gcd.monic(&field)));
        assert!(found.is_none_or(|found| found == x.gcd(&field, &layout(), &y, &[7, 7, 7])));
        if determined {
            // A monomial too few is noticed.
            let fewer = Multivariate::new(&field, gcd.terms()[..gcd.terms().len() - 1].to_vec());
            assert_eq!(interpolate(&field, &fewer, [&x, &y]), None);
        }
    }

    #[test]
    fn leading_coefficient_of_one_term() {
        check(&[([2, 1, 0], 4), ([1, 0, 2], -1), ([1, 3, 0], 9), ([0, 0, 0], 2), ([0, 1, 1], 1)], true);
    }

    #[test]
    fn leading_coefficient_of_several_terms() {
        check(
            &[([2, 1, 0], 4), ([2, 0, 1], 5), ([2, 0, 0], 1), ([1, 3, 0], 9), ([0, 0, 0], 2), ([0, 1, 1], 1)],
            true,
        );
    }

    #[test]
    fn content_in_the_first_variable_leaves_it_undetermined() {
        // (y + 1)(x² + z + 3): any multiple of x² + z + 3 on these monomials has the same images.
        let terms =
            [([2, 1, 0], 1), ([2, 0, 0], 1), ([0, 1, 1], 1), ([0, 1, 0], 3), ([0, 0, 1], 1), ([0, 0, 0], 3)];
        check(&terms, false);
    }
}
