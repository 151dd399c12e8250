// Tables that say in numbers what a plot draws.
import { readable, titled } from "../units";

export interface TableColumn {
    label: string;
    unit: string;
    values: ArrayLike<number>;
}

const MOST_ROWS = 200;

/** A table of columns; of long ones every so many rows, which its caption tells. */
export function dataTable(caption: string, columns: TableColumn[]): HTMLElement {
    const rows = columns[0]?.values.length ?? 0;
    const stride = Math.max(1, Math.ceil(rows / MOST_ROWS));
    const table = document.createElement("table");
    table.createCaption().textContent = stride > 1 ? `${caption}: one row in ${stride} of ${rows}` : caption;
    const head = table.createTHead().insertRow();
    for (const { label, unit } of columns) {
        const cell = document.createElement("th");
        cell.scope = "col";
        cell.textContent = titled(label, unit);
        head.append(cell);
    }
    const body = table.createTBody();
    for (let row = 0; row < rows; row += stride) {
        const line = body.insertRow();
        for (const { values } of columns) {
            line.insertCell().textContent = readable(values[row] ?? NaN);
        }
    }
    const scroller = document.createElement("div");
    scroller.className = "table-scroller";
    scroller.tabIndex = 0;
    scroller.setAttribute("role", "region");
    scroller.setAttribute("aria-label", `Numbers of ${caption}`);
    scroller.append(table);
    return scroller;
}

/** The same, folded away; made when it is unfolded. */
export function foldedTable(caption: string, columns: () => TableColumn[]): HTMLDetailsElement {
    const details = document.createElement("details");
    details.className = "data-table";
    const summary = document.createElement("summary");
    summary.textContent = "Numbers";
    details.append(summary);
    details.addEventListener("toggle", () => {
        if (details.open) {
            details.replaceChildren(summary, dataTable(caption, columns()));
        }
    });
    return details;
}
