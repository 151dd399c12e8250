// Which grains can be seen: inside a packing most are hidden behind others, and need not be drawn.

/** Grains and from where they are looked at. */
export interface Sight {
    /** Centres, 3n numbers. */
    position: Float32Array;
    radius: Float32Array;
    /** What turns a place into view space, as in `THREE.Matrix4.elements`: turned, moved, and scaled alike in all directions. */
    toView: ArrayLike<number>;
    /** By how much the radii are scaled. */
    scale: number;
    /** Half of the angle of view from below to above, as its tangent. */
    tangent: number;
    /** Width of the picture over its height. */
    aspect: number;
    /** What is nearer is not drawn. */
    near: number;
    /** A plane in view space beyond which nothing is drawn: `a x + b y + c z <= d` stays. */
    clip: [number, number, number, number] | null;
    /** Whether grains hide what is behind them. */
    solid: boolean;
}

/** Of a grain of usual size so many pixels are looked at, from its centre to its edge. */
const PIXELS = 3.5;
/** Least and most rows of pixels that are looked at. */
const ROWS = { least: 64, most: 640 };
/** Pixels of a block on a side, and as a power of 2. */
const BLOCK = 4;
const SHIFT = 2;
/** Distances are told apart by so many steps when grains are put in order. */
const STEPS = 1 << 14;

/**
 * Finds the grains that can be seen, nearest first.
 *
 * No grain that is seen is left out: what hides others are pixels of a coarse picture that lie wholly inside the outline of
 * a grain, at the largest distance of its front; hidden is what is farther in all pixels that its own outline touches.
 */
export class VisibleGrains {
    /** Indices of grains; `count` of them count. */
    readonly found: Uint32Array;
    count = 0;
    readonly #seen: Candidates;
    readonly #order: Uint32Array;
    /** The nearest that is known to hide what is behind it, for every pixel. */
    #depth = new Float32Array();
    #columns = 0;
    #rows = 0;
    /** For every block of pixels: how many of them hide nothing yet, and the farthest of what the others hide from on. */
    #open = new Uint8Array();
    #farthest = new Float32Array();
    #across = 0;

    /** For so many grains. */
    constructor(most: number) {
        this.found = new Uint32Array(most);
        this.#order = new Uint32Array(most);
        this.#seen = new Candidates(most);
    }

    find(sight: Sight): void {
        const seen = this.#seen;
        seen.collect(sight);
        this.count = 0;
        if (!sight.solid) {
            for (let k = 0; k < seen.count; k++) {
                this.found[this.count++] = seen.index[k]!;
            }
            return;
        }
        const rows = Math.min(Math.max(Math.ceil((2 * PIXELS) / seen.usual()), ROWS.least), ROWS.most);
        this.#begin(Math.ceil(rows * sight.aspect), rows);
        // from units of half the height to pixels
        const [half, middle] = [0.5 * rows, 0.5 * this.#columns];
        const order = this.#sorted();
        for (let k = 0; k < order.length; k++) {
            const at = order[k]!;
            const x = middle + half * seen.x[at]!;
            const y = half + half * seen.y[at]!;
            const front = seen.distance[at]! - seen.radius[at]!;
            if (this.#isHidden(x, y, half * seen.outer[at]!, front)) {
                continue;
            }
            this.found[this.count++] = seen.index[at]!;
            if (seen.inner[at]! > 0) {
                this.#cover(x, y, half * seen.inner[at]!, Math.sqrt(front * (seen.distance[at]! + seen.radius[at]!)));
            }
        }
    }

    #begin(columns: number, rows: number): void {
        if (columns !== this.#columns || rows !== this.#rows) {
            this.#depth = new Float32Array(columns * rows);
            [this.#columns, this.#rows] = [columns, rows];
            this.#across = Math.ceil(columns / BLOCK);
            const blocks = this.#across * Math.ceil(rows / BLOCK);
            this.#open = new Uint8Array(blocks);
            this.#farthest = new Float32Array(blocks);
        }
        this.#depth.fill(Infinity);
        this.#open.fill(BLOCK * BLOCK);
        this.#farthest.fill(0);
        // blocks at the edges have fewer pixels
        for (let row = 0; row < rows && columns % BLOCK > 0; row += BLOCK) {
            this.#open[(row / BLOCK) * this.#across + this.#across - 1] = BLOCK * (columns % BLOCK);
        }
        for (let column = 0; column < columns && rows % BLOCK > 0; column += BLOCK) {
            const wide = Math.min(columns - column, BLOCK);
            this.#open[(Math.ceil(rows / BLOCK) - 1) * this.#across + column / BLOCK] = wide * (rows % BLOCK);
        }
    }

    /** The candidates, nearest first, within the steps that distances are told apart by. */
    #sorted(): Uint32Array {
        const { distance, count } = this.#seen;
        let [low, high] = [Infinity, 0];
        for (let k = 0; k < count; k++) {
            low = Math.min(low, distance[k]!);
            high = Math.max(high, distance[k]!);
        }
        const factor = (STEPS - 1) / Math.max(high - low, 1e-30);
        const starts = new Uint32Array(STEPS + 1);
        for (let k = 0; k < count; k++) {
            starts[Math.floor((distance[k]! - low) * factor) + 1]! += 1;
        }
        for (let step = 0; step < STEPS; step++) {
            starts[step + 1]! += starts[step]!;
        }
        for (let k = 0; k < count; k++) {
            this.#order[starts[Math.floor((distance[k]! - low) * factor)]!++] = k;
        }
        return this.#order.subarray(0, count);
    }

