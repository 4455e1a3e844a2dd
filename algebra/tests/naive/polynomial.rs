//! Polynomials as maps from exponents to rational numbers, with every operation as in a textbook.

use std::collections::BTreeMap;

use hodograph_algebra::{Poly, Rational, Variable, integer};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

/// The number of variables; the generators of the number field come after them.
pub(crate) const VARIABLES: usize = 3;
/// `sqrt2` and `theta = √(110 + 100·√2)`.
pub(crate) const GENERATORS: usize = 2;

type Exponents = Vec<u32>;

/// A polynomial in u, v, w over Q(√2, θ); the exponents are those of u, v, w, √2, θ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Naive(BTreeMap<Exponents, BigRational>);

/// The variables u, v, w.
pub(crate) fn variables() -> [Variable; VARIABLES] {
    [Variable::new(0, "u"), Variable::new(1, "v"), Variable::new(Variable::SYMBOL, "w")]
}

/// `√2` and `θ`, in this order.
pub(crate) fn generators() -> [Poly; GENERATORS] {
    let root = Poly::sqrt_of(&integer(2));
    let theta = (root.scale(&integer(100)) + Poly::integer(110)).sqrt().expect("it is positive");
    [root, theta]
}

pub(crate) fn big(value: &Rational) -> BigRational {
    BigRational::new(value.numer().to_big(), value.denom().to_big())
}

pub(crate) fn small(value: &BigRational) -> Rational {
    Rational::new(value.numer().clone().into(), value.denom().clone().into())
}

impl Naive {
    pub(crate) fn new(terms: impl IntoIterator<Item = (Exponents, BigRational)>) -> Naive {
        let mut sum = Naive(BTreeMap::new());
        for (exponents, coefficient) in terms {
            sum.insert(exponents, coefficient);
        }
        sum
    }

    /// Adds a term whose generators may have any exponent.
    fn insert(&mut self, mut exponents: Exponents, coefficient: BigRational) {
        if exponents[VARIABLES + 1] >= 2 {
            exponents[VARIABLES + 1] -= 2;
            self.insert(exponents.clone(), &coefficient * BigRational::from(BigInt::from(110)));
            exponents[VARIABLES] += 1;
            self.insert(exponents, coefficient * BigRational::from(BigInt::from(100)));
            return;
        }
        if exponents[VARIABLES] >= 2 {
            exponents[VARIABLES] -= 2;
            self.insert(exponents, coefficient * BigRational::from(BigInt::from(2)));
            return;
        }
        let sum = self.0.entry(exponents.clone()).or_insert_with(BigRational::zero);
        *sum += coefficient;
        if sum.is_zero() {
            self.0.remove(&exponents);
        }
    }

    pub(crate) fn of(poly: &Poly) -> Naive {
        let names = variables();
        let ring = poly.ring();
        let terms = poly.terms().iter().map(|term| {
            let mut exponents = vec![0; VARIABLES + GENERATORS];
            for (variable, exponent) in ring.variables().iter().zip(ring.exponents(term.monomial)) {
                let place = names.iter().position(|name| name == variable).expect("one of the variables");
                exponents[place] = exponent;
            }
            let powers = ring.generator_exponents(term.monomial);
            for (generator, exponent) in ring.field().generators().iter().zip(powers) {
                let place = match generator.name() {
                    "sqrt2" => 0,
                    "theta" => 1,
                    other => panic!("the field has another generator {other}"),
                };
                exponents[VARIABLES + place] = exponent;
            }
            (exponents, big(poly.content()) * BigRational::from(term.coefficient.to_big()))
        });
        Naive::new(terms)
    }

    pub(crate) fn to_poly(&self) -> Poly {
        let symbols: Vec<Poly> = variables().iter().map(Poly::variable).chain(generators()).collect();
        let terms = self.0.iter().map(|(exponents, coefficient)| {
            let powers = symbols.iter().zip(exponents).map(|(symbol, &exponent)| symbol.pow(exponent));
            powers.product::<Poly>().scale(&small(coefficient))
        });
        terms.sum()
    }

    pub(crate) fn add(&self, other: &Naive) -> Naive {
        Naive::new(self.0.iter().chain(&other.0).map(|(e, c)| (e.clone(), c.clone())))
    }

    pub(crate) fn mul(&self, other: &Naive) -> Naive {
        let mut terms = Vec::new();
        for (d, a) in &self.0 {
            for (e, b) in &other.0 {
                terms.push((d.iter().zip(e).map(|(i, j)| i + j).collect(), a * b));
            }
        }
        Naive::new(terms)
    }

    pub(crate) fn derivative(&self, place: usize) -> Naive {
        let derive = |(exponents, coefficient): (&Exponents, &BigRational)| {
            let mut lower = exponents.clone();
            lower[place] = lower[place].checked_sub(1)?;
            Some((lower, coefficient * BigRational::from(BigInt::from(exponents[place]))))
        };
        Naive::new(self.0.iter().filter_map(derive))
    }

    pub(crate) fn substitute(&self, place: usize, value: &Naive) -> Naive {
        let mut sum = Naive::new([]);
        for (exponents, coefficient) in &self.0 {
            let mut rest = exponents.clone();
            rest[place] = 0;
            let mut term = Naive::new([(rest, coefficient.clone())]);
            for _ in 0..exponents[place] {
                term = term.mul(value);
            }
            sum = sum.add(&term);
        }
        sum
    }

    pub(crate) fn one() -> Naive {
        Naive::new([(vec![0; VARIABLES + GENERATORS], BigRational::one())])
    }
}
