//! Exact values as formulas for people: sums of monomials, products, fractions, cut where they are very long.
//!
//! What is not cut is ASCII that any computer-algebra system reads, in the symbols of the number field. A length that is
//! asked for is one of characters; `usize::MAX` gives everything.

use hodograph_algebra::{Fraction, Poly, Variable, budget};

/// The number of terms up to which a polynomial is written as a product.
const MOST_TERMS: usize = 400;

/// The length that each factor of a product may have, however many there are.
const SHORTEST: usize = 60;

/// The units of work that may go into writing one polynomial as a product.
const BUDGET: u64 = 3_000_000;

/// A polynomial as a sum of monomials with their coefficients in the field, such as `(sqrt2 + 1)*u^2 + 3`; of a very long
/// one the first monomials and the number of all.
pub fn polynomial(poly: &Poly, longest: usize) -> String {
    let monomials = monomials(poly, longest);
    if monomials.iter().map(String::len).sum::<usize>() <= longest {
        return monomials.concat();
    }
    let mut text = String::new();
    for monomial in &monomials {
        if text.len() + monomial.len() > longest && !text.is_empty() {
            return format!("{text} + … ({} monomials)", poly.monomial_count());
        }
        text += monomial;
    }
    text
}

/// Whether [`polynomial`] prints the whole of it.
pub fn is_short(poly: &Poly, longest: usize) -> bool {
    monomials(poly, longest).iter().map(String::len).sum::<usize>() <= longest
}

/// A product of a number and of powers of polynomials, as a formula.
pub fn product(unit: &Poly, factors: &[(Poly, u32)], longest: usize) -> String {
    if factors.is_empty() {
        return polynomial(unit, longest);
    }
    let mut parts = Vec::new();
    let rational = unit.to_rational();
    let sign = if *unit == Poly::integer(-1) { "-" } else { "" };
    if sign.is_empty() && !unit.is_one() {
        parts.push(rational.map_or_else(|| parenthesized(unit, longest), |value| value.to_string()));
    }
    let alone = factors.len() == 1 && parts.is_empty() && sign.is_empty();
    for (factor, exponent) in factors {
        parts.push(match exponent {
            1 if alone => polynomial(factor, longest),
            1 => parenthesized(factor, longest),
            _ => format!("{}^{exponent}", parenthesized(factor, longest)),
        });
    }
    format!("{sign}{}", parts.join("*"))
}

/// A polynomial as the product of the factors that its squarefree decomposition finds, such as `2*u*(v + 1)^2`; as a sum if it
/// has none, or is so long that they take too much work.
///
/// ```
/// use hodograph_algebra::{Poly, Variable};
/// use hodograph_codegen::formula::factored;
/// let (u, v) = (Poly::variable(&Variable::new(0, "u")), Poly::variable(&Variable::new(1, "v")));
/// assert_eq!(factored(&(&u * &v - &u), 80), "u*(v - 1)");
/// assert_eq!(factored(&(u + v), 80), "u + v");
/// ```
pub fn factored(poly: &Poly, longest: usize) -> String {
    let found = (poly.terms().len() <= MOST_TERMS)
        .then(|| budget::with_budget(BUDGET, || poly.squarefree()).ok())
        .flatten();
    match found {
        Some(mut split)
            if split.factors.len() > 1 || split.factors.iter().any(|(_, exponent)| *exponent > 1) =>
        {
            // Symbols before parameters, as in a monomial.
            split.factors.sort_by_key(|(factor, _)| {
                factor.occurring_variables().iter().any(|variable| variable.rank() < Variable::SYMBOL)
            });
            // Each factor may have its share of the length.
            product(&split.unit, &split.factors, (longest / split.factors.len()).max(SHORTEST.min(longest)))
        }
        _ => polynomial(poly, longest),
    }
}

/// A rational function in lowest terms, its numerator and its denominator each as a product.
///
/// ```
/// use hodograph_algebra::{Fraction, Poly, Variable};
/// use hodograph_codegen::formula::fraction;
/// let u = Poly::variable(&Variable::new(0, "u"));
/// let f = Fraction::new(&u * &u - Poly::one(), [(&u * &u + Poly::one(), 1)]);
/// assert_eq!(fraction(&f, 80), "(u^2 - 1)/(u^2 + 1)");
/// assert_eq!(fraction(&(&f * &f.reciprocal(&[]).unwrap()), 80), "1");
/// ```
pub fn fraction(value: &Fraction, longest: usize) -> String {
    let lowest = budget::with_budget(BUDGET, || value.lowest_terms()).unwrap_or_else(|_| value.clone());
    let numerator = factored(lowest.numerator(), longest);
    match lowest.factors() {
        [] => numerator,
        [(factor, exponent)] => {
            let factor = parenthesized(factor, longest);
            let power = if *exponent > 1 { format!("^{exponent}") } else { String::new() };
            format!("{}/{factor}{power}", grouped(&numerator))
        }
        factors => format!("{}/({})", grouped(&numerator), product(&Poly::one(), factors, longest)),
    }
}

/// A formula in parentheses if it is a sum: what stands outside of its parentheses decides.
///
/// ```
/// use hodograph_codegen::formula::grouped;
/// assert_eq!(grouped("u + v"), "(u + v)");
/// assert_eq!(grouped("-2*(u + v)"), "-2*(u + v)");
/// ```
pub fn grouped(formula: &str) -> String {
    let mut depth = 0_usize;
    for character in formula.chars() {
        match character {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            ' ' if depth == 0 => return format!("({formula})"),
            _ => {}
        }
    }
    formula.to_owned()
}

