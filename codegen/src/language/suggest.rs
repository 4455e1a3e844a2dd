//! "Did you mean …?": the nearest of the words that would have been right.

/// The candidate nearest to `word`, if it is near enough to be meant: at most a third of the letters (and at
/// least one) differ, case aside. Of equally near ones the first.
///
/// The distance counts insertions, deletions, replacements and swaps of neighbors (optimal string alignment:
/// Damerau 1964). Takes O(candidates · length²).
///
/// ```
/// use hodograph_codegen::language::closest;
///
/// assert_eq!(closest("domian", ["domain", "source"]), Some("domain"));
/// assert_eq!(closest("banana", ["domain", "source"]), None);
/// ```
pub fn closest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let letters = lowercase(word);
    // Nobody means a name by forty wrong letters, and long words would take long.
    if letters.len() > 40 {
        return None;
    }
    let mut best: Option<(usize, &str)> = None;
    for candidate in candidates {
        let allowed = (letters.len().max(candidate.len()) / 3).max(1);
        // A single letter is no misspelling of another single letter.
        if candidate.len() > 2 * letters.len() + 1 || letters.len() > 2 * candidate.len() + 1 {
            continue;
        }
        let distance = distance(&letters, &lowercase(candidate));
        let nearest = best.is_none_or(|(least, _)| distance < least);
        if distance <= allowed && distance < letters.len() && nearest {
            best = Some((distance, candidate));
        }
    }
    best.map(|(_, candidate)| candidate)
}

fn lowercase(word: &str) -> Vec<char> {
    word.chars().flat_map(char::to_lowercase).collect()
}

/// Optimal string alignment distance.
fn distance(a: &[char], b: &[char]) -> usize {
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for (i, row) in rows.iter_mut().enumerate() {
        row[0] = i;
    }
    for (j, cell) in rows[0].iter_mut().enumerate() {
        *cell = j;
    }
    for i in 1..=a.len() {
        for j in 1..=b.len() {
            let replaced = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut least = replaced.min(rows[i - 1][j] + 1).min(rows[i][j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                least = least.min(rows[i - 2][j - 2] + 1);
            }
            rows[i][j] = least;
        }
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances() {
        let between = |a: &str, b: &str| distance(&lowercase(a), &lowercase(b));
        assert_eq!(between("", "abc"), 3);
        assert_eq!(between("profile", "profile"), 0);
        assert_eq!(between("porfile", "profile"), 1);
        assert_eq!(between("kitten", "sitting"), 3);
    }

    #[test]
    fn suggestions() {
        assert_eq!(closest("Surface", ["source", "surface"]), Some("surface"));
        assert_eq!(closest("symbols", ["symbol", "sweep"]), Some("symbol"));
        assert_eq!(closest("x", ["y", "z"]), None);
        assert_eq!(closest("u", ["surface"]), None);
        assert_eq!(closest(&"a".repeat(1000), ["a"]), None);
        assert_eq!(closest("", ["a"]), None);
    }
}
