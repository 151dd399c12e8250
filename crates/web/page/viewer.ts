// The page of `demeter view`: the whole history of a run, also while it goes on.
import "./base.css";
import "./viewer.css";
import { group, make, tick } from "./dom";
import { ScenePanel } from "./scene_panel";
import { quantity } from "./units";
import { readState, ServerError, type RunState } from "./viewer/api";
import { ExportPanel } from "./viewer/export";
import { Frames, type Frame } from "./viewer/frames";
import { GrainPanel } from "./viewer/grain";
import { SeriesPanel } from "./viewer/series";
import { TIME_KEYS, Timeline } from "./viewer/timeline";

/** How often a run that goes on is asked for news, and one that has ended [ms]. */
const POLL = { live: 700, idle: 4000 };

class Viewer {
    readonly #frames = new Frames();
    readonly #title = make("h1", {}, "…");
    readonly #badge = make("p", { class: "badge", role: "status" });
    readonly #about = make("p", { class: "about" });
    readonly #fault = make("p", { class: "notice bad", role: "alert", hidden: true });
    readonly #walls = make("div");
    /** Names of walls that are not drawn. */
    readonly #hidden = new Set<string>();
    readonly #panel: ScenePanel;
    readonly #timeline: Timeline;
    readonly #series: SeriesPanel;
    readonly #grain: GrainPanel;
    readonly #export: ExportPanel | null;
    #steps: number[] = [];
    #times: number[] = [];
    #epoch = -1;
    #frame: Frame | null = null;
    #wallNames = new Map<number, string>();
    #name = "run";

