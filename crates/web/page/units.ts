// Numbers and quantities as people write them.

const PREFIXES: [string, number][] = [
    ["G", 1e9],
    ["M", 1e6],
    ["k", 1e3],
    ["", 1],
    ["m", 1e-3],
    ["µ", 1e-6],
    ["n", 1e-9],
    ["p", 1e-12],
];
/** Units that take a prefix as they are. */
const PREFIXED = new Set(["m", "s", "N", "J", "Pa", "W", "m/s", "N m", "Hz"]);

/** A number with at most so many digits. */
export function readable(value: number, digits = 5): string {
    if (!Number.isFinite(value)) {
        return Number.isNaN(value) ? "–" : value > 0 ? "∞" : "−∞";
    }
    const size = Math.abs(value);
    const plain = size === 0 || (size >= 1e-3 && size < 1e5);
    const text = plain ? String(Number(value.toPrecision(digits))) : value.toExponential(digits - 1).replace(/\.?0+e/, "e");
    return text.replaceAll("-", "−").replace("e+", "e");
}

/** The prefix with which values up to a size read best in a unit. */
export function scaled(size: number, unit: string): { unit: string; factor: number } {
    if (!PREFIXED.has(unit) || !(size > 0) || !Number.isFinite(size)) {
        return { unit, factor: 1 };
    }
    const [prefix, factor] = PREFIXES.find(([, f]) => size * 1.00005 >= f) ?? PREFIXES[PREFIXES.length - 1]!;
    return { unit: prefix + unit, factor };
}

/** A value with its unit, in the prefix with which it reads best. */
export function quantity(value: number, unit: string): string {
    const { unit: shown, factor } = scaled(Math.abs(value), unit);
    return shown === "" ? readable(value, 4) : `${readable(value / factor, 4)} ${shown}`;
}

/** A name with its unit. */
export function titled(label: string, unit: string): string {
    return unit === "" ? label : `${label} [${unit}]`;
}
