//! Real number fields: towers of square roots.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use num_traits::Signed;

use super::bracket::{Bracket, GeneratorValues};
use super::square_root;
use crate::modular::field::PrimeField;
use crate::modular::splitting::{Radicand, Splitting};
use crate::poly::Poly;
use crate::poly::reduction::Reduction;
use crate::{Int, budget};

/// The largest number of generators of a field, so that its degree is at most 2¹⁶.
const MAX_GENERATORS: usize = 16;

/// One generator `g` of a [`NumberField`]: the positive root of `g² = r`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Generator {
    name: String,
    /// The radicand's integer coefficients, by the exponents of the earlier generators.
    radicand: Vec<(Vec<u32>, Int)>,
}

impl Generator {
    /// The symbol that it prints with.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    pub(crate) fn radicand_terms(&self) -> impl Iterator<Item = (Vec<u32>, Int)> + '_ {
        self.radicand.iter().cloned()
    }

    /// The number of square roots that are nested in it.
    fn depth(&self, earlier: &[Generator]) -> usize {
        let occurs = |position: &usize| self.radicand.iter().any(|(exponents, _)| exponents[*position] > 0);
        1 + (0..earlier.len())
            .filter(occurs)
            .map(|position| earlier[position].depth(&earlier[..position]))
            .max()
            .unwrap_or(0)
    }
}

/// A real number field `Q(g₁, …, gₙ)` with `gᵢ² = rᵢ`, where `rᵢ > 0` is an integer polynomial in `g₁, …, gᵢ₋₁` that
/// is no square in the field before it; so the degree is `2ⁿ`, and the products of distinct generators are a basis.
///
/// Every generator stands for the positive root, which fixes the embedding into the real numbers: numbers of the field
/// have a sign. The numbers themselves are [`Poly`]s without variables. A tower of square roots is all that curves from
/// Hermite data need, and its arithmetic is that of polynomials with one rewriting rule a generator, over integers with
/// one common denominator.
///
/// # Example
/// ```
/// use hodograph_algebra::{Poly, integer};
/// let root = Poly::sqrt_of(&integer(2));
/// let field = root.ring().field();
/// assert_eq!(field.degree(), 2);
/// assert_eq!(field.relation(0).to_string(), "sqrt2^2 - 2");
/// ```
#[derive(Debug)]
pub struct NumberField {
    generators: Vec<Generator>,
    /// What follows from the generators, when it is first asked for.
    values: GeneratorValues,
    reduction: OnceLock<Option<Reduction>>,
    splittings: Splittings,
}

/// By prime and positions of generators, the homomorphisms modulo the prime, if it splits.
type Splittings = Mutex<BTreeMap<(u64, Vec<usize>), Option<Arc<Splitting>>>>;

impl PartialEq for NumberField {
    fn eq(&self, other: &NumberField) -> bool {
        self.generators == other.generators
    }
}

impl Eq for NumberField {}

/// A relation `g² − radicand = 0` that defines a generator.
#[derive(Clone, Debug)]
pub struct Relation {
    symbol: String,
    radicand: Poly,
}

impl std::fmt::Display for Relation {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let negated = (-&self.radicand).to_string();
        match negated.strip_prefix('-') {
            Some(rest) => write!(f, "{}^2 - {rest}", self.symbol),
            None => write!(f, "{}^2 + {negated}", self.symbol),
        }
    }
}

impl NumberField {
    /// The rationals: no generators.
    #[must_use]
    pub fn rationals() -> Arc<NumberField> {
        NumberField::with_generators(Vec::new())
    }

    /// The generators, each in terms of those before it.
    #[must_use]
    pub fn generators(&self) -> &[Generator] {
        &self.generators
    }

    /// The degree over the rationals.
    #[must_use]
    pub fn degree(&self) -> u64 {
        1 << self.generators.len()
    }

    /// The polynomial `g² − r`, as text, which vanishes for the generator at `position`.
    #[must_use]
    pub fn relation(self: &Arc<NumberField>, position: usize) -> Relation {
        Relation { symbol: self.generators[position].name.clone(), radicand: self.radicand(position) }
    }

    /// The square of the generator at `position`, as a number of the field.
    #[must_use]
    pub fn radicand(self: &Arc<NumberField>, position: usize) -> Poly {
        Poly::generator(self, position).pow(2)
    }

