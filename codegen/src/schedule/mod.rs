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
//! Coefficients may have symbols besides (`families.rs`, `symbols.rs`): what depends on them alone is a stage of its own.
//!
//! [`check`] proves the result: it runs the program over polynomials and compares every output with what was derived.
//! Nothing here is approximate; constants are exact until [`crate::round`].

mod check;
mod differentiate;
mod families;
mod linear;
mod quotient;
mod separate;
mod slope;
mod symbols;
mod univariate;

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
    /// The numerators of the normal: R_u × R_v without the common factor of its components. If there are none, it is
    /// computed from the derivatives.
    pub normal: Option<&'a [Poly; 3]>,
    /// The root ρ of the normal's squared norm, ρ² = N·N, if there is one: the unit normal is then rational.
    pub normal_root: Option<&'a Poly>,
    /// The common factor of R_u × R_v, where the surface has zeros of it on its domain.
    pub singular: Option<&'a Poly>,
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
    /// R_u × R_v from the partial derivatives, for families whose normal is too large to be worth evaluating by itself.
    pub const CROSS_PRODUCT: &str = "cross_product";
    /// A polynomial that vanishes where the surface is singular, if there may be such points on the domain.
    pub const SINGULAR: &str = "singular";
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
///     normal: Some(&[-&y, -&x, Poly::one()]),
///     normal_root: None,
///     singular: None,
///     known: &[],
///     domain: &[[integer(0), integer(1)], [integer(0), integer(1)]],
///     conditions: &[],
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
        Some(form) => {
            if !families::symbols(derived.homogeneous, &parameters).is_empty() {
                builder.hint = Some(form.weight.clone());
            }
            form.schedule_surface(&mut builder, &preferred);
        }
        None => schedule_quotients(&mut builder, derived.homogeneous),
    }
    match derived.normal {
        None => schedule_cross_product(&mut builder.program),
        Some(normal) => schedule_normal(&mut builder, normal, derived.normal_root, &preferred),
    }
    let turns = derived.singular.filter(|_| builder.program.results(outputs::CROSS_PRODUCT).is_empty());
    if let Some(singular) = turns {
        let values = polynomials(&mut builder, std::slice::from_ref(singular));
        builder.program.output(outputs::SINGULAR, values);
    }
    if !derived.conditions.is_empty() {
        let values = derived.conditions.iter().map(|condition| builder.polynomial(condition)).collect();
        builder.program.output(outputs::CONDITIONS, values);
    }
    Ok(builder.program)
}

/// R_u × R_v
fn schedule_cross_product(program: &mut Program<Poly>) {
    let (a, b) = (program.results(outputs::PARTIAL_U).to_vec(), program.results(outputs::PARTIAL_V).to_vec());
    let values = cross_product(&a, &b, |operation| match operation {
        (true, x, y) => program.multiply(x, y),
        (false, x, y) => program.subtract(x, y),
    });
    program.output(outputs::CROSS_PRODUCT, values);
}

/// The components of a × b by operations: products (`true`) and differences (`false`).
fn cross_product(
    a: &[Value],
    b: &[Value],
    mut apply: impl FnMut((bool, Value, Value)) -> Value,
) -> Vec<Value> {
    let pairs = [(1, 2), (2, 0), (0, 1)];
    let minor = |(i, j): (usize, usize)| {
        let (plus, minus) = (apply((true, a[i], b[j])), apply((true, a[j], b[i])));
        apply((false, plus, minus))
    };
    pairs.into_iter().map(minor).collect()
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
        let separation = Separation::new(coordinates, Some(&weight), parameters, preferred);
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
        if builder.hint.is_some() {
            return self.schedule_family(builder, preferred);
        }
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

    /// The same for a family, where the derivatives of quotients are not always worth being reduced.
    fn schedule_family(&self, builder: &mut Builder<'_>, preferred: &[Poly]) {
        let parameters = builder.parameters;
        let point = quotients(builder, &self.of_u, &self.of_v);
        let homogeneous = self.homogeneous(builder);
        let of_u: Vec<Value> = self.of_u.iter().map(|f| builder.quotient(f)).collect();
        let mut of_v: Vec<Vec<Value>> = Vec::new();
        for row in &self.of_v {
            of_v.push(row.iter().map(|g| builder.quotient(g)).collect());
        }
        let slopes_u = builder.slopes(&self.of_u, &parameters.u, preferred);
        let all: Vec<Quotient> = self.of_v.iter().flatten().cloned().collect();
        let mut slopes_v = builder.slopes(&all, &parameters.v, preferred).into_iter();
        let (mut partial_u, mut partial_v) = (Vec::new(), Vec::new());
        for row in &of_v {
            let slopes: Vec<Value> = slopes_v.by_ref().take(row.len()).collect();
            let products: Vec<(Value, Value)> = slopes_u.iter().copied().zip(row.iter().copied()).collect();
            partial_u.push(builder.sum_of_nonzero_products(&products));
            let products: Vec<(Value, Value)> = of_u.iter().copied().zip(slopes).collect();
            partial_v.push(builder.sum_of_nonzero_products(&products));
        }
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
    let known: Vec<Poly> = builder.known.iter().map(|(_, poly)| poly.clone()).collect();
    let separation = Separation::new(polys, builder.hint.as_ref(), builder.parameters, &known);
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
fn schedule_normal(builder: &mut Builder<'_>, normal: &[Poly; 3], root: Option<&Poly>, preferred: &[Poly]) {
    let Some(root) = root else {
        let values = polynomials(builder, normal);
        builder.program.output(outputs::NORMAL_DIRECTION, values);
        return;
    };
    let values = match Form::of(root, normal, builder.parameters, preferred) {
        Some(form) => quotients(builder, &form.of_u, &form.of_v),
        None => {
            let root = polynomials(builder, std::slice::from_ref(root));
            let one = builder.program.constant(Poly::one());
            let inverse = builder.program.divide(one, root[0]);
            let direction = polynomials(builder, normal);
            direction.into_iter().map(|value| builder.program.multiply(value, inverse)).collect()
        }
    };
    builder.program.output(outputs::UNIT_NORMAL, values);
}

#[cfg(test)]
pub(crate) mod tests;
