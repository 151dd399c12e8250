// Plots: lines over time or over another column, and histograms. Drag to zoom, double click to see everything; keys and
// buttons do the same; every plot has its numbers as a table. Drawn by uPlot.
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { Legend, valuesAt, type LegendEntry } from "./plots/legend";
import { foldedTable, titled, type TableColumn } from "./plots/table";
import { listenToKeys, reset, zoomButtons, type Ranges } from "./plots/zoom";

export { dataTable, foldedTable, readable, titled, type TableColumn } from "./plots/table";

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

    constructor(container: HTMLElement, options: PlotOptions) {
        this.#options = options;
        this.element.className = "plot";
        this.#surface.className = "plot-surface";
        this.#surface.tabIndex = 0;
        this.#surface.setAttribute("role", "application");
        listenToKeys(this.#surface, () => this.#plot, () => this.#whole);
        container.append(this.element);
        this.#make();
        this.#watch = new ResizeObserver(() => this.#plot.setSize(this.#size()));
        this.#watch.observe(this.#surface);
        this.#dark.addEventListener("change", this.#redo);
        window.addEventListener("beforeprint", this.#redo);
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

    reset(): void {
        reset(this.#plot, this.#whole);
    }

    dispose(): void {
        this.#watch.disconnect();
        this.#dark.removeEventListener("change", this.#redo);
        window.removeEventListener("beforeprint", this.#redo);
        this.#plot.destroy();
        this.element.remove();
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
        caption.append(zoomButtons(() => this.#plot, () => this.#whole));
        this.#surface.setAttribute("aria-label", describe(options));
        this.#legend = new Legend(options.x, entries, (series, shown) => this.#plot.setSeries(series, { show: shown }));
        const table = foldedTable(options.title, () => [options.x, ...options.lines]);
        this.element.replaceChildren(caption, this.#surface, this.#legend.element, table);
        const loop = !grows(options.x.values);
        const made = loop ? loopPlot(options, entries) : timePlot(options, entries);
        made.options.hooks = {
            setCursor: [(plot) => this.#legend.show(...(loop ? nearest(plot) : valuesAt(plot)))],
            draw: [(plot) => drawMarks(plot, options.marks ?? [])],
        };
        this.#plot = new uPlot({ ...made.options, ...this.#size() }, made.data, this.#surface);
        this.#whole = made.whole;
    }
}

interface Made {
    options: Omit<uPlot.Options, "width" | "height">;
    data: uPlot.AlignedData;
    whole: Ranges;
}

/** What a screen reader says of the drawing. */
function describe(options: PlotOptions): string {
    const lines = options.lines.map((line) => titled(line.label, line.unit)).join(", ");
    return `Plot of ${lines} over ${titled(options.x.label, options.x.unit)}. Plus and minus zoom, arrows move, 0 shows everything. The numbers follow as a table.`;
}

function entry(line: TableColumn, k: number): LegendEntry {
    return { label: line.label, unit: line.unit, colour: css(`--line-${(k % 8) + 1}`), dash: k >= 8 };
}

function css(name: string): string {
    return getComputedStyle(document.documentElement).getPropertyValue(name).trim() || "#888888";
}

function grows(values: ArrayLike<number>): boolean {
    for (let k = 1; k < values.length; k++) {
        if (!(values[k]! >= values[k - 1]!)) {
            return false;
        }
    }
    return values.length === 0 || Number.isFinite(values[0]!);
}

/** The range of all finite values; a little wider than nothing. */
function extent(columns: ArrayLike<number>[]): [number, number] {
    let [low, high] = [Infinity, -Infinity];
    for (const values of columns) {
        for (let k = 0; k < values.length; k++) {
            const value = values[k]!;
            if (Number.isFinite(value)) {
                low = Math.min(low, value);
                high = Math.max(high, value);
            }
        }
    }
    if (low > high) {
        return [0, 1];
    }
    const pad = 0.5 * Math.abs(low) || 0.5;
    return high > low ? [low, high] : [low - pad, high + pad];
}

/** Values with gaps where there is none to draw. */
function drawable(values: ArrayLike<number>, log: boolean): (number | null)[] {
    return Array.from(values, (v) => (Number.isFinite(v) && (!log || v > 0) ? v : null));
}

function axes(options: PlotOptions): uPlot.Axis[] {
    const line = { stroke: css("--ink-soft"), grid: { stroke: css("--grid"), width: 1 }, ticks: { stroke: css("--grid"), width: 1 } };
    const units = [...new Set(options.lines.map((l) => l.unit))];
    const only = options.lines.length === 1 ? options.lines[0]!.label : "";
    const vertical = units.length === 1 ? titled(only, units[0]!) : "";
    const numbers = (_: uPlot, ticks: number[]) => ticks.map((tick) => tickText(tick));
    return [
        { ...line, label: titled(options.x.label, options.x.unit), labelSize: 20, size: 36, values: numbers },
        { ...line, label: vertical, labelSize: vertical ? 20 : 4, size: 62, values: options.log ? (_, ticks) => ticks.map(logTick) : numbers },
    ];
}

function tickText(tick: number | null): string {
    if (tick == null) {
        return "";
    }
    const size = Math.abs(tick);
    const text = size !== 0 && (size >= 1e5 || size < 1e-3) ? tick.toExponential(2).replace(/\.?0+e/, "e").replace("e+", "e") : String(Number(tick.toPrecision(6)));
    return text.replaceAll("-", "−");
}

/** Powers of ten only. */
function logTick(tick: number | null): string {
    return tick != null && Math.abs(Math.log10(tick) - Math.round(Math.log10(tick))) < 1e-6 ? `1e${Math.round(Math.log10(tick))}`.replace("-", "−") : "";
}

function common(options: PlotOptions, entries: LegendEntry[]): Omit<uPlot.Options, "width" | "height" | "series"> & { series: uPlot.Series[] } {
    const bars = options.bars ? uPlot.paths.bars!({ size: [1, Infinity], align: 0 }) : null;
    const series = entries.map((e): uPlot.Series => ({
        label: e.label,
        stroke: e.colour,
        width: 1.6,
        points: { show: options.bars ? false : options.x.values.length < 40, size: 5 },
        ...(e.dash ? { dash: [6, 4] } : {}),
        ...(bars ? { paths: bars, fill: `${e.colour}59`, width: 1 } : {}),
    }));
    return { legend: { show: false }, axes: axes(options), series };
}

/** Lines whose horizontal values grow. */
function timePlot(options: PlotOptions, entries: LegendEntry[]): Made {
    const shared = common(options, entries);
    const whole = extent([options.x.values]);
    if (options.bars && options.x.values.length > 1) {
        const half = (options.x.values[1]! - options.x.values[0]!) / 2;
        whole[0] -= half;
        whole[1] += half;
    }
    const log = options.log ?? false;
    return {
        options: {
            ...shared,
            series: [{}, ...shared.series],
            scales: {
                x: { time: false, range: (_, min, max) => (min == null || max == null || !(max > min) ? whole : inside([min, max], whole)) },
                y: log ? { distr: 3 } : options.bars ? { range: (_, __, max) => [0, 1.05 * max || 1] } : {},
            },
            cursor: { drag: { x: true, y: false }, y: false, points: { show: !options.bars } },
        },
        data: [Array.from(options.x.values), ...options.lines.map((line) => drawable(line.values, log))],
        whole: { x: whole },
    };
}

/** Keeps a range within another. */
function inside([min, max]: [number, number], [low, high]: [number, number]): [number, number] {
    const width = Math.min(max - min, high - low);
    const start = Math.min(Math.max(min, low), high - width);
    return [start, start + width];
}

/** Lines whose horizontal values come back: paths in the order of the rows. */
function loopPlot(options: PlotOptions, entries: LegendEntry[]): Made {
    const log = options.log ?? false;
    const shared = common(options, entries);
    const x = padded(extent([options.x.values]));
    const rows = options.lines.map((line) => drawable(line.values, log));
    const all = extent(rows.map((values) => values.filter((v): v is number => v !== null)));
    const y: [number, number] = log ? all : padded(all);
    const facets = ["x", "y"].map((scale) => ({ scale, auto: true }));
    const xs = Array.from(options.x.values);
    return {
        options: {
            ...shared,
            mode: 2,
            series: [null as unknown as uPlot.Series, ...shared.series.map((s) => ({ ...s, facets, paths: loopPath, points: { show: false } }))],
            scales: {
                x: { time: false, auto: false, range: (_, min, max) => (min == null || max == null || !(max > min) ? x : [min, max]) },
                y: { auto: false, ...(log ? { distr: 3 as const } : {}), range: (_, min, max) => (min == null || max == null || !(max > min) ? y : [min, max]) },
            },
            cursor: { drag: { x: true, y: true, uni: 30 }, points: { show: false } },
        },
        data: [null, ...rows.map((values) => [xs, values])] as unknown as uPlot.AlignedData,
        whole: { x, y },
    };
}

function padded([low, high]: [number, number]): [number, number] {
    const pad = 0.04 * (high - low);
    return [low - pad, high + pad];
}

/** The line through the rows in their order, with gaps where there is no value. */
const loopPath: uPlot.Series.PathBuilder = (plot, series) => {
    const [xs, ys] = plot.data[series] as unknown as [number[], (number | null)[]];
    const stroke = new Path2D();
    let pen = false;
    for (let k = 0; k < xs.length; k++) {
        const [x, y] = [xs[k]!, ys[k] ?? null];
        if (y === null || !Number.isFinite(x)) {
            pen = false;
            continue;
        }
        const place: [number, number] = [plot.valToPos(x, "x", true), plot.valToPos(y, "y", true)];
        if (pen) {
            stroke.lineTo(...place);
        } else {
            stroke.moveTo(...place);
        }
        pen = true;
    }
    return { stroke, fill: null, clip: null, flags: 0 } as unknown as uPlot.Series.Paths;
};

/** The row of a loop that is drawn nearest to the cursor. */
function nearest(plot: uPlot): [number | null, (number | null)[]] {
    const { left, top } = plot.cursor;
    const lines = plot.data.slice(1) as unknown as [number[], (number | null)[]][];
    if (left == null || top == null || left < 0 || lines.length === 0) {
        return [null, []];
    }
    let [found, distance] = [-1, 60 ** 2];
    for (const [xs, ys] of lines) {
        for (let k = 0; k < xs.length; k++) {
            const y = ys[k];
            const away = y == null ? Infinity : (plot.valToPos(xs[k]!, "x") - left) ** 2 + (plot.valToPos(y, "y") - top) ** 2;
            if (away < distance) {
                [found, distance] = [k, away];
            }
        }
    }
    return found < 0 ? [null, []] : [lines[0]![0][found]!, lines.map(([, ys]) => ys[found] ?? null)];
}

function drawMarks(plot: uPlot, marks: Mark[]): void {
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.strokeStyle = ctx.fillStyle = css("--ink-soft");
    ctx.lineWidth = window.devicePixelRatio;
    ctx.setLineDash([2 * window.devicePixelRatio, 3 * window.devicePixelRatio]);
    ctx.font = `${11 * window.devicePixelRatio}px system-ui, sans-serif`;
    let free = -Infinity;
    for (const { at, label } of marks) {
        const x = plot.valToPos(at, "x", true);
        if (x < bbox.left || x > bbox.left + bbox.width) {
            continue;
        }
        ctx.beginPath();
        ctx.moveTo(x, bbox.top);
        ctx.lineTo(x, bbox.top + bbox.height);
        ctx.stroke();
        const width = ctx.measureText(label).width;
        if (x > free && x + width < bbox.left + bbox.width) {
            ctx.fillText(label, x + 4 * window.devicePixelRatio, bbox.top + 12 * window.devicePixelRatio);
            free = x + width + 12 * window.devicePixelRatio;
        }
    }
    ctx.restore();
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
