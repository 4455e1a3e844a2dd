//! From derived polynomials to a staged program.
//!
//! [`schedule`] takes the homogeneous coordinates W, X, Y, Z of a surface and its reduced normal, and makes the program
//! that evaluates them together with the point, the first derivatives and the normal direction:
//!
//! 1. Each group of polynomials is separated exactly into the fewest terms f(u)·g(v) (`separate.rs`).
//! 2. Where the weight is a product A(u)·B(v), as it is of all sweeps of Farouki and Nittler, a point is the sum of
//!    (f/A)(u)·(g/B)(v) with both quotients reduced: the same rational function in another form, whose parts are each
//!    computed at their own stage. It has a pole exactly where W has a zero, since a factor common to all coordinates
//!    was divided out when they were derived. Derivatives differentiate those quotients. For other weights the
//!    coordinates are divided by W at each point.
//! 3. Polynomials of one parameter are evaluated once, by Horner's scheme or as products of others (`univariate.rs`).
//!
//! [`check`] proves the result: it runs the program over polynomials and compares every output with what was derived.
//! Nothing here is approximate; constants are exact until [`crate::round`].

mod check;
mod linear;
mod quotient;
mod separate;
mod univariate;

use std::collections::BTreeSet;
use std::fmt;

use hodograph_algebra::{Poly, Rational, Variable};

pub use check::{Fractions, Mismatch, check};

use crate::program::{Program, Value};
use quotient::Quotient;
use separate::{Parameters, Separation, split_weight};
use univariate::Builder;

/// What a schedule is made of: the derived polynomials of a surface.
#[derive(Clone, Debug)]
pub struct Derived<'a> {
    /// The parameters u and v.
    pub parameters: [&'a Variable; 2],
    /// The homogeneous coordinates W, X, Y, Z, with W not zero.
    pub homogeneous: &'a [Poly; 4],
    /// The numerators of the normal: R_u × R_v without the common factor of its components.
    pub normal: &'a [Poly; 3],
    /// The root ρ of the normal's squared norm, ρ² = N·N, if there is one: the unit normal is then rational.
    pub normal_root: Option<&'a Poly>,
    /// The common factor of R_u × R_v, where the surface has zeros of it on its domain.
    pub singular: Option<&'a Poly>,
    /// Names for polynomials of one parameter that may occur, such as σ. Names are ASCII identifiers.
    pub known: &'a [(String, Poly)],
    /// First and last value of u, then of v.
    pub domain: &'a [[Rational; 2]; 2],
}

impl Derived<'_> {
    fn validate(&self) -> Result<(), ScheduleError> {
        if self.homogeneous[0].is_zero() {
            return Err(ScheduleError::NoWeight);
        }
        let polys = self.homogeneous.iter().chain(self.normal).chain(self.normal_root).chain(self.singular);
        let occurring = polys.flat_map(Poly::occurring_variables);
        let symbols: BTreeSet<Variable> =
            occurring.filter(|variable| !self.parameters.contains(&variable)).collect();
        if symbols.is_empty() { Ok(()) } else { Err(ScheduleError::Symbols(symbols.into_iter().collect())) }
    }
}

/// Names of the outputs of scheduled programs.
pub mod outputs {
    /// W, X, Y, Z.
    pub const HOMOGENEOUS: &str = "homogeneous";
    /// x, y, z.
    pub const POINT: &str = "point";
    /// R_u.
    pub const PARTIAL_U: &str = "partial_u";
    /// R_v.
    pub const PARTIAL_V: &str = "partial_v";
    /// The unit normal, for surfaces where it is rational.
    pub const UNIT_NORMAL: &str = "unit_normal";
    /// A direction of the normal, for other surfaces.
    pub const NORMAL_DIRECTION: &str = "normal_direction";
    /// A polynomial that vanishes where the surface is singular, if there may be such points on the domain.
    pub const SINGULAR: &str = "singular";
}

/// Why a surface has no program.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum ScheduleError {
    /// There are symbols besides the parameters, whose values a program cannot know.
    Symbols(Vec<Variable>),
    /// The weight W is zero everywhere.
    NoWeight,
}

