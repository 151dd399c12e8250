//! Scenarios to start from: `demeter new drum`.

/// Name, summary and text of every template.
pub const TEMPLATES: &[(&str, &str, &str)] = &[
    (
        "settle",
        "grains are poured into a box and come to rest",
        include_str!("templates/settle.toml"),
    ),
    (
        "compress",
        "a packing is squeezed by a plate and released",
        include_str!("templates/compress.toml"),
    ),
    (
        "drum",
        "grains tumble in a rotating drum",
        include_str!("templates/drum.toml"),
    ),
    (
        "silo",
        "grains flow out of a hopper",
        include_str!("templates/silo.toml"),
    ),
    (
        "collide",
        "two grains collide head-on",
        include_str!("templates/collide.toml"),
    ),
];

/// Text of the template of a name.
pub fn template(name: &str) -> Option<&'static str> {
    TEMPLATES.iter().find(|t| t.0 == name).map(|t| t.2)
}
