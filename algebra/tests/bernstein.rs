//! Bernstein forms against their definition.

#[path = "support/config.rs"]
mod config;
#[path = "support/intervals.rs"]
mod intervals;

use std::cmp::Ordering;

use config::config;
use hodograph_algebra::{Bernstein, Int, Interval, Poly, Rational, Variable, integer, ratio};
use intervals::{intervals, numbers, u, v};
use num_integer::binomial;
use proptest::prelude::*;

/// Polynomials in u, v of degree at most (3, 2), some with a symbol in their coefficients.
fn polynomials(symbols: bool) -> impl Strategy<Value = Poly> {
    let symbol = Poly::variable(&Variable::new(Variable::SYMBOL, "c0"));
    prop::collection::vec((numbers(), 0..4_u32, 0..3_u32, any::<bool>()), 0..6).prop_map(move |terms| {
        let term = |(number, i, j, with): (Poly, u32, u32, bool)| {
            let symbol = if symbols && with { symbol.clone() } else { Poly::one() };
            number * Poly::variable(&u()).pow(i) * Poly::variable(&v()).pow(j) * symbol
        };
        terms.into_iter().map(term).sum()
    })
}

/// `C(n, i)·tⁱ·(1 − t)ⁿ⁻ⁱ` with `t = (variable − lower)/(upper − lower)`.
fn basis(variable: &Variable, interval: &Interval, degree: u32, index: u32) -> Poly {
    let t = (Poly::variable(variable) - interval.lower()) * interval.width().inverse();
    let rest = Poly::one() - &t;
    (t.pow(index) * rest.pow(degree - index)).scale(&integer(binomial(degree, index).into()))
}

fn fractions() -> impl Strategy<Value = Rational> {
    (0_i64..=12).prop_map(|n| ratio(n, 12))
}

proptest! {
    #![proptest_config(config(48))]

    #[test]
    fn the_form_is_the_polynomial(f in polynomials(true), a in intervals(), b in intervals(), more in 0_u32..2) {
        let domain = [(u(), a.clone()), (v(), b.clone())];
        let [m, n] = [u(), v()].map(|variable| f.degree(&variable).unwrap_or(0) + more);
        let form = Bernstein::with_degrees(&f, &domain, &[m, n]).expect("the degrees suffice");
        let mut sum = Poly::zero();
        for i in 0..=m {
            for j in 0..=n {
                let coefficient = form.coefficient(&[i, j]).expect("the index is in range");
                prop_assert!(coefficient.is_valid());
                sum += coefficient * basis(&u(), &a, m, i) * basis(&v(), &b, n, j);
            }
        }
        prop_assert_eq!(&sum, &f);
        prop_assert_eq!(&form.to_poly(), &f);
        prop_assert_eq!(form.coefficients().len() as u32, (m + 1) * (n + 1));
        prop_assert_eq!(form.coefficient(&[m + 1, 0]), None);
    }

    #[test]
    fn elevation_and_subdivision_keep_the_polynomial(
        f in polynomials(true),
        a in intervals(),
        b in intervals(),
        t in fractions(),
        position in 0..2_usize,
    ) {
        let domain = [(u(), a), (v(), b)];
        let form = Bernstein::new(&f, &domain);
        let mut degrees: Vec<u32> = form.axes().iter().map(|axis| axis.degree()).collect();
        let value = domain[position].1.point(&t);
        match form.subdivided(position, &value) {
            None => prop_assert!(t == ratio(0, 1) || t == ratio(1, 1)),
            Some(parts) => for part in [parts.0, parts.1] {
                let axes = part.axes().iter();
                let smaller: Vec<_> = axes.map(|axis| (axis.variable().clone(), axis.interval().clone())).collect();
                // The twin: the form of the polynomial over the smaller box.
                prop_assert_eq!(&part, &Bernstein::new(&f, &smaller));
            },
        }
        degrees[position] += 2;
        let twice = form.elevated(position).elevated(position);
        prop_assert_eq!(Some(twice), Bernstein::with_degrees(&f, &domain, &degrees));
        degrees[position] -= 1;
        if degrees[position] > 1 {
            degrees[position] = f.degree(&domain[position].0).unwrap_or(0).wrapping_sub(1);
            prop_assert!(
                degrees[position] == u32::MAX || Bernstein::with_degrees(&f, &domain, &degrees).is_none()
            );
        }
    }

    #[test]
    fn coefficients_enclose_the_values(
        f in polynomials(false),
        a in intervals(),
        b in intervals(),
        s in fractions(),
        t in fractions(),
    ) {
        let (at_u, at_v) = (a.point(&s), b.point(&t));
        let form = Bernstein::new(&f, &[(u(), a.clone()), (v(), b.clone())]);
        let (least, greatest) = form.range().expect("the coefficients are numbers");
        let value = f.substitute(&u(), &at_u).substitute(&v(), &at_v);
        prop_assert!(least.compare(&value) != Ordering::Greater);
        prop_assert!(greatest.compare(&value) != Ordering::Less);
        let corner = f.substitute(&u(), a.upper()).substitute(&v(), b.lower());
        let m = form.axes()[0].degree();
        prop_assert_eq!(form.coefficient(&[m, 0]), Some(&corner));
    }

    #[test]
    fn variations_bound_the_roots(roots in prop::collection::vec(-12_i64..24, 1..6), pairs in 0_u32..3) {
        // Roots at multiples of 1/12, and pairs of complex ones.
        let x = Poly::variable(&u());
        let f = roots.iter().map(|&n| &x - Poly::constant(ratio(n, 12))).product::<Poly>()
            * (x.pow(2) + Poly::constant(ratio(1, 9))).pow(pairs);
        let inside = roots.iter().filter(|&&n| 0 < n && n < 12).count();
        let variations = Bernstein::new(&f, &[(u(), Interval::unit())]).sign_variations().expect("numbers");
        prop_assert!(variations >= inside);
        prop_assert_eq!((variations - inside) % 2, 0);
    }
}

#[test]
fn symbols_have_no_order() {
    let f = Poly::variable(&u()) * Poly::variable(&Variable::new(Variable::SYMBOL, "c0"));
    let form = Bernstein::new(&f, &[(u(), Interval::unit())]);
    assert_eq!((form.range(), form.sign_variations()), (None, None));
    assert_eq!(Bernstein::new(&Poly::zero(), &[(u(), Interval::unit())]).coefficients(), [Poly::zero()]);
    let content = Poly::common_content(form.coefficients());
    assert_eq!(content, Rational::from(Int::ONE));
}
