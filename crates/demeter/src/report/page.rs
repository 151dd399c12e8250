//! The page.

use super::distributions::{Distribution, distributions};
use super::figures::{count, quantity};
use super::html::{Html, escaped, json_for_script};
use super::plots::{self, Plots};
use super::profiles::MOST;
use super::{Contents, ledger, outcome, series};
use crate::results::Packing;
use serde_json::{Map, Value, json};

/// The parts of the page, by the names of their places and their titles.
const PARTS: [(&str, &str); 7] = [
    ("state", "Last state"),
    ("plots", "Series"),
    ("energy", "Energy ledger"),
    ("contacts", "Contacts"),
    ("walls", "Walls"),
    ("stages", "Stages"),
    ("parameters", "Parameters"),
];

/// What stands where a part needs the script, until it has run.
const NEEDS_SCRIPT: &str =
    "<noscript><p class=\"note\">Plots and the 3D view need JavaScript; the tables do not.</p></noscript>";

/// The whole page.
pub(super) fn page(contents: &Contents) -> String {
    let distributions: Vec<Distribution> = contents.packing.iter().flat_map(distributions).collect();
    let rounding = contents.packing.as_ref().map_or(0.0, Packing::rounding);
    let drawn = (contents.series.as_ref().filter(|series| series.rows() > 0))
        .map(|series| Plots::new(series, contents.parameters.as_ref(), rounding))
        .unwrap_or_default();
    let mut body = Html::default();
    header(contents, &mut body);
    body.raw("<main id=\"main\">");
    notices(contents, &mut body);
    figures(contents, &mut body);
    body.raw(NEEDS_SCRIPT);
    for (place, title) in PARTS {
        body.raw(&format!(
            "<section id=\"{place}\" aria-labelledby=\"{place}-title\"><h2 id=\"{place}-title\">{title}</h2>"
        ));
        match place {
            "state" => state(contents.packing.as_ref(), &mut body),
            "plots" => plots(contents, &drawn, &mut body),
            "energy" => energy(contents, &mut body),
            "contacts" => contacts(&distributions, &mut body),
            "walls" => walls(contents, &drawn, rounding, &mut body),
            "stages" => contents.outcome.stages(contents.series.as_ref(), &mut body),
            _ => parameters(contents, &mut body),
        }
        body.raw("</section>");
    }
    body.raw("</main><footer><p>");
    body.text(&format!("Written by Demeter {}. ", crate::VERSION));
    body.raw("This page needs no network; libraries and their licences are named in its source.</p></footer>");
    document(contents.title(), body.as_str(), &data(contents, &drawn, distributions))
}

fn document(title: &str, body: &str, data: &Value) -> String {
    let page = demeter_web::REPORT;
    let policy = format!(
        "default-src 'none'; script-src 'sha256-{}'; style-src 'sha256-{}'; img-src data: blob:; base-uri 'none'; form-action 'none'",
        page.script_hash, page.style_hash
    );
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{policy}\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n\
         <meta name=\"referrer\" content=\"no-referrer\">\n\
         <title>{title} – Demeter</title>\n<style>{style}</style>\n</head>\n<body>\n{body}\n\
         <script type=\"application/json\" id=\"report-data\">{data}</script>\n<script>{script}</script>\n</body>\n</html>\n",
        title = escaped(title),
        style = page.style,
        data = json_for_script(data),
        script = page.script,
    )
}

fn header(contents: &Contents, html: &mut Html) {
    html.raw("<a class=\"skip\" href=\"#main\">Skip to the content</a><header><div class=\"title\">");
    html.element("h1", contents.title());
    let (word, class) = contents.outcome.end.mark();
    html.raw(&format!(
        "<p class=\"badge {class}\">{word}</p></div><p class=\"about\">"
    ));
    html.text(&about(contents));
    html.raw("</p><nav aria-label=\"Parts of the report\"><ul>");
    for (place, title) in PARTS {
        html.raw(&format!("<li><a href=\"#{place}\">{title}</a></li>"));
    }
    html.raw("</ul></nav></header>");
}

/// What was run, in a line.
fn about(contents: &Contents) -> String {
    let mut parts = vec![format!("Run “{}”", contents.name)];
    let text = |key: &str| contents.outcome.text(key);
    parts.extend(text("scenario").map(|file| format!("scenario {file}")));
    parts.extend(text("version").map(|version| format!("Demeter {version}")));
    parts.join(" · ")
}