impl fmt::Display for ScheduleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ScheduleError::Symbols(symbols) => {
                let names: Vec<&str> = symbols.iter().map(Variable::name).collect();
                write!(f, "an evaluator needs numbers for the symbols {}", names.join(", "))
            }
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
/// [`ScheduleError`] if W is zero or symbols occur.
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
///     normal: &[-&y, -&x, Poly::one()],
///     normal_root: None,
///     singular: None,
///     known: &[],
///     domain: &[[integer(0), integer(1)], [integer(0), integer(1)]],
/// };
/// let program = schedule(&saddle).unwrap();
/// assert_eq!(check(&program, &saddle), Ok(()));
/// assert_eq!(program.count_all(program.results(outputs::POINT)).to_string(), "1 operation (1 ×)");
/// ```
pub fn schedule(derived: &Derived<'_>) -> Result<Program<Poly>, ScheduleError> {
    derived.validate()?;
    let [u, v] = derived.parameters;
    let parameters = Parameters { u: u.clone(), v: v.clone() };
    let mut builder = Builder::new(&parameters, derived.known, derived.domain);
    let preferred: Vec<Poly> = derived.known.iter().map(|(_, poly)| poly.clone()).collect();
    let [weight, coordinates @ ..] = derived.homogeneous;
    match Form::of(weight, coordinates, &parameters, &preferred) {
        Some(form) => form.schedule_surface(&mut builder, &preferred),
        None => schedule_quotients(&mut builder, derived.homogeneous),
    }
    schedule_normal(&mut builder, derived, &preferred);
    if let Some(singular) = derived.singular {
        let values = polynomials(&mut builder, std::slice::from_ref(singular));
        builder.program.output(outputs::SINGULAR, values);
    }
    Ok(builder.program)
}

/// Coordinates over a weight A(u)·B(v): c = Σ_k f_k(u)·g_{c,k}(v) and c/(A·B) = Σ_k (f_k/A)(u)·(g_{c,k}/B)(v).
struct Form {
    weight: (Poly, Poly),
    separation: Separation,
    /// f_k/A
    of_u: Vec<Quotient>,
    /// g_{c,k}/B, a row for each coordinate.
    of_v: Vec<Vec<Quotient>>,
}

impl Form {
    /// The form for `coordinates` over `weight`; `None` if the weight is not a product.
    fn of(weight: &Poly, coordinates: &[Poly], parameters: &Parameters, preferred: &[Poly]) -> Option<Form> {
        let weight = split_weight(weight, parameters)?;
        let separation = Separation::new(coordinates, Some(&weight), parameters);
        let of_u = separation.basis.iter().map(|f| Quotient::new(f, &weight.0, preferred)).collect();
        let of_v = separation
            .cofactors
            .iter()
            .map(|row| row.iter().map(|g| Quotient::new(g, &weight.1, preferred)).collect())
            .collect();
        Some(Form { weight, separation, of_u, of_v })
    }

    fn schedule_surface(&self, builder: &mut Builder<'_>, preferred: &[Poly]) {
        let parameters = builder.parameters;
        let derivative_u: Vec<Quotient> =
            self.of_u.iter().map(|f| f.derivative(&parameters.u, preferred)).collect();
        let derivative_v: Vec<Vec<Quotient>> = self
            .of_v
            .iter()
            .map(|row| row.iter().map(|g| g.derivative(&parameters.v, preferred)).collect())
            .collect();

        let point = quotients(builder, &self.of_u, &self.of_v);
        let homogeneous = self.homogeneous(builder);
        let partial_u = quotients(builder, &derivative_u, &self.of_v);
        let partial_v = quotients(builder, &self.of_u, &derivative_v);

        builder.program.output(outputs::HOMOGENEOUS, homogeneous);
        builder.program.output(outputs::POINT, point);
        builder.program.output(outputs::PARTIAL_U, partial_u);
        builder.program.output(outputs::PARTIAL_V, partial_v);
    }

    fn homogeneous(&self, builder: &mut Builder<'_>) -> Vec<Value> {
        let (a, b) = &self.weight;
        let (a, b) = (builder.polynomial(a), builder.polynomial(b));
        let mut values = vec![builder.sum_of_products(&[(a, b)])];
        values.extend(separated(builder, &self.separation));
        values
    }
}

