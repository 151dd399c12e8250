//! The command line.

mod files;
mod pictures;
mod sweep;

pub use files::{CompletionsArguments, ConvertArguments, ManArguments};
pub use pictures::{PlotArguments, RenderArguments};
pub use sweep::SweepArguments;

use crate::exit;
use clap::{Args, Parser, Subcommand};
use demeter::scenario::MOST_THREADS;
use demeter::scenario::schema::FileKind;
use demeter_physics::lanes::Instructions;
use std::path::PathBuf;

/// Discrete element method for powders and soft grains: one text file in, one folder of results out.
#[derive(Debug, Parser)]
#[command(name = "demeter", version, after_help = exit::HELP)]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Run a scenario and write its results into a folder
    #[command(after_help = exit::HELP)]
    Run(RunArguments),
    /// Tell everything that is wrong with a scenario, or how it would run; writes nothing
    #[command(after_help = exit::HELP)]
    Check(CheckArguments),
    /// Go on with an interrupted or killed run from its latest checkpoint
    #[command(after_help = exit::HELP)]
    Resume(ResumeArguments),
    /// Run a scenario with many values on the cores of this machine or a cluster, and gather the results into one table
    #[command(after_help = exit::HELP)]
    Sweep(Box<SweepArguments>),
    /// Write the report of a run anew from what is in its folder, also while it goes on or after a kill
    #[command(after_help = exit::HELP)]
    Report(ReportArguments),
    /// Look at a run in the browser: its whole history, also while it goes on
    #[command(after_help = exit::HELP)]
    View(ViewArguments),
    /// Collide two bodies: restitution, contact time, outcome, energies
    #[command(after_help = exit::HELP)]
    Collide(CollideArguments),
    /// Trace the quasi-static curve of a law: load, unload, reload, pull-off
    #[command(after_help = exit::HELP)]
    ContactCurve(CurveArguments),
    /// Find the speed below which two bodies stick, against their size
    #[command(after_help = exit::HELP)]
    Sticking(StickingArguments),
    /// Draw the figures of the papers on damped springs and adhesive grains, and tell how exact they are
    #[command(after_help = exit::HELP)]
    Figure(FigureArguments),
    /// Find the parameters of a law from observed collisions, or a number of a scenario from a measured force curve
    #[command(after_help = exit::HELP)]
    Fit(FitArguments),
    /// Average the cycles of runs and compare them with a run or an experiment: forces, contacts, force distributions
    #[command(after_help = exit::HELP)]
    Compare(CompareArguments),
    /// Draw columns of what runs left, as SVG or PNG, or list them
    #[command(after_help = exit::HELP)]
    Plot(PlotArguments),
    /// Draw pictures of the packing, without a browser or a graphics card
    #[command(after_help = exit::HELP)]
    Render(RenderArguments),
    /// Convert packings from and to LAMMPS, LIGGGHTS, OVITO (extended XYZ), YADE, CSV, ParaView
    ///
    /// Formats: csv (named columns with units), lammps-data, liggghts-data, lammps-dump, liggghts-dump (text, several moments),
    /// xyz (extended XYZ for OVITO and ASE, several moments), yade (text packing), vtp (ParaView; output only). A run of Demeter is
    /// told by its folder, or by one .vtp file of its frames. What cannot be carried over is said.
    #[command(after_help = exit::HELP)]
    Convert(ConvertArguments),
    /// List the contact laws, or explain one
    Laws(LawsArguments),
    /// Tell the JSON schema by which editors complete and check files
    Schema(SchemaArguments),
    /// Write a scenario to start from, or list those there are
    New(NewArguments),
    /// Tell what is in a file or in the folder of a run
    Info(InfoArguments),
    /// Write the completions of a shell to standard output
    Completions(CompletionsArguments),
    /// Write the pages of the manual into a folder
    Man(ManArguments),
}

