//! Plain products and gcds.

use hodograph_algebra::{Poly, Variable};

/// The variables of the products.
pub(crate) const FIVE: &[&str] = &["x", "y", "z", "t", "u"];
/// The variables of the gcds.
pub(crate) const FOUR: &[&str] = &["x", "y", "z", "t"];

fn variables<const N: usize>(names: &[&str]) -> [Poly; N] {
    std::array::from_fn(|i| Poly::variable(&Variable::new(i as u32, names[i])))
}

/// `f·(f + 1)` with `f = (1 + x + y + z + t)¹²` (Fateman, *Comparing the speed of programs for sparse polynomial
/// multiplication*, 2003).
pub(crate) fn fateman() -> Box<dyn FnMut() -> Vec<Poly>> {
    let sum: Poly = variables::<4>(FIVE).into_iter().sum();
    let f = (sum + Poly::one()).pow(12);
    let g = &f + Poly::one();
    Box::new(move || vec![&f * &g])
}

/// The product of `(1 + x + y + 2z² + 3t³ + 5u⁵)¹⁰` and the same with the variables in reverse (Monagan and Pearce, *Sparse
/// polynomial multiplication and division in Maple 14*, 2010).
pub(crate) fn sparse() -> Box<dyn FnMut() -> Vec<Poly>> {
    let variables = variables::<5>(FIVE);
    let power = |[x, y, z, t, u]: [&Poly; 5]| {
        let terms = [(1, x, 1), (1, y, 1), (2, z, 2), (3, t, 3), (5, u, 5)];
        let sum: Poly = terms
            .map(|(factor, variable, exponent)| variable.pow(exponent) * Poly::integer(factor))
            .into_iter()
            .sum();
        (sum + Poly::one()).pow(10)
    };
    let [x, y, z, t, u] = variables.each_ref();
    let (f, g) = (power([x, y, z, t, u]), power([u, t, z, y, x]));
    Box::new(move || vec![&f * &g])
}

/// The gcd of a·g and b·g, for the polynomials a, b and g in `text`: a line for each term, with its coefficient and its
/// exponents, after a line with the name.
pub(crate) fn gcd(text: &str) -> Box<dyn FnMut() -> Vec<Poly>> {
    let variables = variables::<4>(FOUR);
    let mut polys: Vec<Poly> = Vec::new();
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        let numbers: Vec<i64> = line.split(' ').filter_map(|number| number.parse().ok()).collect();
        match (numbers.as_slice(), polys.last_mut()) {
            ([coefficient, exponents @ ..], Some(poly)) => {
                let powers = variables
                    .iter()
                    .zip(exponents)
                    .map(|(variable, &exponent)| variable.pow(exponent as u32));
                *poly += Poly::integer(*coefficient) * powers.product::<Poly>();
            }
            _ => polys.push(Poly::zero()),
        }
    }
    let [a, b, g] = polys.try_into().expect("the data are three polynomials");
    let (first, second) = (a * &g, b * &g);
    Box::new(move || vec![first.gcd(&second)])
}
