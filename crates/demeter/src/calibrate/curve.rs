//! The quasi-static curve of a normal law: force against overlap while two bodies are pressed together, unloaded,
//! pressed again and pulled apart.

use super::error::CalibrateError;
use super::pull::{Pull, largest_pull, press};
use crate::scenario::{CurveDepth, ImpactFile};
use demeter_physics::collision::ode::locate;
use demeter_physics::collision::{HeadOn, Tolerance};
use demeter_physics::contact::PairSize;
use demeter_physics::contact::normal::{Normal, NormalVisitor};

/// What is done to the bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branch {
    /// They come near, not yet touching.
    Approach,
    /// They are pressed together for the first time.
    Load,
    /// They are let go.
    Unload,
    /// They are pressed together again.
    Reload,
    /// They are pulled apart.
    PullOff,
}

impl Branch {
    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Approach => "approach",
            Self::Load => "load",
            Self::Unload => "unload",
            Self::Reload => "reload",
            Self::PullOff => "pull-off",
        }
    }
}

/// A row of the curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvePoint {
    /// What is done.
    pub branch: Branch,
    /// Overlap [m]; negative across a gap.
    pub overlap: f64,
    /// Force [N]; repulsion is positive.
    pub force: f64,
    /// Energy that the contact would give back [J].
    pub stored: f64,
}

/// What stands out on the way, whatever rows were drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes {
    /// Deepest overlap [m].
    pub max_overlap: f64,
    /// Largest force [N].
    pub max_force: f64,
    /// Force of the largest pull, negative [N], and its overlap [m]; absent where the bodies never pull.
    pub largest_pull: Option<(f64, f64)>,
    /// Overlap at which contact ends on the way out [m]; negative across a gap.
    pub end_of_contact: f64,
}

/// A curve.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactCurve {
    /// Its rows. They may end before the contact does: a long attraction is not drawn to its end.
    pub points: Vec<CurvePoint>,
    /// What stands out.
    pub extremes: Extremes,
}

impl ContactCurve {
    /// The overlap at which the rows end, where contact goes on [m].
    pub fn cut_at(&self) -> Option<f64> {
        let last = self.points.last()?.overlap;
        (last > self.extremes.end_of_contact).then_some(last)
    }
}

/// Depth of a curve when the file tells neither a depth nor a velocity, as share of the effective radius.
const DEFAULT_DEPTH: f64 = 0.01;

/// Deepest overlap that is looked at for a force, as share of the effective radius.
const DEEPEST: f64 = 1.0;

/// The curve of the law between the bodies of a file.
pub fn contact_curve(file: &ImpactFile) -> Result<ContactCurve, CalibrateError> {
    let law = file.law()?;
    let size = file.size();
    let depth = match (file.curve.depth, file.impact.velocity) {
        (CurveDepth::Overlap(overlap), _) => overlap,
        (CurveDepth::Force(force), _) => law.normal.visit(DepthAtForce(size, force))?,
        (CurveDepth::Automatic, None) => DEFAULT_DEPTH * size.radius,
        (CurveDepth::Automatic, Some(speed)) => {
            let impact = HeadOn {
                law: &law.normal,
                size,
                speed: speed * libm::cos(file.impact.angle),
                start: file.impact.start,
            };
            impact.run(&Tolerance::default())?.max_overlap
        }
    };
    if depth > DEEPEST * size.radius {
        return Err(CalibrateError::Curve(format!(
            "the curve goes to an overlap of {depth} m; at most the effective radius, {} m, makes sense",
            DEEPEST * size.radius
        )));
    }
    if let Some(to) = file.curve.unload_to.filter(|to| *to >= depth) {
        return Err(CalibrateError::Curve(format!(
            "`unload_to` is {to} m, and the curve unloads from {depth} m: tell a smaller overlap"
        )));
    }
    Ok(law.normal.visit(Trace { size, depth, file }))
}

/// Overlap at which the first loading reaches a force [N].
struct DepthAtForce(PairSize, f64);

impl NormalVisitor for DepthAtForce {
    type Output = Result<f64, CalibrateError>;

    fn visit<L: Normal>(self, law: &L) -> Self::Output {
        let Self(size, force) = self;
        let reached = |overlap: f64| {
            let mut history = vec![0.0; L::HISTORY.len()];
            press(law, size, &mut history, overlap, f64::MIN_POSITIVE)
        };
        let excess = |overlap: f64| reached(overlap) - force;
        let deepest = DEEPEST * size.radius;
        let mut depth = 1e-9 * size.radius;
        while excess(depth) < 0.0 {
            if depth >= deepest {
                let reached = reached(deepest);
                return Err(CalibrateError::Curve(format!(
                    "`max_force` is {force} N; at an overlap of the effective radius, {deepest} m, the force is \
                     {reached:.4e} N only"
                )));
            }
            depth = (2.0 * depth).min(deepest);
        }
        Ok(locate(&excess, (0.0, -force), (depth, excess(depth))))
    }
}

