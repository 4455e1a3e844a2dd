//! Text as a source of tokens: its name, its characters, and where each token stands in it.

use std::fs::File;
use std::io::Read;
use std::ops::Range;
use std::path::Path;

use super::diagnostic::{Diagnostic, Diagnostics};
use super::report::Report;
use super::token::{Span, SpanId};

/// A place in a text, as editors count: lines and characters from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Position {
    /// The line, from 1.
    pub line: usize,
    /// The character in the line, from 1.
    pub column: usize,
}

/// A text with its name, which resolves the places of its tokens.
#[derive(Clone, Debug)]
pub struct Source {
    name: String,
    text: String,
    /// Where each token stands, in bytes, by its `SpanId`.
    places: Vec<Range<usize>>,
    /// Where each line begins.
    lines: Vec<usize>,
}

impl Source {
    /// The name as the caller gave it: a file's path, mostly.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The whole text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The bytes of [`Source::text`] at this place.
    pub fn range(&self, span: Span) -> Range<usize> {
        let place = |id: SpanId| self.places.get(id.0 as usize);
        match (place(span.first), place(span.last)) {
            (Some(first), Some(last)) => first.start..last.end.max(first.end),
            _ => self.text.len()..self.text.len(),
        }
    }

    /// Line and column where the place begins. Takes O(log lines + length of the line).
    pub fn position(&self, span: Span) -> Position {
        let offset = self.range(span).start;
        let (line, bytes) = self.line_at(offset);
        Position { line, column: self.text[bytes.start..offset].chars().count() + 1 }
    }

    /// The number of the line, from 1, that holds this byte, and the bytes of that line without its end.
    pub(super) fn line_at(&self, offset: usize) -> (usize, Range<usize>) {
        let line = self.lines.partition_point(|&start| start <= offset);
        let start = self.lines[line - 1];
        let end = self.lines.get(line).map_or(self.text.len(), |next| next - 1);
        let end = if self.text[start..end].ends_with('\r') { end - 1 } else { end };
        (line, start..end.max(offset))
    }

    /// A text whose tokens stand at these places.
    pub(super) fn new(name: &str, text: &str, places: Vec<Range<usize>>) -> Source {
        let breaks = text.bytes().enumerate().filter(|&(_, byte)| byte == b'\n').map(|(at, _)| at + 1);
        let lines = std::iter::once(0).chain(breaks).collect();
        Source { name: name.to_string(), text: text.to_string(), places, lines }
    }
}

/// The text in a file's bytes, without a byte-order mark.
///
/// # Errors
/// Bytes that are not UTF-8, or hold a NUL as only binary files do, with line and column of the first of them.
///
/// ```
/// use hodograph_codegen::language::decode;
///
/// assert_eq!(decode("a.sweep", b"\xEF\xBB\xBFsweep").unwrap(), "sweep");
/// let report = decode("a.sweep", b"sweep\nx \xFF").unwrap_err();
/// assert_eq!(report.lines(), ["a.sweep:2:3: this is not UTF-8 text"]);
/// ```
pub fn decode<'a>(name: &str, bytes: &'a [u8]) -> Result<&'a str, Box<Report>> {
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    let valid = match std::str::from_utf8(bytes) {
        Ok(text) => text,
        Err(error) => std::str::from_utf8(&bytes[..error.valid_up_to()]).unwrap_or_default(),
    };
    let (end, message, help) = if bytes.starts_with(b"\xFF\xFE") || bytes.starts_with(b"\xFE\xFF") {
        (0, "this is UTF-16, not UTF-8", "save the file as UTF-8")
    } else if let Some(nul) = valid.find('\0') {
        (nul, "this is a binary file: it holds a zero byte", "give a text in the sweep language")
    } else if valid.len() < bytes.len() {
        (valid.len(), "this is not UTF-8 text", "save the file as UTF-8")
    } else {
        return Ok(valid);
    };
    let shown = format!("{}\u{FFFD}", &valid[..end]);
    let place = end..shown.len();
    let source = Source::new(name, &shown, vec![place]);
    let mut diagnostics = Diagnostics::new();
    diagnostics.push(Diagnostic::new(Span::at(SpanId(0)), message).help(help));
    Err(Box::new(Report::new(source, diagnostics)))
}

/// The text of a file that a source names as `name`.
///
/// # Errors
/// Why there is none: no such file, no text, or more bytes than [`MAX_LENGTH`](super::MAX_LENGTH).
pub fn read_input(path: &Path, name: &str) -> Result<String, String> {
    let mut bytes = Vec::new();
    let limit = u64::try_from(super::MAX_LENGTH).unwrap_or(u64::MAX);
    let file = File::open(path).map_err(|error| error.to_string())?;
    // Room for a byte-order mark, and for one byte that is too many.
    file.take(limit + 4).read_to_end(&mut bytes).map_err(|error| error.to_string())?;
    if bytes.len() > super::MAX_LENGTH + 3 {
        return Err(format!("it is longer than the limit of {} bytes", super::MAX_LENGTH));
    }
    let text = decode(name, &bytes).map_err(|report| report.message())?;
    Ok(text.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions() {
        let source = Source::new("a", "ab\r\né√x\n", vec![0..1, 9..10, 11..11]);
        let position = |id| source.position(Span::at(SpanId(id)));
        assert_eq!(position(0), Position { line: 1, column: 1 });
        assert_eq!(position(1), Position { line: 2, column: 3 });
        assert_eq!(position(2), Position { line: 3, column: 1 });
        assert_eq!(source.line_at(1), (1, 0..2));
        assert_eq!(source.line_at(4), (2, 4..10));
        assert_eq!(source.line_at(11), (3, 11..11));
        assert_eq!(source.range(Span::at(SpanId(0)).to(Span::at(SpanId(1)))), 0..10);
    }

    #[test]
    fn bytes_that_are_no_text() {
        assert_eq!(decode("a", b"").unwrap(), "");
        let lines = |bytes: &[u8]| decode("a", bytes).unwrap_err().lines();
        assert_eq!(lines(b"a\0b"), ["a:1:2: this is a binary file: it holds a zero byte"]);
        assert_eq!(lines(b"\xFF\xFEa\0"), ["a:1:1: this is UTF-16, not UTF-8"]);
        assert_eq!(lines(b"\xC3"), ["a:1:1: this is not UTF-8 text"]);
        assert_eq!(lines("é\n√".as_bytes().split_last().unwrap().1), ["a:2:1: this is not UTF-8 text"]);
    }
}
