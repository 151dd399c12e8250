// Colour maps, as textures for the shaders and as gradients for legends.
import * as THREE from "three";

export type MapName = "viridis" | "cividis" | "coolwarm" | "grey";

// Anchors of the maps in equal steps from the lowest value to the highest; between them sRGB is mixed.
// viridis and cividis as in matplotlib (CC0), coolwarm after K. Moreland (2009).
const ANCHORS: Record<MapName, string[]> = {
    viridis: ["#440154", "#482878", "#3e4989", "#31688e", "#26828e", "#1f9e89", "#35b779", "#6ece58", "#b5de2b", "#fde725"],
    cividis: ["#00224e", "#123570", "#3b496c", "#575d6d", "#707173", "#8a8678", "#a59c74", "#c3b369", "#e1cc55", "#fee838"],
    coolwarm: ["#3b4cc0", "#6788ee", "#9abbff", "#c9d7f0", "#edd1c2", "#f7a889", "#e26952", "#b40426"],
    grey: ["#303030", "#f0f0f0"],
};

/** Colours of categories (materials, tags): the bright scheme of P. Tol, told apart by the colour-blind. */
export const CATEGORY_COLOURS = ["#4477aa", "#ee6677", "#228833", "#ccbb44", "#66ccee", "#aa3377", "#bbbbbb", "#ee8866", "#44bb99", "#99ddff"];

/** Colour of a value that is not a number. */
export const NO_VALUE_COLOUR = "#909090";

const SIZE = 256;

function parse(hex: string): [number, number, number] {
    const n = parseInt(hex.slice(1), 16);
    return [(n >> 16) & 255, (n >> 8) & 255, n & 255];
}

/** The colour of a map at `t` from 0 to 1, as sRGB bytes. */
export function mapColour(map: MapName, t: number): [number, number, number] {
    const anchors = ANCHORS[map];
    const at = Math.min(Math.max(t, 0), 1) * (anchors.length - 1);
    const low = Math.min(Math.floor(at), anchors.length - 2);
    const a = parse(anchors[low]!);
    const b = parse(anchors[low + 1]!);
    const mix = (i: 0 | 1 | 2) => Math.round(a[i] + (b[i] - a[i]) * (at - low));
    return [mix(0), mix(1), mix(2)];
}

/** A gradient for legends. */
export function mapGradient(map: MapName): string {
    return `linear-gradient(to right, ${ANCHORS[map].join(", ")})`;
}

function texture(colour: (i: number) => [number, number, number]): THREE.DataTexture {
    const data = new Uint8Array(4 * SIZE);
    for (let i = 0; i < SIZE; i++) {
        data.set([...colour(i), 255], 4 * i);
    }
    const made = new THREE.DataTexture(data, SIZE, 1, THREE.RGBAFormat);
    made.minFilter = made.magFilter = THREE.NearestFilter;
    made.needsUpdate = true;
    return made;
}

/** A map as a texture of 256 colours. */
export function mapTexture(map: MapName): THREE.DataTexture {
    return texture((i) => mapColour(map, i / (SIZE - 1)));
}

/** The colours of categories as a texture: category `k` has the colour at `k` modulo their number. */
export function categoryTexture(): THREE.DataTexture {
    return texture((i) => parse(CATEGORY_COLOURS[i % CATEGORY_COLOURS.length]!));
}

/** The colour of a category, for legends. */
export function categoryColour(k: number): string {
    const n = CATEGORY_COLOURS.length;
    return CATEGORY_COLOURS[((k % n) + n) % n]!;
}

/** Of more values than this, some tell where most of them lie. */
const MANY = 20_000;

/** What values are like. */
export interface Spread {
    low: number;
    high: number;
    /** Whether there is none for some grain. */
    gaps: boolean;
    /** The range that a colour map spans. */
    range: [number, number];
}

/**
 * The smallest and the largest value, and the range that a colour map spans: from the one to the other, but where few values lie
 * far out (beyond three times the span of the middle 98 %), they are left outside, so that the others can be told apart.
 */
export function spreadOf(values: Float32Array): Spread {
    let [low, high, finite] = [Infinity, -Infinity, 0];
    for (let k = 0; k < values.length; k++) {
        const value = values[k]!;
        if (value - value === 0) {
            finite += 1;
            low = value < low ? value : low;
            high = value > high ? value : high;
        }
    }
    const gaps = finite < values.length;
    if (finite === 0) {
        return { low: NaN, high: NaN, gaps, range: [0, 1] };
    }
    const [q1, q99] = middle(values);
    let range: [number, number] = [low, high];
    if (high - low > 3 * (q99 - q1) && q99 > q1) {
        range = [Math.max(low, q1 - (q99 - q1)), Math.min(high, q99 + (q99 - q1))];
    }
    if (!(range[1] > range[0])) {
        // all are alike; what is nothing for all has the first colour
        range = low === 0 ? [0, 1] : [low - 0.5 * Math.abs(low), low + 0.5 * Math.abs(low)];
    }
    return { low, high, gaps, range };
}

/** Between which values the middle 98 % lie. */
function middle(values: Float32Array): [number, number] {
    const stride = Math.ceil(values.length / MANY);
    const some = stride > 1 ? Float32Array.from({ length: Math.floor(values.length / stride) }, (_, k) => values[k * stride]!) : values;
    const finite = some.filter(Number.isFinite).sort();
    const at = (share: number) => finite[Math.round(share * (finite.length - 1))] ?? 0;
    return [at(0.01), at(0.99)];
}
