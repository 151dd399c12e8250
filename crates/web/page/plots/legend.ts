// The legend of a plot: buttons that show and hide lines, and the values under the cursor.
import type uPlot from "uplot";
import { readable, titled } from "../units";

export interface LegendEntry {
    label: string;
    unit: string;
    colour: string;
    dash: boolean;
}

/** A legend; `show(k)` tells the values at a place, `null` for none. */
export class Legend {
    readonly element = document.createElement("div");
    readonly #values: HTMLElement[] = [];
    readonly #at = document.createElement("span");

    constructor(x: { label: string; unit: string }, entries: LegendEntry[], toggle: (series: number, shown: boolean) => void) {
        this.element.className = "plot-legend";
        entries.forEach((entry, k) => this.#add(entry, k, toggle));
        this.#at.className = "plot-at";
        this.#at.dataset.title = titled(x.label, x.unit);
        this.element.append(this.#at);
    }

    #add(entry: LegendEntry, k: number, toggle: (series: number, shown: boolean) => void): void {
        const button = document.createElement("button");
        button.type = "button";
        button.setAttribute("aria-pressed", "true");
        button.title = "Show or hide";
        const swatch = document.createElement("span");
        swatch.className = entry.dash ? "swatch dash" : "swatch";
        swatch.style.color = entry.colour;
        const value = document.createElement("output");
        this.#values.push(value);
        button.append(swatch, titled(entry.label, entry.unit), value);
        button.addEventListener("click", () => {
            const shown = button.getAttribute("aria-pressed") !== "true";
            button.setAttribute("aria-pressed", String(shown));
            toggle(k + 1, shown);
        });
        this.element.append(button);
    }

    /** Tells the values under the cursor. */
    show(x: number | null, values: (number | null)[]): void {
        this.#at.textContent = x === null ? "" : `${this.#at.dataset.title}: ${readable(x)}`;
        this.#values.forEach((output, k) => (output.textContent = x === null ? "" : readable(values[k] ?? NaN)));
    }
}

/** Values under the cursor of a plot whose series share their places. */
export function valuesAt(plot: uPlot): [number | null, (number | null)[]] {
    const at = plot.cursor.idx;
    if (at == null) {
        return [null, []];
    }
    return [plot.data[0][at] ?? null, plot.data.slice(1).map((values) => (values as (number | null)[])[at] ?? null)];
}
