// The timeline: scrubs, plays, follows.
import { button, choice, make, tick } from "../dom";
import { quantity } from "../units";

/** Frames per second to choose from. */
const SPEEDS = [1, 2, 5, 10, 15, 25, 30, 60];

export interface TimelineEvents {
    /** Shows a frame; resolved when it is drawn. */
    show: (index: number) => Promise<void>;
    /** Which frames come next while it plays, to be read ahead. */
    ahead: (indices: number[]) => void;
    /** Tells when it begins to play, and when it ends. */
    plays: (on: boolean) => void;
}

/** How many frames are read ahead while playing. */
const AHEAD = 4;

/** Where the page remembers that the keys are for the timeline and the view alone. */
const NARROW = "demeter-keys-narrow";

/** What the keys do, for the help text. */
export const TIME_KEYS: [string, string][] = [
    ["Space", "play or pause"],
    ["Left and right arrow, or , and .", "one frame back or on"],
    ["Home and End", "first and last frame"],
];

export class Timeline {
    readonly element = make("section", { class: "timeline", "aria-label": "Timeline" });
    readonly #events: TimelineEvents;
    readonly #slider = make("input", { type: "range", min: 0, max: 0, step: 1, value: 0, "aria-label": "Frame" });
    readonly #told = make("p", { class: "time-told" });
    /** For screen readers; silent while it plays. */
    readonly #status = make("p", { class: "unseen", role: "status", "aria-live": "polite" });
    readonly #play: HTMLButtonElement;
    readonly #live: HTMLInputElement;
    readonly #loop: HTMLInputElement;
    /** Whether the keys work wherever the focus is: single keys must not get into the way of those who speak to their computer. */
    readonly everywhere = tick("These keys work wherever the focus is on the page", !remembered(NARROW), (on) => remember(NARROW, !on));
    #times: number[] = [];
    #steps: number[] = [];
    /** The frame that is shown. */
    #index = -1;
    /** The frame that was asked for last, from which steps are counted. */
    #aim = -1;
    #speed = 10;
    #playing = false;
    /** The frame that is wanted; a newer wish replaces it. */
    #wanted = -1;
    #busy = false;
    /** The frame that is being shown on request. */
    #job = Promise.resolve();
    /** Counts starts, so that of two that follow each other quickly only the last one plays. */
    #turn = 0;

