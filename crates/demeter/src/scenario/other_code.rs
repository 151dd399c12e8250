//! Files of other codes, told where Demeter reads TOML: one fault, in place of one for every line.

use crate::grain_files::{Format, restart_of};

/// Words that begin the lines of an input script of LAMMPS or of a code that descends from it.
const OF_LAMMPS: [&str; 27] = [
    "atom_modify",
    "atom_style",
    "boundary",
    "comm_modify",
    "communicate",
    "compute",
    "create_atoms",
    "create_box",
    "dump",
    "fix",
    "group",
    "hard_particles",
    "mass",
    "neigh_modify",
    "neighbor",
    "newton",
    "pair_coeff",
    "pair_style",
    "read_data",
    "read_restart",
    "region",
    "run",
    "thermo",
    "thermo_modify",
    "timestep",
    "units",
    "variable",
];

/// So many of them, each once, are no accident.
const ENOUGH: usize = 3;

/// What LIGGGHTS alone has.
const OF_LIGGGHTS: [&str; 7] = [
    "property/global",
    "particletemplate",
    "particledistribution",
    "mesh/surface",
    "wall/gran",
    "hard_particles",
    "insert/",
];

/// Other programs, and how lines begin that tell them.
const OTHERS: [(&str, &[&str]); 5] = [
    ("YADE", &["from yade import", "import yade", "O.engines", "O.bodies"]),
    ("ESyS-Particle", &["from esys."]),
    (
        "MercuryDPM",
        &[
            "#include \"Mercury",
            "#include <Mercury",
            "#include \"DPMBase",
            "#include <DPMBase",
            "restart_version",
        ],
    ),
    ("Demeter for Python", &["import demeter", "from demeter import"]),
    ("Python", &["import numpy", "import math", "if __name__"]),
];

/// How files begin that store tables of numbers, those of EDEM among them.
const HDF5: &[u8] = b"\x89HDF\r\n\x1a\n";

/// What a text that is no TOML seems to be, and what to do with it; nothing where it is like none that is known.
pub(super) fn recognise(text: &str) -> Option<(String, String)> {
    let told = |what: &str, help: &str| Some((format!("this looks like {what}; Demeter reads TOML"), help.to_string()));
    let format = Format::of_text(text);
    if format != Format::Columns {
        return told(
            &format!("a file of grains (`{format}`)"),
            "name it in a scenario: `source = \"file\"` in `[[grains]]`; `demeter new` writes a scenario to start from, and \
             `demeter convert` writes the grains in another format",
        );
    }
    if is_of_lammps(text) {
        let name = match OF_LIGGGHTS.iter().any(|word| text.contains(word)) {
            true => "LIGGGHTS",
            false => "LAMMPS",
        };
        return told(
            &format!("an input script of {name}"),
            "write what it does as a scenario: `demeter new` writes one to start from, and \"Coming from another code\" in the book \
                 translates the commands. Grains of its data files and dumps are read as they are (`source = \"file\"`, `demeter \
                 convert`)",
        );
    }
    let begins_with = |mark: &&str| text.lines().any(|line| line.trim_start().starts_with(mark));
    let (name, _) = OTHERS.into_iter().find(|(_, marks)| marks.iter().any(begins_with))?;
    match name {
        "Python" | "Demeter for Python" => told(
            &format!("a program for {}", name.trim_start_matches("Demeter for ")),
            "run it with `python`; `import demeter` there runs scenarios, and `demeter new` writes one to start from",
        ),
        _ => told(
            &format!("an input of {name}"),
            "write what it does as a scenario: `demeter new` writes one to start from, and \"Coming from another code\" in the book \
             tells how. Grains are read from CSV, extended XYZ, and text packings of YADE (`source = \"file\"`, `demeter convert`)",
        ),
    }
}

/// What bytes that are no text seem to be.
pub(super) fn recognise_bytes(bytes: &[u8]) -> Option<String> {
    if let Some(code) = restart_of(bytes) {
        return Some(format!(
            "this looks like a binary restart file of {code}; Demeter reads TOML. Write its grains to a data file (`write_data`) and \
             name that in a scenario (`source = \"file\"` in `[[grains]]`); `demeter new` writes one to start from"
        ));
    }
    bytes.starts_with(HDF5).then(|| {
        "this looks like an HDF5 file, as EDEM and others write them; Demeter reads TOML. Export the grains as CSV and name that file \
         in a scenario (`source = \"file\"` in `[[grains]]`); `demeter new` writes one to start from"
            .to_string()
    })
}

/// Whether lines begin with different commands of LAMMPS and go on with their arguments, which a key of TOML does not.
fn is_of_lammps(text: &str) -> bool {
    let mut found: Vec<&str> = Vec::new();
    for line in text.lines() {
        let mut words = line.split_whitespace();
        let command = words.next().filter(|word| OF_LAMMPS.contains(word));
        let has_arguments = words.next().is_some_and(|word| !word.starts_with('='));
        if let Some(command) = command.filter(|command| has_arguments && !found.contains(command)) {
            found.push(command);
        }
        if found.len() >= ENOUGH {
            return true;
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use crate::scenario::{Scenario, TEMPLATES, template};
    use std::path::Path;

    fn refused(text: &str) -> String {
        Scenario::parse(text, "in.file", Path::new(""), &[])
            .unwrap_err()
            .to_string()
    }

    #[test]
    fn inputs_of_other_codes_are_told_in_one_fault() {
        let lammps = "# a hopper\nunits si\natom_style sphere\npair_style granular\npair_coeff * * hertz/material 1e7 0.8 0.3\nrun 1000\n";
        let liggghts =
            "units si\natom_style granular\nfix m1 all property/global youngsModulus peratomtype 5.e6\nrun 1\n";
        let cases = [
            (lammps, "an input script of LAMMPS"),
            (liggghts, "an input script of LIGGGHTS"),
            (
                "from yade import pack\nO.bodies.append(sphere((0,0,0), 1))\n",
                "an input of YADE",
            ),
            (
                "#include \"Mercury3D.h\"\nint main() { return 0; }\n",
                "an input of MercuryDPM",
            ),
            ("restart_version 18 name a\n", "an input of MercuryDPM"),
            (
                "import demeter\nsim = demeter.run(\"a.toml\")\nprint sim\n",
                "a program for Python",
            ),
            ("ITEM: TIMESTEP\n0\n", "a file of grains (`lammps-dump`)"),
            ("LAMMPS data file\n\n2 atoms\n", "a file of grains (`lammps-data`)"),
        ];
        for (text, what) in cases {
            let found = refused(text);
            assert!(found.contains(&format!("this looks like {what}; ")), "{found}");
            assert!(found.contains("demeter new") && !found.contains('\n'), "{found}");
        }
        let place = tempfile::tempdir().unwrap();
        let deck = place.path().join("deck.dem");
        std::fs::write(&deck, b"\x89HDF\r\n\x1a\n\0\0\0").unwrap();
        let found = Scenario::read(&deck, &[]).unwrap_err().to_string();
        assert!(found.contains("EDEM"), "{found}");
    }

    /// A scenario that is broken is told where.
    #[test]
    fn a_scenario_with_a_slip_is_still_one() {
        for (name, ..) in TEMPLATES {
            let text = format!("# import yade\n{}\nrun 1000\nunits si\n", template(name).unwrap());
            assert!(refused(&text).contains("not valid TOML"), "{name}");
        }
    }
}
