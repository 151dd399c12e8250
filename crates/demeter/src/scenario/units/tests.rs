use super::*;

/// Every row of the table once: symbol, SI value of one, and the same worked out by hand.
const ROWS: &[(&str, f64, Dimension)] = &[
    ("m", 1.0, Dimension::LENGTH),
    ("g", 0.001, Dimension::MASS),
    ("s", 1.0, Dimension::TIME),
    ("N", 1.0, Dimension::FORCE),
    ("Pa", 1.0, Dimension::PRESSURE),
    ("bar", 100_000.0, Dimension::PRESSURE),
    ("J", 1.0, Dimension::ENERGY),
    ("W", 1.0, POWER),
    ("Hz", 1.0, Dimension::FREQUENCY),
    ("L", 0.001, Dimension::VOLUME),
    ("t", 1000.0, Dimension::MASS),
    ("min", 60.0, Dimension::TIME),
    ("h", 3600.0, Dimension::TIME),
    ("day", 86_400.0, Dimension::TIME),
    ("in", 0.0254, Dimension::LENGTH),
    ("ft", 0.3048, Dimension::LENGTH),
    ("lb", 0.453_592_37, Dimension::MASS),
    // 1 lb times 9.80665 m/s^2 over (0.0254 m)^2
    ("psi", 0.453_592_37 * 9.806_65 / (0.0254 * 0.0254), Dimension::PRESSURE),
    ("rad", 1.0, Dimension::NONE),
    ("deg", 0.017_453_292_519_943_295, Dimension::NONE),
    ("rev", 360.0 * 0.017_453_292_519_943_295, Dimension::NONE),
    ("rpm", 0.104_719_755_119_659_77, Dimension::FREQUENCY),
];

#[test]
fn every_unit_has_its_value() {
    assert_eq!(
        ROWS.iter().map(|r| r.0).collect::<Vec<_>>(),
        UNITS.iter().map(|u| u.symbol).collect::<Vec<_>>(),
        "one row per unit"
    );
    for &(symbol, value, dimension) in ROWS {
        let read = parse(&format!("1 {symbol}")).unwrap();
        assert!((read.value - value).abs() <= 1e-15 * value, "{symbol}: {}", read.value);
        assert_eq!(read.dimension, dimension, "{symbol}");
        let angle = i8::from(["rad", "deg", "rev", "rpm"].contains(&symbol));
        assert_eq!(read.angle, angle, "{symbol}");
    }
}

#[test]
fn every_prefix_has_its_value() {
    let values = [
        ("f", 1e-15),
        ("p", 1e-12),
        ("n", 1e-9),
        ("u", 1e-6),
        ("µ", 1e-6),
        ("μ", 1e-6),
        ("m", 1e-3),
        ("c", 1e-2),
        ("d", 1e-1),
        ("h", 1e2),
        ("k", 1e3),
        ("M", 1e6),
        ("G", 1e9),
        ("T", 1e12),
    ];
    assert_eq!(
        values.map(|v| v.0).to_vec(),
        PREFIXES.iter().map(|p| p.0).collect::<Vec<_>>()
    );
    for (prefix, value) in values {
        assert_eq!(parse(&format!("1 {prefix}N")).unwrap().value, value, "{prefix}");
    }
}

#[test]
fn no_prefixed_unit_reads_as_another_unit() {
    for unit in UNITS.iter().filter(|u| u.prefixes) {
        for (prefix, _) in PREFIXES {
            let symbol = format!("{prefix}{}", unit.symbol);
            let clash = UNITS.iter().any(|u| u.symbol == symbol);
            assert!(!clash, "{symbol} is a unit of its own and a prefixed {}", unit.name);
        }
    }
}

