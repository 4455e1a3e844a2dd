//! Rational functions as text that can be pasted into any computer-algebra system.

use std::fmt;

use super::Fraction;

impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.factors.is_empty() {
            return self.numerator.fmt(f);
        }
        if self.numerator.terms().len() > 1 {
            write!(f, "({})/", self.numerator)?;
        } else {
            write!(f, "{}/", self.numerator)?;
        }
        let power = |exponent: u32| if exponent > 1 { format!("^{exponent}") } else { String::new() };
        if let [(factor, exponent)] = self.factors.as_slice() {
            return if factor.terms().len() > 1 {
                write!(f, "({factor}){}", power(*exponent))
            } else {
                write!(f, "{factor}{}", power(*exponent))
            };
        }
        let parts: Vec<String> =
            self.factors.iter().map(|(factor, exponent)| format!("({factor}){}", power(*exponent))).collect();
        write!(f, "({})", parts.join("*"))
    }
}

impl fmt::Debug for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
