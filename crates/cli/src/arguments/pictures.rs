//! Arguments of the commands that draw what runs left.

use clap::Args;
use std::path::PathBuf;

/// Of `demeter plot`.
#[derive(Debug, Args)]
pub struct PlotArguments {
    /// The folder of a run, or a CSV file that a run wrote (its series, a distribution, a profile)
    pub run: PathBuf,
    /// Column of the horizontal axis, with or without its unit; all columns are listed when absent. Bins of a distribution are two
    /// columns: `bin`, their lower edges, and `in bin`
    #[arg(requires = "y")]
    pub x: Option<String>,
    /// Columns of the vertical axis; behind `--`, a `-` before one turns its sign round: `-- "-wall top force z"`
    pub y: Vec<String>,
    /// Another run or file, drawn into the same plot; may be given many times
    #[arg(long, value_name = "RUN")]
    pub with: Vec<PathBuf>,
    /// Which axes are logarithmic: `x`, `y` or `xy`
    #[arg(long, value_name = "AXES", value_parser = ["x", "y", "xy"])]
    pub log: Option<String>,
    /// First and last value of the horizontal axis, as `0..2.5`
    #[arg(long, value_name = "A..B", allow_hyphen_values = true)]
    pub x_range: Option<String>,
    /// First and last value of the vertical axis
    #[arg(long, value_name = "A..B", allow_hyphen_values = true)]
    pub y_range: Option<String>,
    /// Which moment of the bins of a distribution, or of a profile: `last`, `all`, or a step
    #[arg(long, value_name = "STEP|all|last", default_value = "last")]
    pub at: String,
    /// Draw a circle at each row in place of a line
    #[arg(long)]
    pub points: bool,
    /// Text over the plot
    #[arg(long, value_name = "TEXT")]
    pub title: Option<String>,
    /// File to write, `.svg` or `.png`; replaced when it is there
    ///
    /// Without it the file is named by the columns, in the present folder.
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Write one JSON object to standard output
    #[arg(long)]
    pub json: bool,
}

/// Of `demeter render`.
#[derive(Debug, Args)]
pub struct RenderArguments {
    /// The folder of the run
    pub run: PathBuf,
    /// Which frame: `last`, a number from 0, the one nearest to a time, as "0.5 s", or `all`
    ///
    /// With `all` numbered pictures go into a folder, all seen from one place and with one colour bar, and the line that makes
    /// a film of them with ffmpeg is told.
    #[arg(long, value_name = "N|TIME|all|last", default_value = "last")]
    pub frame: String,
    /// Width and height [pixels]
    #[arg(long, value_name = "WxH", default_value = "1200x900")]
    pub size: String,
    /// From where: `corner`, `front`, `back`, `left`, `right`, `top`, `bottom`, or degrees about z and above the horizon
    #[arg(long, value_name = "NAME|A,E", default_value = "corner", allow_hyphen_values = true)]
    pub view: String,
    /// What the colours tell: `automatic`, `force`, `speed`, `diameter` (or `radius`), `coordination`, `material`, `tag`, `spin`, `pressure`
    #[arg(long, visible_alias = "color", value_name = "QUANTITY", default_value = "automatic")]
    pub colour: String,
    /// Value at the start of the colour bar, as "2 mm"; when absent 0, or of diameters about the least
    #[arg(
        long,
        visible_alias = "color-start",
        value_name = "VALUE",
        allow_hyphen_values = true,
        conflicts_with = "chains"
    )]
    pub colour_start: Option<String>,
    /// Value at the end of the colour bar, as "2 m/s"; where most values end when absent
    #[arg(long, visible_alias = "color-end", value_name = "VALUE", allow_hyphen_values = true)]
    pub colour_end: Option<String>,
    /// Cut away what is on one side of a plane, as "y > 10 mm"; grains show their sections; may be given many times
    #[arg(long, value_name = "CUT")]
    pub clip: Vec<String>,
    /// Draw force chains: a cylinder for every contact, thick and bright where the force is large
    #[arg(long)]
    pub chains: bool,
    /// How walls are drawn
    #[arg(long, value_name = "HOW", default_value = "lines", value_parser = ["lines", "faces", "none"])]
    pub walls: String,
    /// Text over the picture; the title of the run when absent
    #[arg(long, value_name = "TEXT")]
    pub title: Option<String>,
    /// File to write (.png), or with `--frame all` the folder; replaced when it is there
    ///
    /// Without it `RUN-STEP.png` or the folder `RUN-frames`, in the present folder.
    #[arg(long, value_name = "FILE|DIR")]
    pub out: Option<PathBuf>,
    /// Write one JSON object to standard output
    #[arg(long)]
    pub json: bool,
}