/// The first monomials in the variables, each with its coefficient and the sign before it: all that have this length together, and
/// one more, but two at least.
fn monomials(poly: &Poly, longest: usize) -> Vec<String> {
    let variables = poly.occurring_variables();
    if variables.is_empty() {
        return vec![poly.to_string()];
    }
    let (mut signed, mut length) = (Vec::new(), 0);
    visit(poly, &variables, &mut Vec::new(), &mut |exponents, coefficient| {
        let text = monomial(&variables, exponents, coefficient, signed.is_empty());
        length += text.len();
        signed.push(text);
        length <= longest || signed.len() < 2
    });
    signed
}

/// Calls a function with the exponents and the coefficient of each monomial, from the highest one on, as long as it returns true.
fn visit(
    poly: &Poly,
    variables: &[Variable],
    exponents: &mut Vec<u32>,
    call: &mut dyn FnMut(&[u32], &Poly) -> bool,
) -> bool {
    let Some((first, rest)) = variables.split_first() else {
        return poly.is_zero() || call(exponents, poly);
    };
    let coefficients = poly.coefficients(first);
    coefficients.iter().enumerate().rev().all(|(exponent, coefficient)| {
        exponents.push(exponent as u32);
        let goes_on = coefficient.is_zero() || visit(coefficient, rest, exponents, call);
        exponents.pop();
        goes_on
    })
}

/// A monomial with its coefficient, and its sign unless it is the first.
fn monomial(variables: &[Variable], exponents: &[u32], coefficient: &Poly, is_first: bool) -> String {
    let powers = variables.iter().zip(exponents).filter(|(_, exponent)| **exponent > 0);
    // Symbols before parameters, as polynomials print.
    let (symbols, parameters): (Vec<_>, Vec<_>) = powers.partition(|(v, _)| v.rank() >= Variable::SYMBOL);
    let power = |(variable, exponent): (&Variable, &u32)| match exponent {
        1 => variable.to_string(),
        _ => format!("{variable}^{exponent}"),
    };
    let monomial = symbols.into_iter().chain(parameters).map(power).collect::<Vec<_>>().join("*");
    let text = coefficient.to_string();
    let (sign, factor) = match coefficient.terms() {
        [_] => text.strip_prefix('-').map_or(("+", text.clone()), |rest| ("-", rest.to_owned())),
        _ if monomial.is_empty() => ("+", text.clone()),
        _ => ("+", format!("({text})")),
    };
    let term = match (factor.as_str(), monomial.as_str()) {
        (_, "") => factor,
        ("1", _) => monomial,
        _ => format!("{factor}*{monomial}"),
    };
    // A coefficient without a monomial is a sum that continues this one.
    match (is_first, sign) {
        (true, "+") => term,
        (true, _) => format!("-{term}"),
        (false, "+") => match term.strip_prefix('-') {
            Some(rest) => format!(" - {rest}"),
            None => format!(" + {term}"),
        },
        (false, _) => format!(" - {term}"),
    }
}

fn parenthesized(poly: &Poly, longest: usize) -> String {
    let text = polynomial(poly, longest);
    if text.contains(['^', '*', '/', ' ', '-']) { format!("({text})") } else { text }
}

#[cfg(test)]
mod tests {
    use hodograph_algebra::integer;

    use super::*;

    #[test]
    fn products() {
        let u = Poly::variable(&Variable::new(0, "u"));
        let f = &u + Poly::one();
        assert_eq!(product(&Poly::one(), &[], 600), "1");
        assert_eq!(product(&Poly::one(), &[(f.clone(), 1)], 600), "u + 1");
        assert_eq!(product(&Poly::integer(-2), &[(u.clone(), 1), (f.clone(), 2)], 600), "-2*u*(u + 1)^2");
        assert_eq!(product(&Poly::integer(-1), &[(f.clone(), 1)], 600), "-(u + 1)");
        assert_eq!(product(&(&f * &u), &[], 600), "u^2 + u");
    }

    #[test]
    fn coefficients_are_collected() {
        let (u, a) =
            (Poly::variable(&Variable::new(0, "u")), Poly::variable(&Variable::new(Variable::SYMBOL, "a")));
        let number = Poly::sqrt_of(&integer(2)) - Poly::one();
        let f = &number * u.pow(2) * &a - &u * &a + u.pow(2) + &u - &number;
        assert_eq!(polynomial(&f, 600), "(sqrt2 - 1)*a*u^2 + u^2 - a*u + u - sqrt2 + 1");
        assert_eq!(polynomial(&-(&u * &number), 600), "(-sqrt2 + 1)*u");
        assert_eq!(polynomial(&-u, 600), "-u");
        assert_eq!(polynomial(&number, 600), "sqrt2 - 1");
        assert_eq!(polynomial(&Poly::zero(), 600), "0");
    }

    #[test]
    fn long_polynomials_are_cut_between_terms() {
        let (u, v) = (Poly::variable(&Variable::new(0, "u")), Poly::variable(&Variable::new(1, "v")));
        let long = (u + v + Poly::one()).pow(20);
        let text = polynomial(&long, 600);
        let end = " + … (231 monomials)";
        assert!(text.len() < 600 + 40 && text.ends_with(end), "{text}");
        assert!(long.to_string().starts_with(text.trim_end_matches(end)));
        assert!(!is_short(&long, 600));
    }
}
