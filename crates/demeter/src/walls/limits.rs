//! What numbers of walls and motions are allowed.

use super::error::WallError;
use glam::DVec3;

/// Largest coordinate [m]: its square is far from overflow.
pub(super) const LARGEST: f64 = 1e100;
/// Largest deviation from 1 of the length of a unit vector, and from 0 of the cosine of a right angle.
pub(super) const UNIT_TOLERANCE: f64 = 1e-6;

pub(super) fn finite(field: &'static str, value: DVec3) -> Result<DVec3, WallError> {
    if value.is_finite() && value.abs().max_element() <= LARGEST {
        Ok(value)
    } else {
        Err(WallError::NotFinite { field, value })
    }
}

pub(super) fn unit(field: &'static str, value: DVec3) -> Result<DVec3, WallError> {
    let length = finite(field, value)?.length();
    if (length - 1.0).abs() <= UNIT_TOLERANCE {
        Ok(value / length)
    } else {
        Err(WallError::NotUnit { field, value })
    }
}

pub(super) fn positive(field: &'static str, value: f64) -> Result<f64, WallError> {
    in_range(field, value, "positive", |value| value > 0.0)
}

pub(super) fn not_negative(field: &'static str, value: f64) -> Result<f64, WallError> {
    in_range(field, value, "0 or positive", |value| value >= 0.0)
}

pub(super) fn in_range(
    field: &'static str,
    value: f64,
    allowed: &'static str,
    fits: impl Fn(f64) -> bool,
) -> Result<f64, WallError> {
    if value.abs() <= LARGEST && fits(value) {
        Ok(value)
    } else {
        Err(WallError::OutOfRange { field, value, allowed })
    }
}
