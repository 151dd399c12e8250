#![doc = include_str!("reference.md")]

mod bodies;
mod box_of_file;
mod checks;
mod collisions;
mod column_stops;
mod deformation;
mod diagnostics;
mod differences;
mod document;
mod doubtful_units;
mod estimates;
mod feeding;
mod feeds;
mod field_files;
mod field_measures;
mod fit_file;
mod followed;
mod grains;
mod impact;
mod impact_speeds;
mod in_vain;
mod input_files;
mod interiors;
mod laws_of_stages;
mod live;
mod materials;
mod measures;
mod meshes;
mod motions;
mod named_files;
mod observed;
mod other_code;
mod other_kind;
mod overrides;
mod packing_file;
mod periodic_walls;
mod plain;
mod plots;
mod prepare;
mod quantity;
mod reader;
mod reference;
mod region_measures;
mod report;
mod resolved;
mod rows;
mod run;
mod run_error;
mod run_options;
pub mod schema;
mod selections;
mod settings;
mod sizes;
mod solids;
mod stages;
mod stop_checks;
mod stray_places;
mod stray_walls;
mod tags;
mod templates;
mod traffic;
pub mod units;
mod wall_report;
mod walls;
mod walls_in_one_place;
mod words;
mod zones;

#[cfg(test)]
mod tests;

pub use checks::available_memory;
pub use diagnostics::{Diagnostic, Diagnostics};
pub(crate) use differences::{line_differences, shortened};
pub use document::{Document, SourceText, Span};
pub use estimates::Fed;
pub use feeds::{EXCHANGE_EVERY, FeedEnd, FeedRate, FeedSpec, MAX_FEEDS, RemovalSpec};
pub use fit_file::{DEFAULT_ERROR, FIT_REFERENCE, FitFile, MAX_OBSERVATIONS, MAX_UNKNOWNS};
pub use grains::{MAX_BATCHES, MAX_GRAINS};
pub use impact::{
    Body, CurveDepth, CurveSpec, IMPACT_REFERENCE, ImpactFile, ImpactSpec, MAX_CURVE_POINTS, Partner, pair_size,
};
pub use input_files::InputFile;
pub(crate) use input_files::content;
pub use live::{LiveRun, Pause, Until};
pub use materials::{ContactSpec, MAX_MATERIALS};
pub use measures::{MAX_MEASURES, MeasureKind, MeasureSpec};
pub use meshes::{MeshOrigin, MeshSource};
pub use observed::{Measured, Observable, Observation, StandardError, Target, Unknown};
pub use overrides::{Override, key_of, key_places, key_steps};
pub use packing_file::{FitTask, Match, PACKING_FIT_REFERENCE, PackingFile, UnknownNumber};
pub use plain::{Foreign, Plain, faults_with_foreign};
pub use prepare::{Prepared, prepare};
pub use reader::suggest_or_list;
pub use report::{Report, RunEnd};
pub(crate) use run::thread_pool;
pub use run::{Observer, Progress, RunState, all_or_none, resume, resume_shared, run, run_shared};
pub use run_error::RunError;
pub use run_options::{MOST_THREADS, RunOptions};
pub use settings::{
    AUTOMATIC_CHECKPOINTS, AUTOMATIC_FRAMES, AUTOMATIC_ROWS, DEFAULT_MAX_OVERLAP, DomainSpec, OutputSpec, PlotSpec,
    SimulationSpec, TimeStep,
};
pub use stages::{MAX_REPEAT, MAX_STAGES};
pub use tags::{MAX_TAGS, TagSpec};
pub use templates::{TEMPLATES, template};
pub use wall_report::{WallReport, inspect_walls};
pub use walls::{MAX_WALLS, MeshFile, WallShape, WallSpec};

use crate::insertion::Insertion;
use crate::materials::Material;
use crate::simulation::Stage;
use document::read_toml;
use glam::DVec3;
use interiors::MeshWithoutUnit;
use other_kind::refuse_other_kind;
use reader::{Context, TableReader};
use std::cell::{Cell, RefCell};
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Names of the coordinate axes.
const AXES: [&str; 3] = ["x", "y", "z"];

/// All keys of a scenario, with their meaning.
pub const REFERENCE: &str = include_str!("reference.md");

/// Largest scenario file [bytes].
pub const MAX_FILE_SIZE: u64 = 16 << 20;