/// Σ_k f_k(u)·g_{c,k}(v) for each row c of quotients.
fn quotients(builder: &mut Builder<'_>, of_u: &[Quotient], of_v: &[Vec<Quotient>]) -> Vec<Value> {
    let occurs = |k: &usize| !of_u[*k].is_zero() && of_v.iter().any(|row| !row[*k].is_zero());
    let all: Vec<&Quotient> = (0..of_u.len())
        .filter(occurs)
        .flat_map(|k| of_v.iter().map(move |row| &row[k]).chain([&of_u[k]]))
        .collect();
    builder.share(all.iter().copied());
    builder.prepare(all.iter().flat_map(|quotient| [&quotient.denominator, &quotient.numerator]));
    let mut rows = Vec::new();
    for row in of_v {
        let mut products = Vec::new();
        for (f, g) in of_u.iter().zip(row) {
            if !f.is_zero() && !g.is_zero() {
                products.push((builder.quotient(f), builder.quotient(g)));
            }
        }
        rows.push(builder.sum_of_products(&products));
    }
    rows
}

/// The polynomials of a separation.
fn separated(builder: &mut Builder<'_>, separation: &Separation) -> Vec<Value> {
    let of_u: Vec<Quotient> = separation.basis.iter().cloned().map(Quotient::polynomial).collect();
    let of_v: Vec<Vec<Quotient>> = separation
        .cofactors
        .iter()
        .map(|row| row.iter().cloned().map(Quotient::polynomial).collect())
        .collect();
    quotients(builder, &of_u, &of_v)
}

/// Polynomials of both parameters, separated together.
fn polynomials(builder: &mut Builder<'_>, polys: &[Poly]) -> Vec<Value> {
    let separation = Separation::new(polys, None, builder.parameters);
    separated(builder, &separation)
}

/// A surface whose weight is not a product: x = X/W, x_u = (X_u − x·W_u)/W.
fn schedule_quotients(builder: &mut Builder<'_>, homogeneous: &[Poly; 4]) {
    let parameters = builder.parameters;
    let values = polynomials(builder, homogeneous);
    let one = builder.program.constant(Poly::one());
    let inverse = builder.program.divide(one, values[0]);
    let point: Vec<Value> =
        values[1..].iter().map(|&value| builder.program.multiply(value, inverse)).collect();
    builder.program.output(outputs::HOMOGENEOUS, values);
    builder.program.output(outputs::POINT, point.clone());
    for (variable, name) in [(&parameters.u, outputs::PARTIAL_U), (&parameters.v, outputs::PARTIAL_V)] {
        let derivatives: Vec<Poly> = homogeneous.iter().map(|poly| poly.derivative(variable)).collect();
        let derivatives = polynomials(builder, &derivatives);
        let mut partial = Vec::new();
        for (&derivative, &coordinate) in derivatives[1..].iter().zip(&point) {
            let moved = builder.program.multiply(coordinate, derivatives[0]);
            let difference = builder.program.subtract(derivative, moved);
            partial.push(builder.program.multiply(difference, inverse));
        }
        builder.program.output(name, partial);
    }
}

/// The unit normal N/ρ where ρ is a polynomial, else the direction N.
fn schedule_normal(builder: &mut Builder<'_>, derived: &Derived<'_>, preferred: &[Poly]) {
    let Some(root) = derived.normal_root else {
        let values = polynomials(builder, derived.normal);
        builder.program.output(outputs::NORMAL_DIRECTION, values);
        return;
    };
    let values = match Form::of(root, derived.normal, builder.parameters, preferred) {
        Some(form) => quotients(builder, &form.of_u, &form.of_v),
        None => {
            let root = polynomials(builder, std::slice::from_ref(root));
            let one = builder.program.constant(Poly::one());
            let inverse = builder.program.divide(one, root[0]);
            let direction = polynomials(builder, derived.normal);
            direction.into_iter().map(|value| builder.program.multiply(value, inverse)).collect()
        }
    };
    builder.program.output(outputs::UNIT_NORMAL, values);
}

#[cfg(test)]
pub(crate) mod tests;
