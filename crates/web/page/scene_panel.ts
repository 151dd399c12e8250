// A scene with its controls: colours, force chains, opacities, clip plane, views, and what is known of a picked grain.
import { button, choice, group, make, save, slider, tick, type Slider } from "./dom";
import { CAMERA_KEYS, createScene, type Contacts, type Grains, type MapName, type PackingScene, type ViewName, type WallSurface } from "./scene";
import { colourKey, type ShownScale } from "./scene/colour_key";
import { quantity, readable, scaled } from "./units";

/** A scalar of grains, for the list of colours. */
export interface ScalarInfo {
    name: string;
    unit: string;
    meaning: string;
}

/** Contacts at a moment. */
export interface ContactState {
    count: number;
    /** Mean size of the normal forces [N]. */
    meanForce: number;
    /** What chains are drawn of; null where it was not read yet. */
    chains: Contacts | null;
    /** Which bodies they join, where picked grains are described by the panel: ids of the first grains, of the second, indices of walls, forces [N]. */
    partners?: { idI: Uint32Array; idJ: Uint32Array; wall: Float32Array; totalForce: Float32Array };
}

/** What is shown at a moment. */
export interface PackingState {
    grains: Grains;
    contacts: ContactState | null;
    walls: WallSurface[];
    scalars: ScalarInfo[];
}

export interface PanelOptions {
    label: string;
    /** Name of saved pictures, without extension. */
    fileName: string;
    /** Whether what is known of a picked grain is told below the view; otherwise whoever listens to `onPick` tells it. */
    describes?: boolean;
    /** Called with the id of the picked grain, or null. */
    onPick?: (id: number | null) => void;
    /** Called when chains are to be drawn of contacts that were not read yet; the state is to be shown again with them. */
    needsChains?: () => void;
}

type Axis = "x" | "y" | "z";
type Direction = [number, number, number];
const DIRECTIONS: Record<Axis, Direction> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };
const MAPS: [MapName, string][] = [
    ["viridis", "Viridis"],
    ["cividis", "Cividis"],
    ["coolwarm", "Cool to warm"],
    ["grey", "Grey"],
];
const VIEWS: [ViewName, string][] = [
    ["oblique", "Oblique"],
    ["front", "Front"],
    ["side", "Side"],
    ["top", "Top"],
];
/** Grains become this opaque when force chains are shown, so that these are seen. */
const BESIDE_CHAINS = 0.12;
/** Name under which frames hold the sides of a periodic box that deforms, in the place of walls. */
const PERIODIC_BOX = "periodic box";
const NOTHING_PICKED = "Click a grain, or type its id, to see its values.";
/** Most contacts of a grain that are listed. */
const MOST_LISTED = 30;

/** Panels of the page, for ids. */
let panels = 0;

const percent = (share: number) => `${Math.round(100 * share)} %`;

/** A 3D view with controls; without WebGL a message in the place of the view, and no controls. */
export class ScenePanel {
    readonly scene: PackingScene | null;
    readonly element = make("div", { class: "scene-panel" });
    /** The column of the view, for what belongs below it. */
    readonly view = make("div", { class: "scene-view" });
    /** The column of the controls; not on the page without WebGL. */
    readonly controls = make("div", { class: "scene-controls" });
    readonly #options: PanelOptions;
    readonly #key = make("div", { class: "key-holder" });
    readonly #chainKey = make("div", { class: "key-holder", hidden: true });
    readonly #picked = make("div", { class: "picked", role: "status" });
    readonly #chainsTold = make("p", { class: "hint" });
    /** What the picture shows, in words, for those who do not see it. */
    readonly #inWords = make("p", { class: "unseen", id: `scene-in-words-${++panels}` });
    #state: PackingState = { grains: { position: new Float32Array(), radius: new Float32Array(), id: new Uint32Array(), scalars: new Map() }, contacts: null, walls: [], scalars: [] };
    #colour: { scalar: string; map: MapName; range: [number, number] | null } = { scalar: "", map: "viridis", range: null };
    #chosen = false;
    #chains = { shown: false, threshold: 1 };
    #clip: { axis: Axis | "any" | ""; normal: Direction; share: number; flipped: boolean } = { axis: "", normal: [1, -1, 1], share: 0.5, flipped: false };
    #scalars!: HTMLSelectElement;
    #range!: [HTMLInputElement, HTMLInputElement];
    #grainOpacity!: Slider;
    #clipPosition!: Slider;

