//! A surface that a build script has compiled from `formulas/gutter.sweep`; `build.rs` is all that it takes.
//!
//! ```
//! use hodograph::Surface;
//! use hodograph_example_build_script::gutter::Gutter;
//!
//! let point = Gutter.point(0.0, 0.5)?;
//! assert!(point.iter().all(|x: &f64| x.is_finite()));
//! # Ok::<(), hodograph::Undefined>(())
//! ```

#![forbid(unsafe_code)]

include!(concat!(env!("OUT_DIR"), "/gutter.rs"));

#[cfg(test)]
mod tests {
    use hodograph::Surface;

    /// The same sweep, expanded by the macro.
    mod expanded {
        hodograph::sweep!(file = "formulas/gutter.sweep");
    }

    #[test]
    fn build_script_and_macro_give_the_same_bits() {
        for k in 0..=100 {
            let (u, v) = (f64::from(k) / 100.0 - 0.5, 1.0 - f64::from(k) / 100.0);
            let built = super::gutter::Gutter.local_geometry(u, v);
            assert_eq!(built, expanded::gutter::Gutter.local_geometry(u, v));
            assert!(built.is_ok());
        }
        assert_eq!(super::gutter::Gutter::FORMULA, expanded::gutter::Gutter::FORMULA);
    }
}
