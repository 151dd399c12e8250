// Plots: lines over time or over another column, and histograms. Drag to zoom, double click to see everything; keys and
// buttons do the same; every plot has its numbers as a table. Drawn by uPlot.
import uPlot from "uplot";
import { button } from "./dom";
import "uplot/dist/uPlot.min.css";
import { describe, entry, extent, grows, loopPlot, nearest, timePlot } from "./plots/drawing";
import { Legend, valuesAt } from "./plots/legend";
import { drawMarks, drawNow } from "./plots/marks";
import { foldedTable, type TableColumn } from "./plots/table";
import { listenToKeys, reset, zoomButtons, type Ranges } from "./plots/zoom";

export { dataTable, foldedTable, type TableColumn } from "./plots/table";
export { readable, titled } from "./units";

/** A vertical line with a text, such as the start of a stage. */
export interface Mark {
    at: number;
    label: string;
}

export interface PlotOptions {
    title: string;
    /** The horizontal axis; need not grow from row to row (a force over a strain that comes back). */
    x: TableColumn;
    lines: TableColumn[];
    /** A logarithmic vertical axis; values up to 0 are left out. */
    log?: boolean;
    marks?: Mark[];
    /** Height of the drawing [CSS pixels]. */
    height?: number;
    /** Draws bars from 0 instead of lines; `x` tells the middles of the bins. */
    bars?: boolean;
    /** What the vertical axis tells, where the lines do not. */
    yLabel?: string;
    /** Offers to make the vertical axis logarithmic. */
    canBeLog?: boolean;
    /** Called with the horizontal value of a place that was clicked. */
    onPlace?: (value: number) => void;
    /** Plots with the same link zoom together and show the values of the same place. */
    link?: Link;
}

/** Plots over the same horizontal axis. */
export class Link {
    readonly #plots = new Set<Plot>();
    readonly key = `link-${Math.random()}`;
    #busy = false;

    join(plot: Plot): void {
        this.#plots.add(plot);
    }

    leave(plot: Plot): void {
        this.#plots.delete(plot);
    }

    /** Takes a range over from a plot to the others. */
    spread(from: Plot, range: [number, number]): void {
        if (this.#busy) {
            return;
        }
        this.#busy = true;
        for (const plot of this.#plots) {
            if (plot !== from) {
                plot.see(range);
            }
        }
        this.#busy = false;
    }
}

const HEIGHT = 300;

/** A plot in a container, which it fills; `update` draws other values. */
export class Plot {
    readonly element = document.createElement("figure");
    readonly #surface = document.createElement("div");
    readonly #watch: ResizeObserver;
    readonly #dark = window.matchMedia("(prefers-color-scheme: dark)");
    readonly #redo = () => this.#make();
    #options: PlotOptions;
    #plot!: uPlot;
    #legend!: Legend;
    #whole: Ranges = {};
    #now: number | null = null;