    constructor(container: HTMLElement, options: PanelOptions) {
        this.#options = options;
        const frame = make("div", { class: "scene-frame" });
        this.view.append(frame, this.#inWords, this.#key, this.#chainKey);
        this.element.append(this.view);
        container.replaceChildren(this.element);
        this.scene = createScene(frame, { label: this.#label(), onPick: (id) => this.pick(id) });
        if (this.scene) {
            this.element.append(this.controls);
            this.controls.append(this.#colourControls(), this.#grainControls(), this.#chainControls(), this.#clipControls(), this.#viewControls(this.scene));
            this.scene.canvas.setAttribute("aria-describedby", this.#inWords.id);
            if (options.describes ?? true) {
                this.view.append(this.#pickForm(), this.#picked);
                this.#picked.textContent = NOTHING_PICKED;
            }
            printAsImage(frame, this.scene);
        }
    }

    #label(): string {
        const keys = CAMERA_KEYS.map(([key, what]) => `${key}: ${what}`).join("; ");
        return `${this.#options.label}, a 3D view. ${keys}.`;
    }

    /** Shows a state; colours, chains and the clip plane stay as they are chosen. */
    show(state: PackingState): void {
        if (!this.scene) {
            return;
        }
        this.#state = state;
        const names = state.scalars.map((scalar) => scalar.name);
        if (names.join() !== Array.from(this.#scalars.options, (o) => o.value).join()) {
            this.#scalars.replaceChildren(...names.map((name) => make("option", { value: name }, name)));
        }
        this.#chooseScalar(names);
        this.#scalars.value = this.#colour.scalar;
        // walls first: the first grains decide what is looked at, together with the walls around them
        this.scene.setWalls(state.walls);
        this.scene.setGrains(state.grains);
        this.scene.setContacts(state.contacts?.chains ?? null);
        this.#recolour();
        this.#redrawChains();
        this.#replaceClip();
    }

    /** The colours that are shown: those of the grains, and those of the force chains while there are any. */
    get scales(): ShownScale[] {
        const { colourScale, chainScale } = this.scene!;
        const unit = this.#state.scalars.find((s) => s.name === colourScale.scalar)?.unit ?? "";
        return [{ scale: colourScale, unit }, ...(chainScale ? [{ scale: chainScale, unit: "N" }] : [])];
    }

    /** Whether force chains are drawn. */
    get showsChains(): boolean {
        return this.#chains.shown;
    }

    /** Until somebody chooses: the first scalar of the list that has told grains apart in a state that was shown. */
    #chooseScalar(names: string[]): void {
        const at = names.indexOf(this.#colour.scalar);
        if (at < 0 || !this.#chosen) {
            const telling = firstTelling(this.#state);
            this.#colour.scalar = at >= 0 && at < names.indexOf(telling) ? this.#colour.scalar : telling;
        }
    }

    /** Colours the grains by a scalar. */
    colourBy(scalar: string): void {
        this.#chosen = true;
        this.#colour = { ...this.#colour, scalar, range: null };
        this.#scalars.value = scalar;
        this.#recolour();
    }

    /** Picks a grain, or none. */
    pick(id: number | null): void {
        this.scene?.highlight(id === null ? [] : [id]);
        this.#picked.replaceChildren(...(id === null ? [NOTHING_PICKED] : this.#describe(id)));
        this.#options.onPick?.(id);
    }

    #colourControls(): HTMLElement {
        const scalars = choice("Colour grains by", [], (value) => this.colourBy(value));
        this.#scalars = scalars.select;
        const maps = choice("Colours", MAPS, (value) => {
            this.#colour.map = value as MapName;
            this.#recolour();
        });
        const end = (label: string) => {
            const input = make("input", { type: "number", step: "any", "aria-label": label });
            input.addEventListener("change", () => this.#rangeTyped());
            return input;
        };
        this.#range = [end("From"), end("To")];
        const automatic = button("Automatic", () => {
            this.#colour.range = null;
            this.#recolour();
        });
        const hold = button("Hold", () => {
            this.#colour.range = [...this.scene!.colourScale.range];
            this.#recolour();
        }, { title: "Keep this range in other frames" });
        const range = make("div", { class: "range-row" }, this.#range[0], make("span", {}, "to"), this.#range[1], automatic, hold);
        return group("Colours", scalars.element, maps.element, range);
    }

    #rangeTyped(): void {
        const [low, high] = this.#range.map((input) => input.valueAsNumber) as [number, number];
        const { factor } = this.#shownUnit();
        const ok = Number.isFinite(low) && Number.isFinite(high) && low < high;
        this.#range.forEach((input) => input.setAttribute("aria-invalid", String(!ok)));
        if (ok) {
            this.#colour.range = [low * factor, high * factor];
            this.#recolour();
        }
    }

    #shownUnit(): { unit: string; factor: number } {
        const { scale, unit } = this.scales[0]!;
        return scaled(Math.max(...scale.range.map(Math.abs)), unit);
    }

    #recolour(): void {
        const { scalar, range, map } = this.#colour;
        const scale = this.scene!.colourBy(scalar, range, map);
        this.#key.replaceChildren(colourKey(this.scales[0]!, this.#state.grains.scalars.get(scalar)));
        const meaning = this.#state.scalars.find((s) => s.name === scalar)?.meaning;
        if (meaning) {
            this.#key.append(make("span", { class: "key-meaning" }, meaning));
        }
        this.#tellInWords();
        const { factor } = this.#shownUnit();
        scale.range.forEach((value, k) => {
            const input = this.#range[k as 0 | 1];
            input.value = String(Number((value / factor).toPrecision(4)));
            input.disabled = scale.names !== null;
            input.setAttribute("aria-invalid", "false");
        });
    }

    #tellInWords(): void {
        const { grains, contacts, walls } = this.#state;
        const count = (n: number, what: string) => `${n} ${what}${n === 1 ? "" : "s"}`;
        const told = ({ scale, unit }: ShownScale) => `${scale.scalar}${scale.names ? "" : ` from ${quantity(scale.range[0], unit)} to ${quantity(scale.range[1], unit)}`}`;
        const [colours, chains] = this.scales.map(told);
        const box = this.scene!.bounds();
        const [lower, upper] = [box.min.toArray(), box.max.toArray()];
        const across = box.isEmpty() ? "" : `, in ${lower.map((from, k) => quantity(upper[k]! - from, "m")).join(" by ")}`;
        const inBox = walls.length === 1 && walls[0]!.name === PERIODIC_BOX;
        const held = walls.length === 0 ? "" : inBox ? ", with the sides of the periodic box" : `, with ${count(walls.length, "wall")}`;
        const chained = chains ? `, ${chains}` : "";
        this.#inWords.textContent = `${count(grains.id.length, "grain")}${held}${across}, coloured by ${colours}; ${count(contacts?.count ?? 0, "contact")}${chained}.`;
    }

    /** Picks by id what others pick by a click. */
    #pickForm(): HTMLElement {
        const id = make("input", { type: "number", min: 1, step: 1, "aria-label": "Id of a grain" });
        const form = make("form", { class: "grain-form" }, make("label", {}, "Grain ", id), make("button", { type: "submit" }, "Show"), button("None", () => this.pick(null)));
        form.addEventListener("submit", (event) => {
            event.preventDefault();
            if (Number.isInteger(id.valueAsNumber)) {
                this.pick(id.valueAsNumber);
            }
        });
        return form;
    }

    #grainControls(): HTMLElement {
        const scene = this.scene!;
        this.#grainOpacity = slider("Opacity of grains", { min: 0, max: 1, step: 0.02, value: 1 }, percent, (v) => scene.setGrainOpacity(v));
        const size = slider("Size of grains", { min: 0.1, max: 1, step: 0.05, value: 1 }, percent, (v) => scene.setGrainSize(v));
        const walls = slider("Opacity of walls", { min: 0, max: 1, step: 0.02, value: 0.18 }, percent, (v) => scene.setWallOpacity(v));
        return group("Grains and walls", this.#grainOpacity.element, size.element, walls.element);
    }

    #chainControls(): HTMLElement {
        const shown = tick("Show force chains", false, (value) => {
            this.#chains.shown = value;
            if (value && this.#grainOpacity.input.valueAsNumber === 1) {
                this.#grainOpacity.set(BESIDE_CHAINS);
            } else if (!value && this.#grainOpacity.input.valueAsNumber === BESIDE_CHAINS) {
                this.#grainOpacity.set(1);
            }
            this.#redrawChains();
            if (value && this.#state.contacts && !this.#state.contacts.chains) {
                this.#options.needsChains?.();
            }
        });
        const told = (v: number) => (v === 0 ? "all contacts" : `from ${readable(v, 2)} × mean`);
        const threshold = slider("Normal force", { min: 0, max: 5, step: 0.1, value: 1 }, told, (v) => {
            this.#chains.threshold = v;
            this.#redrawChains();
        });
        return group("Force chains", shown.element, threshold.element, this.#chainsTold);
    }

    #redrawChains(): void {
        const contacts = this.#state.contacts;
        const mean = contacts?.meanForce ?? 0;
        const drawn = this.scene!.showChains(this.#chains.shown, this.#chains.threshold * mean);
        const all = contacts?.count ?? 0;
        const scale = this.scales[1];
        this.#chainKey.hidden = !scale;
        this.#chainKey.replaceChildren(...(scale ? [colourKey(scale)] : []));
        this.#tellInWords();
        const none = all === 0 ? "No contact carries a force in this state." : `Mean normal force ${quantity(mean, "N")}.`;
        this.#chainsTold.textContent = this.#chains.shown && all > 0 && contacts?.chains ? `${drawn} of ${all} contacts; thicker is stronger. ${none}` : none;
    }

    #clipControls(): HTMLElement {
        this.#clipPosition = slider("Position", { min: 0, max: 1, step: 0.01, value: 0.5 }, (share) => this.#clipTold(share), (share) => {
            this.#clip.share = share;
            this.#recut();
        });
        const axes: [string, string][] = [["", "off"], ["x", "across x"], ["y", "across y"], ["z", "across z"], ["any", "across any direction"]];
        const normal = this.#normalControls(() => this.#replaceClip());
        const axis = choice("Cut", axes, (value) => {
            this.#clip.axis = value as Axis | "any" | "";
            this.#clipPosition.input.disabled = value === "";
            normal.hidden = value !== "any";
            this.#replaceClip();
        });
        const flip = tick("Show the other side", false, (value) => {
            this.#clip.flipped = value;
            this.#recut();
        });
        this.#clipPosition.input.disabled = true;
        return group("Clip plane", axis.element, normal, this.#clipPosition.element, flip.element);
    }

    /** Lets the plane stand at the same share of what is shown now, and tells where that is. */
    #replaceClip(): void {
        this.#clipPosition.set(this.#clip.share);
    }