impl Command {
    /// Whether the answer is asked for as JSON.
    pub fn wants_json(&self) -> bool {
        match self {
            Self::Run(a) => a.output.json,
            Self::Check(a) => a.json,
            Self::Resume(a) => a.output.json,
            Self::Sweep(a) => a.json,
            Self::Report(a) => a.json,
            Self::View(_) => false,
            Self::Collide(a) => a.json,
            Self::ContactCurve(a) => a.json,
            Self::Sticking(a) => a.json,
            Self::Figure(a) => a.json,
            Self::Fit(a) => a.output.json,
            Self::Compare(a) => a.json,
            Self::Laws(a) => a.json,
            Self::Plot(a) => a.json,
            Self::Render(a) => a.json,
            Self::Convert(a) => a.json,
            Self::Schema(_) | Self::New(_) | Self::Completions(_) | Self::Man(_) => false,
            Self::Info(a) => a.json,
        }
    }
}

/// Of `demeter run`.
#[derive(Debug, Args)]
pub struct RunArguments {
    /// The scenario
    pub file: PathBuf,
    /// Folder for the results
    ///
    /// Without it they go to `runs/NAME` in the present folder, where NAME is the name of the scenario file, or that of
    /// its folder when the file is called `scenario.toml`. When `runs/NAME` is taken, the next free one of `runs/NAME-2`,
    /// `runs/NAME-3`, ... is used, so that nothing is ever lost. A folder named here must be new or empty.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Replace an earlier run in the folder; other files in it are kept
    #[arg(long)]
    pub overwrite: bool,
    /// Change a value of the scenario, as `grains[0].count=200`; may be given many times
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// How to run it.
    #[command(flatten)]
    pub output: HowToRun,
    /// What of the engine to choose and to tell.
    #[command(flatten)]
    pub engine: Engine,
}

/// Of `run` and `resume`: nothing of it changes the results.
#[derive(Debug, Args)]
pub struct Engine {
    /// Tell at the end where the time went, and how far that is from what the machine can do
    ///
    /// Seconds, shares and nanoseconds per particle-step of the search, the narrow phase, the laws, sums with kick and
    /// drift, walls, books and output; bytes and operations that each particle-step needs at least, and how many times the
    /// time that memory alone would need the steps took; and what the tables hold in memory. Also in `summary.json`, as `profile`.
    #[arg(long)]
    pub profile: bool,
    /// Instructions of the processor to compute with: `portable`, `avx2`, `avx512` or `neon`; the widest when absent
    ///
    /// The results are the same with all.
    #[arg(long, value_name = "NAME", value_parser = Instructions::named)]
    pub instructions: Option<Instructions>,
}

/// Of `run` and `resume`.
#[derive(Debug, Args)]
pub struct HowToRun {
    /// Number of threads; when absent all cores, or one for each process under `mpirun`. The results are the same for any number
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=i64::from(MOST_THREADS)))]
    pub threads: Option<u16>,
    /// Write one JSON object to standard output at the end; everything else goes to standard error
    #[arg(long)]
    pub json: bool,
}

/// Of `demeter report`.
#[derive(Debug, Args)]
pub struct ReportArguments {
    /// The folder of the run
    ///
    /// `report.html` in it is replaced: one page for browsers that needs no network. What is missing or damaged in the
    /// folder is left out of the page and told.
    pub folder: PathBuf,
    /// Write one JSON object to standard output
    #[arg(long)]
    pub json: bool,
}

/// Of `demeter view`.
#[derive(Debug, Args)]
pub struct ViewArguments {
    /// The folder of the run
    ///
    /// It is served at 127.0.0.1 until Ctrl-C, to programs of this machine only, and only to those that know the key in the
    /// address that is told; nothing outside the folder is read, and nothing is written.
    pub folder: PathBuf,
    /// The port; a free one when left out
    #[arg(long, default_value_t = 0, hide_default_value = true)]
    pub port: u16,
    /// Only print the address
    #[arg(long)]
    pub no_browser: bool,
    /// Compress what is sent: for slow connections, such as a tunnel to a cluster
    #[arg(long)]
    pub compress: bool,
}

/// Of `demeter check`.
#[derive(Debug, Args)]
pub struct CheckArguments {
    /// The scenario
    pub file: PathBuf,
    /// Change a value of the scenario, as `grains[0].count=200`; may be given many times
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Write one JSON object to standard output
    #[arg(long)]
    pub json: bool,
}

