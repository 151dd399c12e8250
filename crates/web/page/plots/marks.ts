// Vertical lines with a text, such as the starts of stages.
import type uPlot from "uplot";
import type { Mark } from "../plots";
import { css } from "./drawing";

/** Draws those marks that are in the range; texts that would overlap are left out. */
export function drawMarks(plot: uPlot, marks: Mark[]): void {
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.strokeStyle = ctx.fillStyle = css("--ink-soft");
    ctx.lineWidth = window.devicePixelRatio;
    ctx.setLineDash([2 * window.devicePixelRatio, 3 * window.devicePixelRatio]);
    ctx.font = `${11 * window.devicePixelRatio}px system-ui, sans-serif`;
    ctx.textAlign = "left";
    ctx.textBaseline = "alphabetic";
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
            ctx.fillText(label, x + 4 * window.devicePixelRatio, bbox.top - 5 * window.devicePixelRatio);
            free = x + width + 12 * window.devicePixelRatio;
        }
    }
    ctx.restore();
}


/** A line at the moment that is shown elsewhere. */
export function drawNow(plot: uPlot, now: number | null): void {
    const { ctx, bbox } = plot;
    const x = now === null ? NaN : plot.valToPos(now, "x", true);
    if (!(x >= bbox.left && x <= bbox.left + bbox.width)) {
        return;
    }
    ctx.save();
    ctx.strokeStyle = css("--accent");
    ctx.lineWidth = 2 * window.devicePixelRatio;
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    ctx.restore();
}
