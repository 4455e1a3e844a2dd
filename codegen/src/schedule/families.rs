//! Separation of polynomials whose coefficients have symbols.
//!
//! Over the field of fractions in the symbols the linear algebra of `separate.rs` would divide by large polynomials.
//! But which basis f_1, …, f_r to take can be seen from members of the family: the symbols are replaced by numbers, a
//! basis is found there, and then proved for the family by exact division. In this order, a basis is
//!
//! 1. made of polynomials that have names, and products of two of them;
//! 2. what two members agree on, if the polynomials in u have no symbols that matter (a profile given by numbers);
//! 3. the cofactors of such a basis in v (a symbolic profile whose sweep is given by numbers);
//! 4. the powers of u, which always are one.

use hodograph_algebra::{Poly, Rational, Variable, integer, ratio};

use super::linear;
use super::quotient::proportional;
use super::separate::{Parameters, Separation};

/// The separation of polynomials with symbols, for division by the weight A(u)·B(v).
///
/// `known` are polynomials that may be worth having in the basis.
pub(super) fn separate(
    polys: &[Poly],
    weight: &(Poly, Poly),
    parameters: &Parameters,
    known: &[Poly],
) -> Separation {
    let all = polys.iter().chain([&weight.0, &weight.1]).chain(known);
    let family = Family { polys, weight, parameters, symbols: symbols(all, parameters) };
    family
        .of_known(known)
        .or_else(|| family.of_numbers())
        .or_else(|| family.of_cofactors())
        .unwrap_or_else(|| family.of_powers())
}

/// The variables that are no parameters.
pub(super) fn symbols<'a>(
    polys: impl IntoIterator<Item = &'a Poly>,
    parameters: &Parameters,
) -> Vec<Variable> {
    let mut symbols: Vec<Variable> = polys.into_iter().flat_map(Poly::occurring_variables).collect();
    symbols.retain(|variable| *variable != parameters.u && *variable != parameters.v);
    symbols.sort();
    symbols.dedup();
    symbols
}

struct Family<'a> {
    polys: &'a [Poly],
    weight: &'a (Poly, Poly),
    parameters: &'a Parameters,
    symbols: Vec<Variable>,
}

