//! Verdicts for programs.

use hodograph_codegen::meaning::{self, Explanation, Judgement};
use serde::Serialize;

use super::Entry;

#[derive(Serialize)]
struct Output<'a> {
    schema: u32,
    claims: Vec<Claim<'a>>,
}

/// A clause of a claim.
#[derive(Serialize)]
struct Claim<'a> {
    id: &'a str,
    sweep: &'a str,
    source: Option<&'a str>,
    statement: &'a str,
    verdict: String,
    scope: &'a str,
    condition: Option<&'a str>,
    expected: String,
    derived: &'a str,
    witness: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    steps: Option<Vec<Step<'a>>>,
}

/// A step of a derivation.
#[derive(Serialize)]
struct Step<'a> {
    what: &'a str,
    formula: &'a str,
    because: &'a str,
}

/// All claims as JSON, an entry a clause, in the order of the source.
pub(super) fn output(entries: &[Entry]) -> String {
    let claims = entries.iter().flat_map(|entry| &entry.judgements).map(claim).collect();
    crate::layout::json(&Output { schema: 1, claims })
}

/// The claims of one id as JSON, each with its derivation.
pub(super) fn explanations(explanations: &[&Explanation]) -> String {
    let claims = explanations.iter().map(|explanation| Claim {
        steps: Some(explanation.steps.iter().map(step).collect()),
        ..claim(&explanation.judgement)
    });
    crate::layout::json(&Output { schema: 1, claims: claims.collect() })
}

fn step(step: &meaning::Step) -> Step<'_> {
    Step { what: step.what, formula: &step.formula, because: &step.because }
}

fn claim(judgement: &Judgement) -> Claim<'_> {
    Claim {
        id: &judgement.id,
        sweep: &judgement.sweep,
        source: judgement.source.as_deref(),
        statement: &judgement.statement,
        verdict: judgement.verdict.to_string(),
        scope: &judgement.scope,
        condition: judgement.condition.as_deref(),
        expected: judgement.expected.to_string(),
        derived: &judgement.derived,
        witness: judgement.witness.as_deref(),
        steps: None,
    }
}

#[cfg(test)]
mod tests {
    use hodograph_codegen::language::ast::Verdict;

    use super::super::tests::{entry, judgement};
    use super::*;

    #[test]
    fn keys_and_their_order_are_fixed() {
        let refuted = entry(vec![judgement("FN-1", Verdict::Refuted, Verdict::Proved)]);
        let expected = "\
{
  \"schema\": 1,
  \"claims\": [
    {
      \"id\": \"FN-1\",
      \"sweep\": \"s\",
      \"source\": \"a book\",
      \"statement\": \"degree(X) == (2, 9)\",
      \"verdict\": \"refuted\",
      \"scope\": \"the sweep s\",
      \"condition\": null,
      \"expected\": \"proved\",
      \"derived\": \"(2, 8)\",
      \"witness\": \"u = 1/2: left 1, right 2\"
    }
  ]
}
";
        assert_eq!(output(&[refuted]), expected);
    }
}
