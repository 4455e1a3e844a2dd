//! Sweeps of several pieces: one surface for each, and one for the whole.

use hodograph_codegen::compile::{compile_all, expand};
use hodograph_codegen::emit;
use hodograph_codegen::language::parse_text;
use hodograph_codegen::meaning::{Model, models};

/// Two pieces, which meet at 1/3.
const TURN: &str = "/// A line that turns.
sweep turn {
    profile c(u) = (u, 0, 0);
    frames F(v) = frames([frame((0, 0, 0), (0, 0, 0, 1)), frame((0, 0, 1), (3/5, 0, 0, 4/5)), frame((0, 0, 3), (4/5, 0, 0, 3/5))],
        knots = [0, 1/3, 1]);
    surface R = F.sweep(c);
    domain u in 0..1;
}";

fn of(text: &str) -> Vec<Model> {
    let (models, mistakes) = models(&parse_text("turn.sweep", text).unwrap().0);
    assert!(mistakes.is_empty(), "{mistakes:?}");
    models
}

#[test]
fn pieces_know_their_place_and_whether_they_meet() {
    let models = of(TURN);
    let artifacts: Vec<_> = compile_all(&models).into_iter().map(|(_, artifact)| artifact.unwrap()).collect();
    let pieces: Vec<_> = artifacts.iter().map(|artifact| artifact.piece.clone().unwrap()).collect();
    assert_eq!(
        pieces.iter().map(|piece| (piece.of.as_str(), piece.index, piece.count)).collect::<Vec<_>>(),
        [("turn", 0, 2), ("turn", 1, 2)]
    );
    // The float next to 1/3 is below it.
    assert_eq!((pieces[1].start, pieces[1].start_is_exact), ((1.0_f64 / 3.0).next_up(), false));
    assert_eq!((pieces[0].start, pieces[0].start_is_exact), (0.0, true));
    assert_eq!([pieces[0].meets, pieces[1].meets], [false, true]);
    // The second piece by itself has no neighbor.
    let alone = compile_all(&models[1..]).remove(0).1.unwrap();
    assert!(!alone.piece.unwrap().meets);
}

#[test]
fn pieces_are_followed_by_the_whole() {
    let (file, _) = parse_text("turn.sweep", TURN).unwrap();
    let (tokens, mistakes) = expand(&file);
    assert!(mistakes.is_empty(), "{mistakes:?}");
    let text = emit::format(tokens).unwrap();
    let modules: Vec<&str> = text.lines().filter(|line| line.starts_with("pub mod")).collect();
    assert_eq!(modules, ["pub mod turn_1 {", "pub mod turn_2 {", "pub mod turn {"]);
    let whole = &text[text.find("pub mod turn {").unwrap()..];
    assert!(whole.contains("pub const Turn: Turn = ::hodograph::Piecewise::NEW;"));
    assert!(whole.contains("const JOINTS: &'static [f64] = &[0.33333333333333337];"));
    // 1/3 is no float, so nothing is said of the jump.
    let words: Vec<&str> = whole.split_whitespace().collect();
    let unknown = "const JUMPS: [f64; 4] = [ f64::INFINITY, f64::INFINITY, f64::INFINITY, f64::INFINITY, ];";
    assert!(words.join(" ").contains(unknown));
    assert!(whole.contains("0 => visitor.visit(super::turn_1::Turn1),"));
    assert!(whole.contains("_ => visitor.visit(super::turn_2::Turn2),"));
    assert!(
        text.contains(
            "They meet exactly. How far rounding separates their points at the joints is not proved."
        )
    );
}

#[test]
fn the_jump_is_that_of_both_neighbors() {
    let models = of(&TURN.replace("1/3", "1/2"));
    let artifacts: Vec<_> = compile_all(&models).into_iter().map(|(_, artifact)| artifact.unwrap()).collect();
    let text = emit::format(emit::modules(&artifacts, &"hodograph".parse().unwrap())).unwrap();
    let errors = |place: usize| {
        let error = |index: usize| {
            let proofs = artifacts[index].proofs.as_ref().unwrap();
            proofs.bounds.iter().find(|bound| bound.name == "point").unwrap().errors[place]
        };
        error(0) + error(1)
    };
    let (_, after) = text.split_once("const JUMPS: [f64; 4] = [").unwrap();
    let (jumps, _) = after.split_once(']').unwrap();
    let jumps: Vec<f64> = jumps.split(',').filter_map(|jump| jump.trim().parse().ok()).collect();
    assert_eq!(jumps.len(), 4, "{after:.100}");
    // They are rounded up to three digits.
    for (place, jump) in jumps.into_iter().enumerate() {
        let sum = errors(place);
        assert!(sum.is_finite() && sum <= jump && jump < 1.01 * sum, "{jump} {sum} {place}");
    }
}

#[test]
fn the_header_has_the_whole_after_all_of_its_pieces() {
    let models = of(TURN);
    let artifacts: Vec<_> = compile_all(&models).into_iter().map(|(_, artifact)| artifact.unwrap()).collect();
    let text = emit::header(&artifacts).unwrap();
    let sections: Vec<&str> =
        text.lines().filter(|line| line.starts_with("#define HODOGRAPH_SWEEP_")).collect();
    assert_eq!(sections, ["turn_1", "turn_2", "turn"].map(|name| format!("#define HODOGRAPH_SWEEP_{name}")));
    // The float next to 1/3 is below it, and nothing is said of a jump where no float is.
    assert!(text.contains("static const double turn_joints[1] = {0.33333333333333337};"));
    assert!(text.contains("static const double turn_jump = INFINITY, turn_jump_f = INFINITY;"));
    assert!(text.contains("enum { turn_count = 2 };"));
    assert!(text.contains(" * | `turn_2` | from 0.3333333333333333 to 1.0 |"));
    assert!(text.contains(
        "    switch (turn_piece_atf(v)) {
    case 0:
        return turn_1_pointf(u, v, out);
    default:
        return turn_2_pointf(u, v, out);
    }
"
    ));
    // Pieces that are asked for by themselves are surfaces like all others.
    let text = emit::header(&artifacts[1..]).unwrap();
    assert!(
        text.contains("turn_2_point(") && !text.contains("turn_count") && !text.contains("HODOGRAPH_JOINTS")
    );
}