#[test]
fn quantities_of_the_design_read_exactly() {
    let cases = [
        ("23.3 kPa", 23_300.0, Dimension::PRESSURE),
        ("2 mm/min", 2e-3 / 60.0, Dimension::VELOCITY),
        ("-2.64 nN", -2.64e-9, Dimension::FORCE),
        ("1000 kg/m^3", 1000.0, Dimension::DENSITY),
        ("9.81 m/s^2", 9.81, Dimension::ACCELERATION),
        ("9.3 mm", 9.3e-3, Dimension::LENGTH),
        ("1e-5 s", 1e-5, Dimension::TIME),
        ("1.5e3 N s/m", 1500.0, Dimension::DAMPING),
        ("3 1/s", 3.0, Dimension::FREQUENCY),
        ("3 1 / s", 3.0, Dimension::FREQUENCY),
        ("2 N/(m s)", 2.0, Dimension::new(1, 0, -3)),
        ("5mm", 5e-3, Dimension::LENGTH),
        ("2 cm^2", 2e-4, Dimension::AREA),
        ("2 m s^-1", 2.0, Dimension::VELOCITY),
        ("2500 kg / m^3", 2500.0, Dimension::DENSITY),
        ("2500 kg/ m^3", 2500.0, Dimension::DENSITY),
        ("4 mm³", 4e-9, Dimension::VOLUME),
        ("1 g/cm^3", 1000.0, Dimension::DENSITY),
        ("7 kg/m/s", 7.0, Dimension::new(1, -1, -1)),
        ("+.5 m", 0.5, Dimension::LENGTH),
        ("0.05 J/m^2", 0.05, Dimension::SURFACE_ENERGY),
        ("50 mJ/m^2", 0.05, Dimension::SURFACE_ENERGY),
        ("50 mN/m", 0.05, Dimension::SURFACE_ENERGY),
        ("2 GN/m^1.5", 2e9, Dimension::HERTZ_STIFFNESS),
        ("3 kg m^-0.5 s^-2", 3.0, Dimension::HERTZ_STIFFNESS),
        ("4 m^1.5 m^1.5", 4.0, Dimension::VOLUME),
    ];
    for (text, value, dimension) in cases {
        let read = parse(text).unwrap();
        assert_eq!((read.value, read.dimension), (value, dimension), "{text}");
    }
    assert_eq!(parse("30 deg").unwrap().value, 30.0 * (PI / 180.0));
    assert_eq!(parse("5 %").unwrap().value, 0.05);
    assert!(!parse("5").unwrap().has_unit);
}

#[test]
fn half_powers_take_roots_of_prefixes_and_factors() {
    // 1 mm^-1.5 = 10^4.5 m^-1.5, 1 min^0.5 = sqrt(60) s^0.5
    for (text, value) in [
        ("1 N/mm^1.5", 10.0_f64.powf(4.5)),
        ("1 mm^0.5", 10.0_f64.powf(-1.5)),
        ("2 min^0.5", 2.0 * 60.0_f64.sqrt()),
        ("2 s/min^1.5", 2.0 / 60.0_f64.powf(1.5)),
    ] {
        let read = parse(text).unwrap().value;
        assert!((read / value - 1.0).abs() < 1e-15, "{text}: {read}");
    }
}

#[test]
fn faults_say_what_is_wrong() {
    let message = |text: &str| parse(text).unwrap_err().to_string();
    assert_eq!(message("mm"), "`mm` does not begin with a number");
    assert_eq!(message("nan m"), "`nan` is not a finite number");
    assert_eq!(message("-inf m"), "`-inf` is not a finite number");
    assert_eq!(message("1e999 m"), "`1e999` is not a finite number");
    assert_eq!(message("2 kp"), "unknown unit `kp`");
    for text in [
        "1 N/m s",
        "1 m3",
        "1 m^",
        "1 m^2.3",
        "1 m^2.",
        "1 m^9.5",
        "1 m^0",
        "1 rad^0.5",
        "1 N/",
        "1 (m s)",
        "1 N/(m",
        "1 m)",
        "1 m$",
        "1 m//s",
        "3 1 mm",
        "3 1",
        "3 mm 1",
        "3 m/1",
        "3 m 1/s",
    ] {
        assert!(
            matches!(parse(text), Err(UnitError::Form { .. })),
            "{text}: {:?}",
            parse(text)
        );
    }
    assert!(parse(&format!("1 {}", "m ".repeat(1000))).is_err());
    assert!(parse(&format!("1 {}", ["m^9"; 15].join(" "))).is_err());
}

#[test]
fn unknown_units_are_met_with_a_suggestion() {
    for (written, meant) in [
        ("sec", "s"),
        ("kpa", "kPa"),
        ("micron", "um"),
        ("ml", "mL"),
        ("KPa", "kPa"),
        ("Nm", "N m"),
    ] {
        match parse(&format!("1 {written}")) {
            Err(UnitError::Unknown { suggestion, .. }) => {
                assert_eq!(suggestion.as_deref(), Some(meant), "{written}");
            }
            other => panic!("{written}: {other:?}"),
        }
    }
}
