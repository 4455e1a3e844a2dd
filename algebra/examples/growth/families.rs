//! The families of paths: PH curves of rising degree with coefficients of one kind.

use hodograph_algebra::{Complex, Poly, Preimage, PreimageError, Rational, integer, ratio};

/// PH curves of rising degree.
pub(crate) struct Family {
    /// What the command line calls it.
    pub(crate) name: &'static str,
    /// What it is.
    pub(crate) title: &'static str,
    /// The degrees of the curves.
    pub(crate) degrees: &'static [u32],
    /// The numbers of its preimages.
    pub(crate) numbers: Numbers,
    /// What its costs come from.
    pub(crate) explanation: &'static str,
}

/// The numbers of a family.
pub(crate) enum Numbers {
    /// Each coefficient has two symbols.
    Symbols,
    /// Sums of random multiples of 1 and of these irrational numbers, which generate a field of this degree.
    Random { size: Size, field_degree: u32, irrational: fn() -> Vec<Poly> },
}

/// The size of random rational numbers.
#[derive(Clone, Copy)]
pub(crate) enum Size {
    /// Integers from −9 to 9.
    Digit,
    /// Numerators and denominators of 20 bits.
    Bits20,
}

const ALL: &[u32] = &[3, 5, 7, 9, 13, 17, 21];
const FEW: &[u32] = &[3, 5, 7, 9];

const fn family(
    name: &'static str,
    title: &'static str,
    degrees: &'static [u32],
    numbers: Numbers,
    explanation: &'static str,
) -> Family {
    Family { name, title, degrees, numbers, explanation }
}

const fn random(size: Size, field_degree: u32, irrational: fn() -> Vec<Poly>) -> Numbers {
    Numbers::Random { size, field_degree, irrational }
}

/// All families.
pub(crate) const FAMILIES: [Family; 11] = [
    family(
        "rational-small",
        "integers from −9 to 9",
        ALL,
        random(Size::Digit, 1, Vec::new),
        "Operands of some hundred terms with coefficients of one word: a step takes as long as it takes to set up a few dozen products,\n\
            quotients and images, which hardly depends on n.",
    ),
    family(
        "rational-20",
        "rationals with numerators and denominators of 20 bits",
        ALL,
        random(Size::Bits20, 1, Vec::new),
        "Every number of the preimage has a denominator of its own, so that the common one has some 20(n + 1) bits, twice as many in the\n\
            normal, and four times as many in the products of s and σ: both terms and the length of coefficients grow with n.\n\
            Sums of up to 1023 bits are formed in cells of a fixed width, longer ones, here above n = 13, in allocated integers.",
    ),
    family(
        "symbolic",
        "symbols",
        ALL,
        Numbers::Symbols,
        "The coordinates have a term for nearly every product of two coefficients of w, by another two, and a power of v: some n⁴ of\n\
            them, each with a coefficient of a few digits, and a step takes a few microseconds for each term that it reads. The normal has\n\
            far fewer terms than the coordinates from whose derivatives it comes. Steps are uneven: at n = 13 the terms of the\n\
            coordinates, of 32 bytes each, fill a second-level cache of 2 MiB, and at n = 21 coefficients take two words. Beyond\n\
            n = 21 one polynomial has no room for the exponents of so many symbols.",
    ),
    family(
        "field-2-small",
        "a + b√2 with integers from −9 to 9",
        FEW,
        random(Size::Digit, 2, || roots(&[2])),
        "Twice the terms of the rational case, and quotients by the conjugate of a divisor's leading coefficient.",
    ),
    family(
        "field-2-20",
        "a + b√2 with rationals of 20 bits",
        FEW,
        random(Size::Bits20, 2, || roots(&[2])),
        "As for rationals of 20 bits, but of twice the length and more: the weight is made rational by a factor as long as itself. Quotients\n\
            are lifted from as many primes as their coefficients have words, under both homomorphisms.",
    ),
    family(
        "field-4-small",
        "a + b√2 + c√3 with integers from −9 to 9",
        FEW,
        random(Size::Digit, 4, || roots(&[2, 3])),
        "Sixteen products for each pair of numbers, still of one word or two: arithmetic begins to outweigh what is spent to set up.",
    ),
    family(
        "field-4-20",
        "a + b√2 + c√3 with rationals of 20 bits",
        FEW,
        random(Size::Bits20, 4, || roots(&[2, 3])),
        "The longest coefficients have thousands of bits. Half of the time goes into products of such integers, the rest into their residues\n\
            modulo primes and the way back.",
    ),
    family(
        "tower-4",
        "a + bθ with θ = √(110 + 100√2), integers from −9 to 9",
        FEW,
        random(Size::Digit, 4, || vec![tower(2)]),
        "The same degree of the field, with a rule θ² = 110 + 100√2 that makes coefficients longer. One prime of eight splits, instead of one of\n\
            four.",
    ),
    family(
        "field-8-small",
        "a + b√2 + c√3 + d√5 with integers from −9 to 9",
        FEW,
        random(Size::Digit, 8, || roots(&[2, 3, 5])),
        "Sixty-four products for each pair of numbers; coefficients are of two words where they were of one.",
    ),
    family(
        "field-8-20",
        "a + b√2 + c√3 + d√5 with rationals of 20 bits",
        FEW,
        random(Size::Bits20, 8, || roots(&[2, 3, 5])),
        "The longest coefficients have ten thousand bits, and two thirds of the time go into their products. This comes from the numbers,\n\
            not from the way: with 20 bits in each of eight coordinates, a norm alone has eight times the bits of a number.",
    ),
    family(
        "tower-8",
        "a + bη with η = √(7 + θ), θ as above, integers from −9 to 9",
        FEW,
        random(Size::Digit, 8, || vec![tower(3)]),
        "One prime of 128 splits, which is the degree of the normal closure: the search for these primes, whose results are remembered, is\n\
            what a small curve pays for.",
    ),
];

