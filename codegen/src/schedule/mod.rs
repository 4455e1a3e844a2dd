//! From derived polynomials to a staged program.
//!
//! [`schedule`] takes the homogeneous coordinates W, X, Y, Z of a surface and its reduced normal, and makes the
//! program that evaluates them together with all that follows: the point, first and second derivatives, the unit
//! normal, both fundamental forms, curvatures, speeds and the derivatives of the normal.
//!
//! 1. Each group of polynomials is separated exactly into the fewest terms f(u)·g(v) (`separate.rs`).
//! 2. Where the weight is a product A(u)·B(v), as it is of all sweeps of Farouki and Nittler, a point is the sum of
//!    (f/A)(u)·(g/B)(v) with both quotients reduced: the same rational function in another form, whose parts are each
//!    computed at their own stage. It has a pole exactly where W has a zero, since a factor common to all coordinates
//!    was divided out when they were derived. A single point is computed in a form that divides once (`surface.rs`).
//!    Derivatives differentiate the quotients of one parameter (`slope.rs`). For other weights the coordinates are
//!    divided by W at each point (`inseparable.rs`).
//! 3. Polynomials of one parameter are evaluated once, as products of others (`univariate.rs`), or by the scheme that the
//!    [`Preference`] asks for (`forms.rs`, `evaluate.rs`); the accurate point is a sum without cancellation (`accurate.rs`).
//! 4. Unit normal (`normal.rs`), forms and curvatures (`curvature.rs`) are computed from the derivatives of the point and of the
//!    normal (`weingarten.rs`); what decides on a sign is computed without cancellation (`sign.rs`).
//!
//! Coefficients may have symbols besides (`families.rs`, `symbols.rs`): what depends on them alone is a stage of its own.
//!
//! [`check`] proves the result: it runs the program over polynomials and compares its outputs with what was derived,
//! and proves derivatives by the rules of calculus (`differentiate.rs`, `letters.rs`). Nothing here is approximate;
//! constants are exact until [`crate::round`].

mod accurate;
mod check;
mod curvature;
mod differentiate;
mod evaluate;
mod families;
mod forms;
mod inseparable;
mod letters;
mod linear;
mod normal;
mod quotient;
mod regular;
mod separate;
mod sign;
mod slope;
mod surface;
mod symbols;
mod univariate;
mod vanish;
mod vector;
mod weingarten;

use std::fmt;

use hodograph_algebra::{BoxSign, Fraction, Interval, Poly, Rational, Variable, budget, integer};

pub(crate) use accurate::have_one_sign;
pub use check::{Fractions, Mismatch, check};
pub use forms::Preference;

use crate::program::{Program, Value};
use separate::Parameters;
use surface::Form;
use univariate::Builder;
use weingarten::Base;

/// An output with its values.
type OutputValues = (&'static str, Vec<Value>);

/// What a schedule is made of: the derived polynomials of a surface.
#[derive(Clone, Debug)]
pub struct Derived<'a> {
    /// The parameters u and v.
    pub parameters: [&'a Variable; 2],
    /// The homogeneous coordinates W, X, Y, Z by `scale`, with W not zero.
    pub homogeneous: &'a [Poly; 4],
    /// A power of two, so that floats hold what is made of very large or very small coefficients; 1 for others.
    pub scale: Rational,
    /// The numerators of the normal: R_u × R_v without the common factor of its components. If there are none, the normal
    /// is computed from the derivatives.
    pub normal: Option<&'a [Poly; 3]>,
    /// The root ρ of the normal's squared norm, ρ² = N·N, if there is one: the unit normal is then rational.
    pub normal_root: Option<&'a Poly>,
    /// The common factor of R_u × R_v, where the surface has zeros of it on its domain.
    pub singular: Option<&'a Poly>,
    /// The rational function by which R_u × R_v is the numerators of the normal, if it is known.
    pub factor: Option<&'a Fraction>,
    /// Names for polynomials of one parameter that may occur, such as σ. Names are ASCII identifiers.
    pub known: &'a [(String, Poly)],
    /// First and last value of u, then of v.
    pub domain: &'a [[Rational; 2]; 2],
    /// Polynomials of one parameter at most that are positive on the domain if the symbols have values for which the
    /// formulas hold.
    pub conditions: &'a [Poly],
}

impl Derived<'_> {
    fn validate(&self) -> Result<(), ScheduleError> {
        if self.homogeneous[0].is_zero() {
            return Err(ScheduleError::NoWeight);
        }
        Ok(())
    }
}

