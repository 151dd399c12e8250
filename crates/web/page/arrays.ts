// Numbers of a page, which are base64 of their little-endian bytes.

export interface Packed {
    f32?: string;
    f64?: string;
    u32?: string;
}

function bytes(text: string): ArrayBuffer {
    const raw = atob(text);
    const out = new Uint8Array(raw.length);
    for (let k = 0; k < raw.length; k++) {
        out[k] = raw.charCodeAt(k);
    }
    return out.buffer;
}

export function floats(packed: Packed): Float32Array {
    return new Float32Array(bytes(packed.f32 ?? ""));
}

export function counts(packed: Packed): Uint32Array {
    return new Uint32Array(bytes(packed.u32 ?? ""));
}

/** Numbers of either length. */
export function numbers(packed: Packed): Float32Array | Float64Array {
    return packed.f64 === undefined ? floats(packed) : new Float64Array(bytes(packed.f64));
}
