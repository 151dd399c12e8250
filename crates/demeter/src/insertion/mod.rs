//! insertion
