//! Scenarios to start from: `demeter new drum`.

/// Name, summary and text of every template.
pub const TEMPLATES: &[(&str, &str, &str)] = &[
    (
        "settle",
        "grains are poured into a box and come to rest",
        include_str!("templates/settle.toml"),
    ),
    (
        "hopper",
        "grains flow out of a hopper",
        include_str!("templates/hopper.toml"),
    ),
    (
        "drum",
        "grains tumble in a rotating drum",
        include_str!("templates/drum.toml"),
    ),
    (
        "mill",
        "balls hit each other and the shell of a ball mill",
        include_str!("templates/mill.toml"),
    ),
    (
        "mixer",
        "pitched blades mix two layers of grains",
        include_str!("templates/mixer.toml"),
    ),
    (
        "heap",
        "a tube is lifted off a heap: the angle of repose",
        include_str!("templates/heap.toml"),
    ),
    (
        "chute",
        "grains flow down a rough chute, in a box without ends",
        include_str!("templates/chute.toml"),
    ),
    (
        "penetration",
        "a ball falls into a bed of grains",
        include_str!("templates/penetration.toml"),
    ),
    (
        "uniaxial-compression",
        "a packing is squeezed by a plate and released",
        include_str!("templates/uniaxial-compression.toml"),
    ),
    (
        "tablet-press",
        "a powder is pressed by two punches, relieved and ejected",
        include_str!("templates/tablet-press.toml"),
    ),
    (
        "shear-cell",
        "a loaded packing is sheared: the friction of the bulk",
        include_str!("templates/shear-cell.toml"),
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
