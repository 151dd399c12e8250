// What the server of `demeter view` answers.

export interface Column {
    name: string;
    unit: string;
    /** Whether it holds numbers; columns of words (the stage) cannot be plotted. */
    numbers: boolean;
}

export interface Stage {
    name: string;
    /** Its rows in the series, from and up to, the last one left out. */
    from: number;
    to: number;
}

export interface RunState {
    version: string;
    folder: string;
    title: string;
    /** Grows when moments or rows went away: what was read before is then of no use. */
    epoch: number;
    going_on: boolean;
    summary: { finished: boolean; stopped_by: string; warnings: string[] } | null;
    moments: { from: number; count: number; steps: number[]; times: number[] };
    series: { rows: number; columns: Column[]; stages: Stage[] } | null;
    /** Why the series cannot be read. */
    fault: string | null;
}

export interface GrainContact {
    partner: number;
    /** Index of the wall, -1 between grains. */
    wall: number;
    element: number;
    overlap: number | null;
    /** Away from the partner. */
    normal: [number, number, number];
    /** Repulsion is positive [N]. */
    normal_force: number | null;
    tangential_force: number | null;
}

export interface GrainAnswer {
    id: number;
    step: number;
    time: number;
    values: Record<string, number | string | (number | null)[] | null>;
    contacts: GrainContact[];
}

/** A grain at a moment. */
export interface GrainMoment {
    position: [number, number, number];
    speed: number | null;
    force: number | null;
    contact_force: number | null;
    coordination: number | null;
}

/** The server said no, or is gone. */
export class ServerError extends Error {}

async function get(path: string, signal?: AbortSignal): Promise<Response> {
    let response: Response;
    try {
        response = await fetch(path, signal ? { signal } : {});
    } catch (error) {
        if (signal?.aborted) {
            throw error;
        }
        throw new ServerError("The server does not answer. Is `demeter view` still running?");
    }
    if (!response.ok) {
        const told = (await response.json().catch(() => ({}))) as { error?: string };
        throw new ServerError(told.error ?? `The server answers ${response.status}.`);
    }
    return response;
}

async function json<T>(path: string): Promise<T> {
    return (await (await get(path)).json()) as T;
}

export const readState = (moments: number) => json<RunState>(`api/state?moments=${moments}`);
export const readGrain = (step: number, id: number) => json<GrainAnswer>(`api/grain/${step}/${id}`);
/** A grain at the first of these moments, as many as the server tells quickly. */
export const readHistory = (id: number, moments: number[]) =>
    json<{ epoch: number; moments: (GrainMoment | null)[] }>(`api/history/${id}?moments=${moments.join(",")}`);
export const readSeries = (columns: number[], from: number) => readPack(`api/series?columns=${columns.join(",")}&from=${from}`);

type Numbers = Float32Array | Float64Array | Uint32Array | Int32Array;
const TYPES = { f32: Float32Array, f64: Float64Array, u32: Uint32Array, i32: Int32Array } as const;

/** Numbers with a head; the arrays are used where they lie. */
export class Pack {
    readonly head: Record<string, unknown>;
    readonly bytes: number;
    readonly #arrays = new Map<string, Numbers>();

    constructor(buffer: ArrayBuffer) {
        const length = new DataView(buffer).getUint32(0, true);
        this.head = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length))) as Record<string, unknown>;
        this.bytes = buffer.byteLength;
        const start = Math.ceil((4 + length) / 8) * 8;
        for (const { name, type, place, length } of this.head["arrays"] as { name: string; type: keyof typeof TYPES; place: number; length: number }[]) {
            this.#arrays.set(name, new TYPES[type](buffer, start + place, length));
        }
    }

    floats(name: string): Float32Array {
        return this.#array(name) as Float32Array;
    }

    doubles(name: string): Float64Array {
        return this.#array(name) as Float64Array;
    }

    counts(name: string): Uint32Array {
        return this.#array(name) as Uint32Array;
    }

    integers(name: string): Int32Array {
        return this.#array(name) as Int32Array;
    }

    #array(name: string): Numbers {
        const found = this.#arrays.get(name);
        if (!found) {
            throw new ServerError(`The server does not tell ${name}.`);
        }
        return found;
    }
}

export async function readPack(path: string, signal?: AbortSignal): Promise<Pack> {
    return new Pack(await (await get(path, signal)).arrayBuffer());
}