    /** Whether all pixels that a circle touches show what is nearer than `front`. */
    #isHidden(x: number, y: number, radius: number, front: number): boolean {
        return this.#blocksHide(x, y, radius, front) || this.#pixelsHide(x, y, radius, front);
    }

    /** Whether all blocks around a circle do. */
    #blocksHide(x: number, y: number, radius: number, front: number): boolean {
        const right = Math.min(Math.floor(x + radius), this.#columns - 1) >> SHIFT;
        const bottom = Math.min(Math.floor(y + radius), this.#rows - 1) >> SHIFT;
        const left = Math.max(Math.floor(x - radius), 0) >> SHIFT;
        for (let row = Math.max(Math.floor(y - radius), 0) >> SHIFT; row <= bottom; row++) {
            for (let at = row * this.#across + left; at <= row * this.#across + right; at++) {
                if (this.#open[at]! > 0 || this.#farthest[at]! > front) {
                    return false;
                }
            }
        }
        return true;
    }

    #pixelsHide(x: number, y: number, radius: number, front: number): boolean {
        const columns = this.#columns;
        const depth = this.#depth;
        const last = Math.min(Math.floor(y + radius), this.#rows - 1);
        for (let row = Math.max(Math.floor(y - radius), 0); row <= last; row++) {
            // the part of the row that is nearest to the centre
            const away = Math.max(Math.abs(row + 0.5 - y) - 0.5, 0);
            const reach = Math.sqrt(Math.max(radius * radius - away * away, 0));
            const end = row * columns + Math.min(Math.floor(x + reach), columns - 1);
            for (let at = row * columns + Math.max(Math.floor(x - reach), 0); at <= end; at++) {
                if (depth[at]! > front) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Marks the pixels that lie wholly inside a circle as hidden from `distance` on. */
    #cover(x: number, y: number, radius: number, distance: number): void {
        const columns = this.#columns;
        const depth = this.#depth;
        const last = Math.min(Math.ceil(y + radius), this.#rows - 1);
        for (let row = Math.max(Math.floor(y - radius), 0); row <= last; row++) {
            const away = Math.abs(row + 0.5 - y) + 0.5;
            const square = radius * radius - away * away;
            if (square <= 0) {
                continue;
            }
            const reach = Math.sqrt(square);
            const first = row * columns;
            const blocks = (row >> SHIFT) * this.#across;
            const end = first + Math.min(Math.floor(x + reach) - 1, columns - 1);
            for (let at = first + Math.max(Math.ceil(x - reach), 0); at <= end; at++) {
                const before = depth[at]!;
                if (before > distance) {
                    depth[at] = distance;
                    if (before === Infinity) {
                        const block = blocks + ((at - first) >> SHIFT);
                        this.#open[block]! -= 1;
                        if (distance > this.#farthest[block]!) {
                            this.#farthest[block] = distance;
                        }
                    }
                }
            }
        }
    }
}

/** Grains in front of the eye: where they are in the picture, in units of half its height from its middle. */
class Candidates {
    count = 0;
    readonly index: Uint32Array;
    readonly x: Float32Array;
    readonly y: Float32Array;
    /** The outline is between two circles about the centre; the inner one is 0 where the grain hides nothing. */
    readonly inner: Float32Array;
    readonly outer: Float32Array;
    /** Distance of the centre from the eye. */
    readonly distance: Float32Array;
    readonly radius: Float32Array;

    constructor(most: number) {
        this.index = new Uint32Array(most);
        const numbers = () => new Float32Array(most);
        [this.x, this.y, this.inner, this.outer, this.distance, this.radius] = [numbers(), numbers(), numbers(), numbers(), numbers(), numbers()];
    }

    collect({ position, radius, toView: m, scale, tangent, aspect, near, clip }: Sight): void {
        this.count = 0;
        const [a, b, c, d] = clip ?? [0, 0, 0, Infinity];
        const n = radius.length;
        for (let k = 0; k < n; k++) {
            const px = position[3 * k]!;
            const py = position[3 * k + 1]!;
            const pz = position[3 * k + 2]!;
            const x = m[0]! * px + m[4]! * py + m[8]! * pz + m[12]!;
            const y = m[1]! * px + m[5]! * py + m[9]! * pz + m[13]!;
            const ahead = -(m[2]! * px + m[6]! * py + m[10]! * pz + m[14]!);
            const r = radius[k]! * scale;
            const beyond = clip ? a * x + b * y - c * ahead - d : -Infinity;
            // what is not a number is not drawn either
            if (!(beyond <= r && ahead + r > near && r > 0)) {
                continue;
            }
            const distance = Math.sqrt(x * x + y * y + ahead * ahead);
            if (!(distance < FARTHEST)) {
                continue;
            }
            const sine = r / distance;
            const cosine = ahead / distance;
            // cosine of the largest angle from the axis at which the grain is seen
            const widest = cosine * Math.sqrt(1 - sine * sine) - Math.sqrt(Math.max(1 - cosine * cosine, 0)) * sine;
            const at = x / (ahead * tangent);
            const high = y / (ahead * tangent);
            const outer = sine / (cosine * widest * tangent);
            const around = !(widest > 0.01);
            if (!around && (Math.abs(at) - outer > aspect || Math.abs(high) - outer > 1)) {
                continue;
            }
            const here = this.count++;
            this.index[here] = k;
            // what surrounds the eye, or nearly so, is everywhere in the picture
            this.x[here] = around ? 0 : at;
            this.y[here] = around ? 0 : high;
            this.outer[here] = around ? 4 * aspect : outer * ROUNDED_UP;
            this.inner[here] = around || beyond > -r || ahead - r < near ? 0 : (sine / tangent) * ROUNDED_DOWN;
            this.distance[here] = distance;
            this.radius[here] = around ? distance : r;
        }
    }

    /** The radius of a usual grain in the picture. */
    usual(): number {
        let [sum, number] = [0, 0];
        const stride = Math.max(Math.floor(this.count / 1000), 1);
        for (let k = 0; k < this.count; k += stride) {
            sum += Math.min(this.outer[k]!, 1);
            number += 1;
        }
        return number > 0 ? Math.max(sum / number, 1e-6) : 1;
    }
}

/** Numbers of 32 bits round: circles are taken a little larger, or smaller, than they are. */
const ROUNDED_UP = 1 + 1e-5;
const ROUNDED_DOWN = 1 - 1e-5;
/** Beyond this distance nothing is drawn; the content of a scene has a size of about 1. */
const FARTHEST = 1e6;
