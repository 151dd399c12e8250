//! Python module of Demeter: a skeleton that holds the crate's place in the workspace.
//!
//! The module itself (PyO3, NumPy views, the Python package) is an issue of its own; this crate is outside
//! `default-members`, so that building Demeter needs no Python.

/// Version of the engine that the module wraps.
pub const ENGINE_VERSION: &str = demeter::VERSION;
