//! The search for the largest errors of evaluators, and their comparison with the proved bounds.

use std::collections::BTreeMap;
use std::fmt::Write;

use hodograph::{Bound, Bounds};
use hodograph_algebra::Derivation;
use hodograph_codegen::bound::{Precision, Rounding};
use hodograph_codegen::emit::TASKS;
use hodograph_codegen::program::Variant;
use hodograph_codegen::schedule::outputs;

use crate::oracle::Oracle;
use crate::points::Points;
use crate::surfaces::Subject;

/// The outputs that are searched, by the names that programs have for them.
pub use hodograph_codegen::proofs::BOUNDED as OUTPUTS;

/// The tasks that have all outputs between them.
const SEARCHED: [&str; 3] = ["Homogeneous", "Point", "Local"];

/// The largest error that has been found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Worst {
    /// |computed − exact|, rounded down.
    pub error: f64,
    /// The parameters.
    pub at: (f64, f64),
    /// The largest quotient of an error and the size of the output at the same place.
    pub relative: f64,
    /// How often nothing finite was computed.
    pub undefined: usize,
}

/// A search for the largest errors of a surface's evaluators, in all outputs and roundings at once.
pub struct Search<'a> {
    subject: &'a Subject,
    oracle: Oracle<'a>,
    found: BTreeMap<(&'static str, usize), Worst>,
    tried: usize,
}

/// How many numbers an output has.
#[must_use]
pub fn length(output: &str) -> usize {
    match output {
        outputs::HOMOGENEOUS => 4,
        outputs::GAUSSIAN | outputs::MEAN => 1,
        outputs::PRINCIPAL | outputs::SPEEDS => 2,
        _ => 3,
    }
}

/// The bound of an output.
///
/// # Panics
/// If there is no such output.
#[must_use]
pub fn bound_of<'a>(bounds: &'a Bounds, output: &str) -> &'a Bound {
    match output {
        outputs::HOMOGENEOUS => &bounds.homogeneous,
        outputs::POINT => &bounds.point,
        outputs::SEPARATED_POINT => &bounds.separated_point,
        outputs::PARTIAL_U => &bounds.partial_u,
        outputs::PARTIAL_V => &bounds.partial_v,
        outputs::PARTIAL_UU => &bounds.partial_uu,
        outputs::PARTIAL_UV => &bounds.partial_uv,
        outputs::PARTIAL_VV => &bounds.partial_vv,
        outputs::UNIT_NORMAL => &bounds.unit_normal,
        outputs::FIRST_FORM => &bounds.first_form,
        outputs::SECOND_FORM => &bounds.second_form,
        outputs::GAUSSIAN => &bounds.gaussian,
        outputs::MEAN => &bounds.mean,
        outputs::PRINCIPAL => &bounds.principal,
        outputs::SPEEDS => &bounds.speeds,
        outputs::NORMAL_U => &bounds.normal_u,
        outputs::NORMAL_V => &bounds.normal_v,
        _ => panic!("`{output}` has no bound"),
    }
}

/// The unit roundoff of a precision: 2⁻⁵³ or 2⁻²⁴.
#[must_use]
pub fn unit_roundoff(precision: Precision) -> f64 {
    f64::from(precision.unit_exponent()).exp2()
}

/// A short name of a rounding.
#[must_use]
pub fn rounding_name(rounding: Rounding) -> &'static str {
    match (rounding.precision, rounding.variant) {
        (Precision::Double, Variant::Plain) => "f64",
        (Precision::Double, Variant::Fused) => "f64 fused",
        (Precision::Single, Variant::Plain) => "f32",
        (Precision::Single, Variant::Fused) => "f32 fused",
    }
}

