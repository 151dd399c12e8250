// The page of a report: draws what the report holds as data.
import "./base.css";
import "./report.css";
import { counts, floats, numbers, type Packed } from "./arrays";
import { Link, Plot, type Mark, type TableColumn } from "./plots";
import type { Grains } from "./scene";
import { contactEnds } from "./scene/contact_ends";
import { ScenePanel, type PackingState, type ScalarInfo } from "./scene_panel";
import { OwnPlot } from "./own_plot";

interface ColumnData {
    name: string;
    unit: string;
    meaning: string;
    values: Packed;
}

interface SeriesData {
    rows: number;
    columns: ColumnData[];
    stages: { name: string; row: number }[];
    groups: { title: string; place: string; x: string; y: string[] }[];
}

interface PackingData {
    grains: { id: Packed; position: Packed; radius: Packed; scalars: (ColumnData & { names?: string[] })[] };
    contacts: { id_i: Packed; id_j: Packed; wall: Packed; point: Packed; normal_force: Packed; total_force: Packed; mean_force: number | null };
    walls: { name: string; index: number; triangles: Packed }[];
}

interface DistributionData {
    x: string;
    unit: string;
    low: number;
    width: number;
    of: string;
    lines: { name: string; counts: number[] }[];
}

interface ReportData {
    title: string;
    series: SeriesData | null;
    packing: PackingData | null;
    distributions: Record<string, DistributionData>;
}

/** The whole of this page's plots over time zooms together. */
const time = new Link();

function start(): void {
    const data = JSON.parse(document.getElementById("report-data")!.textContent!) as ReportData;
    // one part that fails leaves the others whole
    for (const part of [drawSeries, drawDistributions, drawPacking]) {
        try {
            part(data);
        } catch (error) {
            console.error(error);
        }
    }
    preparePrint();
}

function drawSeries({ series }: ReportData): void {
    if (!series) {
        return;
    }
    const columns = series.columns.map((c): TableColumn & { meaning: string } => ({ label: c.name, unit: c.unit, meaning: c.meaning, values: numbers(c.values) }));
    const find = (name: string) => columns.find((c) => c.label === name || `${c.label} [${c.unit}]` === name);
    const times = find("time");
    const marks: Mark[] = series.stages.map(({ name, row }) => ({ at: times?.values[row] ?? NaN, label: name }));
    for (const { title, place, x, y } of series.groups) {
        const container = document.getElementById(place);
        const [across, lines] = [find(x), y.map(find).filter((c) => c !== undefined)];
        if (container && across && lines.length > 0) {
            // spans many powers of ten wherever grains come to rest
            const log = y.includes("kinetic over elastic");
            new Plot(container, { title, x: across, lines, canBeLog: true, log, ...(across === times ? { marks, link: time } : {}) });
        }
    }
    const own = document.getElementById("own-plot");
    if (own) {
        new OwnPlot(own, columns, marks);
    }
}

function drawDistributions({ distributions }: ReportData): void {
    for (const [key, { x, unit, low, width, of, lines }] of Object.entries(distributions)) {
        const container = document.getElementById(`distribution-${key}`);
        const bins = lines[0]?.counts.length ?? 0;
        if (container && bins > 0) {
            const middles = Float64Array.from({ length: bins }, (_, k) => low + (k + 0.5) * width);
            new Plot(container, {
                title: `${of[0]!.toUpperCase()}${of.slice(1)} in each bin`,
                x: { label: x, unit, values: middles },
                lines: lines.map((line) => ({ label: line.name, unit: "", values: line.counts })),
                bars: true,
                yLabel: of,
                canBeLog: true,
            });
        }
    }
}

function drawPacking({ packing, title }: ReportData): void {
    const container = document.getElementById("scene");
    if (container && packing) {
        new ScenePanel(container, { label: `Last state of ${title}`, fileName: "packing" }).show(stateOf(packing));
    }
}

function stateOf({ grains, contacts, walls }: PackingData): PackingState {
    const scalars = new Map<string, Float32Array>();
    const categories = new Map<string, string[]>();
    const infos: ScalarInfo[] = [];
    for (const { name, unit, meaning, values, names } of grains.scalars) {
        scalars.set(name, floats(values));
        infos.push({ name, unit, meaning });
        if (names) {
            categories.set(name, names);
        }
    }
    const drawn: Grains = { position: floats(grains.position), radius: floats(grains.radius), id: counts(grains.id), scalars, categories };
    const places = { idI: counts(contacts.id_i), idJ: counts(contacts.id_j), point: floats(contacts.point) };
    return {
        grains: drawn,
        contacts: {
            count: places.idI.length,
            meanForce: contacts.mean_force ?? 0,
            chains: { ends: contactEnds(places, drawn), normalForce: floats(contacts.normal_force) },
            partners: { ...places, wall: floats(contacts.wall), totalForce: floats(contacts.total_force) },
        },
        walls: walls.map(({ name, index, triangles }) => ({ name, index, triangles: floats(triangles) })),
        scalars: infos,
    };
}

/** On paper everything is dark on white, whatever the screen shows. */
function preparePrint(): void {
    const root = document.documentElement;
    const set = (printed: boolean) => {
        root.toggleAttribute("data-printed", printed);
        window.dispatchEvent(new Event("demeter:colours"));
    };
    window.addEventListener("beforeprint", () => set(true));
    window.addEventListener("afterprint", () => set(false));
}

start();
