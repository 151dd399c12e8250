//! Answers of the server. Everything here may wait for the disk and runs on threads of its own.

use crate::cache::{Cache, Key, lock};
use crate::grain::Finder;
use crate::pack::Pack;
use crate::page::HTML;
use crate::request::Request;
use crate::watch::{Watch, modified};
use crate::{frame, grain};
use bytes::Bytes;
use demeter::results::{Cells, Columns, ResultsError, Run, TableKind};
use demeter_web::{LICENCES, VIEWER};
use hyper::StatusCode;
use serde_json::{Value, json};
use std::path::PathBuf;
use std::sync::Mutex;

/// An answer: its type and its bytes.
#[derive(Clone, Debug)]
pub(crate) struct Answer {
    pub status: StatusCode,
    pub kind: &'static str,
    pub bytes: Bytes,
    /// The path to which whoever asks is led.
    pub leads_to: Option<String>,
}

impl Answer {
    fn new(kind: &'static str, bytes: impl Into<Bytes>) -> Self {
        Self {
            status: StatusCode::OK,
            kind,
            bytes: bytes.into(),
            leads_to: None,
        }
    }

    fn json(value: &Value) -> Self {
        Self::new("application/json", value.to_string())
    }

    fn packed(bytes: impl Into<Bytes>) -> Self {
        Self::new("application/octet-stream", bytes)
    }

    /// Leads to a path; nothing is kept of the one that was asked for.
    fn lead_to(path: &str) -> Self {
        Self {
            status: StatusCode::SEE_OTHER,
            leads_to: Some(path.to_owned()),
            ..Self::new("text/plain; charset=utf-8", Bytes::new())
        }
    }

    /// Tells what is wrong.
    pub fn fault(status: StatusCode, problem: &str) -> Self {
        Self {
            status,
            ..Self::json(&json!({ "error": problem }))
        }
    }
}

/// What answers are made of.
#[derive(Debug)]
pub(crate) struct Api {
    run: Run,
    name: String,
    watch: Mutex<Watch>,
    cache: Mutex<Cache>,
    /// Columns of ids, by which a grain is found.
    ids: Mutex<Cache>,
}

impl Api {
    pub fn new(run: Run, cache: usize) -> Result<Self, ResultsError> {
        let root = run.folder().root();
        let name = root.canonicalize().unwrap_or_else(|_| root.to_owned());
        Ok(Self {
            name: name
                .file_name()
                .map_or_else(|| "run".into(), |name| name.to_string_lossy().into_owned()),
            watch: Mutex::new(Watch::new(run.clone())?),
            run,
            cache: Mutex::new(Cache::new(cache - cache / 4)),
            ids: Mutex::new(Cache::new(cache / 4)),
        })
    }

    /// Answers a request.
    pub fn answer(&self, request: &Request) -> Answer {
        let answer = match request {
            Request::LeadTo(path) => Ok(Answer::lead_to(path)),
            Request::Page => Ok(Answer::new("text/html; charset=utf-8", HTML)),
            Request::Script => Ok(Answer::new("text/javascript; charset=utf-8", VIEWER.script)),
            Request::Style => Ok(Answer::new("text/css; charset=utf-8", VIEWER.style)),
            Request::Licences => Ok(Answer::new("text/plain; charset=utf-8", LICENCES)),
            Request::State { moments } => self.state(*moments),
            Request::Series { columns, from } => Ok(self.series(columns, *from)),
            Request::Frame { step } => self.kept("frame", *step, TableKind::Grains, frame::frame),
            Request::Contacts { step } => self.kept("contacts", *step, TableKind::Contacts, frame::contacts),
            Request::Walls { step } => self.kept("walls", *step, TableKind::Walls, frame::walls),
            Request::Grain { step, id } => self.grain(*step, *id),
            Request::History { id, moments } => Ok(self.history(*id, moments)),
        };
        answer.unwrap_or_else(|error| {
            let status = match error {
                ResultsError::NoFrame { .. } => StatusCode::NOT_FOUND,
                ResultsError::NotInside { .. } => StatusCode::FORBIDDEN,
                _ => StatusCode::INTERNAL_SERVER_ERROR,
            };
            Answer::fault(status, &self.without_paths(&error))
        })
    }

    /// A message in which the folder is called by its name: the page need not know where it lies.
    fn without_paths(&self, error: &ResultsError) -> String {
        let root = self.run.folder().root().display().to_string();
        error.to_string().replace(&root, &self.name)
    }

