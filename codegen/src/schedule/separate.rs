//! Exact separation of variables: the fewest terms f(u)·g(v) that several polynomials are sums of.
//!
//! Write the coefficients of the polynomials p_c = Σ m_{i,(c,j)} u^i v^j as one matrix with a row for each power of u
//! and a column for each power of v of each polynomial. A factorization M = F·G through its rank r gives polynomials
//! f_k(u) and g_{c,k}(v), k < r, with p_c = Σ_k f_k·g_{c,k}, and no fewer terms do. Which basis f_1, …, f_r of the
//! column space is chosen decides what the terms cost. Polynomials that will be divided by a weight A(u)·B(v) get the
//! basis that makes most of the quotients (f_k/A)·(g_{c,k}/B) simple: as many f_k as possible multiples of A, and
//! their g_{c,k} multiples of B.

use hodograph_algebra::{Poly, Variable};

use super::families::{self, symbols};
use super::linear;
use super::quotient::{proportional, ratio_of, remainder};
use crate::round::power_of_size;

/// The parameters u and v of a surface.
#[derive(Clone, Debug)]
pub(super) struct Parameters {
    pub(super) u: Variable,
    pub(super) v: Variable,
}

/// Polynomials p_c(u, v) = Σ_k `basis[k]`(u) · `cofactors[c][k]`(v).
#[derive(Clone, Debug)]
pub(super) struct Separation {
    pub(super) basis: Vec<Poly>,
    pub(super) cofactors: Vec<Vec<Poly>>,
}

impl Separation {
    /// The separation of `polys` of least rank, for division by the weight A(u)·B(v) where there is one.
    ///
    /// If there are symbols, polynomials among the `known` ones are taken into the basis where that is possible.
    pub(super) fn new(
        polys: &[Poly],
        weight: Option<&(Poly, Poly)>,
        parameters: &Parameters,
        known: &[Poly],
    ) -> Separation {
        let one = (Poly::one(), Poly::one());
        let weight = weight.unwrap_or(&one);
        let (a, b) = weight;
        if !symbols(polys.iter().chain([a, b]), parameters).is_empty() {
            return families::separate(polys, weight, parameters, known);
        }
        let mut separation = with_basis(polys, &choose_basis(polys, a, parameters), parameters);
        separation.simplify_cofactors(a, b, parameters);
        separation.scale(a, b);
        separation
    }

    /// Changes the basis so that the cofactors of multiples of A become multiples of B where that can be; numbers, where
    /// B is a number.
    ///
    /// Since Σ f_k g_k = f_a (g_a − Σ c_k g_k) + f_k (…), adding c_k f_a to each other f_k takes Σ c_k g_k off g_a.
    fn simplify_cofactors(&mut self, a: &Poly, b: &Poly, parameters: &Parameters) {
        if b.is_constant() && a.is_constant() {
            return;
        }
        let degrees = self.cofactors.iter().flatten().filter_map(|g| g.degree(&parameters.v));
        let length = degrees.max().map_or(0, |degree| degree as usize + 1);
        let residue = |g: &Poly| {
            if !b.is_constant() {
                return remainder(g, b, &parameters.v);
            }
            let mut coefficients = g.coefficients(&parameters.v);
            coefficients.resize(length, Poly::zero());
            coefficients.into_iter().skip(1).collect()
        };
        let residues = |separation: &Separation, k: usize| -> Vec<Poly> {
            separation.cofactors.iter().flat_map(|row| residue(&row[k])).collect()
        };
        for place in 0..self.basis.len() {
            let target = residues(self, place);
            if self.basis[place].exact_div(a).is_none() || target.iter().all(Poly::is_zero) {
                continue;
            }
            let others: Vec<usize> = (0..self.basis.len()).filter(|&k| k != place).collect();
            let vectors: Vec<Vec<Poly>> = others.iter().map(|&k| residues(self, k)).collect();
            let Some(numbers) = linear::combine(&vectors, &target) else { continue };
            for (&k, number) in others.iter().zip(&numbers) {
                if number.is_zero() {
                    continue;
                }
                self.basis[k] = &self.basis[k] + &(number * &self.basis[place]);
                for row in &mut self.cofactors {
                    row[place] = &row[place] - &(number * &row[k]);
                }
            }
        }
    }

