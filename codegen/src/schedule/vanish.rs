//! Values that are zero whatever the polynomials are that they are made of.
//!
//! In R_u·R_v of a sweep whose profile moves in the normal plane of its path, x'·y' − y'·x' cancels, whatever x' and
//! y' are. Such an identity is found with letters for sums of one parameter: first with numbers modulo a prime in
//! their place, which tells nearly all other values, then proved with fractions of polynomials.

use std::collections::BTreeMap;

use hodograph_algebra::{Int, Poly, Variable, integer};

use super::check::Fractions;
use crate::program::{Arithmetic, Operation, Program, Stage, Value};

/// The prime 2^61 − 1.
const PRIME: u64 = (1 << 61) - 1;
/// With more letters than this no identity is looked for.
const MOST_LETTERS: usize = 24;
/// Nor with fractions that have more terms.
const MOST_TERMS: usize = 500;

/// Whether a value is proved to be zero for all parameters, wherever it is defined.
pub(super) fn is_zero_identically(program: &Program<Poly>, value: Value) -> bool {
    if Expansion::new(program, Residues).of(value) != Some(0) {
        return false;
    }
    let arithmetic = Fractions { u: Poly::zero(), v: Poly::zero(), symbols: Vec::new() };
    let fraction = Expansion::new(program, Letters { arithmetic }).of(value);
    fraction.is_some_and(|(numerator, _)| numerator.is_zero())
}

/// What letters and numbers are computed with; `None` where nothing can be told.
trait Algebra {
    type Number: Clone;
    fn letter(&self, place: usize) -> Self::Number;
    fn constant(&self, constant: &Poly) -> Option<Self::Number>;
    fn add(&self, a: &Self::Number, b: &Self::Number) -> Option<Self::Number>;
    fn negate(&self, a: &Self::Number) -> Self::Number;
    fn multiply(&self, a: &Self::Number, b: &Self::Number) -> Option<Self::Number>;
    fn divide(&self, a: &Self::Number, b: &Self::Number) -> Option<Self::Number>;
}

/// Integers modulo [`PRIME`]; letters are numbers that have nothing to do with each other.
struct Residues;

impl Residues {
    fn of(number: &Int) -> Option<u64> {
        let rest = number % Int::from(PRIME);
        let rest = if rest < Int::from(0) { rest + Int::from(PRIME) } else { rest };
        u64::try_from(rest.small()?).ok()
    }

    fn product(a: u64, b: u64) -> u64 {
        (u128::from(a) * u128::from(b) % u128::from(PRIME)) as u64
    }

    fn power(base: u64, exponent: u64) -> u64 {
        let bits = (0..64 - exponent.leading_zeros()).rev();
        bits.fold(1, |power, bit| {
            let square = Residues::product(power, power);
            if exponent >> bit & 1 == 1 { Residues::product(square, base) } else { square }
        })
    }
}

impl Algebra for Residues {
    type Number = u64;

    fn letter(&self, place: usize) -> u64 {
        Residues::power(1_234_567_891, 3 + 1000 * place as u64)
    }

    fn constant(&self, constant: &Poly) -> Option<u64> {
        let number = constant.to_rational()?;
        self.divide(&Residues::of(number.numer())?, &Residues::of(number.denom())?)
    }

    fn add(&self, a: &u64, b: &u64) -> Option<u64> {
        Some((a + b) % PRIME)
    }

    fn negate(&self, a: &u64) -> u64 {
        (PRIME - a) % PRIME
    }

    fn multiply(&self, a: &u64, b: &u64) -> Option<u64> {
        Some(Residues::product(*a, *b))
    }

    fn divide(&self, a: &u64, b: &u64) -> Option<u64> {
        (*b != 0).then(|| Residues::product(*a, Residues::power(*b, PRIME - 2)))
    }
}

/// Fractions of polynomials in letters.
struct Letters {
    arithmetic: Fractions,
}

impl Algebra for Letters {
    type Number = (Poly, Poly);

    fn letter(&self, place: usize) -> (Poly, Poly) {
        (Poly::variable(&Variable::new(0, &format!("letter{place}"))), Poly::one())
    }

    fn constant(&self, constant: &Poly) -> Option<(Poly, Poly)> {
        constant.to_rational().map(|number| (Poly::constant(number), Poly::one()))
    }

    fn add(&self, a: &(Poly, Poly), b: &(Poly, Poly)) -> Option<(Poly, Poly)> {
        Some(self.arithmetic.add(a, b)).filter(is_small)
    }

    fn negate(&self, a: &(Poly, Poly)) -> (Poly, Poly) {
        self.arithmetic.negate(a)
    }

    fn multiply(&self, a: &(Poly, Poly), b: &(Poly, Poly)) -> Option<(Poly, Poly)> {
        Some(self.arithmetic.multiply(a, b)).filter(is_small)
    }

    fn divide(&self, a: &(Poly, Poly), b: &(Poly, Poly)) -> Option<(Poly, Poly)> {
        self.arithmetic.divide(a, b).filter(is_small)
    }
}

