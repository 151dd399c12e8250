// Zooming a plot without a mouse: by keys and buttons.
import type uPlot from "uplot";

/** The ranges of the scales when everything is seen. */
export type Ranges = Record<string, [number, number]>;

const KEYS: Record<string, (plot: uPlot, whole: Ranges) => void> = {
    "+": (plot) => stretch(plot, 1 / 1.4),
    "=": (plot) => stretch(plot, 1 / 1.4),
    "-": (plot) => stretch(plot, 1.4),
    ArrowLeft: (plot) => shift(plot, -0.15),
    ArrowRight: (plot) => shift(plot, 0.15),
    "0": reset,
    Home: reset,
};

/** Sees everything again. */
export function reset(plot: uPlot, whole: Ranges): void {
    plot.batch(() => {
        for (const [scale, [min, max]] of Object.entries(whole)) {
            plot.setScale(scale, { min, max });
        }
    });
}

/** Zooms about the middle of the horizontal axis. */
export function stretch(plot: uPlot, factor: number): void {
    const { min, max } = plot.scales.x!;
    if (min != null && max != null) {
        const [middle, half] = [(min + max) / 2, (factor * (max - min)) / 2];
        plot.setScale("x", { min: middle - half, max: middle + half });
    }
}

function shift(plot: uPlot, share: number): void {
    const { min, max } = plot.scales.x!;
    if (min != null && max != null) {
        const by = share * (max - min);
        plot.setScale("x", { min: min + by, max: max + by });
    }
}

/** Lets the keys zoom while the surface has the focus. */
export function listenToKeys(surface: HTMLElement, plot: () => uPlot, whole: () => Ranges): void {
    surface.addEventListener("keydown", (event) => {
        const act = KEYS[event.key];
        if (act && event.target === surface && !event.ctrlKey && !event.metaKey && !event.altKey) {
            act(plot(), whole());
            event.preventDefault();
        }
    });
}

/** Buttons that zoom. */
export function zoomButtons(plot: () => uPlot, whole: () => Ranges): HTMLElement {
    const group = document.createElement("span");
    group.className = "zoom-buttons";
    const add = (text: string, label: string, act: () => void) => {
        const button = document.createElement("button");
        button.type = "button";
        button.textContent = text;
        button.setAttribute("aria-label", label);
        button.title = label;
        button.addEventListener("click", act);
        group.append(button);
    };
    add("−", "Zoom out", () => stretch(plot(), 1.4));
    add("+", "Zoom in", () => stretch(plot(), 1 / 1.4));
    add("Reset", "Reset: see everything", () => reset(plot(), whole()));
    return group;
}
