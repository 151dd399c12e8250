// Columns of the series over time or over another column, with the time of the frame; rows that are added appear.
import { choice, make, tick } from "../dom";
import { Plot, type PlotOptions, type TableColumn } from "../plots";
import { titled } from "../units";
import { readSeries, type Column, type RunState } from "./api";

/** Columns that are shown at first, where the run has them. */
const FIRST = ["kinetic energy", "elastic energy"];
/** Most columns that are plotted together. */
const MOST_LINES = 12;

type Series = NonNullable<RunState["series"]>;

export class SeriesPanel {
    readonly element = make("section", { class: "series-panel", "aria-label": "Series" });
    readonly #seek: (time: number) => void;
    readonly #place = make("div", { class: "series-plot" });
    readonly #list = make("div", { class: "column-list" });
    readonly #full = make("p", { class: "hint", role: "status" });
    readonly #filter = make("input", { type: "search", placeholder: "energy, wall top, …" });
    readonly #across: HTMLSelectElement;
    #series: Series | null = null;
    #time: number | null = null;
    #x = 0;
    #log = false;
    #chosen = new Set<number>();
    #values = new Map<number, Float64Array>();
    #plot: Plot | null = null;
    #reading = false;

    constructor(seek: (time: number) => void) {
        this.#seek = seek;
        const across = choice("Horizontal axis", [], (value) => {
            this.#x = Number(value);
            void this.#read();
        });
        this.#across = across.select;
        const log = tick("Logarithmic vertical axis", false, (value) => {
            this.#log = value;
            this.#draw();
        });
        this.#filter.addEventListener("input", () => this.#narrow());
        const find = make("label", { class: "field" }, make("span", {}, "Find columns"), this.#filter);
        const vertical = make("fieldset", {}, make("legend", {}, "Vertical axis"), find, this.#full, this.#list);
        const choices = make("div", { class: "own-choices" }, across.element, log.element, vertical);
        this.element.append(make("h2", {}, "Series"), make("div", { class: "own-plot" }, choices, this.#place));
    }

    /** Takes over what the series has now; `anew` where earlier rows have gone. */
    update(series: Series | null, anew: boolean): void {
        if (anew) {
            this.#values.clear();
        }
        const names = (s: Series | null) => s?.columns.map((c) => c.name).join("\n") ?? "";
        const same = names(series) === names(this.#series);
        const grown = series?.rows !== this.#series?.rows;
        this.#series = series;
        if (!same) {
            this.#begin();
        }
        if (!same || grown || anew) {
            void this.#read();
        }
    }

    /** Tells the time of the frame [s]. */
    setTime(time: number): void {
        this.#time = time;
        this.#plot?.setNow(this.#now());
    }

    #begin(): void {
        const columns = this.#series?.columns ?? [];
        const numbers = columns.map((c, k) => [c, k] as const).filter(([c]) => c.numbers);
        this.#values.clear();
        this.#chosen = new Set(numbers.filter(([c]) => FIRST.includes(c.name)).map(([, k]) => k));
        this.#x = Math.max(columns.findIndex((c) => c.name === "time"), 0);
        this.#across.replaceChildren(...numbers.map(([c, k]) => make("option", { value: k }, titled(c.name, c.unit))));
        this.#across.value = String(this.#x);
        this.#list.replaceChildren(...numbers.map(([c, k]) => this.#row(c, k)));
        this.#narrow();
        this.#limit();
    }

    #row(column: Column, k: number): HTMLElement {
        const row = tick(titled(column.name, column.unit), this.#chosen.has(k), (on) => {
            if (on) {
                this.#chosen.add(k);
            } else {
                this.#chosen.delete(k);
            }
            this.#limit();
            void this.#read();
        });
        row.element.dataset["name"] = column.name.toLowerCase();
        return row.element;
    }

    /** No more columns can be ticked than are plotted together. */
    #limit(): void {
        const full = this.#chosen.size >= MOST_LINES;
        for (const box of this.#list.querySelectorAll("input")) {
            box.disabled = full && !box.checked;
        }
        this.#full.textContent = full ? `${MOST_LINES} columns are ticked, which is the most; untick one to tick another.` : "";
    }

    #narrow(): void {
        const words = this.#filter.value.toLowerCase().split(/\s+/);
        for (const row of this.#list.children as HTMLCollectionOf<HTMLElement>) {
            row.hidden = !words.every((word) => row.dataset["name"]!.includes(word));
        }
    }