fn is_small((numerator, denominator): &(Poly, Poly)) -> bool {
    numerator.terms().len().max(denominator.terms().len()) <= MOST_TERMS
}

/// Values in an algebra.
struct Expansion<'a, A: Algebra> {
    program: &'a Program<Poly>,
    algebra: A,
    known: BTreeMap<Value, A::Number>,
    letters: BTreeMap<Value, A::Number>,
    /// Irrational numbers without their content, and the values that have their letters.
    irrational: Vec<(Poly, Value)>,
}

impl<'a, A: Algebra> Expansion<'a, A> {
    fn new(program: &'a Program<Poly>, algebra: A) -> Expansion<'a, A> {
        let (known, letters) = (BTreeMap::new(), BTreeMap::new());
        Expansion { program, algebra, known, letters, irrational: Vec::new() }
    }

    /// The number of a value. Sums of one parameter are letters, and so are roots, scales, signs, and numbers that
    /// are not rational.
    fn of(&mut self, value: Value) -> Option<A::Number> {
        if let Some(known) = self.known.get(&value) {
            return Some(known.clone());
        }
        let both = self.program.stage(value) == Stage::Both;
        let number = match *self.program.operation(value) {
            Operation::Constant(ref constant) => match self.algebra.constant(constant) {
                Some(number) => number,
                None => self.multiple_of_letter(value, constant)?,
            },
            Operation::Add(a, b) if both => {
                let (a, b) = (self.of(a)?, self.of(b)?);
                self.algebra.add(&a, &b)?
            }
            Operation::Subtract(a, b) if both => {
                let (a, b) = (self.of(a)?, self.of(b)?);
                self.algebra.add(&a, &self.algebra.negate(&b))?
            }
            Operation::Negate(a) => {
                let a = self.of(a)?;
                self.algebra.negate(&a)
            }
            Operation::Multiply(a, b) => {
                let (a, b) = (self.of(a)?, self.of(b)?);
                self.algebra.multiply(&a, &b)?
            }
            Operation::Divide(a, b) => {
                let (a, b) = (self.of(a)?, self.of(b)?);
                self.algebra.divide(&a, &b)?
            }
            // a times the sign of b.
            Operation::Orient(a, b) => {
                let (a, sign) = (self.of(a)?, self.letter(b)?);
                self.algebra.multiply(&a, &sign)?
            }
            Operation::MultiplyAdd(..)
            | Operation::Add(..)
            | Operation::Subtract(..)
            | Operation::Input(_)
            | Operation::SquareRoot(_)
            | Operation::Scale(..) => self.letter(value)?,
        };
        self.known.insert(value, number.clone());
        Some(number)
    }

    /// An irrational number: a rational one times the letter of the first number that it is such a multiple of.
    fn multiple_of_letter(&mut self, value: Value, constant: &Poly) -> Option<A::Number> {
        let primitive = constant.primitive();
        let factor = |known: &Poly| {
            (*known == primitive).then_some(1).or_else(|| (*known == -&primitive).then_some(-1))
        };
        let known = self.irrational.iter().find_map(|(known, value)| Some((factor(known)?, *value)));
        let (sign, value) = known.unwrap_or_else(|| {
            self.irrational.push((primitive.clone(), value));
            (1, value)
        });
        let factor = Poly::constant(constant.content() * integer(sign));
        let (factor, letter) = (self.algebra.constant(&factor)?, self.letter(value)?);
        self.algebra.multiply(&factor, &letter)
    }

    /// The letter of a value.
    fn letter(&mut self, value: Value) -> Option<A::Number> {
        let place = self.letters.len();
        if !self.letters.contains_key(&value) && place == MOST_LETTERS {
            return None;
        }
        let letter = self.letters.entry(value).or_insert_with(|| self.algebra.letter(place));
        Some(letter.clone())
    }
}

#[cfg(test)]
mod tests {
    use hodograph_algebra::{Poly, integer};

    use super::is_zero_identically;
    use crate::program::{Input, Program};

    #[test]
    fn only_identities_are_zero() {
        let mut program = Program::<Poly>::new();
        let (u, v) = (program.input(Input::U), program.input(Input::V));
        let root = program.constant(Poly::sqrt_of(&integer(2)));
        let sum = program.add(v, root);
        let inverse = program.divide(sum, u);
        let (left, right) = (program.multiply(inverse, u), program.multiply(u, sum));
        let same = program.subtract(left, sum);
        let other = program.subtract(left, right);
        assert!(is_zero_identically(&program, same));
        assert!(!is_zero_identically(&program, other));
        // (v + √2)² − (v² + 2√2·v + 2) is zero, but not for any v + √2 and v² + ….
        let (square, again, two) =
            (program.multiply(sum, sum), program.multiply(v, v), program.constant(Poly::integer(2)));
        let (double, twice) = (program.multiply(root, v), program.add(again, two));
        let double = program.multiply(two, double);
        let rest = program.add(twice, double);
        let difference = program.subtract(square, rest);
        assert!(!is_zero_identically(&program, difference));
    }
}
