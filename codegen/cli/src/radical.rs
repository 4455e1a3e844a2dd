//! Numbers of a field, written with square roots.

use std::sync::Arc;

use hodograph_algebra::{NumberField, Poly, minimize_field};

/// The numbers, each as a sum of products of rationals and nested square roots such as `1/2*sqrt(2)*sqrt(3 + sqrt(2))`:
/// text that needs no generators, and that the sweep language and any computer-algebra system reads.
pub(crate) fn written(numbers: &[Poly]) -> Vec<String> {
    minimize_field(numbers).iter().map(number).collect()
}

/// One number, written in the same way.
pub(crate) fn written_one(value: &Poly) -> String {
    written(std::slice::from_ref(value)).concat()
}

fn number(value: &Poly) -> String {
    let field = value.ring().field();
    let mut text = String::new();
    // Descending, as polynomials print.
    for (exponents, coefficient) in value.generator_coefficients().iter().rev() {
        let roots: Vec<String> =
            (0..exponents.len()).filter(|&i| exponents[i] > 0).map(|i| root(field, i)).collect();
        let coefficient = coefficient.to_string();
        let (sign, absolute) = match coefficient.strip_prefix('-') {
            Some(rest) => ("-", rest),
            None => ("+", coefficient.as_str()),
        };
        match (text.is_empty(), sign) {
            (true, "+") => {}
            (true, _) => text.push('-'),
            (false, sign) => text.push_str(&format!(" {sign} ")),
        }
        if roots.is_empty() || absolute != "1" {
            text.push_str(absolute);
            text.push_str(if roots.is_empty() { "" } else { "*" });
        }
        text.push_str(&roots.join("*"));
    }
    if text.is_empty() { "0".to_owned() } else { text }
}

/// The generator at `position` as a square root.
fn root(field: &Arc<NumberField>, position: usize) -> String {
    format!("sqrt({})", number(&field.radicand(position)))
}

#[cfg(test)]
mod tests {
    use hodograph_algebra::{integer, ratio};

    use super::*;

    #[test]
    fn numbers_are_written_without_generators() {
        let root2 = Poly::sqrt_of(&integer(2));
        let nested = (Poly::integer(3) + &root2).sqrt().unwrap_or_else(Poly::zero);
        let sum = nested.scale(&ratio(-1, 2)) + &root2;
        let all = written(&[sum, Poly::constant(ratio(3, 4)), Poly::zero(), root2.pow(2), -root2]);
        assert_eq!(all, ["sqrt(2) - 1/2*sqrt(sqrt(2) + 3)", "3/4", "0", "2", "-sqrt(2)"]);
    }
}
