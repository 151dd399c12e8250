//! Files of a run whose names follow from its scenario, so that a run that takes the place of another removes that one's and no others.

use super::Scenario;
use super::field_files::FieldFiles;
use super::measures::MeasureKind;
use super::plots::ENERGIES;
use super::rows::Rows;
use crate::output::RunFolder;
use std::path::PathBuf;

/// The files with such names that a new run finds in its folder: those of its own scenario, and, where a run was there, those of that
/// one's as far as it can still be read. All else in the folder belongs to somebody else.
pub(super) fn named_files(scenario: &Scenario, folder: &RunFolder, was_a_run: bool) -> Vec<PathBuf> {
    let former = was_a_run.then(|| Scenario::read_to_go_on(&folder.scenario()).ok());
    let former = former.flatten().map(|former| of_scenario(&former, folder));
    let mut files = of_scenario(scenario, folder);
    files.extend(former.unwrap_or_default());
    files
}

fn of_scenario(scenario: &Scenario, folder: &RunFolder) -> Vec<PathBuf> {
    let paths = (scenario.measures.iter()).filter(|measure| matches!(measure.kind, MeasureKind::Paths(_)));
    let lines = paths.map(|measure| folder.path_lines(&measure.name));
    let asked = scenario.output.plots.iter().map(|plot| plot.name.as_str());
    let plots = std::iter::once(ENERGIES).chain(asked).map(|name| folder.plot(name));
    let stages = scenario.stages.iter().enumerate();
    let pictures = stages.map(|(k, stage)| folder.stage_picture(k + 1, &stage.name));
    [Rows::files(scenario, folder), FieldFiles::files(scenario, folder)]
        .into_iter()
        .flatten()
        .chain(lines)
        .chain(plots)
        .chain(pictures)
        .collect()
}

#[cfg(test)]
mod tests {
    use crate::output::RunFolder;
    use crate::scenario::{RunOptions, Scenario};
    use std::fs;
    use std::path::Path;

    fn scenario(measure: &str) -> Scenario {
        let text = format!(
            "[material.glass]\nyoung_modulus = \"1 GPa\"\npoisson_ratio = 0.3\ndensity = \"2500 kg/m^3\"\n\
             [contact]\nnormal = {{ law = \"hertz-tsuji\", restitution = 0.5 }}\n\
             [[grains]]\nmaterial = \"glass\"\nsource = \"list\"\ndiameter = \"1 mm\"\npositions = [\"0 0 0 mm\"]\n\
             [[measure]]\nname = \"{measure}\"\nkind = \"profile\"\nlower = \"-1 -1 -1 mm\"\nupper = \"1 1 1 mm\"\naxis = \"z\"\nslices = 2\n\
             [[measure]]\nname = \"{measure}-paths\"\nkind = \"paths\"\n\
             [[measure]]\nname = \"{measure}-chains\"\nkind = \"force-chains\"\n\
             [[stage]]\nname = \"rest\"\nduration = \"1 ms\"\n[output]\nseries = \"1 ms\"\n"
        );
        Scenario::parse(&text, "rest", Path::new(""), &[]).unwrap()
    }

    /// Writes files, reserves the folder, and tells which of them are left.
    fn left(root: &Path, files: &[&str], scenario: &Scenario) -> Vec<String> {
        for file in files {
            let path = root.join(file);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, "x").unwrap();
        }
        let options = RunOptions {
            overwrite: true,
            ..RunOptions::default()
        };
        options.reserve(root, scenario).unwrap();
        let is_left = |file: &&&str| root.join(file).exists();
        files.iter().filter(is_left).map(ToString::to_string).collect()
    }

    #[test]
    fn a_run_in_place_of_another_removes_that_ones_files_alone() {
        let place = tempfile::tempdir().unwrap();
        let root = place.path().join("run");
        let (former, scenario) = (scenario("old"), scenario("new"));
        let (folder, lock) = RunOptions::default().reserve(&root, &former).unwrap();
        fs::write(folder.scenario(), former.to_resolved_toml()).unwrap();
        drop(lock);
        let (ours, mine) = (
            [
                "profiles/old.csv",
                "paths/old-paths.csv",
                "paths/old-paths.vtp",
                "chains/old-chains.pvd",
                "chains/old-chains_0000000100.vtp",
                "frames/grains_0000000100.vtp",
                "plots/energies.svg",
                "pictures/01-rest.png",
                "profiles/new.csv",
            ],
            [
                "profiles/mine.csv",
                "profiles/old-paths.csv",
                "paths/mine.vtp",
                "chains/thesis.pvd",
                "fields/thesis.csv",
                "distributions/thesis.csv",
                "plots/thesis.svg",
                "pictures/2024.png",
                "frames/grains_mine.vtp",
            ],
        );
        let all = [ours.as_slice(), &mine].concat();
        assert_eq!(left(&root, &all, &scenario), mine);

        // where no run can be read only what the new one will write is known
        let other = place.path().join("other");
        let files = ["profiles/new.csv", "profiles/old.csv", "scenario.toml"];
        assert_eq!(left(&other, &files, &scenario), ["profiles/old.csv"]);
        assert!(RunFolder::find(&other).is_ok());
    }
}