fn roots(radicands: &[i64]) -> Vec<Poly> {
    radicands.iter().map(|&radicand| Poly::sqrt_of(&integer(radicand))).collect()
}

/// √2, θ = √(110 + 100√2) and √(7 + θ) by their height.
fn tower(height: u32) -> Poly {
    let root = |radicand: Poly| radicand.sqrt().expect("the radicand is positive");
    match height {
        1 => Poly::sqrt_of(&integer(2)),
        2 => root(Poly::integer(110) + tower(1) * Poly::integer(100)),
        _ => root(Poly::integer(7) + tower(height - 1)),
    }
}

impl Family {
    /// The degree over the rationals of the field of its numbers.
    pub(crate) fn field_degree(&self) -> u32 {
        match self.numbers {
            Numbers::Symbols => 1,
            Numbers::Random { field_degree, .. } => field_degree,
        }
    }

    /// The preimage of the curve of the given degree: the same one each time.
    pub(crate) fn preimage(&self, degree: u32) -> Result<Preimage, PreimageError> {
        let Numbers::Random { size, irrational, .. } = &self.numbers else {
            return Preimage::symbolic(degree, "");
        };
        let mut source = SplitMix { state: u64::from(degree) };
        let irrational = irrational();
        let mut number = || {
            let multiples = irrational.iter().map(|number| number.scale(&source.rational(*size)));
            let sum: Poly = multiples.collect::<Vec<Poly>>().into_iter().sum();
            sum + Poly::constant(source.rational(*size))
        };
        Preimage::new((0..=degree / 2).map(|_| Complex::new(number(), number())).collect())
    }
}

/// A reproducible stream of words (Steele, Lea, Flood, *Fast splittable pseudorandom number generators*, 2014).
struct SplitMix {
    state: u64,
}

impl SplitMix {
    fn next(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut word = self.state;
        word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        word ^ (word >> 31)
    }

    /// One of `count` numbers from 0 on.
    fn below(&mut self, count: u64) -> i64 {
        (self.next() % count).cast_signed()
    }

    /// A random number other than zero.
    fn rational(&mut self, size: Size) -> Rational {
        let sign = 2 * self.below(2) - 1;
        match size {
            Size::Digit => integer(sign * (1 + self.below(9))),
            Size::Bits20 => {
                let mut twenty_bits = || (1 << 19) + self.below(1 << 19);
                ratio(sign * twenty_bits(), twenty_bits())
            }
        }
    }
}
