//! The two fundamental forms of a rational surface, its curvatures, and what is made of them.

use std::fmt;

use super::direction::Direction;
use super::form_function::{
    FormFunction, first_determinant, mixed_determinant, monomials, second_determinant,
};
use super::normal::Normal;
use super::swept::{OffsetError, SweptSurface};
use crate::geometry::sample::sample_sign_on_box;
use crate::{Fraction, Interval, Poly, QuadraticFraction, Variable, Vector, budget};

/// The fundamental forms of a rational surface R, in parts that keep what they have in common.
///
/// With `R_u × R_v = f·N`, N in lowest terms, the unit normal is `n₁ = N/|N|` and `√(EG − F²) = f·|N|`; beyond the zeros of f, where
/// `f < 0`, that is the negative root, so that all functions are smooth there. The derivatives of N serve in place of second
/// derivatives of R, since `N·R_u = N·R_v = 0`:
///
/// - `L = −R_u·N_u/|N|`, `M = −R_u·N_v/|N|`, `N = −R_v·N_v/|N|`,
/// - `K = k/(f·|N|⁴)` with `k = [N N_u N_v]`,
/// - `H = h/(2f·|N|³)` with `h = [N R_v N_u] − [N R_u N_v]`.
///
/// In quotients such as `H/K = h·|N|/(2k)` the factors f and |N|³ cancel without being multiplied out.
///
/// # Example
/// A saddle: `K = −1/(1 + u² + v²)²` is rational, M is not.
/// ```
/// use hodograph_algebra::{FormFunction, Fraction, Interval, Poly, SweptSurface, Variable, Vector};
/// let parameters = [Variable::new(0, "u"), Variable::new(1, "v")];
/// let [u, v] = parameters.each_ref().map(|p| Fraction::from(Poly::variable(p)));
/// let domain = [Interval::unit(), Interval::unit()];
/// let saddle = SweptSurface::new(Vector::new(u.clone(), v.clone(), &u * &v), parameters, domain);
/// let forms = saddle.forms().unwrap();
/// let value = |name| forms.value(&FormFunction::named(name).unwrap()).unwrap().to_string();
/// assert_eq!(value("E"), "v^2 + 1");
/// assert_eq!(value("M"), "(1/(u^2 + v^2 + 1))*sqrt(u^2 + v^2 + 1)");
/// assert_eq!(value("K"), "-1/(u^2 + v^2 + 1)^2");
/// ```
#[derive(Clone, Debug)]
pub struct FundamentalForms {
    normal: Normal,
    /// `R_u` and `R_v`, each as a factor and a direction.
    along: [Direction; 2],
    /// `N_u` and `N_v`.
    turn: [[Poly; 3]; 2],
    /// `h = [N R_v N_u] − [N R_u N_v]`.
    mean: Fraction,
    /// `k = [N N_u N_v]`.
    gaussian: Poly,
    weight: Poly,
    parameters: [Variable; 2],
    domain: [Interval; 2],
}

/// Why a formula in the fundamental forms has no value on a surface, or no offset.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum FormError {
    /// A divisor vanishes identically: K on a developable surface, H on a minimal one, or another polynomial in E, …, N.
    Vanishes {
        /// The divisor as a formula.
        divisor: String,
    },
    /// It is no similarity function: a similarity of ratio ϱ multiplies it by a power of ϱ other than the first.
    Weight {
        /// The power.
        weight: i64,
    },
    /// It is no similarity function: its terms are multiplied by different powers of the ratio.
    Mixed,
    /// `|N|²` is too large to be multiplied out, as with many symbols.
    TooLarge,
}

impl fmt::Display for FormError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FormError::Vanishes { divisor } => {
                write!(f, "the divisor {divisor} is zero everywhere on this surface")?;
                f.write_str(match divisor.as_str() {
                    "L*N - M^2" => ": its Gaussian curvature vanishes, it is developable",
                    "E*N - 2*F*M + G*L" => {
                        ": its mean curvature vanishes, it is a minimal surface or a plane"
                    }
                    _ => "",
                })
            }
            FormError::Weight { weight } => {
                write!(f, "a similarity of ratio rho multiplies this formula by rho^{weight}, not by rho")?;
                if weight % 2 == 0 {
                    f.write_str(
                        "; it has an even number of the irrational factors L, M, N, H in each term, so that its \
                         product with the unit normal is not rational",
                    )?;
                }
                Ok(())
            }
            FormError::Mixed => f.write_str(
                "a similarity of ratio rho multiplies the terms of this formula by different powers of rho",
            ),
            FormError::TooLarge => {
                f.write_str("the square of the normal's length is too large to be multiplied out")
            }
        }
    }
}

