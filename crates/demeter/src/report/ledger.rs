//! The energy ledger as a table.

use super::figures::{number, prefix};
use super::html::Html;
use super::series::{PUT_IN, RESIDUAL, STORED, TAKEN_OUT, at};
use crate::results::Columns;

/// Energies at the start and at the end, what was put in and taken out, and what the books do not explain.
pub(super) fn table(series: &Columns, html: &mut Html) {
    let Some(last) = series.rows().checked_sub(1) else {
        html.element("p", "The series has no row.");
        return;
    };
    let value = |name: &str, row| at(series, name, row).unwrap_or(0.0);
    let all = || STORED.iter().chain(&PUT_IN).chain(&TAKEN_OUT);
    let largest = all()
        .flat_map(|name| [value(name, 0).abs(), value(name, last).abs()])
        .filter(|v| v.is_finite())
        .fold(0.0, f64::max);
    let (prefix, factor) = prefix(largest);
    let entry = |name: &str| {
        let (start, end) = (value(name, 0), value(name, last));
        [start, end, end - start]
    };
    let line = |name: &str, values: [f64; 3]| {
        let cells = values.iter().map(|v| number(v / factor));
        std::iter::once(name.to_string()).chain(cells).collect::<Vec<String>>()
    };
    let mut rows = Vec::new();
    let mut group = |names: &[&str], total: &str| {
        let mut sum = [0.0; 3];
        for name in names {
            let values = entry(name);
            if values.iter().any(|v| *v != 0.0) {
                rows.push(line(name, values));
            }
            sum = [sum[0] + values[0], sum[1] + values[1], sum[2] + values[2]];
        }
        rows.push(line(total, sum));
        sum[2]
    };
    let change = group(&STORED, "= present");
    let put_in = group(&PUT_IN, "= put in");
    let taken_out = group(&TAKEN_OUT, "= taken out");
    let mut unexplained = vec!["= unexplained: present − put in + taken out".to_string()];
    unexplained.extend([
        String::new(),
        String::new(),
        number((change - put_in + taken_out) / factor),
    ]);
    rows.push(unexplained);
    let end = format!("at the end [{prefix}J]");
    let titles = [
        "energy",
        &format!("at the start [{prefix}J]"),
        &end,
        &format!("change [{prefix}J]"),
    ];
    html.table("From the first row of the series to the last", &titles, &rows);
    html.element("p", &residual(series));
}

/// What the residual is, and how large it became.
fn residual(series: &Columns) -> String {
    let numbers = series
        .find(RESIDUAL)
        .and_then(|column| column.numbers())
        .unwrap_or_default();
    let finite = numbers.iter().enumerate().filter(|(_, v)| v.is_finite());
    let Some((row, largest)) = finite.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())) else {
        return "The series tells no residual.".to_string();
    };
    let time = at(series, "time", row).unwrap_or(f64::NAN);
    format!(
        "Entries that are zero are left out. The residual, the unexplained share of the energy that passed through the \
         system, is {} at the end and reached {} at {} s.",
        number(numbers.last().copied().unwrap_or(f64::NAN)),
        number(*largest),
        number(time)
    )
}
