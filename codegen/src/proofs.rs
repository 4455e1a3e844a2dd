//! What is proved of a surface's evaluators, in the form in which it is emitted.

use hodograph_algebra::{Essentials, Poly, Rational};

use crate::bound::{Proof, Reason, Rounding, Unbounded, ValueBound, prove};
use crate::certificates::certificates;
use crate::emit::TASKS;
use crate::program::Program;
use crate::round::exact;
use crate::schedule::outputs;

/// The outputs that have bounds, in the order of the runtime's struct.
pub const BOUNDED: [&str; 17] = [
    outputs::HOMOGENEOUS,
    outputs::POINT,
    outputs::SEPARATED_POINT,
    outputs::PARTIAL_U,
    outputs::PARTIAL_V,
    outputs::PARTIAL_UU,
    outputs::PARTIAL_UV,
    outputs::PARTIAL_VV,
    outputs::UNIT_NORMAL,
    outputs::FIRST_FORM,
    outputs::SECOND_FORM,
    outputs::GAUSSIAN,
    outputs::MEAN,
    outputs::PRINCIPAL,
    outputs::SPEEDS,
    outputs::NORMAL_U,
    outputs::NORMAL_V,
];

/// The bounds of an output: the largest of its results, in each of [`Rounding::ALL`].
#[derive(Clone, PartialEq, Debug)]
pub struct OutputBound {
    /// The name of the output.
    pub name: &'static str,
    /// |computed − exact| is at most this; infinite where nothing is proved.
    pub errors: [f64; 4],
    /// The same divided by |exact|, for every result.
    pub relative_errors: [f64; 4],
    /// The bounds for each result by itself.
    pub results: Vec<ResultBound>,
    /// A result has somewhere at least this magnitude.
    pub size: f64,
    /// No result has a greater magnitude; infinite where that is not known.
    pub most: f64,
    /// Why there is no bound, in each of [`Rounding::ALL`].
    pub failures: [Option<Unbounded>; 4],
}

/// The bounds of one result of an output.
#[derive(Clone, PartialEq, Debug)]
pub struct ResultBound {
    /// |computed − exact| is at most this, in each of [`Rounding::ALL`]; infinite where nothing is proved.
    pub errors: [f64; 4],
    /// |computed − exact|/|exact| is at most this in double precision and the plain variant, or if there is underflow.
    pub relative_error: f64,
    /// |computed − exact| may be greater by this, where numbers underflow.
    pub underflow: f64,
}

/// What is proved of a surface, with numbers rounded up to three digits.
#[derive(Clone, PartialEq, Debug)]
pub struct Proofs {
    /// A bound for each of [`BOUNDED`].
    pub bounds: Vec<OutputBound>,
    /// Sentences on poles and singular points.
    pub certificates: Vec<String>,
}

impl Proofs {
    /// What holds on all of several surfaces; `None` of no surface.
    #[must_use]
    pub fn together(all: &[&Proofs]) -> Option<Proofs> {
        let (first, others) = all.split_first()?;
        let mut together = Proofs { bounds: first.bounds.clone(), certificates: Vec::new() };
        for proofs in others {
            for (bound, other) in together.bounds.iter_mut().zip(&proofs.bounds) {
                bound.join(other);
            }
        }
        Some(together)
    }
}

impl OutputBound {
    /// Makes it a bound for the output of another surface too.
    fn join(&mut self, other: &OutputBound) {
        let raise = |bounds: &mut [f64], others: &[f64]| {
            bounds.iter_mut().zip(others).for_each(|(bound, &other)| *bound = bound.max(other));
        };
        raise(&mut self.errors, &other.errors);
        raise(&mut self.relative_errors, &other.relative_errors);
        for (result, other) in self.results.iter_mut().zip(&other.results) {
            raise(&mut result.errors, &other.errors);
            result.relative_error = result.relative_error.max(other.relative_error);
            result.underflow = result.underflow.max(other.underflow);
        }
        self.size = self.size.max(other.size);
        self.most = self.most.max(other.most);
        for (failure, other) in self.failures.iter_mut().zip(other.failures) {
            *failure = failure.or(other);
        }
    }
}