    /** Fields for the direction across which the plane lies. */
    #normalControls(changed: () => void): HTMLElement {
        const fields = (["x", "y", "z"] as const).map((name, k) => {
            const input = make("input", { type: "number", step: "any", value: this.#clip.normal[k]!, "aria-label": `${name} of the normal` });
            input.addEventListener("input", () => {
                const typed = fields.map((field) => field.valueAsNumber);
                const ok = typed.every(Number.isFinite) && typed.some((v) => v !== 0);
                fields.forEach((field) => field.setAttribute("aria-invalid", String(!ok)));
                if (ok) {
                    this.#clip.normal = typed as Direction;
                    changed();
                }
            });
            return input;
        });
        const row = make("div", { class: "range-row direction" }, "normal ", ...fields);
        row.hidden = true;
        return row;
    }

    /** Unit vector across the plane, and the plane's place along it. */
    #clipPlane(share: number): { normal: Direction; place: number } {
        const { axis, normal: any } = this.#clip;
        const given = axis === "any" || axis === "" ? any : DIRECTIONS[axis];
        const length = Math.hypot(...given);
        const normal = given.map((c) => c / length) as Direction;
        const box = this.scene!.bounds();
        if (box.isEmpty()) {
            return { normal, place: 0 };
        }
        const [low, high] = [box.min.toArray(), box.max.toArray()];
        const end = (upper: boolean) => normal.reduce((sum, c, k) => sum + c * (c > 0 === upper ? high : low)[k]!, 0);
        return { normal, place: end(false) + share * (end(true) - end(false)) };
    }