/// Names of the outputs of scheduled programs.
pub mod outputs {
    /// W, X, Y, Z.
    pub const HOMOGENEOUS: &str = "homogeneous";
    /// x, y, z with one division.
    pub const POINT: &str = "point";
    /// x, y, z from quotients of one parameter each: what takes least for each point of a grid.
    pub const SEPARATED_POINT: &str = "separated_point";
    /// x, y, z without cancellation where the control points' coordinates have one sign: if
    /// [`Preference::Accurate`](super::Preference) is asked for and there are no symbols.
    pub const ACCURATE_POINT: &str = "accurate_point";
    /// R_u.
    pub const PARTIAL_U: &str = "partial_u";
    /// R_v.
    pub const PARTIAL_V: &str = "partial_v";
    /// R_uu.
    pub const PARTIAL_UU: &str = "partial_uu";
    /// R_uv.
    pub const PARTIAL_UV: &str = "partial_uv";
    /// R_vv.
    pub const PARTIAL_VV: &str = "partial_vv";
    /// The unit normal n on the side of R_u × R_v.
    pub const UNIT_NORMAL: &str = "unit_normal";
    /// E = R_u·R_u, F = R_u·R_v, G = R_v·R_v.
    pub const FIRST_FORM: &str = "first_form";
    /// L = n·R_uu, M = n·R_uv, N = n·R_vv.
    pub const SECOND_FORM: &str = "second_form";
    /// The Gaussian curvature K.
    pub const GAUSSIAN: &str = "gaussian";
    /// The mean curvature H.
    pub const MEAN: &str = "mean";
    /// The principal curvatures k₁ ≥ k₂.
    pub const PRINCIPAL: &str = "principal";
    /// The parametric speeds ‖R_u‖ and ‖R_v‖.
    pub const SPEEDS: &str = "speeds";
    /// n_u.
    pub const NORMAL_U: &str = "normal_u";
    /// n_v.
    pub const NORMAL_V: &str = "normal_v";
    /// The derivative by u of what the unit normal is made of: of N/ρ where N·N has the root ρ, else of N. Not for families.
    pub const DIRECTION_U: &str = "direction_u";
    /// The same by v.
    pub const DIRECTION_V: &str = "direction_v";
    /// The rational function by which R_u × R_v is that which is differentiated: the signed area element where it is N/ρ.
    /// It is there if curvatures are computed with it.
    pub const AREA_FACTOR: &str = "area_factor";
    /// The derivative of the point by the parameter that it may vanish with, divided by a factor of it, if curvatures are
    /// computed with it.
    pub const PARTIAL_DIVIDED: &str = "partial_divided";
    /// The derivative by the same parameter of what the unit normal is made of, divided by the same factor.
    pub const DIRECTION_DIVIDED: &str = "direction_divided";
    /// The factor, by which the area factor is divided too.
    pub const COMMON_FACTOR: &str = "common_factor";
    /// Polynomials of one parameter that are positive on the domain where the symbols have values that are allowed.
    pub const CONDITIONS: &str = "conditions";
}

/// Why a surface has no program.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum ScheduleError {
    /// The weight W is zero everywhere.
    NoWeight,
}

impl fmt::Display for ScheduleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ScheduleError::NoWeight => f.write_str("the weight W of the surface is zero everywhere"),
        }
    }
}

impl std::error::Error for ScheduleError {}

/// The program that evaluates a surface.
///
/// Its outputs are those of [`outputs`]. A program for a surface of degree (m, n) and rank r takes O(r·(m + n))
/// operations, of which some r for each coordinate depend on both parameters.
///
/// # Errors
/// [`ScheduleError`] if W is zero.
///
/// # Example
/// ```
/// use hodograph_algebra::{Poly, Variable, integer};
/// use hodograph_codegen::schedule::{Derived, check, outputs, schedule};
/// let (u, v) = (Variable::new(0, "u"), Variable::new(1, "v"));
/// let (x, y) = (Poly::variable(&u), Poly::variable(&v));
/// let saddle = Derived {
///     parameters: [&u, &v],
///     homogeneous: &[Poly::one(), x.clone(), y.clone(), &x * &y],
///     scale: integer(1),
///     normal: Some(&[-&y, -&x, Poly::one()]),
///     normal_root: None,
///     singular: None,
///     factor: None,
///     known: &[],
///     domain: &[[integer(0), integer(1)], [integer(0), integer(1)]],
///     conditions: &[],
/// };
/// let program = schedule(&saddle).unwrap();
/// assert_eq!(check(&program, &saddle), Ok(()));
/// assert_eq!(program.count_all(program.results(outputs::POINT)).to_string(), "1 operation (1 ×)");
/// ```
pub fn schedule(derived: &Derived<'_>) -> Result<Program<Poly>, ScheduleError> {
    schedule_preferring(derived, Preference::default())
}

