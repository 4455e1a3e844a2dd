//! Bidegrees.

use std::fmt;

use crate::{Poly, Variable};

/// The degrees of a polynomial, or of a group of polynomials, in the two parameters of a surface.
///
/// The degrees of a group are the componentwise largest. The zero polynomial has the degrees −1, −1.
///
/// # Example
/// ```
/// use hodograph_algebra::{Bidegree, Poly, Variable};
/// let (u, v) = (Variable::new(0, "u"), Variable::new(1, "v"));
/// let f = Poly::variable(&u).pow(2) + Poly::variable(&v).pow(9);
/// assert_eq!(Bidegree::of(&f, &[u, v]).to_string(), "(2, 9)");
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Bidegree {
    /// The degree in the first parameter.
    pub u: i64,
    /// The degree in the second parameter.
    pub v: i64,
}

impl Bidegree {
    /// The degree of the zero polynomial.
    pub const ZERO: Bidegree = Bidegree { u: -1, v: -1 };

    /// The degrees of `poly` in `parameters`.
    #[must_use]
    pub fn of(poly: &Poly, parameters: &[Variable; 2]) -> Bidegree {
        let [u, v] = parameters.each_ref().map(|variable| poly.degree(variable).map_or(-1, i64::from));
        Bidegree { u, v }
    }

    /// The degrees of a group: the componentwise largest.
    #[must_use]
    pub fn of_group<'a>(polys: impl IntoIterator<Item = &'a Poly>, parameters: &[Variable; 2]) -> Bidegree {
        let degrees = polys.into_iter().map(|poly| Bidegree::of(poly, parameters));
        degrees.fold(Bidegree::ZERO, Bidegree::max)
    }

    /// The componentwise largest degrees of both.
    #[must_use]
    pub fn max(self, other: Bidegree) -> Bidegree {
        Bidegree { u: self.u.max(other.u), v: self.v.max(other.v) }
    }
}

impl fmt::Display for Bidegree {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({}, {})", self.u, self.v)
    }
}