    /// Scales each f_k: to A where it is a multiple, to take in a cofactor that is a multiple of B and the only one, and
    /// otherwise to coprime integer coefficients where it has rational ones.
    pub(super) fn scale(&mut self, a: &Poly, b: &Poly) {
        for k in 0..self.basis.len() {
            let mut cofactors = self.cofactors.iter().map(|row| &row[k]).filter(|poly| !poly.is_zero());
            let factor = match (cofactors.next(), cofactors.next()) {
                _ if proportional(&self.basis[k], a) => ratio_of(a, &self.basis[k]),
                (Some(only), None) if proportional(only, b) => ratio_of(only, b),
                _ => {
                    let scaled = self.basis[k].normalized();
                    let lowest = scaled.terms().last().map(|term| term.coefficient < 0.into());
                    // Floats hold the coefficients, if they are large too.
                    let size = power_of_size(std::slice::from_ref(&scaled));
                    let factor = ratio_of(&scaled, &self.basis[k]).scale(&size.recip());
                    if lowest == Some(true) { -factor } else { factor }
                }
            };
            let inverse = factor.inverse();
            self.basis[k] = &self.basis[k] * &factor;
            for row in &mut self.cofactors {
                row[k] = &row[k] * &inverse;
            }
        }
    }
}

/// The factors A(u) and B(v) of a weight that is their product; `None` if it is not such a product.
pub(super) fn split_weight(weight: &Poly, parameters: &Parameters) -> Option<(Poly, Poly)> {
    let columns = weight.coefficients(&parameters.v);
    let column = columns.iter().find(|column| !column.is_zero())?;
    // Symbols that are a factor of the whole column belong to B.
    let column = column.primitive_in(&parameters.u).normalized();
    let cofactor = weight.exact_div(&column)?;
    (!cofactor.contains(&parameters.u)).then_some((column, cofactor))
}

/// Independent polynomials in u that span all coefficients of powers of v, those of the simplest polynomials first, and
/// of each of them the multiples of `a` first.
fn choose_basis(polys: &[Poly], a: &Poly, parameters: &Parameters) -> Vec<Poly> {
    let length =
        polys.iter().filter_map(|poly| poly.degree(&parameters.u)).max().map_or(0, |d| d as usize + 1);
    let row = |poly: &Poly| {
        let mut row = poly.coefficients(&parameters.u);
        row.resize(length, Poly::zero());
        row
    };
    let mut spaces: Vec<Vec<Vec<Poly>>> = polys
        .iter()
        .map(|poly| linear::reduce(poly.coefficients(&parameters.v).iter().map(row).collect()).0)
        .collect();
    spaces.sort_by_key(Vec::len);
    let poly = |row: &[Poly]| Poly::from_coefficients(&parameters.u, row);
    let mut candidates: Vec<Vec<Poly>> = Vec::new();
    for space in spaces {
        let residues: Vec<Vec<Poly>> =
            space.iter().map(|row| remainder(&poly(row), a, &parameters.u)).collect();
        let multiple = |relation: &Vec<Poly>| -> Vec<Poly> {
            (0..length)
                .map(|i| relation.iter().zip(&space).map(|(number, row)| number * &row[i]).sum())
                .collect()
        };
        let multiples = if a.is_constant() {
            Vec::new()
        } else {
            linear::reduce(linear::relations(&residues).iter().map(multiple).collect()).0
        };
        candidates.extend(multiples.into_iter().chain(space));
    }
    linear::independent(&candidates).into_iter().map(|place| poly(&candidates[place])).collect()
}