    /// The number of nested square roots in the generator at `position`.
    pub(crate) fn depth(&self, position: usize) -> usize {
        self.generators[position].depth(&self.generators[..position])
    }

    /// The number `Σ coefficient · Π generators` in fixed point with `bits` bits after the point; the terms name generators
    /// as a set of positions.
    pub(crate) fn sum_of_products<'a>(
        &self,
        terms: impl IntoIterator<Item = (u64, &'a Int)>,
        bits: u64,
    ) -> Bracket {
        self.values.sum(&self.generators, terms, bits)
    }

    /// The table by which products of numbers are reduced, if the field is small enough for one.
    pub(crate) fn reduction(&self) -> Option<&Reduction> {
        self.reduction.get_or_init(|| Reduction::new(&self.generators)).as_ref()
    }

    /// The homomorphisms to a prime field from the ring of the generators at `positions`, whose rules in terms of each other are
    /// `radicands`; `None` if the prime does not split.
    pub(crate) fn splitting(
        &self,
        field: PrimeField,
        positions: &[usize],
        radicands: &[Radicand],
    ) -> Option<Arc<Splitting>> {
        // Nothing unwinds with the lock.
        let known = || self.splittings.lock().unwrap_or_else(PoisonError::into_inner);
        let key = (field.modulus(), positions.to_vec());
        if let Some(splitting) = known().get(&key) {
            return splitting.clone();
        }
        let splitting = Splitting::new(field, radicands).map(Arc::new);
        known().insert(key, splitting.clone());
        splitting
    }

    fn with_generators(generators: Vec<Generator>) -> Arc<NumberField> {
        Arc::new(NumberField {
            generators,
            values: GeneratorValues::default(),
            reduction: OnceLock::new(),
            splittings: Mutex::default(),
        })
    }

    fn is_prefix_of(&self, other: &NumberField) -> bool {
        other.generators.starts_with(&self.generators)
    }
}

/// The field with a further generator, the positive root of `radicand`: a positive number of `field` with integer
/// coefficients that is no square in it.
///
/// Leaves the computation (see [`budget`]) where that needs more than [`MAX_GENERATORS`].
pub(crate) fn adjoin(field: &Arc<NumberField>, radicand: &Poly) -> Arc<NumberField> {
    if field.generators.len() >= MAX_GENERATORS {
        budget::refuse(format!("these numbers need more than {MAX_GENERATORS} independent square roots"));
    }
    budget::spend(1 << field.generators.len());
    debug_assert!(radicand.content().is_integer());
    let content = radicand.content().to_integer();
    let count = field.generators.len();
    let terms: Vec<(Vec<u32>, Int)> = radicand
        .terms()
        .iter()
        .map(|term| {
            let mut exponents = radicand.ring().generator_exponents(term.monomial);
            exponents.resize(count, 0);
            (exponents, &term.coefficient * &content)
        })
        .collect();
    let name = match radicand.to_rational() {
        Some(value) => {
            debug_assert!(value.is_positive());
            format!("sqrt{}", value.to_integer())
        }
        None => {
            let nested =
                field.generators.iter().filter(|generator| generator.name.starts_with("theta")).count();
            if nested == 0 { "theta".to_owned() } else { format!("theta{}", nested + 1) }
        }
    };
    let mut generators = field.generators.clone();
    generators.push(Generator { name, radicand: terms });
    NumberField::with_generators(generators)
}

/// A field that holds both: it begins with the generators of `a`. If it begins with those of `b` as well, no images
/// are given; otherwise the second value maps the generators of `b` to it.
pub(crate) fn join(a: &Arc<NumberField>, b: &Arc<NumberField>) -> (Arc<NumberField>, Option<Vec<Poly>>) {
    if b.is_prefix_of(a) {
        return (a.clone(), None);
    }
    if a.is_prefix_of(b) {
        return (b.clone(), None);
    }
    let mut field = a.clone();
    let mut images: Vec<Poly> = Vec::new();
    for position in 0..b.generators.len() {
        let radicand = b.radicand(position).map_generators(&field, &images);
        let root = square_root::adjoin_sqrt(&field, &radicand);
        field = root.ring().field().clone();
        images.push(root);
    }
    (field, Some(images))
}
