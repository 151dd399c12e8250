//! Numbers for the page, packed: `[length of the head: u32][head: JSON][padding to 8 bytes][arrays]`, little endian.
//!
//! The head has the key `arrays`: for every array its name, type (`f32`, `f64`, `u32`, `i32`), place from the end of the
//! padding [bytes] and number of values. Arrays begin at multiples of 8 bytes, so that a page uses them where they are.

use serde_json::{Map, Value, json};

/// What an answer is made of.
#[derive(Debug, Default)]
pub struct Pack {
    head: Map<String, Value>,
    arrays: Vec<Value>,
    data: Vec<u8>,
}

impl Pack {
    /// Adds a value to the head.
    pub fn tell(&mut self, name: &str, value: Value) {
        self.head.insert(name.to_string(), value);
    }

    /// Adds an array of 32-bit floating point.
    pub fn f32s(&mut self, name: &str, values: impl IntoIterator<Item = f64>) {
        self.array(name, "f32", values.into_iter().map(|v| (v as f32).to_le_bytes()));
    }

    /// Adds an array of 64-bit floating point.
    pub fn f64s(&mut self, name: &str, values: impl IntoIterator<Item = f64>) {
        self.array(name, "f64", values.into_iter().map(f64::to_le_bytes));
    }

    /// Adds an array of integers without sign.
    pub fn u32s(&mut self, name: &str, values: impl IntoIterator<Item = u32>) {
        self.array(name, "u32", values.into_iter().map(u32::to_le_bytes));
    }

    /// Adds an array of integers.
    pub fn i32s(&mut self, name: &str, values: impl IntoIterator<Item = i32>) {
        self.array(name, "i32", values.into_iter().map(i32::to_le_bytes));
    }

    fn array<const N: usize>(&mut self, name: &str, kind: &str, values: impl Iterator<Item = [u8; N]>) {
        pad(&mut self.data);
        let place = self.data.len();
        self.data.reserve(N * values.size_hint().0);
        values.for_each(|bytes| self.data.extend_from_slice(&bytes));
        let length = (self.data.len() - place) / N;
        self.arrays
            .push(json!({ "name": name, "type": kind, "place": place, "length": length }));
    }

    /// The bytes of the answer.
    pub fn encode(mut self) -> Vec<u8> {
        self.head.insert("arrays".to_string(), Value::Array(self.arrays));
        let head = Value::Object(self.head).to_string();
        // a head has at most some thousand columns
        let mut bytes = u32::try_from(head.len()).unwrap_or(u32::MAX).to_le_bytes().to_vec();
        bytes.reserve(head.len() + 8 + self.data.len());
        bytes.extend_from_slice(head.as_bytes());
        pad(&mut bytes);
        bytes.extend_from_slice(&self.data);
        bytes
    }
}

fn pad(bytes: &mut Vec<u8>) {
    bytes.resize(bytes.len().next_multiple_of(8), 0);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrays_lie_where_the_head_says() {
        let mut pack = Pack::default();
        pack.tell("step", json!(7));
        pack.u32s("id", [1, 2, 3]);
        pack.f64s("time", [0.5]);
        pack.f32s("none", []);
        let bytes = pack.encode();
        let head_length = u32::from_le_bytes(bytes[..4].try_into().unwrap()) as usize;
        let head: Value = serde_json::from_slice(&bytes[4..4 + head_length]).unwrap();
        let data = &bytes[(4 + head_length).next_multiple_of(8)..];
        assert_eq!(head["step"], 7);
        assert_eq!(
            head["arrays"][0],
            json!({ "name": "id", "type": "u32", "place": 0, "length": 3 })
        );
        assert_eq!(head["arrays"][1]["place"], 16);
        assert_eq!(data[..12], [1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0]);
        assert_eq!(data[16..24], 0.5_f64.to_le_bytes());
        assert_eq!((head["arrays"][2]["length"].as_u64(), data.len()), (Some(0), 24));
    }
}
