//! Mistakes in a text, shown to a person.

use std::fmt;
use std::ops::Range;

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};

use super::diagnostic::Diagnostics;
use super::source::Source;
use super::token::Span;

/// How many characters of a place are underlined.
const UNDERLINED: usize = 60;

/// The width of the lines that are shown, in characters; longer ones are cut around the place.
const WIDTH: usize = 120;

/// The mistakes found in a text, with that text. `Display` shows it plainly, [`Report::colored`] for a terminal.
///
/// # Example
/// ```
/// use hodograph_codegen::language::parse_text;
///
/// let report = parse_text("a.sweep", "lemma a {\n  domian u in 0..1;\n}").unwrap_err();
/// assert_eq!(report.lines(), ["a.sweep:2:3: there is no clause `domian`"]);
/// assert_eq!(report.message(), "a.sweep:2:3: there is no clause `domian`\n  help: did you mean `domain`?");
/// assert!(report.to_string().starts_with("error: there is no clause `domian`"));
/// ```
#[derive(Clone, Debug)]
pub struct Report {
    source: Source,
    diagnostics: Diagnostics,
}

impl Report {
    /// The mistakes `diagnostics` found in `source`.
    pub fn new(source: Source, diagnostics: Diagnostics) -> Report {
        Report { source, diagnostics }
    }

    /// The mistakes.
    pub fn diagnostics(&self) -> &Diagnostics {
        &self.diagnostics
    }

    /// The text that they were found in.
    pub fn source(&self) -> &Source {
        &self.source
    }

    /// Each mistake in one line, `file:line:column: message`; all of them, by place.
    pub fn lines(&self) -> Vec<String> {
        self.diagnostics.iter().map(|mistake| self.line(mistake.span, &mistake.message)).collect()
    }

    /// The first mistakes as `file:line:column: message`, each followed by what to do: for where no source can be
    /// shown, as in the message of a macro that reads a file.
    pub fn message(&self) -> String {
        let mut lines = Vec::new();
        for mistake in self.diagnostics.shown() {
            lines.push(self.line(mistake.span, &mistake.message));
            for (span, text) in &mistake.also {
                lines.push(format!("  {}", self.line(*span, text)));
            }
            lines.extend(mistake.help.iter().map(|help| format!("  help: {help}")));
        }
        lines.extend(self.diagnostics.remainder());
        lines.join("\n")
    }

    /// The report in colors, as terminals understand them.
    pub fn colored(&self) -> String {
        self.render(&Renderer::styled())
    }

    fn line(&self, span: Span, message: &str) -> String {
        let position = self.source.position(span);
        format!("{}:{}:{}: {message}", self.source.name(), position.line, position.column)
    }

    fn render(&self, renderer: &Renderer) -> String {
        let renderer = renderer.clone().term_width(WIDTH);
        let mut parts = Vec::new();
        for mistake in self.diagnostics.shown() {
            let title = Level::ERROR.primary_title(mistake.message.as_str());
            let mut groups = vec![title.element(self.snippet(
                AnnotationKind::Primary,
                mistake.span,
                mistake.label.as_deref(),
            ))];
            for (span, text) in &mistake.also {
                let snippet = self.snippet(AnnotationKind::Primary, *span, None);
                groups.push(Level::NOTE.secondary_title(text.as_str()).element(snippet));
            }
            if let Some(help) = &mistake.help {
                groups.push(Group::with_title(Level::HELP.secondary_title(help.as_str())));
            }
            parts.push(renderer.render(&groups));
        }
        parts.extend(self.diagnostics.remainder());
        parts.join("\n\n")
    }

    /// The line where the place begins, with as much of the place as stands on it underlined.
    fn snippet<'a>(
        &'a self,
        kind: AnnotationKind,
        span: Span,
        label: Option<&'a str>,
    ) -> Snippet<'a, annotate_snippets::Annotation<'a>> {
        let range = self.source.range(span);
        let (number, line) = self.source.line_at(range.start);
        let text = &self.source.text()[line.clone()];
        let place = underlined(text, range.start - line.start..range.end.min(line.end) - line.start);
        // What is far behind the place would be read through only to be cut off.
        let rest = &text[place.end..];
        let end = rest.char_indices().nth(2 * WIDTH).map_or(text.len(), |(at, _)| place.end + at);
        Snippet::source(&text[..end])
            .line_start(number)
            .path(self.source.name())
            .annotation(kind.span(place).label(label))
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.render(&Renderer::plain()))
    }
}

impl std::error::Error for Report {}

/// The first characters of the place, so that the line that is shown stays short.
fn underlined(text: &str, place: Range<usize>) -> Range<usize> {
    let end =
        text[place.clone()].char_indices().nth(UNDERLINED).map_or(place.end, |(at, _)| place.start + at);
    place.start..end
}

#[cfg(test)]
mod tests {
    use super::super::{parse_text, token::SpanId};
    use super::*;
    use crate::language::Diagnostic;

    fn report(text: &str, places: &[Range<usize>]) -> Report {
        let mut diagnostics = Diagnostics::new();
        for id in 0..places.len() as u32 {
            diagnostics.push(Diagnostic::new(Span::at(SpanId(id)), "wrong").label("here"));
        }
        Report::new(Source::new("a.sweep", text, places.to_vec()), diagnostics)
    }

    #[test]
    fn a_place_is_shown_with_label_and_help() {
        let report = parse_text("a.sweep", "lemma a {\n    domian u in 0..1;\n}\n").unwrap_err();
        let expected = "\
error: there is no clause `domian`
 --> a.sweep:2:5
  |
2 |     domian u in 0..1;
  |     ^^^^^^
  |
help: did you mean `domain`?";
        assert!(report.to_string().starts_with(expected), "{report}");
        assert!(report.colored().contains("\u{1b}["));
    }

    #[test]
    fn tabs_and_wide_characters_keep_the_underline_right() {
        let shown = report("\t\tx\n漢字x", &[2..3, 10..11]).to_string();
        let lines: Vec<&str> = shown.lines().collect();
        assert_eq!(lines[3..5], ["1 |         x", "  |         ^ here"]);
        assert_eq!(lines[7], " --> a.sweep:2:3");
        assert_eq!(lines[9..11], ["2 | 漢字x", "  |     ^ here"]);
    }

    #[test]
    fn long_lines_are_cut_around_the_place() {
        let text = format!("{}!{}", "a".repeat(50_000), "b".repeat(50_000));
        for place in [50_000..50_001, 0..1, 100_000..100_001, 0..100_001] {
            let column = place.start + 1;
            let shown = report(&text, &[place]).to_string();
            assert!(shown.len() < 1000, "{} bytes", shown.len());
            assert!(shown.contains(&format!("a.sweep:1:{column}\n")), "{shown}");
        }
    }

    #[test]
    fn twenty_mistakes_are_shown_then_a_count() {
        let text = "x".repeat(30);
        let places: Vec<Range<usize>> = (0..30).map(|at| at..at + 1).collect();
        let report = report(&text, &places);
        assert_eq!(report.to_string().matches("error: wrong").count(), 20);
        assert!(report.to_string().ends_with("… and 10 more mistakes"));
        assert!(report.message().ends_with("a.sweep:1:20: wrong\n… and 10 more mistakes"));
        assert_eq!(report.lines().len(), 30);
    }
}