/// A scenario, read and checked; all values in SI.
#[derive(Clone, Debug)]
pub struct Scenario {
    /// Title; the name of the file when it tells none.
    pub title: String,
    /// Seed of all random choices.
    pub seed: u64,
    /// Time step, gravity and watch.
    pub simulation: SimulationSpec,
    /// Where grains may be.
    pub domain: DomainSpec,
    /// Materials; elsewhere they are told by their index.
    pub materials: Vec<Material>,
    /// Contact laws of every pair of materials.
    pub contact: ContactSpec,
    /// Batches of grains; the path of the first is `grains[0]`.
    pub grains: Vec<Insertion>,
    /// Grains that come while the run goes on; the path of the first is `feed[0]`.
    pub feeds: Vec<FeedSpec>,
    /// Where grains go while the run goes on; the path of the first is `removal[0]`.
    pub removals: Vec<RemovalSpec>,
    /// Tags that grains are given while the run goes on; the path of the first is `tag[0]`.
    pub tags: Vec<TagSpec>,
    /// Walls; the path of the first is `wall[0]`.
    pub walls: Vec<WallSpec>,
    /// Stages with repeats unrolled.
    pub stages: Vec<Stage>,
    /// Path of the table that told each stage, as `stage[1].stage[0]`.
    pub stage_paths: Vec<String>,
    /// Contact laws that stages tell, by the number that these have for them.
    pub stage_contacts: Vec<ContactSpec>,
    /// What is measured beside what every run measures.
    pub measures: Vec<MeasureSpec>,
    /// Output of the run.
    pub output: OutputSpec,
    /// The text as read, without overrides.
    pub text: String,
    /// Name of the scenario for messages: its path as given.
    pub name: String,
    /// Folder that relative paths start from.
    pub base: PathBuf,
    document: Arc<Document>,
    /// Meshes of regions and inlets whose unit nobody tells.
    without_unit: Vec<MeshWithoutUnit>,
}

impl Scenario {
    /// Reads a scenario from a file. Overrides are texts `key=value`, as `grains[0].count=200`.
    pub fn read(path: &Path, overrides: &[String]) -> Result<Self, Diagnostics> {
        let base = path.parent().unwrap_or(Path::new(""));
        Self::parse(&Self::text_of(path)?, &path.display().to_string(), base, overrides)
    }

    /// The text of the file of a scenario, for [`Self::parse`].
    pub fn text_of(path: &Path) -> Result<String, Diagnostics> {
        read_text(path).map_err(|fault| lone_fault(&path.display().to_string(), fault))
    }

    /// Reads the scenario of a run that has started: files of grains at the start may be gone.
    pub fn read_to_go_on(path: &Path) -> Result<Self, Diagnostics> {
        let base = path.parent().unwrap_or(Path::new(""));
        Self::parse_for(&Self::text_of(path)?, &path.display().to_string(), base, &[], true)
    }

    /// Reads a scenario from a text. Relative paths in it start from `base`.
    pub fn parse(text: &str, name: &str, base: &Path, overrides: &[String]) -> Result<Self, Diagnostics> {
        Self::parse_with(text, name, base, &set(overrides))
    }

    /// As [`Self::parse`], with overrides that say where they were told.
    pub fn parse_with(text: &str, name: &str, base: &Path, overrides: &[Override]) -> Result<Self, Diagnostics> {
        Self::parse_for(text, name, base, overrides, false)
    }

    fn parse_for(
        text: &str,
        name: &str,
        base: &Path,
        overrides: &[Override],
        has_started: bool,
    ) -> Result<Self, Diagnostics> {
        let document = tree_with(text, name, overrides)?;
        refuse_other_kind(name, &document, schema::FileKind::Scenario)?;
        let context = Context {
            has_started,
            ..Context::new(Diagnostics::new(name, Arc::clone(&document)))
        };
        let read = Self::walk(&context, text, name, base, document);
        let mut faults = context.faults.into_inner();
        if faults.is_empty() {
            materials::check_laws(&read, &mut faults);
            laws_of_stages::check(&read, &mut faults);
        }
        if faults.is_empty() { Ok(read) } else { Err(faults) }
    }

