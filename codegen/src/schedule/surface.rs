//! Surfaces whose weight is a product: points and derivatives as sums of products of one parameter each.
//!
//! Over a weight W = A(u)·B(v) every coordinate is c/W = Σ_k (f_k/A)(u)·(g_{c,k}/B)(v). That sum has two forms:
//!
//! - *separated*: each quotient is reduced and computed at its own stage, so that a point of a grid takes a product and a sum
//!   for each term. Derivatives differentiate the quotients of one parameter:
//!   R_u = Σ (f_k/A)'·(g_k/B), R_uv = Σ (f_k/A)'·(g_k/B)', R_vv = Σ (f_k/A)·(g_k/B)''.
//! - *joint*: with one inverse 1/(A·B) for a point, by which only those terms are multiplied that are no polynomials.

use hodograph_algebra::Poly;

use super::outputs;
use super::quotient::Quotient;
use super::separate::{Parameters, Separation, split_weight};
use super::univariate::Builder;
use crate::program::Value;

/// Coordinates over a weight A(u)·B(v): c = Σ_k f_k(u)·g_{c,k}(v) and c/(A·B) = Σ_k (f_k/A)(u)·(g_{c,k}/B)(v).
pub(super) struct Form {
    pub(super) weight: (Poly, Poly),
    separation: Separation,
    /// f_k/A
    pub(super) of_u: Vec<Quotient>,
    /// g_{c,k}/B, a row for each coordinate.
    pub(super) of_v: Vec<Vec<Quotient>>,
}