/// Proves bounds for a program over the domain of the surface, and where the surface has neither poles nor singular points.
pub(crate) fn proofs(derivation: &Essentials, program: &Program<Poly>, rounded: &Program<f64>) -> Proofs {
    let Ok(proofs) = prove(program, rounded, &domain(derivation), &Rounding::ALL) else {
        unreachable!("one program is the other one rounded")
    };
    let mut bounds: Vec<OutputBound> = BOUNDED.iter().map(|name| output_bound(name, &proofs)).collect();
    exclude_overflow(&mut bounds);
    let has_normal = |bound: &OutputBound| {
        bound.name == outputs::UNIT_NORMAL && bound.errors.iter().any(|error| error.is_finite())
    };
    let certificates = certificates(derivation, bounds.iter().any(has_normal));
    Proofs { bounds, certificates }
}

/// The domain over which the bounds of a surface are proved: its ends, and the floats next to them in both precisions.
#[must_use]
pub fn domain(derivation: &Essentials) -> [[Rational; 2]; 2] {
    derivation.domain.each_ref().map(|interval| hull(interval.lower(), interval.upper()))
}

/// The bounds of one output, from the proofs for all roundings.
#[must_use]
pub fn output_bound(name: &'static str, proofs: &[Proof]) -> OutputBound {
    let mut bound = OutputBound {
        name,
        errors: [f64::INFINITY; 4],
        relative_errors: [f64::INFINITY; 4],
        results: Vec::new(),
        size: proofs.first().map_or(0.0, |proof| rounded_down(proof.attained(name))),
        most: f64::INFINITY,
        failures: [None; 4],
    };
    for (place, proof) in proofs.iter().enumerate() {
        let results = proof.output(name);
        match proof.error(name) {
            Ok(error) => bound.errors[place] = rounded_up(error),
            Err(failure) => bound.failures[place] = Some(failure),
        }
        let relative = |result: &Result<ValueBound, Unbounded>| {
            let relative = result.as_ref().ok().and_then(|bound| bound.relative);
            relative.map_or((f64::INFINITY, 0.0), |relative| (relative.factor, relative.underflow))
        };
        // What comes from underflow is no matter of a factor.
        let factors = results.iter().map(|result| match relative(result) {
            (factor, 0.0) => factor,
            _ => f64::INFINITY,
        });
        bound.relative_errors[place] =
            factors.fold(0.0, |largest: f64, error| largest.max(rounded_up(error)));
        if place == 0 {
            bound.results = results
                .iter()
                .map(|result| {
                    let (relative_error, underflow) = relative(result);
                    ResultBound {
                        errors: [f64::INFINITY; 4],
                        relative_error: rounded_up(relative_error),
                        underflow: rounded_up(underflow),
                    }
                })
                .collect();
            let sizes = results.iter().map(|result| result.as_ref().map_or(f64::INFINITY, ValueBound::size));
            let most = rounded_up(sizes.fold(0.0, f64::max));
            // No component of a unit vector is greater than 1.
            bound.most = if name == outputs::UNIT_NORMAL && most.is_finite() { most.min(1.0) } else { most };
        }
        for (known, result) in bound.results.iter_mut().zip(results) {
            known.errors[place] = result.as_ref().map_or(f64::INFINITY, |bound| rounded_up(bound.error));
        }
    }
    bound
}

/// Outputs that have evaluators by themselves, beside those of tasks.
const ALONE: [&str; 3] = [outputs::PARTIAL_U, outputs::PARTIAL_V, outputs::SPEEDS];

