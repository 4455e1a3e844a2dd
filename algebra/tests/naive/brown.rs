//! Greatest common divisors by Brown's dense interpolation modulo one prime.

use std::collections::BTreeMap;

use hodograph_algebra::{Int, Poly, Variable};
use num_integer::Integer;

/// The Mersenne prime 2⁶¹ − 1: coefficients of gcds must be smaller than half of it.
const PRIME: u64 = (1 << 61) - 1;

/// Coefficients in F_p by ascending degree, the last one not zero.
type Dense = Vec<u64>;

/// Polynomials over F_p by their exponents; no coefficient is zero.
type Image = BTreeMap<Vec<u32>, u64>;

/// The gcd of nonzero polynomials over the rationals, if one prime tells it: where it is no common divisor, the coefficients of the
/// gcd were too large, or the points were unlucky.
///
/// Brown, *On Euclid's algorithm and the computation of polynomial greatest common divisors*, 1971.
pub(crate) fn brown_gcd(a: &Poly, b: &Poly, variables: &[Variable]) -> Option<Poly> {
    let image = gcd(&image_of(a, variables), &image_of(b, variables), variables.len());
    let leading = |poly: &Poly| poly.terms()[0].coefficient.clone();
    let scale = residue(&leading(a).gcd(&leading(b)));
    let term = |(exponents, value): (&Vec<u32>, &u64)| {
        let value = mul(*value, scale);
        let value = if value > PRIME / 2 { value as i64 - PRIME as i64 } else { value as i64 };
        let powers = variables.iter().zip(exponents);
        powers.map(|(variable, &exponent)| Poly::variable(variable).pow(exponent)).product::<Poly>()
            * Poly::integer(value)
    };
    let candidate = image.iter().map(term).sum::<Poly>().normalized();
    (candidate.divides(a) && candidate.divides(b)).then_some(candidate)
}

fn image_of(poly: &Poly, variables: &[Variable]) -> Image {
    let ring = poly.ring();
    let mut image = Image::new();
    for term in poly.terms() {
        let exponent =
            |variable: &Variable| ring.position(variable).map_or(0, |i| ring.exponent(term.monomial, i));
        image.insert(variables.iter().map(exponent).collect(), residue(&term.coefficient));
    }
    image.retain(|_, value| *value != 0);
    image
}

fn residue(value: &Int) -> u64 {
    let residue = value.mod_floor(&Int::from(PRIME));
    residue.to_big().iter_u64_digits().next().unwrap_or(0)
}

fn add(a: u64, b: u64) -> u64 {
    (a + b) % PRIME
}

fn mul(a: u64, b: u64) -> u64 {
    (u128::from(a) * u128::from(b) % u128::from(PRIME)) as u64
}

/// 1/a by Fermat's little theorem, for a that is not zero.
fn invert(a: u64) -> u64 {
    let (mut power, mut base, mut exponent) = (1, a, PRIME - 2);
    while exponent > 0 {
        if exponent & 1 == 1 {
            power = mul(power, base);
        }
        base = mul(base, base);
        exponent >>= 1;
    }
    power
}

fn trimmed(mut a: Dense) -> Dense {
    while a.last() == Some(&0) {
        a.pop();
    }
    a
}

fn dense_mul(a: &Dense, b: &Dense) -> Dense {
    let mut product = vec![0; (a.len() + b.len()).saturating_sub(1)];
    for (i, &x) in a.iter().enumerate() {
        for (j, &y) in b.iter().enumerate() {
            product[i + j] = add(product[i + j], mul(x, y));
        }
    }
    trimmed(product)
}

fn dense_div(a: &Dense, b: &Dense) -> [Dense; 2] {
    let (mut rest, inverse) = (a.clone(), invert(b[b.len() - 1]));
    let mut quotient = vec![0; (a.len() + 1).saturating_sub(b.len())];
    for shift in (0..quotient.len()).rev() {
        quotient[shift] = mul(rest[shift + b.len() - 1], inverse);
        for (i, &y) in b.iter().enumerate() {
            rest[shift + i] = add(rest[shift + i], PRIME - mul(quotient[shift], y));
        }
    }
    [trimmed(quotient), trimmed(rest)]
}

fn dense_gcd(a: &Dense, b: &Dense) -> Dense {
    let (mut high, mut low) = (a.clone(), b.clone());
    while !low.is_empty() {
        let [_, rest] = if high.len() < low.len() { [Dense::new(), high] } else { dense_div(&high, &low) };
        (high, low) = (low, rest);
    }
    let inverse = high.last().map_or(0, |&leading| invert(leading));
    high.into_iter().map(|value| mul(value, inverse)).collect()
}

fn value(a: &Dense, point: u64) -> u64 {
    a.iter().rev().fold(0, |sum, &coefficient| add(mul(sum, point), coefficient))
}

