//! Templates of C text, with places such as `@name@`.

/// The text of a template, where each place `@key@` has the value that `values` give for its key.
///
/// # Panics
/// If a place has no value: templates are part of this program.
pub(super) fn fill(template: &str, values: &[(&str, &str)]) -> String {
    let mut text = String::new();
    for (i, part) in template.split('@').enumerate() {
        if i % 2 == 0 {
            text.push_str(part);
            continue;
        }
        let value = values.iter().find(|(key, _)| *key == part);
        let Some((_, value)) = value else { unreachable!("nothing is given for the place `{part}`") };
        text.push_str(value);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::fill;

    #[test]
    fn places_are_filled() {
        let values = [("name", "tube"), ("f", "")];
        assert_eq!(fill("@name@_point@f@(u, @name@)", &values), "tube_point(u, tube)");
        assert_eq!(fill("", &values), "");
    }

    #[test]
    #[should_panic(expected = "nothing is given for the place `size`")]
    fn a_place_without_value_is_a_mistake() {
        let _ = fill("out[@size@]", &[("f", "")]);
    }
}
