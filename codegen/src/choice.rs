//! Of two programs for a surface, a fast one and an accurate one, what has the smaller proved bounds.
//!
//! Schemes are chosen by figures of their errors (`schedule/forms.rs`), which is not always what the bound of a whole output tells.
//! So both programs are bounded, and an output is taken over from the fast one where the accurate one's bound is larger:
//!
//! - A coordinate of the accurate point is kept if its bound relative to itself is smaller, and, where neither has one, if nothing
//!   cancels in it; others are those of the smaller bound.
//! - Homogeneous coordinates, the separated point and second derivatives are chosen for each output.
//! - First derivatives, the normal and all that follows from them go together: they are the accurate ones if none of their bounds is
//!   larger.

use hodograph_algebra::{Poly, Rational};

use crate::bound::{Precision, Proof, Rounding, ValueBound, prove};
use crate::program::{Program, Value, Variant};
use crate::round::{RoundError, round};
use crate::schedule::outputs;

/// The outputs that are chosen one by one.
const SINGLE: [&str; 5] = [
    outputs::HOMOGENEOUS,
    outputs::SEPARATED_POINT,
    outputs::PARTIAL_UU,
    outputs::PARTIAL_UV,
    outputs::PARTIAL_VV,
];

/// The program `accurate` with what has a smaller bound over the domain in `fast`, in double precision; `keep` says in which
/// coordinates of the accurate point nothing cancels.
///
/// # Errors
/// [`RoundError`] if a constant has no float.
pub(crate) fn of_both(
    mut accurate: Program<Poly>,
    fast: &Program<Poly>,
    domain: &[[Rational; 2]; 2],
    keep: [bool; 3],
) -> Result<Program<Poly>, RoundError> {
    let proof = |program: &Program<Poly>| -> Result<Option<Proof>, RoundError> {
        let exact = program.fused();
        let rounded = round(&exact)?;
        let rounding = Rounding { precision: Precision::Double, variant: Variant::Plain };
        Ok(prove(&exact, &rounded, domain, &[rounding]).ok().and_then(|mut proofs| proofs.pop()))
    };
    let (Some(of_accurate), Some(of_fast)) = (proof(&accurate)?, proof(fast)?) else { return Ok(accurate) };
    let error = |proof: &Proof, name: &str| proof.error(name).unwrap_or(f64::INFINITY);
    let is_larger = |name: &str| error(&of_accurate, name) > error(&of_fast, name);

    let mut taken: Vec<(String, Vec<Value>)> = Vec::new();
    if !accurate.results(outputs::ACCURATE_POINT).is_empty() {
        let (slow, quick) = (of_accurate.output(outputs::ACCURATE_POINT), of_fast.output(outputs::POINT));
        let mut values = accurate.results(outputs::ACCURATE_POINT).to_vec();
        let others = accurate.import(fast, fast.results(outputs::POINT));
        for (place, value) in values.iter_mut().enumerate() {
            let larger = match (&slow[place], &quick[place]) {
                (Ok(slow), Ok(quick)) => {
                    let factor = |bound: &ValueBound| bound.relative.map_or(f64::INFINITY, |it| it.factor);
                    let (slow_factor, quick_factor) = (factor(slow), factor(quick));
                    let is_kept = slow_factor < quick_factor || slow_factor.is_infinite() && keep[place];
                    !is_kept && slow.error > quick.error
                }
                (slow, _) => slow.is_err(),
            };
            if larger {
                *value = others[place];
            }
        }
        taken.push((outputs::ACCURATE_POINT.to_string(), values));
    }
    let others: Vec<&str> = fast
        .outputs()
        .iter()
        .map(|output| output.name.as_str())
        .filter(|name| !SINGLE.contains(name) && ![outputs::POINT, outputs::CONDITIONS].contains(name))
        .collect();
    let all_larger = others.iter().any(|name| is_larger(name));
    for output in fast.outputs() {
        let name = output.name.as_str();
        let single = (SINGLE.contains(&name) || name == outputs::POINT) && is_larger(name);
        if single || others.contains(&name) && all_larger {
            let values = accurate.import(fast, &output.values);
            taken.push((name.to_string(), values));
        }
    }
    for (name, values) in taken {
        accurate.set_output(&name, values);
    }
    Ok(accurate)
}