/// How it ended, warnings, and what could not be read.
fn notices(contents: &Contents, html: &mut Html) {
    let (_, class) = contents.outcome.end.mark();
    html.raw(&format!("<p class=\"notice {class}\"><strong>How it ended: </strong>"));
    html.prose(&contents.outcome.reason);
    html.raw("</p>");
    for (title, class, texts) in [
        ("Warnings", "warn", &contents.outcome.warnings),
        ("Not in this report", "bad", &contents.problems),
    ] {
        if texts.is_empty() {
            continue;
        }
        html.raw(&format!("<div class=\"notice {class}\"><strong>{title}</strong><ul>"));
        for text in texts {
            html.raw("<li>");
            html.prose(text);
            html.raw("</li>");
        }
        html.raw("</ul></div>");
    }
}

fn figures(contents: &Contents, html: &mut Html) {
    html.raw("<dl class=\"figures\">");
    for [name, value, remark] in contents.outcome.figures(contents.series.as_ref()) {
        html.raw("<div>");
        html.element("dt", &name);
        html.raw("<dd>");
        html.element("span", &value);
        if !remark.is_empty() {
            html.element("small", &remark);
        }
        html.raw("</dd></div>");
    }
    html.raw("</dl>");
}

fn state(packing: Option<&Packing>, html: &mut Html) {
    let Some(packing) = packing else {
        html.element("p", "The run has written no frame of its grains.");
        return;
    };
    let time = quantity(packing.time, "s");
    html.element("p", &format!("The last frame: step {}, {time}.", count(packing.step)));
    notes(&packing.left_out(), html);
    html.raw("<div id=\"scene\"></div>");
}

fn plots(contents: &Contents, drawn: &Plots, html: &mut Html) {
    let Some(series) = contents.series.as_ref().filter(|series| series.rows() > 0) else {
        html.element("p", "The run has written no series.");
        return;
    };
    notes(&series::told(series), html);
    notes(&drawn.told(plots::SERIES), html);
    grid(plots::SERIES, html);
    contents.profiles.iter().for_each(|profile| profile.write(html));
    let left_out = contents
        .parameters
        .as_ref()
        .map_or(0, |p| p.profiles().len().saturating_sub(MOST));
    if left_out > 0 {
        let text = format!("{left_out} more profiles are left out; `demeter plot` draws them.");
        notes(&[text], html);
    }
    html.raw("<div id=\"own\"><h3>A plot of your own</h3><div id=\"own-plot\"></div></div>");
}

/// A place for plots.
fn grid(place: &str, html: &mut Html) {
    html.raw(&format!("<div class=\"plot-grid\" id=\"{place}\"></div>"));
}

fn energy(contents: &Contents, html: &mut Html) {
    with_series(contents, html, ledger::table);
    grid(plots::ENERGY, html);
}

fn walls(contents: &Contents, drawn: &Plots, rounding: f64, html: &mut Html) {
    with_series(contents, html, |series, html| outcome::walls(series, rounding, html));
    notes(&drawn.told(plots::WALLS), html);
    grid(plots::WALLS, html);
}

fn contacts(distributions: &[Distribution], html: &mut Html) {
    if distributions.is_empty() {
        html.element("p", "The run has written no frame of its contacts.");
    }
    html.raw("<div class=\"plot-grid thirds\">");
    for distribution in distributions {
        html.raw("<div>");
        html.element("h3", distribution.title);
        html.element("p", &distribution.told);
        html.raw(&format!("<div id=\"distribution-{}\"></div></div>", distribution.key));
    }
    html.raw("</div>");
}

fn with_series(contents: &Contents, html: &mut Html, write: impl Fn(&crate::results::Columns, &mut Html)) {
    match contents.series.as_ref().filter(|series| series.rows() > 0) {
        Some(series) => write(series, html),
        None => html.element("p", "The run has written no series."),
    }
}

fn parameters(contents: &Contents, html: &mut Html) {
    if !contents.outcome.time_step_reason.is_empty() {
        html.raw("<p><strong>Time step: </strong>");
        html.prose(&contents.outcome.time_step_reason);
        html.raw("</p>");
    }
    if let Some(parameters) = &contents.parameters {
        html.element(
            "p",
            "As the scenario tells them; what it does not tell has its default value.",
        );
        parameters.write(html);
    }
    html.unfolded("The whole scenario, as it was resolved", &contents.scenario);
    html.unfolded("The log", &contents.log);
}

fn notes(texts: &[String], html: &mut Html) {
    for text in texts {
        html.raw("<p class=\"note\">");
        html.text(text);
        html.raw("</p>");
    }
}

/// What the script draws.
fn data(contents: &Contents, drawn: &Plots, distributions: Vec<Distribution>) -> Value {
    let series = contents.series.as_ref().filter(|series| series.rows() > 0);
    let counted = distributions
        .into_iter()
        .filter_map(|d| Some((d.key.to_string(), d.data?)));
    json!({
        "title": contents.title(),
        "series": series.map(|series| series::data(series, &drawn.groups)),
        "packing": contents.packing.as_ref().map(Packing::data),
        "distributions": counted.collect::<Map<_, _>>(),
    })
}