/// The separation with the given basis, which spans what it must.
fn with_basis(polys: &[Poly], basis: &[Poly], parameters: &Parameters) -> Separation {
    let length =
        basis.iter().filter_map(|poly| poly.degree(&parameters.u)).max().map_or(0, |d| d as usize + 1);
    let row = |poly: &Poly| {
        let mut row = poly.coefficients(&parameters.u);
        row.resize(length, Poly::zero());
        row
    };
    let columns: Vec<Vec<Poly>> = polys.iter().map(|poly| poly.coefficients(&parameters.v)).collect();
    let vectors: Vec<Vec<Poly>> = basis.iter().map(row).collect();
    let targets: Vec<Vec<Poly>> = columns.iter().flatten().map(row).collect();
    let mut numbers = linear::coordinates(&vectors, &targets).into_iter();
    let cofactors = columns.iter().map(|columns| {
        let numbers: Vec<Vec<Poly>> = numbers.by_ref().take(columns.len()).collect();
        let cofactor = |k: usize| {
            let column: Vec<Poly> = numbers.iter().map(|numbers| numbers[k].clone()).collect();
            Poly::from_coefficients(&parameters.v, &column)
        };
        (0..basis.len()).map(cofactor).collect()
    });
    Separation { cofactors: cofactors.collect(), basis: basis.to_vec() }
}

#[cfg(test)]
mod tests {
    use hodograph_algebra::{Poly, Variable};

    use super::{Parameters, Separation, split_weight};

    fn parameters() -> Parameters {
        Parameters { u: Variable::new(0, "u"), v: Variable::new(1, "v") }
    }

    fn sums(separation: &Separation) -> Vec<Poly> {
        let sum = |row: &Vec<Poly>| row.iter().zip(&separation.basis).map(|(g, f)| g * f).sum();
        separation.cofactors.iter().map(sum).collect()
    }

    fn texts(polys: &[Poly]) -> Vec<String> {
        polys.iter().map(Poly::to_string).collect()
    }

    #[test]
    fn the_profile_of_a_translation_is_found_again() {
        // X = (1 + u²)·σx + (1 − u²)·y' with σ = v² + 1, x = v³ + 2, y' = 2v, and Z = 2uσ.
        let parameters = parameters();
        let (u, v) = (Poly::variable(&parameters.u), Poly::variable(&parameters.v));
        let (plus, minus) = (Poly::one() + u.pow(2), Poly::one() - u.pow(2));
        let (sigma, x) = (v.pow(2) + Poly::one(), v.pow(3) + Poly::integer(2));
        let polys = [
            &plus * &sigma * &x + &minus * &v * Poly::integer(2),
            &plus * &sigma * &v + &minus * (v.pow(2) - Poly::one()),
            Poly::integer(2) * &u * &sigma,
        ];
        let weight = split_weight(&(&plus * &sigma), &parameters).unwrap();
        assert_eq!(texts(&[weight.0.clone(), weight.1.clone()]), ["u^2 + 1", "v^2 + 1"]);
        let separation = Separation::new(&polys, Some(&weight), &parameters, &[]);
        assert_eq!(sums(&separation), polys);
        assert_eq!(texts(&separation.basis), ["2*u", "u^2 + 1", "-u^2 + 1"]);
        assert_eq!(separation.cofactors[0][1], &sigma * &x);
        assert_eq!(separation.cofactors[0][2], Poly::integer(2) * &v);
    }

    #[test]
    fn weights_that_are_no_products_are_told_apart() {
        let parameters = parameters();
        let (u, v) = (Poly::variable(&parameters.u), Poly::variable(&parameters.v));
        assert!(split_weight(&(Poly::one() + &u * &v), &parameters).is_none());
        let (a, b) = split_weight(&((&u + Poly::one()) * (&v - Poly::integer(3))), &parameters).unwrap();
        assert_eq!(texts(&[a, b]), ["u + 1", "v - 3"]);
    }

    #[test]
    fn separation_has_the_rank_of_the_coefficients() {
        let parameters = parameters();
        let (u, v) = (Poly::variable(&parameters.u), Poly::variable(&parameters.v));
        let polys = [(&u + &v).pow(3), Poly::zero(), &u * &v];
        let separation = Separation::new(&polys, None, &parameters, &[]);
        assert_eq!(separation.basis.len(), 4);
        assert_eq!(sums(&separation), polys);
        assert!(Separation::new(&[Poly::zero()], None, &parameters, &[]).basis.is_empty());
    }
}