    #clipTold(share: number): string {
        const { axis } = this.#clip ?? { axis: "" };
        const name = axis === "any" ? "distance from the origin" : axis;
        return axis === "" ? "" : `${name} = ${quantity(this.#clipPlane(share).place, "m")}`;
    }

    #recut(): void {
        const { axis, share, flipped } = this.#clip;
        if (axis === "") {
            this.scene!.setClipPlane(null);
            return;
        }
        // the side towards the oblique view is cut away unless told otherwise
        const sign = (axis === "y" ? -1 : 1) * (flipped ? -1 : 1);
        const { normal, place } = this.#clipPlane(share);
        this.scene!.setClipPlane({ normal: normal.map((c) => sign * c) as Direction, offset: sign * place });
    }

    #viewControls(scene: PackingScene): HTMLElement {
        const views = VIEWS.map(([name, text]) => button(text, () => scene.view(name)));
        const picture = button("Save picture", () => void scene.screenshot().then((blob) => save(blob, `${this.#options.fileName}.png`)));
        const full = button("Full screen", () => void (document.fullscreenElement ? document.exitFullscreen() : this.element.requestFullscreen()));
        full.hidden = !document.fullscreenEnabled;
        const keys = make("dl", { class: "keys" }, ...CAMERA_KEYS.flatMap(([key, what]) => [make("dt", {}, key), make("dd", {}, what)]));
        const help = make("details", {}, make("summary", {}, "Mouse and keys"), make("p", {}, "Drag to turn, drag with the right button to move; the wheel zooms once the view has the focus. With the focus on the view:"), keys);
        return group("View", make("div", { class: "button-row" }, ...views), make("div", { class: "button-row" }, picture, full), help);
    }

    /** The values and contacts of a grain. */
    #describe(id: number): Node[] {
        const { grains, contacts, scalars } = this.#state;
        const k = grains.id.indexOf(id);
        if (k < 0) {
            return [make("p", {}, `Grain ${id} is not there.`)];
        }
        const list = make("dl", { class: "values" });
        const add = (name: string, value: string) => list.append(make("div", {}, make("dt", {}, name), make("dd", {}, value)));
        const centre = Array.from(grains.position.subarray(3 * k, 3 * k + 3), (x) => quantity(x, "m"));
        add("centre", `(${centre.join(", ")})`);
        for (const { name, unit } of scalars) {
            const value = grains.scalars.get(name)?.[k] ?? NaN;
            const names = grains.categories?.get(name);
            add(name, names ? (names[value] ?? String(value)) : quantity(value, unit));
        }
        const parts: Node[] = [make("h3", {}, `Grain ${id}`), list];
        const lines = contacts?.partners ? this.#contactsOf(id) : [];
        if (lines.length > 0) {
            const more = lines.length > MOST_LISTED ? [make("li", {}, `and ${lines.length - MOST_LISTED} more`)] : [];
            parts.push(make("details", {}, make("summary", {}, `${lines.length} contacts`), make("ul", {}, ...lines.slice(0, MOST_LISTED).map((line) => make("li", {}, line)), ...more)));
        }
        return parts;
    }

    #contactsOf(id: number): string[] {
        const { contacts, walls } = this.#state;
        const { idI, idJ, wall, totalForce } = contacts!.partners!;
        const { normalForce } = contacts!.chains!;
        const found: [number, string][] = [];
        for (let k = 0; k < idI.length; k++) {
            if (idI[k] === id || (wall[k]! < 0 && idJ[k] === id)) {
                const name = walls.find((w) => w.index === wall[k])?.name;
                const partner = wall[k]! >= 0 ? `wall ${name ?? wall[k]}` : `grain ${idI[k] === id ? idJ[k] : idI[k]}`;
                found.push([totalForce[k]!, `${partner}: normal force ${quantity(normalForce[k]!, "N")}, force ${quantity(totalForce[k]!, "N")}`]);
            }
        }
        return found.sort((a, b) => b[0] - a[0]).map(([, text]) => text);
    }
}

/** The first scalar that tells grains apart, in the order of the list. */
function firstTelling(state: PackingState): string {
    const tells = (name: string) => {
        const values = state.grains.scalars.get(name);
        return values !== undefined && values.some((v) => v !== values[0]);
    };
    return (state.scalars.find((s) => tells(s.name)) ?? state.scalars[0])?.name ?? "";
}

/** Puts an image in the place of the canvas while the page is printed: browsers forget what WebGL has drawn. */
function printAsImage(frame: HTMLElement, scene: PackingScene): void {
    const image = make("img", { class: "print-only", alt: "The 3D view as it was on the screen" });
    frame.append(image);
    window.addEventListener("beforeprint", () => (image.src = scene.picture()));
}