    constructor() {
        const place = make("div");
        const main = make("main", { id: "main" }, this.#fault, place);
        document.body.append(make("a", { class: "skip", href: "#main" }, "Skip to the picture"), make("header", {}, make("div", { class: "title" }, this.#title, this.#badge), this.#about), main);
        this.#timeline = new Timeline({ show: (index) => this.#show(index), ahead: (indices) => this.#frames.prefetch(indices.map((k) => this.#steps[k]!), this.#panel.showsChains), plays: (on) => this.#panel.scene && (this.#panel.scene.plays = on) });
        this.#panel = new ScenePanel(place, { label: "The run", fileName: "packing", describes: false, onPick: (id) => this.#grain.show(id), needsChains: () => void this.#show(this.#timeline.index) });
        this.#panel.view.append(this.#timeline.element);
        const seek = (time: number) => this.#timeline.seekTime(time);
        this.#series = new SeriesPanel(seek);
        this.#grain = new GrainPanel({ pick: (id) => this.#panel.pick(id), seek, wallName: (k) => this.#wallNames.get(k) ?? String(k) });
        main.append(make("div", { class: "below" }, this.#grain.element, this.#series.element), help(this.#timeline.everywhere.element));
        const scene = this.#panel.scene;
        this.#export = scene && new ExportPanel({ scene, name: () => this.#name, count: () => this.#times.length, index: () => this.#timeline.index, time: (k) => this.#times[k] ?? NaN, scales: () => this.#panel.scales, show: (k) => this.#show(k) });
        if (this.#export) {
            this.#panel.controls.append(group("Walls", this.#walls), this.#export.element);
        }
        void this.#watch();
    }

    /** Asks for news as long as the page is open. */
    async #watch(): Promise<void> {
        for (;;) {
            let goesOn = true;
            try {
                const from = this.#epoch < 0 ? 0 : this.#times.length;
                goesOn = await this.#take(await readState(from));
                this.#complain(null);
            } catch (error) {
                this.#complain(error as Error);
            }
            await new Promise((resolve) => setTimeout(resolve, goesOn ? POLL.live : POLL.idle));
        }
    }

    /** Takes over what the run is now; tells whether it goes on. */
    async #take(told: RunState): Promise<boolean> {
        let state = told;
        const first = this.#epoch < 0;
        const anew = state.epoch !== this.#epoch;
        if (anew) {
            if (!first) {
                state = await readState(0);
            }
            this.#frames.clear();
            this.#wallNames.clear();
            this.#walls.replaceChildren();
            [this.#steps, this.#times] = [[], []];
            this.#epoch = state.epoch;
        }
        this.#name = state.folder;
        const { moments } = state;
        const grown = moments.times.length > 0 && moments.from === this.#times.length;
        if (grown) {
            this.#steps = [...this.#steps, ...moments.steps];
            this.#times = [...this.#times, ...moments.times];
        }
        this.#describe(state);
        this.#series.update(state.series, anew && !first);
        if (grown || anew) {
            this.#timeline.setMoments(this.#steps, this.#times, anew);
            this.#grain.setTimes(this.#times, anew && !first);
            this.#export?.setCount(this.#times.length);
        }
        if (first && state.going_on) {
            this.#timeline.live = true;
        }
        return state.going_on;
    }

    #describe(state: RunState): void {
        this.#title.textContent = state.title || state.folder;
        document.title = `${state.title || state.folder} – Demeter`;
        const [text, kind] = state.going_on ? ["running", "good"] : state.summary ? [state.summary.finished ? "finished" : "stopped", state.summary.finished ? "good" : "warn"] : ["not ended", "warn"];
        if (this.#badge.textContent !== text) {
            this.#badge.textContent = text;
            this.#badge.className = `badge ${kind}`;
        }
        const last = this.#times.at(-1);
        const parts = [`folder ${state.folder}`, `${this.#times.length} frames`, ...(last === undefined ? [] : [`to ${quantity(last, "s")}`]), `${state.series?.rows ?? 0} rows`, `Demeter ${state.version}`];
        const why = state.summary && !state.summary.finished ? `; it ended because ${state.summary.stopped_by}` : "";
        this.#about.textContent = `${parts.join(" · ")}${why}`;
        if (state.fault) {
            this.#complain(new ServerError(state.fault));
        }
    }

    async #show(index: number): Promise<void> {
        const [step, epoch] = [this.#steps[index], this.#epoch];
        if (step === undefined) {
            return;
        }
        if (!this.#timeline.playing) {
            this.#frames.only([step]);
        }
        try {
            const frame = await this.#frames.get(step);
            if (this.#panel.showsChains) {
                await this.#frames.readChains(frame);
            }
            if (epoch !== this.#epoch) {
                return;
            }
            this.#frame = frame;
            this.#draw();
            await painted();
            this.#complain(null);
        } catch (error) {
            if ((error as Error).name !== "AbortError") {
                this.#complain(error as Error);
                this.#timeline.pause();
            }
        }
    }

    #draw(): void {
        const frame = this.#frame!;
        if (frame.walls.some((wall) => !this.#wallNames.has(wall.index))) {
            this.#listWalls(frame);
        }
        this.#panel.show({ ...frame, walls: frame.walls.filter((wall) => !this.#hidden.has(wall.name)) });
        this.#series.setTime(frame.time);
        this.#grain.setFrame(frame);
    }

    #listWalls(frame: Frame): void {
        frame.walls.forEach(({ index, name }) => this.#wallNames.set(index, name));
        const rows = [...this.#wallNames.values()].map((name) => {
            const shown = tick(name, !this.#hidden.has(name), (on) => {
                if (on) {
                    this.#hidden.delete(name);
                } else {
                    this.#hidden.add(name);
                }
                this.#draw();
            });
            return shown.element;
        });
        this.#walls.replaceChildren(...rows);
    }

    #complain(error: Error | null): void {
        this.#fault.hidden = error === null;
        if (error && this.#fault.textContent !== error.message) {
            this.#fault.textContent = error.message;
            if (!(error instanceof ServerError)) {
                console.error(error);
            }
        }
    }
}

/** Waits until the browser has drawn. */
function painted(): Promise<void> {
    return new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve, 0)));
}

function help(everywhere: HTMLElement): HTMLElement {
    const keys = make("dl", { class: "keys" }, ...TIME_KEYS.flatMap(([key, what]) => [make("dt", {}, key), make("dd", {}, what)]));
    const licences = make("a", { href: "licences.txt" }, "Licences of the libraries in this page");
    return make("footer", {}, make("details", {}, make("summary", {}, "Keys of the timeline"), keys, everywhere), licences);
}

new Viewer();
