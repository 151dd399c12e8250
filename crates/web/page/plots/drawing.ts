// How uPlot draws the lines of a plot: over an axis that grows, or as loops over one that comes back.
import uPlot from "uplot";
import type { PlotOptions } from "../plots";
import { titled } from "../units";
import type { LegendEntry } from "./legend";
import type { TableColumn } from "./table";
import type { Ranges } from "./zoom";

export interface Made {
    options: Omit<uPlot.Options, "width" | "height">;
    data: uPlot.AlignedData;
    whole: Ranges;
}

/** What a screen reader says of the drawing. */
export function describe(options: PlotOptions): string {
    const lines = options.lines.map((line) => titled(line.label, line.unit)).join(", ");
    return `Plot of ${lines} over ${titled(options.x.label, options.x.unit)}. Plus and minus zoom, arrows move, 0 shows everything. The numbers follow as a table.`;
}

export function entry(line: TableColumn, k: number): LegendEntry {
    return { label: line.label, unit: line.unit, colour: css(`--line-${(k % 8) + 1}`), dash: k >= 8 };
}

export function css(name: string): string {
    return getComputedStyle(document.documentElement).getPropertyValue(name).trim() || "#888888";
}

export function grows(values: ArrayLike<number>): boolean {
    for (let k = 1; k < values.length; k++) {
        if (!(values[k]! >= values[k - 1]!)) {
            return false;
        }
    }
    return values.length === 0 || Number.isFinite(values[0]!);
}

/** The range of all finite values; a little wider than nothing. */
export function extent(columns: ArrayLike<number>[]): [number, number] {
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
    const vertical = options.yLabel ?? (units.length === 1 ? titled(only, units[0]!) : "");
    const numbers = (_: uPlot, ticks: number[]) => {
        const largest = ticks.reduce((size, tick) => Math.max(size, Math.abs(tick ?? 0)), 0);
        return ticks.map((tick) => tickText(tick, largest));
    };
    const wide = (_: uPlot, texts: string[] | null) => Math.max(...(texts ?? []).map((text) => text.length * DIGIT + 16), LEAST_WIDE);
    return [
        { ...line, label: titled(options.x.label, options.x.unit), labelSize: 20, size: 36, values: numbers },
        { ...line, label: vertical, labelSize: vertical ? 20 : 4, size: wide, values: options.log ? (_, ticks) => ticks.map(logTick) : numbers },
    ];
}

/** Width of a digit of a tick, and least width of those beside the vertical axis [pixels]. */
const DIGIT = 7.2;
const LEAST_WIDE = 46;

/** The text of a tick; all of an axis are written alike. */
function tickText(tick: number | null, largest: number): string {
    if (tick == null) {
        return "";
    }
    const text = tick !== 0 && (largest >= 1e5 || largest < 1e-2) ? tick.toExponential(2).replace(/\.?0+e/, "e").replace("e+", "e") : String(Number(tick.toPrecision(6)));
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
    // room for the names of marks
    const top = options.marks?.length ? 18 : 8;
    return { legend: { show: false }, axes: axes(options), series, padding: [top, 12, 0, 0] };
}

/** Lines whose horizontal values grow. */
export function timePlot(options: PlotOptions, entries: LegendEntry[]): Made {
    const shared = common(options, entries);
    const whole = extent([options.x.values]);
    if (options.bars && options.x.values.length > 1) {
        const half = (options.x.values[1]! - options.x.values[0]!) / 2;
        whole[0] -= half;
        whole[1] += half;
    }
    const log = options.log ?? false;
    const [first, last] = extent([options.x.values]);
    const seen = (min: number | null, max: number | null): [number, number] => {
        const all = min == null || max == null || !(max > min) || (min <= first && max >= last);
        return all ? whole : inside([min, max], whole);
    };
    return {
        options: {
            ...shared,
            series: [{}, ...shared.series],
            scales: {
                x: { time: false, range: (_, min, max) => seen(min, max) },
                y: log ? { distr: 3 } : options.bars ? { range: (_, __, max) => [0, 1.05 * max || 1] } : { range: (_, min, max) => around(min, max) },
            },
            cursor: { drag: { x: true, y: false }, y: false, points: { show: !options.bars } },
        },
        data: [Array.from(options.x.values), ...options.lines.map((line) => drawable(line.values, log))],
        whole: { x: whole },
    };
}

/** A vertical range with a little room; about a value that never changes, too. */
function around(min: number | null, max: number | null): [number, number] {
    if (min == null || max == null) {
        return [0, 1];
    }
    const pad = Math.abs(min) || 1;
    return min === max ? [min - pad, max + pad] : (uPlot.rangeNum(min, max, 0.1, true) as [number, number]);
}

/** Keeps a range within another. */
function inside([min, max]: [number, number], [low, high]: [number, number]): [number, number] {
    const width = Math.min(max - min, high - low);
    const start = Math.min(Math.max(min, low), high - width);
    return [start, start + width];
}

/** Lines whose horizontal values come back: paths in the order of the rows. */
export function loopPlot(options: PlotOptions, entries: LegendEntry[]): Made {
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
export function nearest(plot: uPlot): [number | null, (number | null)[]] {
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