    fn walk(context: &Context, text: &str, name: &str, base: &Path, document: Arc<Document>) -> Self {
        let table = TableReader::root(context, &document.root);
        let stem = || {
            Path::new(name)
                .file_stem()
                .map_or_else(|| name.into(), |s| s.to_string_lossy())
        };
        let title = table
            .optional("title")
            .map_or_else(|| stem().to_string(), |i| i.label());
        let seed = table.optional("seed").map_or(1, |i| i.integer(0, i64::MAX)) as u64;
        let simulation = settings::simulation(&table);
        let domain = settings::domain(&table);
        let materials = materials::materials(&table);
        let contact = materials::contact(&table, &materials);
        let around = grains::Surroundings {
            materials: &materials,
            base,
            seed,
            without_unit: RefCell::default(),
        };
        let walls = walls::walls(&table, &around, simulation.gravity);
        let grains = grains::grains(&table, &around);
        let told = settings::output(&table, &walls);
        let feeds = feeds::feeds(&table, &around, &grains);
        let batches = grains.iter().map(|b| b.name.as_str());
        let named = zones::Named {
            around: &around,
            walls: &walls,
            has_domain: domain.bounds.is_some(),
            gravity: simulation.gravity,
            sources: batches.chain(feeds.iter().map(|f| f.name.as_str())).collect(),
        };
        let removals = feeds::removals(&table, &named);
        let tags = tags::tags(&table, &named);
        let measures = measures::measures(&table, &named);
        let cast = stages::Cast {
            walls: &walls,
            feeds: &feeds,
            removals: &removals,
            base,
            gravity: simulation.gravity,
            materials: &materials,
            contact: &contact,
            laws_told: &Cell::default(),
        };
        let protocol = stages::protocol(&table, cast, told.intervals);
        table.finish("the scenario");
        let without_unit = around.without_unit.take();
        let mut scenario = Self {
            title,
            seed,
            simulation,
            domain,
            materials,
            contact,
            grains,
            feeds,
            removals,
            tags,
            walls,
            stages: protocol.stages,
            stage_paths: protocol.paths,
            stage_contacts: protocol.contacts,
            measures,
            output: OutputSpec {
                cadence: protocol.cadence,
                picture: !told.no_picture,
                report: !told.no_report,
                plots: told.plots,
                strain: told.strain,
            },
            text: text.to_string(),
            name: name.to_string(),
            base: base.to_path_buf(),
            document: Arc::clone(&document),
            without_unit,
        };
        // a fault may be why a column is not there
        if context.faults.borrow().is_empty() {
            column_stops::resolve(context, &mut scenario, &protocol.columns);
        }
        scenario
    }

    /// Acceleration of gravity in a stage, or behind the last [m/s^2].
    pub(crate) fn gravity_in(&self, stage: usize) -> DVec3 {
        let told = self.stages.iter().take(stage.saturating_add(1)).rev();
        told.filter_map(|stage| stage.gravity)
            .next()
            .unwrap_or(self.simulation.gravity)
    }

    /// Contact laws in a stage, or behind the last.
    pub(crate) fn contact_in(&self, stage: usize) -> &ContactSpec {
        let mut told = self.stages.iter().take(stage.saturating_add(1)).rev();
        let latest = told.find_map(|stage| stage.contact);
        latest
            .and_then(|index| self.stage_contacts.get(index))
            .unwrap_or(&self.contact)
    }

    /// All contact laws that act in some stage, each once, in the order in which they first do.
    pub(crate) fn contacts(&self) -> Vec<&ContactSpec> {
        let first = self.contact_in(0);
        let later = self.stage_contacts.iter().filter(|later| !std::ptr::eq(*later, first));
        std::iter::once(first).chain(later).collect()
    }

    /// An empty list of faults, to which later checks add theirs by the path of the key at fault.
    pub fn diagnostics(&self) -> Diagnostics {
        Diagnostics::new(&self.name, Arc::clone(&self.document))
    }

    /// Where the value of a key was written; see [`Document::origin`].
    pub fn origin(&self, path: &str) -> Option<Span> {
        self.document.origin(path)
    }

    /// Titles of the columns of the series that a run of it writes.
    pub fn series_titles(&self) -> Vec<String> {
        run::labels(self).header()
    }

    /// The scenario as TOML with all overrides put in, values as they were written. Paths of files are absolute, so
    /// that the text means the same from any folder.
    pub fn to_resolved_toml(&self) -> String {
        resolved::write(&self.document.root, &self.base)
    }
}

