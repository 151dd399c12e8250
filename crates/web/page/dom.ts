// Small pieces of pages.

type Attributes = Record<string, string | number | boolean>;

/** An element with attributes and content; texts mean themselves. */
export function make<K extends keyof HTMLElementTagNameMap>(tag: K, attributes: Attributes = {}, ...content: (Node | string)[]): HTMLElementTagNameMap[K] {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
        if (value === true) {
            element.setAttribute(name, "");
        } else if (value !== false) {
            element.setAttribute(name, String(value));
        }
    }
    element.append(...content);
    return element;
}

export function button(text: string, act: () => void, attributes: Attributes = {}): HTMLButtonElement {
    const made = make("button", { type: "button", ...attributes }, text);
    made.addEventListener("click", act);
    return made;
}

let fields = 0;

/** A control below its label. */
export function field(label: HTMLElement | string, control: HTMLElement, ...more: Node[]): HTMLElement {
    control.id ||= `field-${++fields}`;
    return make("div", { class: "field" }, make("label", { for: control.id }, label), ...more, control);
}

/** A choice with its label. */
export function choice(label: string, options: [string, string][], chosen: (value: string) => void): { element: HTMLElement; select: HTMLSelectElement } {
    const select = make("select", {}, ...options.map(([value, text]) => make("option", { value }, text)));
    select.addEventListener("change", () => chosen(select.value));
    return { element: field(label, select), select };
}

export interface Slider {
    element: HTMLElement;
    input: HTMLInputElement;
    /** Sets the value as if the user had. */
    set(value: number): void;
}

/** A slider with its label and value. */
export function slider(label: string, range: { min: number; max: number; step: number; value: number }, told: (value: number) => string, moved: (value: number) => void): Slider {
    const input = make("input", { type: "range", ...range });
    // the slider itself tells its value
    const output = make("output", { "aria-live": "off" }, told(range.value));
    const act = () => {
        output.textContent = told(input.valueAsNumber);
        input.setAttribute("aria-valuetext", told(input.valueAsNumber));
        moved(input.valueAsNumber);
    };
    input.addEventListener("input", act);
    const element = field(label, input, output);
    output.htmlFor.add(input.id);
    const set = (value: number) => {
        input.value = String(value);
        act();
    };
    return { element, input, set };
}

/** A box to tick with its label. */
export function tick(label: string, ticked: boolean, changed: (ticked: boolean) => void): { element: HTMLElement; input: HTMLInputElement } {
    const input = make("input", { type: "checkbox", checked: ticked });
    input.addEventListener("change", () => changed(input.checked));
    return { element: make("label", { class: "tick" }, input, label), input };
}

/** A group of controls with its title. */
export function group(title: string, ...content: Node[]): HTMLFieldSetElement {
    return make("fieldset", {}, make("legend", {}, title), ...content);
}

/** Saves a file. */
export function save(blob: Blob, name: string): void {
    const link = make("a", { href: URL.createObjectURL(blob), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
