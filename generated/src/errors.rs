#![doc = include_str!("../documentation/errors.md")]