/// The text of a scenario file as [`Scenario::to_resolved_toml`] writes it, with paths of files from `base`, before anything but
/// the TOML is checked: keys may still be missing.
pub fn resolve(path: &Path, base: &Path, overrides: &[String]) -> Result<String, Diagnostics> {
    let name = path.display().to_string();
    let text = read_text(path).map_err(|fault| lone_fault(&name, fault))?;
    let document = tree(&text, &name, overrides)?;
    Ok(resolved::write(&document.root, base))
}

/// What `--set` told.
fn set(overrides: &[String]) -> Vec<Override> {
    overrides.iter().map(|text| Override::set(text)).collect()
}

/// The tree of a text with what `--set` tells.
fn tree(text: &str, name: &str, overrides: &[String]) -> Result<Arc<Document>, Diagnostics> {
    tree_with(text, name, &set(overrides))
}

/// The tree of a text with its overrides.
fn tree_with(text: &str, name: &str, overrides: &[Override]) -> Result<Arc<Document>, Diagnostics> {
    let file = SourceText {
        name: name.to_string(),
        text: text.to_string(),
        is_override: false,
    };
    let mut sources = vec![file];
    sources.extend(overrides.iter().map(overrides::source_text));
    let refuse = |faults: Vec<overrides::OverrideFault>, sources: Vec<SourceText>| {
        let document = Document::without_keys(sources);
        let mut diagnostics = Diagnostics::new(name, Arc::new(document));
        for (fault, help) in faults {
            diagnostics.push_at(Some(fault.span), "", fault.message, help);
        }
        diagnostics
    };
    let mut root = match read_toml(text, 0) {
        Ok(root) => root,
        Err(faults) => {
            if let Some((message, help)) = other_code::recognise(text) {
                let mut diagnostics = Diagnostics::new(name, Arc::new(Document::without_keys(sources)));
                diagnostics.push_at(None, "", message, Some(help));
                return Err(diagnostics);
            }
            let message = |mut fault: document::SyntaxFault| {
                let at = fault.span.bytes.clone();
                let is_list = text.get(..at.start).is_some_and(|before| before.ends_with("[["));
                let again = (fault.message == "duplicate key" && is_list)
                    .then(|| text.get(at.clone()))
                    .flatten();
                let help = again
                    .map(|key| format!("`{key}` was one table before: write `[[{key}]]` there, too"))
                    .or_else(|| document::number_in_full(text, at.start));
                fault.message = format!("not valid TOML: {}", fault.message);
                (fault, help)
            };
            return Err(refuse(faults.into_iter().map(message).collect(), sources));
        }
    };
    if root.is_empty_table() && overrides.is_empty() {
        return Err(lone_fault(
            name,
            "the scenario is empty; `demeter new` writes one to start from".to_string(),
        ));
    }
    let mut faults = Vec::new();
    for (index, told) in overrides.iter().enumerate() {
        if let Err(found) = overrides::apply(&mut root, &told.text, index + 1) {
            faults.extend(found);
        }
    }
    if !faults.is_empty() {
        return Err(refuse(faults, sources));
    }
    Ok(Arc::new(Document { sources, root }))
}

/// One fault without a place.
fn lone_fault(name: &str, message: String) -> Diagnostics {
    let mut diagnostics = Diagnostics::new(name, Arc::new(Document::without_keys(Vec::new())));
    diagnostics.push_at(None, "", message, None);
    diagnostics
}

/// The text of a file, or why it cannot be had.
fn read_text(path: &Path) -> Result<String, String> {
    let explain = |error: std::io::Error| match error.kind() {
        std::io::ErrorKind::NotFound => "there is no such file".to_string(),
        kind => format!("the file cannot be read: {kind}"),
    };
    let file = std::fs::File::open(path).map_err(explain)?;
    if file.metadata().map_err(explain)?.is_dir() {
        return Err("this is a folder; name the scenario file in it".to_string());
    }
    let mut bytes = Vec::new();
    file.take(MAX_FILE_SIZE + 1).read_to_end(&mut bytes).map_err(explain)?;
    if bytes.len() as u64 > MAX_FILE_SIZE {
        return Err(format!("the file is larger than {} MiB", MAX_FILE_SIZE >> 20));
    }
    String::from_utf8(bytes).map_err(|error| {
        if let Some(what) = other_code::recognise_bytes(error.as_bytes()) {
            return what;
        }
        let at = error.utf8_error().valid_up_to();
        let line = error.as_bytes()[..at].iter().filter(|b| **b == b'\n').count() + 1;
        format!("line {line} is not UTF-8 text; save the file as UTF-8")
    })
}