/// The polynomial of lowest degree with these values.
fn interpolate(points: &[u64], values: &[u64]) -> Dense {
    let (mut sum, mut vanishing) = (Dense::new(), vec![1]);
    for (&point, &wanted) in points.iter().zip(values) {
        // Newton's form.
        let missing = add(wanted, PRIME - value(&sum, point));
        let factor = mul(missing, invert(value(&vanishing, point)));
        sum.resize(vanishing.len(), 0);
        sum.iter_mut().zip(&vanishing).for_each(|(target, &v)| *target = add(*target, mul(v, factor)));
        vanishing = dense_mul(&vanishing, &vec![PRIME - point, 1]);
    }
    trimmed(sum)
}

/// The coefficients in the last of `count` variables, by the exponents of the others.
fn split(a: &Image, count: usize) -> BTreeMap<Vec<u32>, Dense> {
    let mut parts: BTreeMap<Vec<u32>, Dense> = BTreeMap::new();
    for (exponents, &coefficient) in a {
        let part = parts.entry(exponents[..count - 1].to_vec()).or_default();
        part.resize(part.len().max(exponents[count - 1] as usize + 1), 0);
        part[exponents[count - 1] as usize] = coefficient;
    }
    parts
}

fn join(parts: &BTreeMap<Vec<u32>, Dense>) -> Image {
    let mut image = Image::new();
    for (exponents, part) in parts {
        for (exponent, &coefficient) in (0..).zip(part).filter(|(_, coefficient)| **coefficient != 0) {
            image.insert([exponents.as_slice(), &[exponent]].concat(), coefficient);
        }
    }
    image
}

fn divide_content(parts: &mut BTreeMap<Vec<u32>, Dense>) -> Dense {
    let content = parts.values().fold(Dense::new(), |content, part| dense_gcd(&content, part));
    parts.values_mut().for_each(|part| *part = dense_div(part, &content)[0].clone());
    content
}

/// The gcd with leading coefficient 1 of nonzero polynomials in `count` variables.
fn gcd(a: &Image, b: &Image, count: usize) -> Image {
    let (mut a, mut b) = (split(a, count), split(b, count));
    let contents = [divide_content(&mut a), divide_content(&mut b)];
    let content = dense_gcd(&contents[0], &contents[1]);
    let constant = |content: &Dense| join(&BTreeMap::from([(vec![0; count - 1], content.clone())]));
    let leading = |parts: &BTreeMap<Vec<u32>, Dense>| {
        parts.last_key_value().map(|last| last.1.clone()).unwrap_or_default()
    };
    let scale = dense_gcd(&leading(&a), &leading(&b));
    let length = |parts: &BTreeMap<Vec<u32>, Dense>| parts.values().map(Vec::len).max().unwrap_or(0);
    let needed = if count == 1 { 0 } else { length(&a).min(length(&b)) + scale.len() - 1 };
    let (mut points, mut images): (Vec<u64>, Vec<Image>) = (Vec::new(), Vec::new());
    // Scattered points: small ones are more often unlucky.
    let candidates = (1_u64..).map(|i| mul(i, 0x1234_5678_9abc_def1 % PRIME));
    for point in candidates {
        if points.len() == needed {
            break;
        }
        if [&a, &b].iter().any(|parts| value(&leading(parts), point) == 0) {
            continue;
        }
        let at = |parts: &BTreeMap<Vec<u32>, Dense>| -> Image {
            let values = parts.iter().map(|(exponents, part)| (exponents.clone(), value(part, point)));
            values.filter(|(_, value)| *value != 0).collect()
        };
        let image = gcd(&at(&a), &at(&b), count - 1);
        let first = |image: &Image| image.last_key_value().map(|last| last.0.clone());
        let order = images.first().map(|other| first(&image).cmp(&first(other)));
        match order {
            Some(std::cmp::Ordering::Greater) => continue,
            Some(std::cmp::Ordering::Less) => (points, images) = (Vec::new(), Vec::new()),
            _ => {}
        }
        let factor = value(&scale, point);
        images.push(image.into_iter().map(|(exponents, value)| (exponents, mul(value, factor))).collect());
        points.push(point);
    }
    if count == 1 {
        return constant(&content);
    }
    let words: std::collections::BTreeSet<&Vec<u32>> = images.iter().flat_map(Image::keys).collect();
    let values =
        |word| images.iter().map(|image| image.get(word).copied().unwrap_or(0)).collect::<Vec<u64>>();
    let mut parts: BTreeMap<Vec<u32>, Dense> =
        words.into_iter().map(|word| (word.clone(), interpolate(&points, &values(word)))).collect();
    divide_content(&mut parts);
    parts.values_mut().for_each(|part| *part = dense_mul(part, &content));
    let inverse = invert(leading(&parts).last().copied().unwrap_or(1));
    join(&parts).into_iter().map(|(exponents, value)| (exponents, mul(value, inverse))).collect()
}
