// The way of a grain over the moments of a run, read from coarse to fine: its plot is whole from the beginning, and gains detail.
import { readHistory, type GrainMoment } from "./api";

/** Moments that are asked for together; the server tells as many of them as it reads quickly. */
const CHUNK = 24;
/** Requests at a time. */
const READERS = 2;

/** What is told together: how the grain moves, or what its contacts push with, for which the server reads more. */
export type Kind = "motion" | "contacts";

/** One grain. */
export class History {
    readonly id: number;
    readonly #told: Record<Kind, (GrainMoment | null | undefined)[]> = { motion: [], contacts: [] };
    #reading: Kind | null = null;
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
    known(kind: Kind): [index: number, moment: GrainMoment | null][] {
        return [...this.#told[kind].entries()].filter((entry): entry is [number, GrainMoment | null] => entry[1] !== undefined);
    }

    /** Reads what is missing of so many moments, and tells each time that more is known. What is being read of another kind is left. */
    async read(kind: Kind, count: number, grown: () => void): Promise<void> {
        if (this.#reading === kind) {
            // what came since is read when all else is
            this.#more = count;
            return;
        }
        const told = this.#told[kind];
        const left = coarseToFine(count).filter((k) => told[k] === undefined);
        const isWanted = () => !this.#stopped && this.#reading === kind;
        this.#reading = kind;
        this.#more = 0;
        const work = async () => {
            while (left.length > 0 && isWanted()) {
                const asked = left.splice(0, CHUNK);
                const { moments } = await readHistory(this.id, asked, kind === "contacts");
                // of a moment that has gone nothing is told, nor of those behind it
                left.unshift(...(moments.length > 0 ? asked.slice(moments.length) : []));
                moments.forEach((moment, k) => (told[asked[k]!] = moment));
                if (isWanted()) {
                    grown();
                }
            }
        };
        try {
            await Promise.all(Array.from({ length: READERS }, work));
        } finally {
            if (this.#reading === kind) {
                this.#reading = null;
            }
        }
        if (this.#more > count && !this.#stopped && this.#reading === null) {
            await this.read(kind, this.#more, grown);
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
