// One grain: its values, its contacts at this moment, and plots of its history.
import { button, choice, make } from "../dom";
import { Plot, type PlotOptions } from "../plots";
import { quantity, readable } from "../units";
import { readGrain, type GrainAnswer, type GrainContact, type GrainMoment } from "./api";
import type { Frame } from "./frames";
import { History } from "./history";

/** While playing, values are read at most so often [ms]. */
const PAUSE = 300;

const UNITS: Record<string, string> = {
    position: "m",
    radius: "m",
    mass: "kg",
    velocity: "m/s",
    angular_velocity: "1/s",
    force: "N",
    torque: "N m",
    contact_force: "N",
    mean_normal_stress: "Pa",
};
/** Arrays that say nothing that others do not say, or not to people. */
const LEFT_OUT = ["id", "diameter", "orientation"];

type Quantity = [key: string, label: string, unit: string, value: (m: GrainMoment) => number | null];
const QUANTITIES: Quantity[] = [
    ["speed", "speed", "m/s", (m) => m.speed],
    ["contact_force", "contact force", "N", (m) => m.contact_force],
    ["force", "total force", "N", (m) => m.force],
    ["coordination", "coordination", "", (m) => m.coordination],
    ["x", "x", "m", (m) => m.position[0]],
    ["y", "y", "m", (m) => m.position[1]],
    ["z", "z", "m", (m) => m.position[2]],
];

export interface GrainEvents {
    pick: (id: number | null) => void;
    seek: (time: number) => void;
    wallName: (index: number) => string;
}

export class GrainPanel {
    readonly element = make("section", { class: "grain-panel", "aria-label": "Picked grain" });
    readonly #events: GrainEvents;
    readonly #id = make("input", { type: "number", min: 1, max: 0xffffffff, step: 1, "aria-label": "Id of a grain" });
    readonly #values = make("div", { class: "grain-values" });
    readonly #plots = make("div", { class: "grain-plots" });
    readonly #fault = make("p", { class: "hint", role: "status" });
    readonly #quantity: HTMLSelectElement;
    #grain: number | null = null;
    #frame: Frame | null = null;
    #times: number[] = [];
    #history: History | null = null;
    /** Counts grains that were picked, so that an answer that comes late is not shown. */
    #turn = 0;
    #plot: Plot | null = null;
    #last = 0;
    #later = 0;

