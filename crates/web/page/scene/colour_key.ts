// What colours mean: a bar with its ends, or the names of categories.
import { make } from "../dom";
import { readable, scaled, titled } from "../units";
import type { ColourScale } from "../scene";
import { categoryColour, mapGradient, NO_VALUE_COLOUR } from "./colours";

/** Most names of categories that are listed. */
const MOST_NAMES = 20;

/** Colours that are shown, and the unit of their values. */
export interface ShownScale {
    scale: ColourScale;
    unit: string;
}

/** What is written beside a bar of colours: its title, and the values at its ends. */
export function barTexts({ scale, unit }: ShownScale): { title: string; low: string; high: string } {
    const [low, high] = scale.range;
    const [below, above] = scale.beyond;
    const { unit: shown, factor } = scaled(Math.max(Math.abs(low), Math.abs(high)), unit);
    return {
        title: titled(scale.scalar, shown),
        low: `${below ? "≤ " : ""}${readable(low / factor, 3)}`,
        high: `${above ? "≥ " : ""}${readable(high / factor, 3)}`,
    };
}

/** The key of the colours of a scene. */
export function colourKey({ scale, unit }: ShownScale, values?: Float32Array): HTMLElement {
    const key = make("div", { class: "colour-key" });
    if (scale.names) {
        const present = new Set(values ?? []);
        const shown = scale.names.map((name, k) => [name, k] as const).filter(([, k]) => present.has(k));
        key.append(make("span", { class: "key-title" }, scale.scalar));
        for (const [name, k] of shown.slice(0, MOST_NAMES)) {
            const swatch = make("span", { class: "key-swatch" });
            swatch.style.background = categoryColour(k);
            key.append(make("span", { class: "key-name" }, swatch, name));
        }
        if (shown.length > MOST_NAMES) {
            key.append(`and ${shown.length - MOST_NAMES} more`);
        }
        return key;
    }
    const { title, low, high } = barTexts({ scale, unit });
    const bar = make("span", { class: "key-bar" });
    bar.style.background = mapGradient(scale.map);
    key.append(make("span", { class: "key-title" }, title), make("span", { class: "key-end" }, low), bar, make("span", { class: "key-end" }, high));
    if (scale.gaps) {
        const swatch = make("span", { class: "key-swatch" });
        swatch.style.background = NO_VALUE_COLOUR;
        key.append(make("span", { class: "key-name" }, swatch, "no value"));
    }
    return key;
}