    /** Reads the rows that are missing of the columns that are shown. */
    async #read(): Promise<void> {
        if (this.#reading) {
            return;
        }
        this.#reading = true;
        try {
            for (let rounds = 0; rounds < 100; rounds++) {
                const rows = this.#series?.rows ?? 0;
                const wanted = this.#wanted().filter((k) => (this.#values.get(k)?.length ?? 0) < rows);
                if (wanted.length === 0) {
                    break;
                }
                const from = Math.min(...wanted.map((k) => this.#values.get(k)?.length ?? 0));
                const pack = await readSeries(wanted, from);
                for (const k of wanted) {
                    this.#values.set(k, joined(this.#values.get(k), pack.doubles(String(k)), pack.head["from"] as number));
                }
            }
        } catch (error) {
            this.#place.dataset["fault"] = String(error);
        } finally {
            this.#reading = false;
        }
        this.#draw();
    }

    #wanted(): number[] {
        const time = this.#series?.columns.findIndex((c) => c.name === "time") ?? -1;
        const shown = [...this.#chosen].sort((a, b) => a - b);
        return [...new Set([this.#x, time, ...shown])].filter((k) => k >= 0);
    }

    #column(k: number, rows: number): TableColumn {
        const { name, unit } = this.#series!.columns[k]!;
        return { label: name, unit, values: this.#values.get(k)!.subarray(0, rows) };
    }

    #draw(): void {
        const shown = [...this.#chosen].sort((a, b) => a - b);
        const all = [this.#x, ...shown].map((k) => this.#values.get(k)?.length ?? 0);
        const rows = Math.min(...all);
        if (!this.#series || shown.length === 0 || rows === 0) {
            this.#plot?.dispose();
            this.#plot = null;
            const hint = this.#series && this.#series.rows > 0 ? "Tick the columns to plot; any column may be the horizontal axis." : "The run has no row yet.";
            this.#place.replaceChildren(make("p", { class: "hint" }, hint));
            return;
        }
        const x = this.#column(this.#x, rows);
        const lines = shown.map((k) => this.#column(k, rows));
        const overTime = x.label === "time";
        const marks = overTime ? this.#series.stages.filter((s) => s.from < rows).map((s) => ({ at: x.values[s.from]!, label: s.name })) : [];
        const options: PlotOptions = { title: `${lines.map((l) => l.label).join(", ")} over ${x.label}`, x, lines, log: this.#log, marks, height: 320, ...(overTime ? { onPlace: this.#seek } : {}) };
        if (this.#plot) {
            this.#plot.update(options);
        } else {
            this.#place.replaceChildren();
            this.#plot = new Plot(this.#place, options);
        }
        this.#plot.setNow(this.#now());
    }

    /** Where the time of the frame is on the horizontal axis. */
    #now(): number | null {
        const time = this.#series?.columns.findIndex((c) => c.name === "time") ?? -1;
        const [times, places] = [this.#values.get(time), this.#values.get(this.#x)];
        if (this.#time === null || !times || !places) {
            return null;
        }
        return time === this.#x ? this.#time : (places[nearest(times, this.#time)] ?? null);
    }
}

/** What was known with what follows from a row on. */
function joined(old: Float64Array | undefined, more: Float64Array, from: number): Float64Array {
    const kept = old?.subarray(0, from) ?? new Float64Array();
    const all = new Float64Array(kept.length + more.length);
    all.set(kept);
    all.set(more, kept.length);
    return all;
}

/** Index of the value that is nearest; the values ascend. */
function nearest(values: Float64Array, value: number): number {
    let [low, high] = [0, values.length - 1];
    while (low < high) {
        const middle = (low + high) >> 1;
        if (values[middle]! < value) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low > 0 && value - values[low - 1]! < values[low]! - value ? low - 1 : low;
}