    constructor(events: GrainEvents) {
        this.#events = events;
        const quantityChoice = choice("History of", QUANTITIES.map(([key, label, unit]) => [key, unit ? `${label} [${unit}]` : label]), () => this.#draw());
        this.#quantity = quantityChoice.select;
        const form = make("form", { class: "grain-form" }, make("label", {}, "Grain ", this.#id), make("button", { type: "submit" }, "Show"), button("None", () => this.#events.pick(null)));
        form.addEventListener("submit", (event) => {
            event.preventDefault();
            if (Number.isInteger(this.#id.valueAsNumber) && this.#id.valueAsNumber >= 0) {
                this.#events.pick(this.#id.valueAsNumber);
            }
        });
        this.#plots.append(quantityChoice.element);
        this.#plots.hidden = true;
        this.element.append(make("h2", {}, "Grain"), form, this.#fault, this.#values, this.#plots);
        this.#fault.textContent = "Click a grain in the picture, or type its id.";
    }

    get grain(): number | null {
        return this.#grain;
    }

    /** Tells about a grain from now on, or about none. */
    show(id: number | null): void {
        this.#turn += 1;
        this.#grain = id;
        this.#history?.stop();
        this.#history = id === null ? null : new History(id);
        this.#plot?.dispose();
        this.#plot = null;
        this.#plots.hidden = id === null;
        this.#values.replaceChildren();
        this.#fault.textContent = id === null ? "Click a grain in the picture, or type its id." : "";
        this.#id.value = id === null ? "" : String(id);
        if (id !== null) {
            void this.#readValues();
            void this.#readHistory();
        }
    }

    /** Takes over the times of the moments; `anew` where earlier ones have gone. */
    setTimes(times: number[], anew: boolean): void {
        this.#times = times;
        if (this.#grain !== null) {
            if (anew) {
                this.#frame = null;
                this.show(this.#grain);
            } else {
                void this.#readHistory();
            }
        }
    }

    /** Tells which frame is shown. */
    setFrame(frame: Frame): void {
        this.#frame = frame;
        this.#plot?.setNow(frame.time);
        if (this.#grain === null) {
            return;
        }
        clearTimeout(this.#later);
        const wait = Math.max(PAUSE - (performance.now() - this.#last), 0);
        this.#later = window.setTimeout(() => void this.#readValues(), wait);
    }

    async #readValues(): Promise<void> {
        const [turn, frame, id] = [this.#turn, this.#frame, this.#grain];
        if (id === null || frame === null) {
            return;
        }
        if (!frame.grains.id.includes(id)) {
            this.#values.replaceChildren();
            this.#fault.textContent = `Grain ${id} is not there at this moment.`;
            return;
        }
        this.#last = performance.now();
        try {
            const answer = await readGrain(frame.step, id);
            if (turn === this.#turn && frame === this.#frame) {
                this.#fault.textContent = "";
                this.#values.replaceChildren(...this.#describe(answer));
            }
        } catch (error) {
            if (turn === this.#turn) {
                this.#values.replaceChildren();
                this.#fault.textContent = (error as Error).message;
            }
        }
    }

    #describe(answer: GrainAnswer): Node[] {
        const list = make("dl", { class: "values" });
        for (const [name, value] of Object.entries(answer.values)) {
            if (!LEFT_OUT.includes(name) && value !== null) {
                list.append(make("div", {}, make("dt", {}, name.replaceAll("_", " ")), make("dd", {}, told(value, UNITS[name] ?? ""))));
            }
        }
        return [list, this.#contacts(answer.contacts)];
    }

    #contacts(contacts: GrainContact[]): HTMLElement {
        if (contacts.length === 0) {
            return make("p", { class: "hint" }, "No contact acts on it at this moment.");
        }
        const table = make("table");
        table.createCaption().textContent = `${contacts.length} ${contacts.length === 1 ? "contact" : "contacts"} at this moment; repulsion is positive`;
        const head = table.createTHead().insertRow();
        for (const title of ["Partner", "Normal force", "Tangential force", "Overlap"]) {
            head.append(make("th", { scope: "col" }, title));
        }
        const body = table.createTBody();
        const size = (c: GrainContact) => Math.abs(c.normal_force ?? 0);
        for (const contact of [...contacts].sort((a, b) => size(b) - size(a))) {
            const row = body.insertRow();
            const partner = make("th", { scope: "row" });
            partner.append(
                contact.wall >= 0
                    ? `wall ${this.#events.wallName(contact.wall)}`
                    : button(`grain ${contact.partner}`, () => this.#events.pick(contact.partner), { class: "link" }),
            );
            row.append(partner);
            for (const [value, unit] of [[contact.normal_force, "N"], [contact.tangential_force, "N"], [contact.overlap, "m"]] as const) {
                row.insertCell().textContent = quantity(value ?? NaN, unit);
            }
        }
        return make("div", { class: "table-scroller", tabindex: 0, role: "region", "aria-label": "Contacts of the grain" }, table);
    }

    /** Reads the moments that are missing; the plot gains detail meanwhile. */
    async #readHistory(): Promise<void> {
        const history = this.#history;
        try {
            await history?.read(this.#times.length, () => history === this.#history && this.#draw());
        } catch (error) {
            if (history === this.#history) {
                this.#fault.textContent = (error as Error).message;
            }
        }
    }

    #draw(): void {
        const [, label, unit, value] = QUANTITIES.find(([key]) => key === this.#quantity.value)!;
        const known = (this.#history?.known() ?? []).filter(([index]) => index < this.#times.length);
        if (known.length === 0) {
            return;
        }
        const times = known.map(([index]) => this.#times[index]!);
        const values = known.map(([, moment]) => (moment ? (value(moment) ?? NaN) : NaN));
        const options: PlotOptions = {
            title: `${label} of grain ${this.#grain} over time`,
            x: { label: "time", unit: "s", values: times },
            lines: [{ label, unit, values }],
            height: 220,
            onPlace: this.#events.seek,
        };
        if (this.#plot) {
            this.#plot.update(options);
        } else {
            this.#plot = new Plot(this.#plots, options);
        }
        this.#plot.setNow(this.#frame?.time ?? null);
    }
}

function told(value: number | string | (number | null)[], unit: string): string {
    if (typeof value === "string") {
        return value;
    }
    if (Array.isArray(value)) {
        return `(${value.map((v) => quantity(v ?? NaN, unit)).join(", ")})`;
    }
    return unit === "" ? readable(value) : quantity(value, unit);
}