impl Family<'_> {
    /// A member of the family: its polynomials with numbers for the symbols.
    fn member(&self, seed: i64, polys: &[Poly]) -> Vec<Poly> {
        let values: Vec<Rational> = (0..self.symbols.len() as i64)
            .map(|place| ratio(2 + (place * 7 + seed * 5) % 11, 1 + (place * 3 + seed) % 5) + integer(place))
            .collect();
        let point: Vec<(&Variable, &Rational)> = self.symbols.iter().zip(&values).collect();
        polys.iter().map(|poly| poly.at(&point)).collect()
    }

    /// A basis without symbols that two members of the family have in common.
    fn of_numbers(&self) -> Option<Separation> {
        let basis = |seed| -> Option<Vec<Poly>> {
            let weight = self.member(seed, &[self.weight.0.clone(), self.weight.1.clone()]);
            let [a, b] = <[Poly; 2]>::try_from(weight).ok()?;
            if a.is_zero() || b.is_zero() {
                return None;
            }
            let separation =
                Separation::new(&self.member(seed, self.polys), Some(&(a, b)), self.parameters, &[]);
            Some(separation.basis.iter().map(Poly::normalized).collect())
        };
        let first = basis(1)?;
        if first != basis(2)? {
            return None;
        }
        self.with_basis(&first)
    }

    /// A basis of known polynomials and products of two of them.
    fn of_known(&self, known: &[Poly]) -> Option<Separation> {
        let (u, v) = (&self.parameters.u, &self.parameters.v);
        let length = self.polys.iter().filter_map(|poly| poly.degree(u)).max()? as usize + 1;
        let known: Vec<&Poly> = known.iter().filter(|poly| poly.contains(u) && !poly.contains(v)).collect();
        let mut candidates = vec![self.weight.0.clone()];
        candidates.extend(known.iter().map(|&poly| poly.clone()));
        for (place, &a) in known.iter().enumerate() {
            candidates.extend(known[place..].iter().map(|&b| a * b));
        }
        candidates.push(Poly::one());
        candidates.retain(|poly| poly.degree(u).is_some_and(|degree| (degree as usize) < length));
        let row = |poly: &Poly| row(poly, u, length);
        let members: Vec<Vec<Poly>> = self.member(1, &candidates).iter().map(row).collect();
        let space = |poly: &Poly| linear::reduce(poly.coefficients(v).iter().map(row).collect()).0;
        let mut spaces: Vec<Vec<Vec<Poly>>> = self.member(1, self.polys).iter().map(space).collect();
        spaces.sort_by_key(Vec::len);
        // What the smallest space consists of first: its polynomials leave the fewest choices.
        let (mut basis, mut rows): (Vec<Poly>, Vec<Vec<Poly>>) = (Vec::new(), Vec::new());
        for space in spaces {
            let mut within = candidates.iter().zip(&members);
            let spans = |rows: &[Vec<Poly>]| space.iter().all(|row| linear::combine(rows, row).is_some());
            while !spans(&rows) {
                let (candidate, member) = within.find(|(_, member)| {
                    linear::combine(&space, member).is_some() && linear::combine(&rows, member).is_none()
                })?;
                basis.push(candidate.clone());
                rows.push(member.clone());
            }
        }
        self.with_basis(&basis)
    }

    /// The cofactors of a basis of polynomials in v without symbols.
    fn of_cofactors(&self) -> Option<Separation> {
        let parameters = Parameters { u: self.parameters.v.clone(), v: self.parameters.u.clone() };
        let weight = (self.weight.1.clone(), self.weight.0.clone());
        let turned = Family {
            polys: self.polys,
            weight: &weight,
            parameters: &parameters,
            symbols: self.symbols.clone(),
        };
        let turned = turned.of_numbers()?;
        let mut basis: Vec<Poly> = Vec::new();
        for cofactor in turned.cofactors.iter().flatten().filter(|cofactor| !cofactor.is_zero()) {
            if !basis.iter().any(|known| proportional(known, cofactor)) {
                basis.push(cofactor.clone());
            }
        }
        let cofactor = |row: &Vec<Poly>, f: &Poly| -> Poly {
            let terms = row.iter().zip(&turned.basis).filter(|(cofactor, _)| proportional(f, cofactor));
            terms.map(|(cofactor, g)| super::quotient::ratio_of(cofactor, f) * g).sum()
        };
        let cofactors =
            turned.cofactors.iter().map(|row| basis.iter().map(|f| cofactor(row, f)).collect()).collect();
        Some(Separation { basis, cofactors })
    }

    /// The powers of u as the basis.
    fn of_powers(&self) -> Separation {
        let u = &self.parameters.u;
        let length =
            self.polys.iter().filter_map(|poly| poly.degree(u)).max().map_or(0, |degree| degree as usize + 1);
        let basis = (0..length as u32).map(|power| Poly::variable(u).pow(power)).collect();
        let cofactors = self.polys.iter().map(|poly| row(poly, u, length)).collect();
        Separation { basis, cofactors }
    }

    /// The separation with this basis, if it is one for the whole family.
    ///
    /// Which elements of the basis a polynomial needs is seen from a member. In as many powers of u as they are, their
    /// cofactors are determined by Cramer's rule; then all other powers are compared.
    fn with_basis(&self, basis: &[Poly]) -> Option<Separation> {
        let (u, v) = (&self.parameters.u, &self.parameters.v);
        let length = self.polys.iter().chain(basis).filter_map(|poly| poly.degree(u)).max()? as usize + 1;
        let members: Vec<Vec<Poly>> = self.member(1, basis).iter().map(|poly| row(poly, u, length)).collect();
        if linear::independent(&members).len() != basis.len() {
            return None;
        }
        let mut cofactors = Vec::new();
        for (poly, member) in self.polys.iter().zip(self.member(1, self.polys)) {
            let columns = member.coefficients(v);
            let numbers = columns.iter().map(|column| linear::combine(&members, &row(column, u, length)));
            let numbers = numbers.collect::<Option<Vec<Vec<Poly>>>>()?;
            let needed: Vec<usize> =
                (0..basis.len()).filter(|&k| numbers.iter().any(|number| !number[k].is_zero())).collect();
            let mut own = vec![Poly::zero(); basis.len()];
            for (&k, cofactor) in needed.iter().zip(self.cofactors(poly, basis, &needed, length)?) {
                own[k] = cofactor;
            }
            cofactors.push(own);
        }
        let mut separation = Separation { basis: basis.to_vec(), cofactors };
        separation.scale(&self.weight.0, &self.weight.1);
        Some(separation)
    }

    /// The cofactors of the `needed` elements of the basis in a polynomial, if there are such.
    fn cofactors(&self, poly: &Poly, basis: &[Poly], needed: &[usize], length: usize) -> Option<Vec<Poly>> {
        let u = &self.parameters.u;
        let elements: Vec<Poly> = needed.iter().map(|&k| basis[k].clone()).collect();
        let vectors: Vec<Vec<Poly>> = elements.iter().map(|element| row(element, u, length)).collect();
        let members: Vec<Vec<Poly>> =
            self.member(1, &elements).iter().map(|element| row(element, u, length)).collect();
        let powers: Vec<Vec<Poly>> =
            (0..length).map(|power| members.iter().map(|vector| vector[power].clone()).collect()).collect();
        let pivots = linear::independent(&powers);
        let entries = |power: usize| vectors.iter().map(|vector| vector[power].clone()).collect();
        let matrix: Vec<Vec<Poly>> = pivots.iter().map(|&power| entries(power)).collect();
        let (adjugate, determinant) = linear::adjugate(&matrix)?;
        let target = row(poly, u, length);
        let mut cofactors = Vec::new();
        for line in &adjugate {
            let sum: Poly = line.iter().zip(&pivots).map(|(entry, &power)| entry * &target[power]).sum();
            cofactors.push(sum.exact_div(&determinant)?);
        }
        let agrees = |power: usize| {
            let sum: Poly = cofactors.iter().zip(&vectors).map(|(cofactor, f)| cofactor * &f[power]).sum();
            sum == target[power]
        };
        (0..length).filter(|power| !pivots.contains(power)).all(agrees).then_some(cofactors)
    }
}

/// The coefficients of 1, u, u², …, as many as `length`.
fn row(poly: &Poly, u: &Variable, length: usize) -> Vec<Poly> {
    let mut row = poly.coefficients(u);
    row.resize(length, Poly::zero());
    row
}