/// Takes away the bounds of what is only computed together with numbers that may overflow, for then there is no answer.
fn exclude_overflow(bounds: &mut [OutputBound]) {
    let overflow = |name: &str, place: usize| {
        let failures = bounds.iter().find(|bound| bound.name == name).map(|bound| bound.failures);
        failures.and_then(|failures| failures[place]).filter(|failure| failure.reason == Reason::Overflow)
    };
    let answer = |name: &str, place: usize| {
        let together = TASKS.iter().filter(|task| task.outputs.contains(&name));
        let mut failures =
            together.map(|task| task.outputs.iter().find_map(|name| overflow(name, place))).peekable();
        let first = failures.peek().copied().flatten();
        let alone = ALONE.contains(&name).then(|| overflow(name, place));
        if failures.chain(alone).all(|failure| failure.is_some()) { first } else { None }
    };
    let failures = |bound: &OutputBound| [0, 1, 2, 3].map(|place| answer(bound.name, place));
    let failures: Vec<[Option<Unbounded>; 4]> = bounds.iter().map(failures).collect();
    for (bound, failures) in bounds.iter_mut().zip(failures) {
        for (place, failure) in failures.into_iter().enumerate() {
            let Some(failure) = failure.filter(|_| bound.failures[place].is_none()) else { continue };
            bound.failures[place] = Some(failure);
            bound.errors[place] = f64::INFINITY;
            bound.relative_errors[place] = f64::INFINITY;
            for result in &mut bound.results {
                result.errors[place] = f64::INFINITY;
                if place == 0 {
                    (result.relative_error, result.underflow) = (f64::INFINITY, 0.0);
                }
            }
        }
    }
}

/// The interval of rationals that holds the given ends and the floats next to them, in both precisions.
fn hull(lower: &Poly, upper: &Poly) -> [Rational; 2] {
    let ends = |end: &Poly| {
        let enclosure = end.enclosure(64);
        let mut ends = vec![enclosure.lower().clone(), enclosure.upper().clone()];
        if let Ok(double) = crate::round::nearest(end) {
            ends.extend(exact(double));
            ends.extend(exact(f64::from(double as f32)));
        }
        ends
    };
    let least = ends(lower).into_iter().min().unwrap_or_default();
    let most = ends(upper).into_iter().max().unwrap_or_default();
    [least, most]
}

/// The least number of three digits that is not below a float that is not negative.
pub(crate) fn rounded_up(number: f64) -> f64 {
    if number == 0.0 || !number.is_finite() {
        return number;
    }
    let mut text = format!("{number:.2e}");
    loop {
        let Some(rounded) = text.parse::<f64>().ok().filter(|_| text.contains('e')) else {
            return f64::INFINITY;
        };
        if rounded >= number {
            return rounded;
        }
        // One more in the last digit.
        let Some((digits, exponent)) = text.split_once('e') else { return f64::INFINITY };
        let Ok(digits) = digits.replace('.', "").parse::<u32>() else { return f64::INFINITY };
        text = format!("{}.{:02}e{exponent}", (digits + 1) / 100, (digits + 1) % 100);
    }
}

/// A number of three digits that is not above a float that is not negative.
fn rounded_down(number: f64) -> f64 {
    let up = rounded_up(number);
    if up <= number {
        return up;
    }
    let Ok(rounded) = format!("{:.2e}", number * (1.0 - 0.005)).parse::<f64>() else { return 0.0 };
    if rounded <= number { rounded } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::{rounded_down, rounded_up};

    #[test]
    fn digits_are_rounded_to_the_safe_side() {
        assert_eq!(rounded_up(1.001e-15), 1.01e-15);
        assert_eq!(rounded_up(9.999), 10.0);
        assert_eq!(rounded_up(0.0), 0.0);
        assert_eq!(rounded_up(f64::INFINITY), f64::INFINITY);
        for k in 1..2000 {
            let number = 1e-17 * 1.013_f64.powi(k);
            let (up, down) = (rounded_up(number), rounded_down(number));
            assert!(
                down <= number && number <= up && up <= 1.011 * number && down >= 0.98 * number,
                "{number}"
            );
        }
    }
}