impl std::error::Error for FormError {}

fn dot(a: &[Poly; 3], b: &[Poly; 3]) -> Poly {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn cross(a: &[Poly; 3], b: &[Poly; 3]) -> [Poly; 3] {
    let minor = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

impl FundamentalForms {
    /// The forms of a surface; `None` if it is a curve or a point.
    pub(super) fn of(surface: &SweptSurface) -> Option<FundamentalForms> {
        let normal = surface.normal().ok()?.clone();
        let parameters = surface.parameters().clone();
        let position = surface.homogeneous().cartesian();
        let [u, v] = parameters
            .each_ref()
            .map(|parameter| Direction::of(&position.derivative(parameter), surface.directions()));
        let along = [u?, v?];
        let vector = normal.numerator();
        let turn = parameters.each_ref().map(|by| vector.each_ref().map(|part| part.derivative(by)));
        let (mean, gaussian) = budget::doing("the curvatures", || {
            let [by_u, by_v] = turn.each_ref().map(|turn| cross(vector, turn));
            // [R_u N N_v] − [R_v N N_u]
            let part = |direction: &Direction, by: &[Poly; 3]| {
                direction.factor.reduced_product(&dot(&direction.numerator, by).into())
            };
            let mean = &part(&along[0], &by_v) - &part(&along[1], &by_u);
            (mean.reduced(), dot(&by_u, &turn[1]))
        });
        let domain = surface.domain().clone();
        let weight = surface.homogeneous().coordinates()[0].clone();
        Some(FundamentalForms { normal, along, turn, mean, gaussian, weight, parameters, domain })
    }

    /// The normal.
    #[must_use]
    pub fn normal(&self) -> &Normal {
        &self.normal
    }

    /// `K = k/(f·|N|⁴)` and `H = h/(2f·|N|³)`, the latter without the number and the square root in it, which is positive: both vanish
    /// where these do.
    ///
    /// # Errors
    /// [`FormError::TooLarge`].
    pub(super) fn curvatures(&self) -> Result<[Fraction; 2], FormError> {
        let over_factor = |part: &Fraction| {
            let known: Vec<Poly> = part.factors().iter().map(|(factor, _)| factor.clone()).collect();
            let inverse = self.normal.factor().reciprocal(&known).ok_or(FormError::TooLarge)?;
            Ok::<Fraction, FormError>(part.reduced_product(&inverse.reduced()))
        };
        let gaussian = over_factor(&self.gaussian.clone().into())?.reduced_product(&self.squared_length(-2)?);
        // 1/|N| is a multiple of the root of the odd factor by the inverse of that and of the root.
        let split = self.normal.squared_length().split();
        let parts = [(split.root.clone(), 1), (split.odd.clone(), 1)];
        let inverse = Fraction::new(Poly::one(), parts.into_iter().filter(|(part, _)| !part.is_constant()));
        let mean = over_factor(&self.mean)?.reduced_product(&self.squared_length(-1)?);
        Ok([gaussian, mean.reduced_product(&inverse)])
    }

    /// Whether the Gaussian and the mean curvature vanish everywhere.
    pub(super) fn are_zero(&self) -> [bool; 2] {
        [self.gaussian.is_zero(), self.mean.is_zero()]
    }

    /// The weight of the surface.
    pub(super) fn weight(&self) -> &Poly {
        &self.weight
    }

    /// The parameters with their intervals.
    pub(super) fn region(&self) -> Vec<(Variable, Interval)> {
        self.parameters.iter().cloned().zip(self.domain.iter().cloned()).collect()
    }

    /// E, F and G, then L, M and N times `|N|`: all rational.
    fn coefficients(&self) -> [Fraction; 6] {
        let [u, v] = &self.along;
        let product = |a: &Direction, b: &Direction| {
            a.factor.reduced_product(&b.factor).reduced_product(&dot(&a.numerator, &b.numerator).into())
        };
        let bend =
            |a: &Direction, turn: &[Poly; 3]| a.factor.reduced_product(&(-dot(&a.numerator, turn)).into());
        [
            product(u, u),
            product(u, v),
            product(v, v),
            bend(u, &self.turn[0]),
            bend(u, &self.turn[1]),
            bend(v, &self.turn[1]),
        ]
    }

    /// `|N|²` as a number and a product of known factors, to the power `exponent`.
    fn squared_length(&self, exponent: i64) -> Result<Fraction, FormError> {
        let squared = self.normal.squared_length();
        if squared.expanded().is_none() {
            return Err(FormError::TooLarge);
        }
        let split = squared.split();
        let parts = [(&split.root, 2), (&split.odd, 1), (squared.radicand(), 1)];
        let count = u32::try_from(exponent.unsigned_abs()).map_err(|_| FormError::TooLarge)?;
        if exponent >= 0 {
            let product: Poly = parts.iter().map(|(part, e)| part.pow(*e * count)).product();
            return Ok((product * split.unit.pow(count)).into());
        }
        let factors = parts.iter().map(|(part, e)| ((*part).clone(), *e * count));
        Ok(Fraction::new(split.unit.inverse().pow(count), factors.filter(|(part, _)| !part.is_one())))
    }

    /// `|N|`, positive where the domain begins.
    ///
    /// # Errors
    /// [`FormError::TooLarge`].
    pub fn length(&self) -> Result<QuadraticFraction, FormError> {
        let squared = self.normal.squared_length();
        let square = squared.expanded().ok_or(FormError::TooLarge)?;
        let root = QuadraticFraction::root_of(&square.clone().into()).ok_or(FormError::TooLarge)?;
        let negative =
            sample_sign_on_box(&squared.split().root.clone().into(), &self.parameters, &self.domain).is_lt();
        Ok(if negative { root.scale(&Poly::integer(-1).into()) } else { root })
    }

    /// The unit normal `n₁ = N/|N|` (GE (4.4)), component by component.
    ///
    /// # Errors
    /// [`FormError::TooLarge`].
    pub fn unit_normal(&self) -> Result<[QuadraticFraction; 3], FormError> {
        let inverse = self.squared_length(-1)?;
        let length = self.length()?.scale(&inverse);
        Ok(self.normal.numerator().each_ref().map(|part| length.scale(&part.clone().into())).map(reduced))
    }

    /// The value of a formula on the surface.
    ///
    /// # Errors
    /// [`FormError`], but for those about weights.
    pub fn value(&self, function: &FormFunction) -> Result<QuadraticFraction, FormError> {
        let Value { factor, length, mixed } = self.evaluate(function)?;
        // |N|^(2e) or |N|^(2e + 1)
        let even = length.div_euclid(2);
        let factor = factor.reduced_product(&self.squared_length(even)?);
        let mut value = QuadraticFraction::from(factor.clone());
        if length.rem_euclid(2) == 1 {
            value = self.length()?.scale(&factor);
        }
        for part in mixed {
            value = value.times(&part).ok_or(FormError::TooLarge)?;
        }
        Ok(reduced(value))
    }

    /// The vector `f·n₁` for a similarity function f: rational, since f contains `|N|` to an odd power (GE (4.13)).
    ///
    /// # Errors
    /// [`FormError`].
    pub(super) fn similarity_vector(&self, function: &FormFunction) -> Result<Vector, FormError> {
        match function.weight() {
            Some(1) => {}
            Some(weight) => return Err(FormError::Weight { weight }),
            None => return Err(FormError::Mixed),
        }
        let [x, y, z] = self.normal.numerator().each_ref().map(|part| Fraction::from(part.clone()));
        let Value { factor, length, mixed } = self.evaluate(function)?;
        if factor.is_zero() {
            return Ok(Vector::zero());
        }
        // Numerator and denominator of a formula that has a weight each contain |N| to powers of one parity.
        if !mixed.is_empty() || length.rem_euclid(2) == 0 {
            return Err(FormError::Mixed);
        }
        let factor = factor.reduced_product(&self.squared_length((length - 1) / 2)?);
        Ok(Vector::new(x, y, z).scale(&factor).reduced())
    }

    /// The value of a formula, its parts kept as powers: f, h and k cancel where exponents add up to zero.
    fn evaluate(&self, function: &FormFunction) -> Result<Value, FormError> {
        let formula = function.formula().lowest_terms();
        let coefficients = self.coefficients();
        let (mut f, mut h, mut k) = (0, 0, 0);
        let mut value = Value { factor: Fraction::one(), length: 0, mixed: Vec::new() };
        let parts = std::iter::once((formula.numerator(), 1))
            .chain(formula.factors().iter().map(|(factor, exponent)| (factor, -i64::from(*exponent))));
        for (poly, exponent) in parts {
            // EG − F² = f²·|N|², EN − 2FM + GL = f·h/|N|, LN − M² = f·k/|N|².
            let (first, rest) = poly.take_out(&first_determinant());
            let (middle, rest) = rest.take_out(&mixed_determinant());
            let (second, rest) = rest.take_out(&second_determinant());
            let [first, middle, second] = [first, middle, second].map(|power| exponent * i64::from(power));
            f += 2 * first + middle + second;
            h += middle;
            k += second;
            value.length += 2 * first - middle - 2 * second;
            value.multiply(&rest, exponent, &self.parity_parts(&rest, &coefficients)?, self)?;
        }
        value.scale(self.normal.factor(), f, "E*G - F^2")?;
        value.scale(&self.mean, h, "E*N - 2*F*M + G*L")?;
        value.scale(&self.gaussian.clone().into(), k, "L*N - M^2")?;
        Ok(value)
    }

    /// A polynomial in E, …, N on the surface as `|N|^−e·a + |N|^−o·b`: its terms with an even and with an odd number of the letters L,
    /// M, N, each with the largest such number.
    fn parity_parts(
        &self,
        poly: &Poly,
        coefficients: &[Fraction; 6],
    ) -> Result<[(Fraction, i64); 2], FormError> {
        let mut parts = [(Fraction::zero(), 0), (Fraction::zero(), 1)];
        for (exponents, coefficient) in monomials(poly) {
            let count: i64 = exponents[3..].iter().map(|e| i64::from(*e)).sum();
            let mut term = Fraction::from(coefficient);
            for (power, own) in exponents.iter().zip(coefficients) {
                term = term.reduced_product(&own.pow(*power));
            }
            let (sum, most) = &mut parts[usize::from(count % 2 == 1)];
            // Both over the larger power of 1/|N|.
            if count > *most {
                *sum = sum.reduced_product(&self.squared_length((count - *most) / 2)?);
                *most = count;
            } else {
                term = term.reduced_product(&self.squared_length((*most - count) / 2)?);
            }
            *sum = (&*sum + &term).reduced();
        }
        Ok(parts)
    }
}

/// A product `factor·|N|^length·Π mixed`.
struct Value {
    factor: Fraction,
    length: i64,
    /// Factors that are sums of both parities.
    mixed: Vec<QuadraticFraction>,
}

impl Value {
    /// Multiplies by a power of a fraction, a formula of this name.
    fn scale(&mut self, base: &Fraction, exponent: i64, name: &str) -> Result<(), FormError> {
        let count = u32::try_from(exponent.unsigned_abs()).map_err(|_| FormError::TooLarge)?;
        if count == 0 {
            return Ok(());
        }
        let power = if exponent > 0 {
            base.clone()
        } else {
            let known: Vec<Poly> = self.factor.factors().iter().map(|(factor, _)| factor.clone()).collect();
            base.reciprocal(&known).ok_or_else(|| FormError::Vanishes { divisor: name.to_owned() })?
        };
        self.factor = self.factor.reduced_product(&power.reduced().pow(count));
        Ok(())
    }

    /// Multiplies by a power of a polynomial in E, …, N, given in its parts.
    fn multiply(
        &mut self,
        formula: &Poly,
        exponent: i64,
        [(even, evens), (odd, odds)]: &[(Fraction, i64); 2],
        forms: &FundamentalForms,
    ) -> Result<(), FormError> {
        let name = formula.to_string();
        if odd.is_zero() || even.is_zero() {
            let (part, count) = if odd.is_zero() { (even, evens) } else { (odd, odds) };
            self.length -= exponent * count;
            return self.scale(part, exponent, &name);
        }
        let power = |part: &Fraction, count: i64| -> Result<Fraction, FormError> {
            Ok(part.reduced_product(&forms.squared_length(-count)?))
        };
        // |N|^−odds = |N|·(|N|²)^−((odds + 1)/2)
        let irrational = forms.length()?.scale(&power(odd, (odds + 1) / 2)?);
        let sum = irrational.plus(&power(even, evens / 2)?.into()).ok_or(FormError::TooLarge)?;
        let sum =
            if exponent > 0 { sum } else { sum.reciprocal().ok_or(FormError::Vanishes { divisor: name })? };
        (0..exponent.abs()).for_each(|_| self.mixed.push(sum.clone()));
        Ok(())
    }
}

/// The same function with known factors cancelled.
fn reduced(value: QuadraticFraction) -> QuadraticFraction {
    value.map(&|part| part.reduced())
}

impl SweptSurface {
    /// The fundamental forms.
    ///
    /// # Errors
    /// [`OffsetError::NoSurface`] if `R_u × R_v` vanishes identically.
    pub fn forms(&self) -> Result<&FundamentalForms, OffsetError> {
        let forms = self.forms_cell().get_or_init(|| FundamentalForms::of(self).map(Box::new));
        forms.as_deref().ok_or(OffsetError::NoSurface)
    }

    /// The similarity offset `R + distance·f·n₁` for a similarity function f, a formula of [weight](FormFunction::weight) 1 (GE (4.10)):
    /// rational for every rational surface (GE Theorem 4.5). It does not depend on the side that n₁ points to.
    ///
    /// # Errors
    /// [`FormError`]; a curve or a point has no forms, so that it is [`FormError::Vanishes`] with the divisor `E*G - F^2`.
    ///
    /// # Example
    /// The unit sphere has `H/K = ∓1`: at the distance 1/2 it becomes the sphere of radius 1/2.
    /// ```
    /// use hodograph_algebra::{FormFunction, Fraction, Interval, Poly, SweptSurface, Variable, Vector, ratio};
    /// let parameters = [Variable::new(0, "u"), Variable::new(1, "v")];
    /// let [u, v] = parameters.each_ref().map(|p| Fraction::from(Poly::variable(p)));
    /// let squares = &(&u * &u) + &(&v * &v);
    /// let (weight, height) = (&Fraction::one() + &squares, &Fraction::one() - &squares);
    /// let sphere = Vector::new(&(&u + &u) / &weight, &(&v + &v) / &weight, &height / &weight);
    /// let sphere = SweptSurface::new(sphere, parameters, [Interval::unit(), Interval::unit()]);
    /// let [mean, gaussian] = ["H", "K"].map(|name| FormFunction::named(name).unwrap());
    /// let f1 = mean.times(&gaussian.reciprocal().unwrap());
    /// let offset = sphere.similarity_offset(&f1, &ratio(1, 2).into()).unwrap();
    /// assert_eq!(offset.position(), &sphere.position().scale_by(&ratio(1, 2)));
    /// assert!(sphere.similarity_offset(&gaussian, &ratio(1, 2).into()).is_err());
    /// ```
    pub fn similarity_offset(
        &self,
        function: &FormFunction,
        distance: &Fraction,
    ) -> Result<SweptSurface, FormError> {
        let forms =
            self.forms().map_err(|_| FormError::Vanishes { divisor: first_determinant().to_string() })?;
        let vector =
            budget::doing("the vector f n1 of a similarity offset", || forms.similarity_vector(function))?;
        let position = &self.homogeneous().cartesian() + &vector.scale(distance);
        let surface = SweptSurface::new(position, self.parameters().clone(), self.domain().clone());
        Ok(surface.with_known_directions(self.directions()))
    }
}
