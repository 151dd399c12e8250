// The way of a grain over the moments of a run, read from coarse to fine: its plot is whole from the beginning, and gains detail.
import { readHistory, type GrainMoment } from "./api";

/** Moments that are asked for together; the server tells as many of them as it reads quickly. */
const CHUNK = 24;
/** Requests at a time. */
const READERS = 2;

/** One grain. */
export class History {
    readonly id: number;
    readonly #told: (GrainMoment | null | undefined)[] = [];
    #reading = false;
    /** How many moments there were when it was asked for more meanwhile. */
    #more = 0;
    #stopped = false;

    constructor(id: number) {
        this.id = id;
    }

    /** Nothing more is read. */
    stop(): void {
        this.#stopped = true;
    }

    /** The moments that were read, in order, with what was told; `null` where the grain is not there. */
    known(): [index: number, moment: GrainMoment | null][] {
        return [...this.#told.entries()].filter((entry): entry is [number, GrainMoment | null] => entry[1] !== undefined);
    }

    /** Reads what is missing of so many moments, and tells each time that more is known. */
    async read(count: number, grown: () => void): Promise<void> {
        if (this.#reading) {
            // what came since is read when all else is
            this.#more = count;
            return;
        }
        const left = coarseToFine(count).filter((k) => this.#told[k] === undefined);
        this.#reading = true;
        this.#more = 0;
        const work = async () => {
            while (left.length > 0 && !this.#stopped) {
                const asked = left.splice(0, CHUNK);
                const { moments } = await readHistory(this.id, asked);
                // of a moment that has gone nothing is told, nor of those behind it
                left.unshift(...(moments.length > 0 ? asked.slice(moments.length) : []));
                moments.forEach((moment, k) => (this.#told[asked[k]!] = moment));
                if (!this.#stopped) {
                    grown();
                }
            }
        };
        try {
            await Promise.all(Array.from({ length: READERS }, work));
        } finally {
            this.#reading = false;
        }
        if (this.#more > count && !this.#stopped) {
            await this.read(this.#more, grown);
        }
    }
}

/** Numbers from 0 up to a count: the first and the last one, then those half-way between, and so on. */
export function coarseToFine(count: number): number[] {
    const order = count > 1 ? [0, count - 1] : count > 0 ? [0] : [];
    let stride = 1;
    while (2 * stride < count) {
        stride *= 2;
    }
    for (; stride >= 1; stride /= 2) {
        for (let k = stride; k < count - 1; k += 2 * stride) {
            order.push(k);
        }
    }
    return order;
}