impl<'a> Search<'a> {
    /// A search that has tried nothing yet.
    #[must_use]
    pub fn new(subject: &'a Subject, derivation: &'a Derivation) -> Search<'a> {
        let all = OUTPUTS.iter().flat_map(|&output| (0..Rounding::ALL.len()).map(move |k| (output, k)));
        let found = all.map(|key| (key, Worst::default())).collect();
        Search { subject, oracle: Oracle::new(derivation), found, tried: 0 }
    }

    /// How many parameters have been tried.
    #[must_use]
    pub fn tried(&self) -> usize {
        self.tried
    }

    /// The largest error of an output in `Rounding::ALL[rounding]`.
    #[must_use]
    pub fn worst(&self, output: &'static str, rounding: usize) -> Worst {
        self.found.get(&(output, rounding)).copied().unwrap_or_default()
    }

    /// Tries parameters that are floats of a precision, in the roundings that can have them.
    pub fn try_at(&mut self, (u, v): (f64, f64), precision: Precision) {
        self.tried += 1;
        let truth = self.oracle.at(u, v);
        for (k, &rounding) in Rounding::ALL.iter().enumerate() {
            if precision == Precision::Double && rounding.precision == Precision::Single {
                continue;
            }
            for task in TASKS.iter().filter(|task| SEARCHED.contains(&task.name)) {
                let numbers = self.subject.surface.numbers(task.name, rounding, (u, v));
                let mut rest = numbers.as_slice();
                for &output in task.outputs {
                    let (computed, others) = rest.split_at(length(output));
                    rest = others;
                    let Some(exact) = truth.output(output) else { continue };
                    let worst = self.found.entry((output, k)).or_default();
                    if computed.iter().any(|number| !number.is_finite()) {
                        worst.undefined += 1;
                    }
                    let pairs = computed.iter().zip(exact).filter(|(number, _)| number.is_finite());
                    let error = pairs.fold(0.0, |error: f64, (&number, exact)| error.max(exact.gap(number)));
                    let size = exact.iter().fold(0.0, |size: f64, exact| size.max(exact.magnitude()));
                    worst.relative = worst.relative.max(error / size);
                    if error > worst.error {
                        (worst.error, worst.at) = (error, (u, v));
                    }
                }
            }
        }
    }

    /// Tries this number of parameters of both precisions each: at the border, anywhere, near the border, near changes of sign,
    /// and near the largest errors so far.
    pub fn run(&mut self, count: usize) {
        for (precision, seed) in [(Precision::Single, 24), (Precision::Double, 53)] {
            let mut points = Points::new(self.subject.surface.as_ref(), precision, seed);
            let end = self.tried + count;
            for point in points.border().into_iter().take(count) {
                self.try_at(point, precision);
            }
            while self.tried < end {
                let kind = points.chance();
                let point = if kind < 0.25 {
                    points.anywhere()
                } else if kind < 0.4 {
                    points.near_border()
                } else if kind < 0.5 {
                    points.cancelling().unwrap_or_else(|| points.anywhere())
                } else {
                    let best = self.any_worst(points.chance(), precision);
                    points.near(best)
                };
                self.try_at(point, precision);
            }
        }
    }

    /// The parameters of one of the largest errors in a precision.
    fn any_worst(&self, chance: f64, precision: Precision) -> (f64, f64) {
        let in_precision = |&(_, k): &(&str, usize)| Rounding::ALL[k].precision == precision;
        let all: Vec<(f64, f64)> =
            self.found.iter().filter(|(key, _)| in_precision(key)).map(|(_, worst)| worst.at).collect();
        all[(chance * all.len() as f64) as usize]
    }

    /// Where the errors exceed the bounds times `factor`, or something that has a bound was not finite: a sentence for each
    /// output and rounding.
    #[must_use]
    pub fn excesses(&self, bounds: &Bounds, factor: f64) -> Vec<String> {
        let mut excesses = Vec::new();
        for (&(output, k), worst) in &self.found {
            let bound = bound_of(bounds, output).errors[k];
            let allowed = factor * bound;
            let (name, rounding) = (self.subject.surface.name(), rounding_name(Rounding::ALL[k]));
            let Worst { error, at: (u, v), undefined, .. } = *worst;
            if error > allowed {
                excesses.push(format!(
                    "{output} of {name} at ({u:?}, {v:?}), {rounding}: {error:e} > {allowed:e}"
                ));
            }
            if bound.is_finite() && undefined > 0 {
                excesses.push(format!("{output} of {name}, {rounding}: not finite in {undefined} cases"));
            }
        }
        excesses
    }

    /// A line for each output: in every rounding the largest error and the bound, in units of the unit roundoff times the
    /// output's size, and the bound divided by the error. Where no size is certain, as for what vanishes everywhere, it counts
    /// as 1. Without a bound, the last number is the largest error in units of the unit roundoff times the size of the output at
    /// the same place.
    #[must_use]
    pub fn table(&self, bounds: &Bounds) -> String {
        let mut table = String::new();
        for output in OUTPUTS {
            let bound = bound_of(bounds, output);
            let size = if bound.size > 0.0 { bound.size } else { 1.0 };
            let cells: Vec<String> = (0..Rounding::ALL.len())
                .map(|k| {
                    let unit = unit_roundoff(Rounding::ALL[k].precision) * size;
                    let Worst { error, relative, .. } = self.worst(output, k);
                    let (allowed, ratio) = match bound.errors[k] {
                        // Nothing is rounded.
                        0.0 => ("0".to_owned(), String::new()),
                        allowed if allowed.is_finite() => {
                            (number(allowed / unit), format!("{:.1}", allowed / error))
                        }
                        _ => {
                            let relative = relative / unit_roundoff(Rounding::ALL[k].precision);
                            ("none".to_owned(), format!("at {}", number(relative)))
                        }
                    };
                    format!("{:>9} {allowed:>9} {ratio:>8}", number(error / unit))
                })
                .collect();
            _ = writeln!(table, "  {output:<16}{}", cells.join(" |"));
        }
        table
    }
}

/// A number in few characters.
fn number(number: f64) -> String {
    if number < 1e5 { format!("{number:.2}") } else { format!("{number:.1e}") }
}