struct Trace<'a> {
    size: PairSize,
    depth: f64,
    file: &'a ImpactFile,
}

impl NormalVisitor for Trace<'_> {
    type Output = ContactCurve;

    fn visit<L: Normal>(self, law: &L) -> Self::Output {
        let Self { size, depth, file } = self;
        let spec = &file.curve;
        let mut pen = Pen {
            law,
            size,
            points: spec.points,
            history: vec![0.0; L::HISTORY.len()],
            rows: Vec::new(),
            pull: None,
        };
        let reach = law.reach(size, &pen.history);
        if reach > 0.0 {
            pen.follow((-reach, 0.0));
            pen.draw(Branch::Approach, -shown_reach(reach, size, depth), 0.0);
        }
        pen.follow((0.0, depth));
        pen.draw(Branch::Load, 0.0, depth);
        if spec.reload {
            let to = spec.unload_to.unwrap_or_else(|| pen.overlap_at_half_force(depth));
            let to = to.clamp(pen.end(depth), depth);
            pen.follow((depth, to));
            pen.draw(Branch::Unload, depth, to);
            let to = to.clamp(pen.end(depth), depth);
            pen.follow((to, depth));
            pen.draw(Branch::Reload, to, depth);
        }
        let end_of_contact = -law.reach(size, &pen.history);
        pen.follow((depth, end_of_contact));
        pen.draw(Branch::PullOff, depth, pen.end(depth));
        let largest = |key: fn(&CurvePoint) -> f64| pen.rows.iter().map(key).fold(f64::NEG_INFINITY, f64::max);
        let extremes = Extremes {
            max_overlap: depth,
            max_force: largest(|point| point.force),
            largest_pull: (pen.pull.filter(|pull| pull.force > 0.0)).map(|pull| (-pull.force, pull.overlap)),
            end_of_contact,
        };
        ContactCurve {
            points: pen.rows,
            extremes,
        }
    }
}

/// As much of the reach of an attraction as is worth drawing: no more than the depth of the curve twice over.
fn shown_reach(reach: f64, size: PairSize, depth: f64) -> f64 {
    reach.min(2.0 * depth).min(size.radius)
}

/// Draws branch after branch.
struct Pen<'a, L> {
    law: &'a L,
    size: PairSize,
    points: usize,
    history: Vec<f64>,
    rows: Vec<CurvePoint>,
    /// The largest pull on the ways that were followed.
    pull: Option<Pull>,
}

impl<L: Normal> Pen<'_, L> {
    fn draw(&mut self, branch: Branch, from: f64, to: f64) {
        let rate = f64::MIN_POSITIVE.copysign(to - from);
        for k in 0..self.points {
            let share = k as f64 / (self.points - 1) as f64;
            let overlap = if k + 1 == self.points {
                to
            } else {
                from + (to - from) * share
            };
            let force = press(self.law, self.size, &mut self.history, overlap, rate);
            let stored = self.law.energy(self.size, overlap, &self.history);
            self.rows.push(CurvePoint {
                branch,
                overlap,
                force,
                stored,
            });
        }
    }

    /// Looks for the largest pull on the way that is drawn next, also where it is not drawn.
    fn follow(&mut self, way: (f64, f64)) {
        let pull = largest_pull(self.law, self.size, &self.history, way);
        if self.pull.is_none_or(|known| pull.force > known.force) {
            self.pull = Some(pull);
        }
    }

    /// Overlap at which drawing ends on the way out.
    fn end(&self, depth: f64) -> f64 {
        let reach = self.law.reach(self.size, &self.history);
        -shown_reach(reach, self.size, depth).min(reach)
    }

    /// Overlap at which the force on the way out is half of what it is now.
    fn overlap_at_half_force(&self, depth: f64) -> f64 {
        let force = |overlap: f64| {
            let mut history = self.history.clone();
            press(self.law, self.size, &mut history, overlap, -f64::MIN_POSITIVE)
        };
        let half = 0.5 * force(depth);
        let end = self.end(depth);
        locate(|x| force(x) - half, (depth, half), (end, force(end) - half))
    }
}
