// Frames that were read, within a bound; those that come next are read ahead.
import type { WallSurface } from "../scene";
import type { PackingState, ScalarInfo } from "../scene_panel";
import { readPack, type Pack } from "./api";

/** Most bytes of frames that are kept. */
const MOST_BYTES = 600e6;

export interface Frame extends PackingState {
    step: number;
    time: number;
    bytes: number;
}

interface ToldScalar extends ScalarInfo {
    names: string[] | null;
    label: boolean;
}

/** Reads frames by their steps and keeps them. */
export class Frames {
    /** The oldest first. */
    readonly #kept = new Map<number, Frame>();
    readonly #asked = new Map<number, { answer: Promise<Frame>; stop: AbortController }>();
    readonly #chains = new Map<number, Promise<Pack>>();
    readonly #walls = new Map<string, Promise<WallSurface[]>>();
    #bytes = 0;

    /** Forgets everything: the run was begun anew. */
    clear(): void {
        for (const { stop } of this.#asked.values()) {
            stop.abort();
        }
        this.#kept.clear();
        this.#asked.clear();
        this.#chains.clear();
        this.#walls.clear();
        this.#bytes = 0;
    }

    /** A frame that was read, or nothing. */
    peek(step: number): Frame | undefined {
        const frame = this.#kept.get(step);
        if (frame) {
            this.#kept.delete(step);
            this.#kept.set(step, frame);
        }
        return frame;
    }

    get(step: number): Promise<Frame> {
        const kept = this.peek(step);
        return kept ? Promise.resolve(kept) : this.#ask(step);
    }

    /** Reads frames that will be wanted, with their contacts where chains are drawn of them. */
    prefetch(steps: number[], withChains: boolean): void {
        for (const step of steps) {
            const kept = this.#kept.get(step);
            const frame = kept ? Promise.resolve(kept) : this.#ask(step);
            frame.then((read) => (withChains ? this.readChains(read) : undefined)).catch(() => undefined);
        }
    }

    /** Reads the contacts of a frame, to draw force chains of them. */
    async readChains(frame: Frame): Promise<void> {
        const { contacts, step } = frame;
        if (!contacts || contacts.chains) {
            return;
        }
        let reading = this.#chains.get(step);
        if (!reading) {
            reading = readPack(`api/contacts/${step}`).finally(() => this.#chains.delete(step));
            this.#chains.set(step, reading);
        }
        const pack = await reading;
        if (!contacts.chains) {
            contacts.chains = { ends: pack.floats("ends"), normalForce: pack.floats("normal_force") };
            frame.bytes += pack.bytes;
            if (this.#kept.get(step) === frame) {
                this.#bytes += pack.bytes;
                this.#drop(step);
            }
        }
    }

    /** Gives up what is being read and not among these. */
    only(steps: number[]): void {
        for (const [step, { stop }] of this.#asked) {
            if (!steps.includes(step)) {
                stop.abort();
                this.#asked.delete(step);
            }
        }
    }

    #ask(step: number): Promise<Frame> {
        const running = this.#asked.get(step);
        if (running) {
            return running.answer;
        }
        const stop = new AbortController();
        const answer = this.#read(step, stop.signal).finally(() => {
            if (this.#asked.get(step)?.stop === stop) {
                this.#asked.delete(step);
            }
        });
        this.#asked.set(step, { answer, stop });
        return answer;
    }

    async #read(step: number, signal: AbortSignal): Promise<Frame> {
        const pack = await readPack(`api/frame/${step}`, signal);
        const frame = frameOf(pack, await this.#wallsOf(step, String(pack.head["walls"])));
        if (!signal.aborted) {
            this.#keep(frame);
        }
        return frame;
    }

    /** Walls that stand still are read once. */
    #wallsOf(step: number, key: string): Promise<WallSurface[]> {
        let walls = this.#walls.get(key);
        if (!walls) {
            walls = readPack(`api/walls/${step}`).then(surfacesOf);
            walls.catch(() => this.#walls.delete(key));
            this.#walls.set(key, walls);
        }
        return walls;
    }

    #keep(frame: Frame): void {
        this.#kept.set(frame.step, frame);
        this.#bytes += frame.bytes;
        this.#drop(frame.step);
    }

    /** Drops the oldest frames as long as there are too many, but not this one. */
    #drop(needed: number): void {
        for (const [step, old] of this.#kept) {
            if (this.#bytes <= MOST_BYTES || step === needed) {
                break;
            }
            this.#kept.delete(step);
            this.#bytes -= old.bytes;
        }
    }
}

function frameOf(pack: Pack, walls: WallSurface[]): Frame {
    const told = pack.head["scalars"] as ToldScalar[];
    const contacts = pack.head["contacts"] as { count: number; mean_force: number | null };
    return {
        step: pack.head["step"] as number,
        time: pack.head["time"] as number,
        bytes: pack.bytes,
        grains: {
            position: pack.floats("position"),
            radius: pack.floats("radius"),
            id: pack.counts("id"),
            scalars: new Map(told.map(({ name }) => [name, pack.floats(name)])),
            categories: new Map(told.flatMap(({ name, names }) => (names ? [[name, names] as const] : []))),
        },
        contacts: { count: contacts.count, meanForce: contacts.mean_force ?? 0, chains: null },
        walls,
        scalars: told.map(({ name, unit, meaning }) => ({ name, unit, meaning })),
    };
}

function surfacesOf(pack: Pack): WallSurface[] {
    const triangles = pack.floats("triangles");
    const list = pack.head["list"] as { name: string; index: number; start: number; end: number }[];
    return list.map(({ name, index, start, end }) => ({ name, index, triangles: triangles.slice(9 * start, 9 * end) }));
}
