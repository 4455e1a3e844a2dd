//! A short stable digest of long texts.

/// The 64-bit FNV-1a hash of `text` in hexadecimal of Fowler, Noll and Vo; the same on every machine.
///
/// ```
/// use hodograph_tests::digest::fnv1a;
/// // The test vectors of its authors.
/// assert_eq!(fnv1a(""), "cbf29ce484222325");
/// assert_eq!(fnv1a("foobar"), "85944171f73967e8");
/// ```
#[must_use]
pub fn fnv1a(text: &str) -> String {
    const OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
    const PRIME: u64 = 0x0100_0000_01b3;
    let hash = text.bytes().fold(OFFSET, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(PRIME));
    format!("{hash:016x}")
}