    constructor(container: HTMLElement, options: PlotOptions) {
        this.#options = options;
        this.element.className = "plot";
        this.#surface.className = "plot-surface";
        this.#surface.tabIndex = 0;
        this.#surface.setAttribute("role", "application");
        listenToKeys(this.#surface, () => this.#plot, () => this.#whole);
        container.append(this.element);
        this.#make();
        options.link?.join(this);
        this.#watch = new ResizeObserver(() => this.#plot.setSize(this.#size()));
        this.#watch.observe(this.#surface);
        this.#dark.addEventListener("change", this.#redo);
        window.addEventListener("demeter:colours", this.#redo);
    }

    /** Draws other values; what was zoomed stays zoomed where only values were added. */
    update(options: PlotOptions): void {
        const sameLines = options.lines.map((line) => line.label).join() === this.#options.lines.map((line) => line.label).join();
        const kept = sameLines && this.zoomed() ? { ...this.#plot.scales.x } : null;
        this.#options = options;
        this.#make();
        if (kept && kept.min != null && kept.max != null) {
            this.#plot.setScale("x", { min: kept.min, max: kept.max });
        }
    }

    /** Whether less than everything is seen. */
    zoomed(): boolean {
        const { min, max } = this.#plot.scales.x!;
        const whole = this.#whole.x;
        return whole !== undefined && min != null && max != null && (min > whole[0] || max < whole[1]);
    }

    /** The range of the horizontal axis that is seen. */
    range(): [number, number] {
        const { min, max } = this.#plot.scales.x!;
        return [min ?? NaN, max ?? NaN];
    }

    /** Sees a range of the horizontal axis. */
    see([min, max]: [number, number]): void {
        this.#plot.setScale("x", { min, max });
    }

    /** Marks a place of the horizontal axis: the moment that is shown elsewhere. */
    setNow(value: number | null): void {
        if (value !== this.#now) {
            this.#now = value;
            this.#plot.redraw(false, false);
        }
    }

    reset(): void {
        reset(this.#plot, this.#whole);
    }

    dispose(): void {
        this.#options.link?.leave(this);
        this.#watch.disconnect();
        this.#dark.removeEventListener("change", this.#redo);
        window.removeEventListener("demeter:colours", this.#redo);
        this.#plot.destroy();
        this.element.remove();
    }

    #logButton(): HTMLElement {
        const log = this.#options.log ?? false;
        const made = button("log", () => {
            this.update({ ...this.#options, log: !log });
            (this.element.querySelector("[aria-pressed].log") as HTMLElement | null)?.focus();
        }, { class: "log", "aria-pressed": log, title: "Logarithmic vertical axis" });
        made.setAttribute("aria-pressed", String(log));
        return made;
    }

    #tell(plot: uPlot, scale: string): void {
        const { min, max } = plot.scales.x!;
        if (scale === "x" && min != null && max != null) {
            this.element.dataset.range = `${min} ${max}`;
            this.#options.link?.spread(this, [min, max]);
        }
    }

    /** A click, but not the end of a drag, tells the place. */
    #listen(plot: uPlot): void {
        const { onPlace } = this.#options;
        if (onPlace) {
            let down = NaN;
            plot.over.addEventListener("mousedown", (event) => (down = event.clientX));
            plot.over.addEventListener("click", (event) => {
                if (Math.abs(event.clientX - down) < 4) {
                    onPlace(plot.posToVal(event.offsetX, "x"));
                }
            });
        }
    }

    #size(): { width: number; height: number } {
        return { width: Math.max(this.#surface.clientWidth, 200), height: this.#options.height ?? HEIGHT };
    }

    #make(): void {
        const options = this.#options;
        this.#plot?.destroy();
        const entries = options.lines.map((line, k) => entry(line, k));
        const caption = document.createElement("figcaption");
        caption.textContent = options.title;
        const buttons = zoomButtons(() => this.#plot, () => this.#whole);
        if (options.canBeLog) {
            buttons.prepend(this.#logButton());
        }
        caption.append(buttons);
        this.#surface.setAttribute("aria-label", describe(options));
        this.#legend = new Legend(options.x, entries, (series, shown) => this.#plot.setSeries(series, { show: shown }));
        const table = foldedTable(options.title, () => [options.x, ...options.lines]);
        // numbers that are looked at stay, with what has come since
        table.open = this.element.querySelector("details")?.open ?? false;
        this.element.replaceChildren(caption, this.#surface, this.#legend.element, table);
        const loop = !grows(options.x.values);
        const made = loop ? loopPlot(options, entries) : timePlot(options, entries);
        made.options.hooks = {
            setCursor: [(plot) => this.#legend.show(...(loop ? nearest(plot) : valuesAt(plot)))],
            draw: [(plot) => drawMarks(plot, options.marks ?? []), (plot) => drawNow(plot, this.#now)],
            ready: [(plot) => this.#listen(plot)],
            setScale: [(plot, scale) => this.#tell(plot, scale)],
        };
        if (options.link && !loop) {
            const moves = (type: string) => type === "mousemove" || type === "mouseleave";
            made.options.cursor = { ...made.options.cursor, sync: { key: options.link.key, setSeries: false, scales: ["x", null], filters: { pub: moves, sub: moves } } };
        }
        this.#plot = new uPlot({ ...made.options, ...this.#size() }, made.data, this.#surface);
        this.#whole = made.whole;
    }
}

/** Counts of values in bins of the same width, as densities are not: what a histogram draws. */
export function histogram(values: ArrayLike<number>, bins = 60): { middles: Float64Array; counts: Float64Array } {
    const [low, high] = extent([values]);
    const counts = new Float64Array(bins);
    for (let k = 0; k < values.length; k++) {
        const value = values[k]!;
        if (Number.isFinite(value)) {
            counts[Math.min(Math.floor(((value - low) / (high - low)) * bins), bins - 1)]! += 1;
        }
    }
    const width = (high - low) / bins;
    return { middles: Float64Array.from({ length: bins }, (_, k) => low + (k + 0.5) * width), counts };
}
