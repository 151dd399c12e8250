//! Arguments of the commands that write files for other programs and for shells.

use clap::Args;
use clap_complete::Shell;
use std::path::PathBuf;

/// Of `demeter convert`.
#[derive(Debug, Args)]
pub struct ConvertArguments {
    /// A file of grains, the folder of a run, or one `grains_*.vtp` of its frames
    pub input: PathBuf,
    /// File to write
    ///
    /// A `*` in its name stands for the step: each moment then gets a file of its own. A file that is there is only replaced
    /// with `--overwrite`. A name that ends with `.gz` is compressed.
    pub output: PathBuf,
    /// Format of the input; told by its content when absent
    #[arg(long, value_name = "FORMAT")]
    pub from: Option<String>,
    /// Format of the output; told by its name when absent
    #[arg(long, value_name = "FORMAT")]
    pub to: Option<String>,
    /// Moments: `all`, `last`, or a number from 0
    ///
    /// Without it all where the output holds several, else the last.
    #[arg(long, value_name = "N|all|last")]
    pub frame: Option<String>,
    /// Columns of csv, xyz or a dump, as `id,x,y,z,radius,vx,vy,vz`; all there are when absent
    #[arg(long, value_name = "NAME,NAME", value_delimiter = ',')]
    pub columns: Option<Vec<String>>,
    /// Units of the input: `si`, `cgs`, `micro`, `nano` (unit styles of LAMMPS), or of length, mass and time, as `mm,g,ms`
    ///
    /// Without it those that the file names, else SI. The output is in SI.
    #[arg(long, value_name = "UNITS")]
    pub units: Option<String>,
    /// Diameter of all grains of a file that tells no sizes, as "1 mm"
    #[arg(long, value_name = "LENGTH")]
    pub diameter: Option<String>,
    /// Density of all grains of a file that tells none, as "2500 kg/m^3"
    #[arg(long, value_name = "DENSITY")]
    pub density: Option<String>,
    /// Names of the materials of types 1, 2, ...
    #[arg(long, value_name = "NAME,NAME", value_delimiter = ',')]
    pub types: Vec<String>,
    /// Atom style of a data file that names none or another, as "hybrid sphere bond"
    #[arg(long, value_name = "STYLE")]
    pub atom_style: Option<String>,
    /// Replace files that are there
    #[arg(long)]
    pub overwrite: bool,
    /// Write one JSON object to standard output
    #[arg(long)]
    pub json: bool,
}

/// Of `demeter completions`.
#[derive(Debug, Args)]
pub struct CompletionsArguments {
    /// The shell
    pub shell: Shell,
}

/// Of `demeter man`.
#[derive(Debug, Args)]
pub struct ManArguments {
    /// Folder for the pages; made when it is not there. Pages of these names are replaced
    pub folder: PathBuf,
}