/// Of `demeter resume`.
#[derive(Debug, Args)]
pub struct ResumeArguments {
    /// The folder of the run
    pub folder: PathBuf,
    /// Go on although `scenario.toml` in the folder was changed, with what it tells now
    #[arg(long)]
    pub changed: bool,
    /// How to run it.
    #[command(flatten)]
    pub output: HowToRun,
    /// What of the engine to choose and to tell.
    #[command(flatten)]
    pub engine: Engine,
}

/// Of `demeter collide`.
#[derive(Debug, Args)]
pub struct CollideArguments {
    /// The file of two bodies
    pub file: PathBuf,
    /// Change a value of the file, as `impact.velocity="2 m/s"`; may be given many times
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Compute it as a run would, with the engine's own steps
    #[arg(long)]
    pub engine: bool,
    /// Write one JSON object to standard output
    #[arg(long)]
    pub json: bool,
    /// Write the course of the collision as CSV
    ///
    /// A file that is there is only replaced with `--overwrite`.
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,
    /// Draw force against overlap
    ///
    /// SVG, or pixels with a name that ends with .png.
    #[arg(long, value_name = "FILE.svg")]
    pub plot: Option<PathBuf>,
    /// Replace files of `--csv` and `--plot` that are there
    #[arg(long)]
    pub overwrite: bool,
}

/// Of `demeter contact-curve`.
#[derive(Debug, Args)]
pub struct CurveArguments {
    /// The file of two bodies
    pub file: PathBuf,
    /// Change a value of the file, as `curve.max_overlap="1 um"`; may be given many times
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Write one JSON object to standard output
    #[arg(long)]
    pub json: bool,
    /// Write the curve as CSV, with the name of the branch in every row
    ///
    /// A file that is there is only replaced with `--overwrite`.
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,
    /// Draw force against overlap
    ///
    /// SVG, or pixels with a name that ends with .png.
    #[arg(long, value_name = "FILE.svg")]
    pub plot: Option<PathBuf>,
    /// Replace files of `--csv` and `--plot` that are there
    #[arg(long)]
    pub overwrite: bool,
}

/// Of `demeter sticking`.
#[derive(Debug, Args)]
pub struct StickingArguments {
    /// The file of two bodies; both are scaled to every effective radius
    pub file: PathBuf,
    /// Effective radii, first and last, as `0.1um..1um`; or one
    #[arg(long, value_name = "FIRST..LAST", allow_hyphen_values = true)]
    pub radius: String,
    /// Number of radii, at equal ratios; 20 when absent
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(2..=10_000))]
    pub points: Option<u16>,
    /// Change a value of the file, as `contact.normal.restitution=0.5`; may be given many times
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Write a JSON list of `{effective_radius, velocity}` to standard output
    #[arg(long)]
    pub json: bool,
    /// Write the speeds as CSV
    ///
    /// A file that is there is only replaced with `--overwrite`.
    #[arg(long, value_name = "FILE")]
    pub csv: Option<PathBuf>,
    /// Draw the speeds
    ///
    /// SVG, or pixels with a name that ends with .png.
    #[arg(long, value_name = "FILE.svg")]
    pub plot: Option<PathBuf>,
    /// Replace files of `--csv` and `--plot` that are there
    #[arg(long)]
    pub overwrite: bool,
}

/// Of `demeter figure`.
#[derive(Debug, Args)]
pub struct FigureArguments {
    /// The figures, or `all`; all are listed when absent
    pub names: Vec<String>,
    /// Folder for NAME.svg and NAME.csv; made when it is not there. Files of these names are replaced
    #[arg(long, value_name = "DIR", default_value = ".")]
    pub output: PathBuf,
    /// List the figures
    #[arg(long, conflicts_with = "names")]
    pub list: bool,
    /// Write one JSON object to standard output
    #[arg(long)]
    pub json: bool,
}

/// Of `demeter fit`.
#[derive(Debug, Args)]
pub struct FitArguments {
    /// The file: observed collisions, or a measured force curve of a packing (a table `[packing]`)
    pub file: PathBuf,
    /// Change a value of the file, as `fit.law="linear"`; may be given many times
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Folder for the runs of a packing, one per trial value; finished ones in it are used again
    ///
    /// Without it they go to `runs/fit-NAME`, where NAME is the name of the file.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// How to run it.
    #[command(flatten)]
    pub output: HowToRun,
}

