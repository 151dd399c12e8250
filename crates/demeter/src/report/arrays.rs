//! Numbers in the data of a page, as base64.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};

/// Numbers of 32 bits: `{ "f32": "..." }`.
pub(super) fn f32s(values: impl IntoIterator<Item = f64>) -> Value {
    let bytes: Vec<u8> = values.into_iter().flat_map(|v| (v as f32).to_le_bytes()).collect();
    json!({ "f32": STANDARD.encode(bytes) })
}

/// Numbers of 64 bits: `{ "f64": "..." }`.
pub(super) fn f64s(values: impl IntoIterator<Item = f64>) -> Value {
    let bytes: Vec<u8> = values.into_iter().flat_map(f64::to_le_bytes).collect();
    json!({ "f64": STANDARD.encode(bytes) })
}

/// Whole numbers: `{ "u32": "..." }`.
pub(super) fn u32s(values: impl IntoIterator<Item = u32>) -> Value {
    let bytes: Vec<u8> = values.into_iter().flat_map(u32::to_le_bytes).collect();
    json!({ "u32": STANDARD.encode(bytes) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_little_endian() {
        assert_eq!(
            f32s([1.0, f64::NAN])["f32"],
            STANDARD.encode([0, 0, 128, 63, 0, 0, 192, 127])
        );
        assert_eq!(f64s([1.0])["f64"], "AAAAAAAA8D8=");
        assert_eq!(u32s([1, 256])["u32"], STANDARD.encode([1, 0, 0, 0, 0, 1, 0, 0]));
        assert_eq!(f32s([])["f32"], "");
    }
}
