//! Operands of three shapes.

use hodograph_algebra::{Poly, Variable, integer};

use crate::sweeps;

/// Two factors and what is known about them.
pub(crate) struct Operands {
    /// The variables that occur.
    pub(crate) variables: Vec<Variable>,
    /// Two polynomials.
    pub(crate) factors: [Poly; 2],
}

/// The shapes of operands: all monomials up to a degree, few of many, and those of a sweep.
pub(crate) const SHAPES: [&str; 3] = ["dense", "sparse", "geometry"];

/// The operands of a shape.
pub(crate) fn operands(shape: &str) -> Operands {
    match shape {
        "dense" => dense(),
        "sparse" => sparse(),
        _ => geometry(),
    }
}

/// The variables x₁, x₂, ….
pub(crate) fn variables(count: u32) -> Vec<Variable> {
    (0..count).map(|rank| Variable::new(rank, &format!("x{rank}"))).collect()
}

/// `(1 + x + y + z + t)⁸` and 1 more.
fn dense() -> Operands {
    let variables = variables(4);
    let f = (variables.iter().map(Poly::variable).sum::<Poly>() + Poly::one()).pow(8);
    let g = &f + Poly::one();
    Operands { variables, factors: [f, g] }
}

/// `(1 + x + y + 2z² + 3t³ + 5u⁵)⁶`, and the same with the variables in reverse.
fn sparse() -> Operands {
    let variables = variables(5);
    let power = |places: [usize; 5]| {
        let terms = places.iter().zip([(1, 1), (1, 1), (2, 2), (3, 3), (5, 5)]);
        let term = |(&place, (factor, exponent)): (&usize, (i64, u32))| {
            Poly::variable(&variables[place]).pow(exponent).scale(&integer(factor))
        };
        (terms.map(term).sum::<Poly>() + Poly::one()).pow(6)
    };
    let factors = [power([0, 1, 2, 3, 4]), power([4, 3, 2, 1, 0])];
    Operands { variables, factors }
}

/// W and X of the oriented translation along the PH quintic with six symbols.
fn geometry() -> Operands {
    let mut coordinates = sweeps::coordinates(&sweeps::translation());
    let [x, w] = [1, 0].map(|place| coordinates.swap_remove(place));
    Operands { variables: (&w * &x).occurring_variables(), factors: [w, x] }
}

/// The operands under the homomorphism that maps each variable to a high power, the highest that its product has room for.
pub(crate) fn scattered(factors: &[Poly; 2]) -> [Poly; 2] {
    let product = &factors[0] * &factors[1];
    let variables = product.occurring_variables();
    let degree = variables.iter().filter_map(|variable| product.degree(variable)).max().unwrap_or(1);
    let power = product.ring().max_exponent() / degree.max(1);
    let scatter = |poly: &Poly| {
        let raise = |poly: Poly, variable| poly.substitute(variable, &Poly::variable(variable).pow(power));
        variables.iter().fold(poly.clone(), raise)
    };
    factors.each_ref().map(scatter)
}