/// Of `demeter compare`.
///
/// The metrics are those of Brodu, Dijksman and Behringer (2015): Rtop, the ratio of the forces at the largest compression;
/// errf, the root mean square of the difference of the forces over all levels; errZ, that of the contacts per grain, when
/// contacts of the run weaker than tau are left out; bhat, -log of the overlap of the distributions of contact forces.
#[derive(Debug, Args)]
pub struct CompareArguments {
    /// Folders of runs
    #[arg(required = true, value_name = "RUN")]
    pub runs: Vec<PathBuf>,
    /// Folder of a run, or a CSV file that was measured
    ///
    /// A measured file has the columns `strain` or `compression [m]`; `loading force [N]`, `unloading force [N]` or both;
    /// and, if they are known, `loading coordination` and `unloading coordination`. Cells may be empty. Metrics that
    /// the reference cannot give are left out.
    #[arg(long, value_name = "RUN or FILE.csv")]
    pub reference: PathBuf,
    /// Stage that loads; its repeats `squeeze 1`, `squeeze 2`, ... begin one cycle each
    #[arg(long, value_name = "STAGE", default_value = "squeeze")]
    pub load: String,
    /// Stage that unloads
    #[arg(long, value_name = "STAGE", default_value = "release")]
    pub unload: String,
    /// Look at loading alone
    #[arg(long, conflicts_with = "unload")]
    pub loading_only: bool,
    /// Number of cycles to leave out at the beginning
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub discard: usize,
    /// Column of the series that is compared; a `-` before it turns its sign round
    #[arg(
        long,
        value_name = "COLUMN",
        default_value = "wall top force z",
        allow_hyphen_values = true
    )]
    pub force: String,
    /// Tell errZ also with this threshold, as "4 mN"
    #[arg(long, value_name = "FORCE")]
    pub threshold: Option<String>,
    /// Leave contacts of the reference out that are weaker, when it is a run
    #[arg(long, value_name = "FORCE")]
    pub reference_threshold: Option<String>,
    /// Name of the [[measure]] that wrote the force distributions; the only one when absent
    #[arg(long, value_name = "NAME")]
    pub distribution: Option<String>,
    /// Average this column of the series as well; may be given many times
    #[arg(long, value_name = "COLUMN")]
    pub also: Vec<String>,
    /// Folder for `metrics.csv`, and for `RUN/cycles.csv` of every run; made when it is not there
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Write one JSON object to standard output
    #[arg(long)]
    pub json: bool,
}

/// Of `demeter laws`.
#[derive(Debug, Args)]
pub struct LawsArguments {
    /// The law to explain
    pub name: Option<String>,
    /// Write one JSON object to standard output
    #[arg(long)]
    pub json: bool,
}

/// Of `demeter schema`.
#[derive(Debug, Args)]
pub struct SchemaArguments {
    /// Kind of file
    #[arg(default_value = "scenario", value_parser = FileKind::ALL.map(FileKind::name))]
    pub kind: String,
    /// File to write it to, in place of an earlier schema; standard output when absent
    ///
    /// A file whose first line is `#:schema` with the way to this file is completed and checked by editors that know
    /// TOML (Even Better TOML for VS Code, taplo) while it is written. `demeter new` does both.
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

/// Of `demeter new`.
#[derive(Debug, Args)]
pub struct NewArguments {
    /// The template; all are listed when absent
    pub template: Option<String>,
    /// File to write; `TEMPLATE.toml` when absent. A file that exists is never replaced
    #[arg(long, value_name = "FILE", requires = "template")]
    pub out: Option<PathBuf>,
}

/// Of `demeter info`.
#[derive(Debug, Args)]
pub struct InfoArguments {
    /// A scenario, the folder of a run or a sweep, a checkpoint, a file of grains, a surface (STL, OBJ, PLY), or a series of a run
    pub file: PathBuf,
    /// Write one JSON object to standard output
    #[arg(long)]
    pub json: bool,
}