    constructor(events: TimelineEvents) {
        this.#events = events;
        const go = (text: string, label: string, act: () => void) => button(text, act, { "aria-label": label, title: label });
        this.#play = go("Play", "Play", () => this.toggle());
        this.#play.classList.add("play");
        const speed = choice("Frames per second", SPEEDS.map((s) => [String(s), String(s)]), (value) => (this.#speed = Number(value)));
        speed.select.value = String(this.#speed);
        const loop = tick("Loop", false, () => undefined);
        const live = tick("Live", false, (on) => on && this.#goLive());
        live.element.title = "Follow the run: show the newest frame as soon as it is there";
        [this.#live, this.#loop] = [live.input, loop.input];
        this.#slider.addEventListener("input", () => this.seek(this.#slider.valueAsNumber));
        const buttons = make(
            "div",
            { class: "time-buttons" },
            go("|◀", "First frame", () => this.seek(0)),
            go("◀", "One frame back", () => this.seek(this.#aim - 1)),
            this.#play,
            go("▶", "One frame on", () => this.seek(this.#aim + 1)),
            go("▶|", "Last frame", () => this.seek(this.#times.length - 1)),
        );
        const choices = make("div", { class: "time-choices" }, speed.element, loop.element, live.element);
        this.element.append(make("div", { class: "time-row" }, buttons, this.#slider, this.#told), choices, this.#status);
        document.addEventListener("keydown", (event) => this.#key(event));
        this.#tell();
    }

    get index(): number {
        return this.#index;
    }

    get playing(): boolean {
        return this.#playing;
    }

    get live(): boolean {
        return this.#live.checked;
    }

    set live(on: boolean) {
        this.#live.checked = on;
        if (on) {
            this.#goLive();
        }
    }

    /** Takes over the moments, `anew` where they are no longer those before; goes to the newest one when it follows. */
    setMoments(steps: number[], times: number[], anew: boolean): void {
        [this.#steps, this.#times] = [steps, times];
        this.#slider.max = String(Math.max(times.length - 1, 0));
        this.#slider.disabled = times.length < 2;
        if (this.#index >= times.length) {
            this.#index = this.#aim = -1;
        }
        if (times.length > 0 && (this.#index < 0 || this.live || anew)) {
            this.#goTo(this.live ? times.length - 1 : Math.max(this.#index, 0));
        }
        this.#tell();
    }

    /** Shows a frame; it then follows no longer, unless it is the last one. */
    seek(index: number): void {
        const at = Math.min(Math.max(index, 0), this.#times.length - 1);
        if (at < this.#times.length - 1) {
            this.#live.checked = false;
        }
        this.pause();
        this.#goTo(at);
    }

    /** Shows the frame that is nearest to a time [s]. */
    seekTime(time: number): void {
        let best = 0;
        this.#times.forEach((t, k) => {
            if (Math.abs(t - time) < Math.abs(this.#times[best]! - time)) {
                best = k;
            }
        });
        this.seek(best);
    }

    toggle(): void {
        if (this.#playing) {
            this.pause();
        } else if (this.#times.length > 1) {
            this.#live.checked = false;
            this.#playing = true;
            this.#label();
            void this.#run();
        }
    }

    pause(): void {
        if (this.#playing) {
            this.#playing = false;
            this.#label();
            this.#announce();
        }
    }

    #goLive(): void {
        this.pause();
        if (this.#times.length > 0) {
            this.#goTo(this.#times.length - 1);
        }
    }

    #label(): void {
        this.#events.plays(this.#playing);
        this.#play.textContent = this.#playing ? "Pause" : "Play";
        const label = this.#playing ? "Pause" : "Play";
        this.#play.setAttribute("aria-label", label);
        this.#play.title = label;
    }

    /** Shows a frame; while one is being read the newest wish waits. */
    #goTo(index: number): void {
        this.#wanted = this.#aim = index;
        this.#slider.value = String(index);
        this.#tellAt(index);
        if (!this.#busy) {
            this.#job = this.#work();
        }
    }

    async #work(): Promise<void> {
        this.#busy = true;
        while (this.#wanted >= 0) {
            const index = this.#wanted;
            this.#wanted = -1;
            await this.#show(index);
        }
        this.#busy = false;
        this.#announce();
    }

    async #show(index: number): Promise<void> {
        try {
            await this.#events.show(index);
        } finally {
            this.#index = index;
            this.element.dataset["shown"] = String(index + 1);
            this.#tell();
        }
    }

    /** Plays until it is paused or at the end. */
    async #run(): Promise<void> {
        const turn = ++this.#turn;
        await this.#job;
        if (this.#index >= this.#times.length - 1) {
            this.#index = -1;
        }
        while (this.#playing && turn === this.#turn) {
            const next = this.#index + 1;
            const begun = performance.now();
            if (next >= this.#times.length && !this.#loop.checked) {
                this.pause();
                break;
            }
            const index = next % this.#times.length;
            this.#aim = index;
            this.#events.ahead(this.#following(index));
            this.#busy = true;
            await this.#show(index);
            this.#busy = false;
            const wait = Math.max(1000 / this.#speed - (performance.now() - begun), 0);
            await new Promise((resolve) => setTimeout(resolve, wait));
        }
        if (this.#wanted >= 0 && !this.#busy) {
            this.#job = this.#work();
        }
    }

    #following(index: number): number[] {
        const count = this.#times.length;
        const following = Array.from({ length: AHEAD + 1 }, (_, k) => index + k);
        return this.#loop.checked ? following.map((k) => k % count) : following.filter((k) => k < count);
    }

    #tell(): void {
        this.#tellAt(this.#aim);
    }

    #tellAt(index: number): void {
        const time = this.#times[index];
        const text = time === undefined ? "no frame yet" : `${quantity(time, "s")} · frame ${index + 1} of ${this.#times.length}`;
        this.#told.textContent = text;
        this.#told.title = time === undefined ? "" : `step ${this.#steps[index]}`;
        this.#slider.setAttribute("aria-valuetext", text);
        if (document.activeElement !== this.#slider || this.#playing) {
            this.#slider.value = String(Math.max(index, 0));
        }
    }

    #announce(): void {
        if (!this.#playing) {
            this.#status.textContent = `Time ${this.#told.textContent}`;
        }
    }

    #key(event: KeyboardEvent): void {
        if (event.ctrlKey || event.metaKey || event.altKey || event.shiftKey || event.defaultPrevented) {
            return;
        }
        const target = event.target as HTMLElement;
        const types = target instanceof HTMLInputElement ? target.type : "";
        const writes = target instanceof HTMLTextAreaElement || ["text", "number", "search"].includes(types);
        if (writes || target instanceof HTMLSelectElement) {
            return;
        }
        const isHere = this.element.contains(target) || target instanceof HTMLCanvasElement;
        if (!isHere && !this.everywhere.input.checked) {
            return;
        }
        const acts = target instanceof HTMLAnchorElement || target instanceof HTMLButtonElement || target.tagName === "SUMMARY" || types === "checkbox";
        // sliders, the 3D view, plots and what scrolls have arrow keys of their own
        const moves = types === "range" || ["application", "region"].includes(target.getAttribute("role") ?? "");
        const keys: Record<string, () => void> = {
            ...(acts ? {} : { " ": () => this.toggle() }),
            ...(moves
                ? {}
                : {
                      ArrowLeft: () => this.seek(this.#aim - 1),
                      ArrowRight: () => this.seek(this.#aim + 1),
                      Home: () => this.seek(0),
                      End: () => this.seek(this.#times.length - 1),
                  }),
            ",": () => this.seek(this.#aim - 1),
            ".": () => this.seek(this.#aim + 1),
        };
        const act = keys[event.key];
        if (act) {
            event.preventDefault();
            act();
        }
    }
}

function remembered(name: string): boolean {
    try {
        return localStorage.getItem(name) === "true";
    } catch {
        return false;
    }
}

/** Browsers may refuse to remember. */
function remember(name: string, value: boolean): void {
    try {
        localStorage.setItem(name, String(value));
    } catch {
        return;
    }
}
