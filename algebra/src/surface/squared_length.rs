//! The squared length of a normal, and whether it is a square.

use crate::{Poly, Rational, SquareSplit, Variable, budget, integer, ratio};

/// `|N|²` for a vector N of polynomials: is it the square of a polynomial?
///
/// It is written out where that is of a sensible size. The square of a normal with many symbols can have millions of terms;
/// then a *member* of the family is looked at first, N with numbers for the symbols. If `|N|²` were a square for all
/// symbols, it would be one for these; so a member that has a factor of odd multiplicity proves that there is no root.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct SquaredLength {
    vector: [Poly; 3],
    expanded: Option<Poly>,
    split: SquareSplit,
    radicand: Poly,
    member: Vec<(Variable, Rational)>,
}

/// The number of products of terms up to which a squared length is written out at once.
const LARGE: usize = 1_000_000;

impl SquaredLength {
    /// The squared length of `vector`, whose components have the `parameters` and perhaps symbols.
    pub(crate) fn of(vector: &[Poly; 3], parameters: &[Variable; 2]) -> SquaredLength {
        let products: usize =
            vector.iter().map(|component| component.terms().len().saturating_pow(2) / 2).sum();
        if products > LARGE
            && let Some(length) = (1..=3).find_map(|seed| irrational_member(vector, parameters, seed))
        {
            return length;
        }
        let expanded: Poly = vector.iter().map(|component| component * component).sum();
        let mut split = budget::doing("the square root of |R_u x R_v|^2", || expanded.square_split());
        // Factors in the symbols alone are numbers, as far as the parameters go.
        let mut radicand = Poly::one();
        for (part, _) in split.odd.squarefree().factors {
            if !parameters.iter().any(|parameter| part.contains(parameter)) {
                split.odd = split.odd.exact_div(&part).unwrap_or(split.odd);
                radicand *= part;
            }
        }
        let vector = vector.clone();
        SquaredLength { vector, expanded: Some(expanded), split, radicand, member: Vec::new() }
    }

    /// `|N|²` as a polynomial; `None` where it is too large to be of use, and a member proves that it is no square.
    #[must_use]
    pub fn expanded(&self) -> Option<&Poly> {
        self.expanded.as_ref()
    }

    /// The squared length as `unit · root² · odd`, up to [`SquaredLength::radicand`]; that of a member if there are values
    /// in [`SquaredLength::member`].
    #[must_use]
    pub fn split(&self) -> &SquareSplit {
        &self.split
    }

    /// The factor of odd multiplicity that is free of the parameters: a polynomial in the symbols, 1 if there is none. The
    /// squared length is `unit · radicand · root² · odd`.
    #[must_use]
    pub fn radicand(&self) -> &Poly {
        &self.radicand
    }

    /// The values of the symbols for which it has been split; none if it has been split for all values.
    #[must_use]
    pub fn member(&self) -> &[(Variable, Rational)] {
        &self.member
    }

    /// `|N|²` as a sum of squares, not multiplied out: `(x)^2 + (y)^2 + (z)^2`.
    #[must_use]
    pub fn sum_of_squares(&self) -> String {
        self.vector.each_ref().map(|component| format!("({component})^2")).join(" + ")
    }

    /// The same with `map`, a homomorphism that keeps the parameters, applied to all polynomials.
    pub(crate) fn map(&self, mut map: impl FnMut(&Poly) -> Poly) -> SquaredLength {
        SquaredLength {
            vector: self.vector.each_ref().map(&mut map),
            expanded: self.expanded.as_ref().map(&mut map),
            split: SquareSplit {
                unit: map(&self.split.unit),
                root: map(&self.split.root),
                odd: map(&self.split.odd),
            },
            radicand: map(&self.radicand),
            member: self.member.clone(),
        }
    }
}

/// The squared length of a member, if it is no square.
fn irrational_member(vector: &[Poly; 3], parameters: &[Variable; 2], seed: i64) -> Option<SquaredLength> {
    let mut symbols: Vec<Variable> = vector.iter().flat_map(Poly::occurring_variables).collect();
    symbols.retain(|variable| !parameters.contains(variable));
    symbols.sort();
    symbols.dedup();
    let value = |place: i64| integer((place * place + 3 * place + seed) % 7 - 3) + ratio(1, 2 + seed);
    let member: Vec<(Variable, Rational)> =
        (0..).map(value).zip(symbols).map(|(value, symbol)| (symbol, value)).collect();
    let point: Vec<(&Variable, &Rational)> = member.iter().map(|(symbol, value)| (symbol, value)).collect();
    let square: Poly =
        vector.iter().map(|component| component.at(&point)).map(|component| &component * &component).sum();
    if square.is_zero() {
        return None;
    }
    let split = square.square_split();
    let split = SquareSplit { odd: split.odd.primitive(), ..split };
    let irrational = !split.odd.is_one() && !split.odd.is_constant();
    let vector = vector.clone();
    irrational.then(|| SquaredLength { vector, expanded: None, split, radicand: Poly::one(), member })
}

#[cfg(test)]
mod tests {
    use super::{SquaredLength, irrational_member};
    use crate::{Poly, Variable};

    #[test]
    fn members_prove_that_there_is_no_root() {
        let parameters = [Variable::new(0, "u"), Variable::new(1, "v")];
        let [u, v] = parameters.each_ref().map(Poly::variable);
        let a = Poly::variable(&Variable::new(Variable::SYMBOL, "a"));
        let rational = [&a * &u, &a * &v, Poly::zero()];
        assert!(irrational_member(&rational, &parameters, 1).is_some());
        // (u² − a²)² + (2au)² = (u² + a²)²
        let square = [u.pow(2) - a.pow(2), Poly::integer(2) * &a * &u, Poly::zero()];
        assert_eq!(irrational_member(&square, &parameters, 1), None);
        let length = SquaredLength::of(&square, &parameters);
        assert!(length.split().is_square() && length.member().is_empty());
        assert_eq!(length.expanded(), Some(&(u.pow(2) + a.pow(2)).pow(2)));
    }
}
