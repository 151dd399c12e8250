// Any columns of a series over any other.
import { choice, field, make, tick } from "./dom";
import { Plot, type Mark, type TableColumn } from "./plots";
import { titled } from "./units";

/** A plot whose columns one chooses. */
export class OwnPlot {
    readonly #columns: (TableColumn & { meaning: string })[];
    readonly #marks: Mark[];
    readonly #place = make("div");
    readonly #chosen = new Set<number>();
    #x: number;
    #log = false;
    #plot: Plot | null = null;

    constructor(container: HTMLElement, columns: (TableColumn & { meaning: string })[], marks: Mark[]) {
        this.#columns = columns;
        this.#marks = marks;
        this.#x = Math.max(0, columns.findIndex((c) => c.label === "time"));
        const names = columns.map((c, k): [string, string] => [String(k), titled(c.label, c.unit)]);
        const across = choice("Horizontal axis", names, (value) => {
            this.#x = Number(value);
            this.#draw();
        });
        across.select.value = String(this.#x);
        const log = tick("Logarithmic vertical axis", false, (value) => {
            this.#log = value;
            this.#draw();
        });
        container.replaceChildren(make("div", { class: "own-plot" }, make("div", { class: "own-choices" }, across.element, log.element, this.#list()), this.#place));
        this.#draw();
    }

    /** The columns to tick, with a field that narrows the list. */
    #list(): HTMLElement {
        const rows = this.#columns.map((column, k) => {
            const row = tick(titled(column.label, column.unit), false, (value) => {
                if (value) {
                    this.#chosen.add(k);
                } else {
                    this.#chosen.delete(k);
                }
                this.#draw();
            });
            row.element.title = column.meaning;
            return row.element;
        });
        const filter = make("input", { type: "search", placeholder: "energy, wall top, …" });
        filter.addEventListener("input", () => {
            const words = filter.value.toLowerCase().split(/\s+/);
            rows.forEach((row, k) => (row.hidden = !words.every((word) => this.#columns[k]!.label.toLowerCase().includes(word))));
        });
        return make("fieldset", {}, make("legend", {}, "Vertical axis"), field("Find columns", filter), make("div", { class: "column-list" }, ...rows));
    }

    #draw(): void {
        this.#plot?.dispose();
        this.#plot = null;
        const x = this.#columns[this.#x];
        const lines = [...this.#chosen].sort((a, b) => a - b).map((k) => this.#columns[k]!);
        if (!x || lines.length === 0) {
            this.#place.replaceChildren(make("p", { class: "hint" }, "Tick the columns to plot; any column may be the horizontal axis."));
            return;
        }
        this.#place.replaceChildren();
        const marks = x.label === "time" ? { marks: this.#marks } : {};
        this.#plot = new Plot(this.#place, { title: `${lines.map((line) => line.label).join(", ")} over ${x.label}`, x, lines, log: this.#log, height: 360, ...marks });
    }
}