/// The program that evaluates a surface, with a preference for speed or for accuracy.
///
/// # Errors
/// [`ScheduleError`] if W is zero.
pub fn schedule_preferring(
    derived: &Derived<'_>,
    preference: Preference,
) -> Result<Program<Poly>, ScheduleError> {
    derived.validate()?;
    let [u, v] = derived.parameters;
    let parameters = Parameters { u: u.clone(), v: v.clone() };
    let mut builder = Builder::new(&parameters, derived.known, derived.domain, preference);
    let preferred: Vec<Poly> = derived.known.iter().map(|(_, poly)| poly.clone()).collect();
    let [weight, coordinates @ ..] = derived.homogeneous;
    let is_family = !families::symbols(derived.homogeneous, &parameters).is_empty();
    match Form::of(weight, coordinates, &parameters, &preferred) {
        Some(form) => {
            if is_family {
                builder.hint = Some(form.weight.clone());
            }
            form.schedule_surface(&mut builder, &preferred);
        }
        None => inseparable::schedule_surface(&mut builder, derived.homogeneous),
    }
    if derived.scale != integer(1) {
        let scale = builder.program.constant(Poly::constant(derived.scale.clone()));
        let scaled = builder.program.results(outputs::HOMOGENEOUS).to_vec();
        let values = scaled.into_iter().map(|value| builder.program.multiply(scale, value)).collect();
        builder.program.set_output(outputs::HOMOGENEOUS, values);
    }
    let wanted = preference == Preference::Accurate && !is_family;
    let accurate = wanted.then(|| accurate::point(&mut builder, derived.homogeneous)).flatten();
    if let Some(point) = accurate {
        builder.program.output(outputs::ACCURATE_POINT, point);
    }
    normal::schedule(&mut builder, derived, &preferred, is_family);
    let base = if is_family { Base::U } else { base(derived) };
    let sphere = if is_family { None } else { regular::of_sphere(derived) };
    let is_special = is_family || sphere.is_some();
    if !is_special && (derived.singular.is_some() || !curvature::is_diagonal(&mut builder.program, base)) {
        normal::schedule_area(&mut builder, derived, base, &preferred);
    }
    for (name, values) in curvature::of_patch(&mut builder.program, base, sphere.as_ref()) {
        builder.program.output(name, values);
    }
    if !derived.conditions.is_empty() {
        let values = derived.conditions.iter().map(|condition| builder.polynomial(condition)).collect();
        builder.program.output(outputs::CONDITIONS, values);
    }
    Ok(builder.program)
}

/// The units of work after which it is given up to prove that a derivative has no zeros.
const LIMIT: u64 = 500_000;

/// The parameter by which the derivative of the surface is known to have no zeros; u if that is known of neither or of both.
fn base(derived: &Derived<'_>) -> Base {
    if derived.singular.is_none() {
        return Base::U;
    }
    let number = |end: &Rational| Poly::constant(end.clone());
    let domain: Option<Vec<(Variable, Interval)>> = derived
        .parameters
        .iter()
        .zip(derived.domain)
        .map(|(&by, [start, end])| Some((by.clone(), Interval::new(number(start), number(end))?)))
        .collect();
    let Some(domain) = domain else { return Base::U };
    let [weight, coordinates @ ..] = derived.homogeneous;
    let is_regular = |by: &Variable| {
        let slope = |x: &Poly| x.derivative(by) * weight - x * weight.derivative(by);
        let mut square: Poly = coordinates.iter().map(|x| slope(x).pow(2)).sum();
        // The weight is not zero, so its square may be divided by.
        while let Some(quotient) = square.exact_div(weight).filter(|_| !weight.is_constant()) {
            square = quotient;
        }
        let sign = budget::with_budget(LIMIT, || square.sign_on(&domain));
        matches!(sign, Ok(Some(BoxSign::Positive)))
    };
    let [u, v] = derived.parameters;
    if !is_regular(u) && is_regular(v) { Base::V } else { Base::U }
}

#[cfg(test)]
mod accurate_tests;
#[cfg(test)]
mod curvature_tests;
#[cfg(test)]
pub(crate) mod tests;