impl Form {
    /// The form for `coordinates` over `weight`; `None` if the weight is not a product.
    pub(super) fn of(
        weight: &Poly,
        coordinates: &[Poly],
        parameters: &Parameters,
        preferred: &[Poly],
    ) -> Option<Form> {
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

    /// Homogeneous coordinates, both forms of the point, and first and second derivatives.
    pub(super) fn schedule_surface(&self, builder: &mut Builder<'_>, preferred: &[Poly]) {
        let parameters = builder.parameters;
        let separated = quotients(builder, &self.of_u, &self.of_v);
        let homogeneous = self.homogeneous(builder);
        let point = self.joint(builder, preferred, &separated);

        let width = self.of_u.len();
        let flat: Vec<Quotient> = self.of_v.iter().flatten().cloned().collect();
        let of_u: Vec<Value> = self.of_u.iter().map(|f| builder.quotient(f)).collect();
        let of_v: Vec<Value> = flat.iter().map(|g| builder.quotient(g)).collect();
        let [slopes_u, bends_u] = builder.slopes(&self.of_u, &parameters.u, preferred);
        let [slopes_v, bends_v] = builder.slopes(&flat, &parameters.v, preferred);
        let mut sums = |of_u: &[Value], of_v: &[Value]| -> Vec<Value> {
            let row = |row: &[Value]| -> Vec<_> { of_u.iter().copied().zip(row.iter().copied()).collect() };
            of_v.chunks(width.max(1)).map(|values| builder.sum_of_nonzero_products(&row(values))).collect()
        };
        let partials = [
            (outputs::PARTIAL_U, sums(&slopes_u, &of_v)),
            (outputs::PARTIAL_V, sums(&of_u, &slopes_v)),
            (outputs::PARTIAL_UU, sums(&bends_u, &of_v)),
            (outputs::PARTIAL_UV, sums(&slopes_u, &slopes_v)),
            (outputs::PARTIAL_VV, sums(&of_u, &bends_v)),
        ];
        builder.program.output(outputs::HOMOGENEOUS, homogeneous);
        builder.program.output(outputs::POINT, point);
        builder.program.output(outputs::SEPARATED_POINT, separated);
        for (name, values) in partials {
            builder.program.output(name, values);
        }
    }

    /// The derivatives of the quotients Σ_k (f_k/A)·(g_{c,k}/B) by u and by v.
    pub(super) fn schedule_slopes(&self, builder: &mut Builder<'_>, preferred: &[Poly]) -> [Vec<Value>; 2] {
        let parameters = builder.parameters;
        let width = self.of_u.len().max(1);
        let flat: Vec<Quotient> = self.of_v.iter().flatten().cloned().collect();
        let of_u: Vec<Value> = self.of_u.iter().map(|f| builder.quotient(f)).collect();
        let of_v: Vec<Value> = flat.iter().map(|g| builder.quotient(g)).collect();
        let (slopes_u, _) = builder.first_slopes(&self.of_u, &parameters.u, preferred);
        let (slopes_v, _) = builder.first_slopes(&flat, &parameters.v, preferred);
        [(slopes_u, of_v), (of_u, slopes_v)].map(|(of_u, of_v)| {
            let row = |row: &[Value]| -> Vec<_> { of_u.iter().copied().zip(row.iter().copied()).collect() };
            of_v.chunks(width).map(|values| builder.sum_of_nonzero_products(&row(values))).collect()
        })
    }

    fn homogeneous(&self, builder: &mut Builder<'_>) -> Vec<Value> {
        let (a, b) = &self.weight;
        let (a, b) = (builder.polynomial(a), builder.polynomial(b));
        let mut values = vec![builder.sum_of_products(&[(a, b)])];
        values.extend(sums(builder, &self.separation));
        values
    }

    /// The point with one division, by the weight: Σ_k f_k·g_k/W, where the sum over those k whose f_k is a multiple
    /// of A and whose g_k is one of B is a polynomial.
    ///
    /// Where the separated form divides once at most, it is this one: that is so if A or B is a number. A number that
    /// is a factor of B is divided out before if that saves operations.
    fn joint(&self, builder: &mut Builder<'_>, preferred: &[Poly], separated: &[Value]) -> Vec<Value> {
        if builder.program.count_all(separated).divisions <= 1 {
            return separated.to_vec();
        }
        let (_, b) = &self.weight;
        // 1/B is a number over B without its number.
        let scaled = Quotient::new(&Poly::one(), b, preferred);
        let (point, inverse) =
            self.over_weight(builder, &Quotient { numerator: Poly::one(), denominator: b.clone() });
        let total = |builder: &Builder<'_>, point: &[Value]| builder.program.count_all(point).total();
        let other = (!scaled.numerator.is_one()).then(|| self.over_weight(builder, &scaled));
        let other = other.filter(|(other, _)| total(builder, other) < total(builder, &point));
        let (point, inverse) = other.unwrap_or((point, inverse));
        builder.program.name(inverse, "weight_inverse");
        point
    }

    /// The joint form with 1/B as a number over a polynomial, and the inverse of A times that polynomial.
    fn over_weight(&self, builder: &mut Builder<'_>, of_b: &Quotient) -> (Vec<Value>, Value) {
        let (a, b) = (builder.polynomial(&self.weight.0), builder.polynomial(&of_b.denominator));
        let weight = builder.sum_of_products(&[(a, b)]);
        let one = builder.program.constant(Poly::one());
        let inverse = builder.program.divide(one, weight);
        let rows: Vec<Row> = (0..self.of_v.len()).map(|row| self.row(row)).collect();
        let scaled = scaled_factors(&rows, self.of_u.len());
        let coordinates = rows.iter().zip(self.of_v.iter().zip(&self.separation.cofactors));
        let point = coordinates.map(|(row, (quotients, cofactors))| {
            let mut sum: Vec<(Value, Value)> = row
                .whole
                .iter()
                .map(|&k| (builder.quotient(&self.of_u[k]), builder.quotient(&quotients[k])))
                .collect();
            let divided: Vec<(Value, Value)> = row
                .divided
                .iter()
                .map(|&k| {
                    let f = builder.polynomial(&self.separation.basis[k]);
                    let f = if scaled[k] { builder.sum_of_products(&[(f, inverse)]) } else { f };
                    (f, builder.polynomial(&(&cofactors[k] * &of_b.numerator)))
                })
                .collect();
            if row.divided.iter().all(|&k| scaled[k]) {
                sum.extend(divided);
            } else {
                sum.push((builder.sum_of_products(&divided), inverse));
            }
            builder.sum_of_products(&sum)
        });
        (point.collect(), inverse)
    }

    /// Which terms of a coordinate are polynomials, and which are divided by the weight.
    fn row(&self, row: usize) -> Row {
        let (mut whole, mut divided) = (Vec::new(), Vec::new());
        for (k, (f, g)) in self.of_u.iter().zip(&self.of_v[row]).enumerate() {
            if f.is_zero() || g.is_zero() {
                continue;
            }
            let polynomial = f.denominator.is_one() && g.denominator.is_one();
            if polynomial { &mut whole } else { &mut divided }.push(k);
        }
        Row { whole, divided }
    }
}

/// The places of a coordinate's terms.
struct Row {
    whole: Vec<usize>,
    divided: Vec<usize>,
}

/// Which factors f_k are multiplied by the inverse of the weight before they are multiplied by others: where they are
/// fewer than the coordinates that they occur in. Otherwise the sum of a coordinate's terms is multiplied.
fn scaled_factors(rows: &[Row], width: usize) -> Vec<bool> {
    // Coordinates that have a factor in common are taken together.
    let mut groups: Vec<usize> = (0..width).collect();
    for row in rows {
        for pair in row.divided.windows(2) {
            let (from, to) = (groups[pair[1]], groups[pair[0]]);
            groups.iter_mut().filter(|group| **group == from).for_each(|group| *group = to);
        }
    }
    let occurs = |k: usize| rows.iter().any(|row| row.divided.contains(&k));
    let factors = |group: usize| (0..width).filter(|&k| groups[k] == group && occurs(k)).count();
    let coordinates =
        |group: usize| rows.iter().filter(|row| row.divided.iter().any(|&k| groups[k] == group)).count();
    groups.iter().map(|&group| factors(group) < coordinates(group)).collect()
}

/// Σ_k f_k(u)·g_{c,k}(v) for each row c of quotients.
pub(super) fn quotients(builder: &mut Builder<'_>, of_u: &[Quotient], of_v: &[Vec<Quotient>]) -> Vec<Value> {
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
fn sums(builder: &mut Builder<'_>, separation: &Separation) -> Vec<Value> {
    let of_u: Vec<Quotient> = separation.basis.iter().cloned().map(Quotient::polynomial).collect();
    let of_v: Vec<Vec<Quotient>> = separation
        .cofactors
        .iter()
        .map(|row| row.iter().cloned().map(Quotient::polynomial).collect())
        .collect();
    quotients(builder, &of_u, &of_v)
}

/// Polynomials of both parameters, separated together.
pub(super) fn polynomials(builder: &mut Builder<'_>, polys: &[Poly]) -> Vec<Value> {
    let known: Vec<Poly> = builder.known.iter().map(|(_, poly)| poly.clone()).collect();
    let separation = Separation::new(polys, builder.hint.as_ref(), builder.parameters, &known);
    sums(builder, &separation)
}