    fn state(&self, from: usize) -> Result<Answer, ResultsError> {
        let mut watch = lock(&self.watch);
        watch.look()?;
        let moments = watch.moments.get(from..).unwrap_or_default();
        let summary = self.run.summary().unwrap_or_default();
        let title = match summary.as_ref().and_then(|summary| summary["title"].as_str()) {
            Some(title) => title.to_string(),
            None => self.title().unwrap_or_default(),
        };
        let told = summary
            .as_ref()
            .map(|s| json!({ "finished": s["finished"], "stopped_by": s["stopped_by"], "warnings": s["warnings"] }));
        Ok(Answer::json(&json!({
            "version": demeter::VERSION,
            "folder": self.name,
            "title": title,
            "epoch": watch.epoch,
            "going_on": self.run.is_going_on(),
            "summary": told,
            "moments": {
                "from": from.min(watch.moments.len()),
                "count": watch.moments.len(),
                "steps": moments.iter().map(|m| m.step).collect::<Vec<_>>(),
                "times": moments.iter().map(|m| m.time).collect::<Vec<_>>(),
            },
            "series": watch.series.as_ref().map(describe),
            "fault": watch.fault,
        })))
    }

    /// Title of the scenario, while there is no summary.
    fn title(&self) -> Option<String> {
        let text = self.run.scenario().ok()??;
        let table: toml::Table = text.parse().ok()?;
        Some(table.get("title")?.as_str()?.to_string())
    }

    fn series(&self, columns: &[usize], from: usize) -> Answer {
        let watch = lock(&self.watch);
        let mut pack = Pack::default();
        pack.tell("epoch", json!(watch.epoch));
        let rows = watch.series.as_ref().map_or(0, Columns::rows);
        let from = from.min(rows);
        pack.tell("from", json!(from));
        for column in columns {
            let numbers = watch
                .series
                .as_ref()
                .and_then(|series| series.all().get(*column)?.numbers());
            let Some(numbers) = numbers else {
                return Answer::fault(StatusCode::NOT_FOUND, "the series has no such column of numbers");
            };
            pack.f64s(&column.to_string(), numbers[from..].iter().copied());
        }
        Answer::packed(pack.encode())
    }

    /// An answer about a step that is made once and kept.
    fn kept(
        &self,
        kind: &'static str,
        step: u64,
        table: TableKind,
        make: fn(&Run, u64) -> Result<Vec<u8>, ResultsError>,
    ) -> Result<Answer, ResultsError> {
        let key: Key = (kind, step, modified(&self.run, self.path(table, step)));
        if let Some(bytes) = lock(&self.cache).get(&key) {
            return Ok(Answer::packed(bytes));
        }
        let bytes = Bytes::from(make(&self.run, step)?);
        lock(&self.cache).put(key, bytes.clone());
        Ok(Answer::packed(bytes))
    }

    fn path(&self, table: TableKind, step: u64) -> PathBuf {
        self.run.table_path(table, step)
    }

    fn grain(&self, step: u64, id: u32) -> Result<Answer, ResultsError> {
        Ok(match grain::grain(&self.finder(), step, id)? {
            Some(value) => Answer::json(&value),
            None => Answer::fault(StatusCode::NOT_FOUND, "there is no such grain at this step"),
        })
    }

    fn history(&self, id: u32, asked: &[usize]) -> Answer {
        let (epoch, moments) = {
            let watch = lock(&self.watch);
            let moments = asked.iter().map_while(|k| watch.moments.get(*k).copied());
            (watch.epoch, moments.collect::<Vec<_>>())
        };
        let told = grain::history(&self.finder(), &moments, id);
        Answer::json(&json!({ "epoch": epoch, "moments": told }))
    }

    fn finder(&self) -> Finder<'_> {
        Finder {
            run: &self.run,
            ids: &self.ids,
        }
    }
}

/// Columns, stages and number of rows of the series.
fn describe(series: &Columns) -> Value {
    let columns = series.all().iter().map(|column| {
        let numbers = matches!(column.cells, Cells::Numbers(_));
        json!({ "name": column.name(), "unit": column.unit(), "numbers": numbers })
    });
    let stages = series
        .spans("stage")
        .into_iter()
        .map(|(name, rows)| json!({ "name": name, "from": rows.start, "to": rows.end }));
    json!({ "rows": series.rows(), "columns": columns.collect::<Vec<_>>(), "stages": stages.collect::<Vec<_>>() })
}
