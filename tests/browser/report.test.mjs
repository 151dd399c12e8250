// `report.html` in headless Chromium.
//
// DEMETER_RUN names the folder of a run with contacts, walls and a series; DEMETER_RUN_ALONE that of a run without contacts
// whose title is EVIL. `cargo xtask browser` makes both.
import assert from "node:assert/strict";
import { join, resolve } from "node:path";
import { after, before, describe, test } from "node:test";
import { pathToFileURL } from "node:url";
import { accessibility, compare, keep, launch, listen, open, settled, tabStops, withGpu } from "./browser.mjs";

const EVIL = "</script><script>alert(1)</script><img src=x onerror=alert(1)>";
const address = (variable) => {
    assert.ok(process.env[variable], `${variable} names no folder`);
    return pathToFileURL(join(resolve(process.env[variable]), "report.html")).href;
};

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

/** The report, once its scene is drawn. */
async function report(options = {}, variable = "DEMETER_RUN") {
    const opened = await open(browser, address(variable), options);
    await opened.page.waitForSelector("#scene canvas");
    const view = opened.page.locator("#scene .scene-frame");
    const picture = async () => {
        await settled(opened.page);
        return view.screenshot();
    };
    return { ...opened, view, picture };
}

/** The range of the horizontal axis of a plot. */
const range = (plot) => plot.evaluate((element) => element.dataset.range.split(" ").map(Number));

describe("the 3D view", () => {
    test("shows the packing, and every control changes it", async () => {
        const { page, faults, picture } = await report({ init: `(${withGpu})()` });
        const first = await picture();
        const { colours } = await compare(browser, first);
        assert.ok(colours > 200, `the view has ${colours} colours`);
        await keep(page, "report");
        let last = first;
        const changes = async (what, least = 0.002) => {
            const now = await picture();
            const { different } = await compare(browser, last, now);
            assert.ok(different > least, `${what} changed ${different} of the picture`);
            last = now;
        };
        const controls = page.locator(".scene-controls");
        const named = await controls.getByLabel("Colour grains by").locator("option").allTextContents();
        assert.deepEqual(named.slice(0, 8), ["contact force", "speed", "spin", "mean normal stress", "coordination", "radius", "total force", "material"]);
        for (const name of ["speed", "spin", "mean normal stress", "coordination", "radius", "total force", "material"]) {
            await controls.getByLabel("Colour grains by").selectOption(name);
            assert.match(await page.locator(".colour-key").textContent(), new RegExp(`^${name}`));
            await changes(`colouring by ${name}`);
        }
        await controls.getByLabel("Show force chains").check();
        assert.match(await controls.locator(".hint").first().textContent(), /^\d+ of \d+ contacts/);
        assert.match(await page.locator(".colour-key").last().textContent(), /^force chains: normal force \[\S*N\]0/);
        await changes("force chains");
        await controls.getByLabel("Opacity of walls").fill("0.6");
        await changes("the opacity of walls");
        await controls.getByLabel("Cut", { exact: true }).selectOption("across y");
        await changes("the clip plane");
        await controls.getByRole("button", { name: "Top" }).click();
        await changes("the view from above");
        assert.deepEqual(faults, []);
        await page.close();
    });

    test("is turned by keys and tells of a picked grain", async () => {
        const { page, view, picture, faults } = await report();
        const canvas = page.locator("#scene canvas");
        await canvas.focus();
        const before = await picture();
        for (const key of ["ArrowLeft", "Shift+ArrowUp", "+"]) {
            await page.keyboard.press(key);
        }
        assert.ok((await compare(browser, before, await picture())).different > 0.01);
        await page.keyboard.press("0");
        const { width, height } = await view.boundingBox();
        // the grains lie at the bottom of the box: from its middle downwards one is met
        const picked = page.locator(".picked");
        for (let share = 0.5; share < 0.9 && !(await picked.textContent()).startsWith("Grain "); share += 0.05) {
            await canvas.click({ position: { x: width / 2, y: share * height } });
        }
        assert.match(await picked.textContent(), /^Grain \d+.*centre.*speed/s);
        assert.deepEqual(faults, []);
        await page.close();
    });

    test("tells of a grain that is picked by its id, and says what changes once", async () => {
        const { page, faults } = await report();
        const said = await listen(page);
        await page.getByLabel("Id of a grain").fill("7");
        await page.keyboard.press("Enter");
        assert.match(await page.locator(".picked").textContent(), /^Grain 7.*centre.*speed/s);
        assert.equal((await said()).length, 1);
        await page.getByLabel("Id of a grain").fill("123456");
        await page.keyboard.press("Enter");
        assert.equal(await page.locator(".picked").textContent(), "Grain 123456 is not there.");
        await page.getByLabel("Opacity of grains").focus();
        await said();
        await page.keyboard.press("ArrowLeft");
        assert.equal(await page.getByLabel("Opacity of grains").getAttribute("aria-valuetext"), "98 %");
        assert.deepEqual(await said(), [], "a slider tells its value itself");
        assert.deepEqual(faults, []);
        await page.close();
    });

    test("is a message where there is no WebGL, and the rest works", async () => {
        const without = await launch({ webgl: false });
        const { page, faults } = await open(without, address("DEMETER_RUN"));
        await page.waitForSelector(".no-webgl");
        assert.match(await page.locator(".no-webgl").textContent(), /needs WebGL 2/);
        assert.ok((await page.locator("#plots-energy canvas").count()) > 0);
        assert.deepEqual(faults.filter((fault) => !fault.includes("WebGL")), []);
        await without.close();
    });
});

describe("plots", () => {
    test("zoom by dragging, together, and come back", async () => {
        const { page, faults } = await report();
        const [plot, linked] = [page.locator("#plots-energy .plot").first(), page.locator("#plots-series .plot").first()];
        const whole = await range(plot);
        await plot.scrollIntoViewIfNeeded();
        const box = await plot.locator(".u-over").boundingBox();
        await page.mouse.move(box.x + 0.3 * box.width, box.y + 50);
        await page.mouse.down();
        await page.mouse.move(box.x + 0.6 * box.width, box.y + 60, { steps: 4 });
        await page.mouse.up();
        const zoomed = await range(plot);
        assert.ok(zoomed[1] - zoomed[0] < 0.4 * (whole[1] - whole[0]), `${zoomed} of ${whole}`);
        assert.deepEqual(await range(linked), zoomed);
        await plot.getByRole("button", { name: "Reset: see everything" }).click();
        assert.deepEqual(await range(plot), whole);
        await plot.locator(".plot-surface").focus();
        await page.keyboard.press("+");
        assert.ok((await range(plot))[1] < whole[1]);
        await page.keyboard.press("0");
        assert.deepEqual(await range(plot), whole);
        assert.deepEqual(faults, []);
        await page.close();
    });

    test("have their numbers as tables, and lines that can be hidden", async () => {
        const { page } = await report();
        const plot = page.locator("#plots-energy .plot").first();
        await plot.getByText("Numbers").click();
        // the table is filled when it has opened
        await plot.locator("tbody tr").nth(1).waitFor({ state: "attached" });
        const line = plot.locator(".plot-legend button").first();
        const before = await plot.locator(".plot-surface").screenshot();
        await line.click();
        assert.equal(await line.getAttribute("aria-pressed"), "false");
        assert.ok((await compare(browser, before, await plot.locator(".plot-surface").screenshot())).different > 0.001);
        await page.close();
    });

    test("of any columns can be made", async () => {
        const { page, faults } = await report();
        const own = page.locator("#own-plot");
        await own.getByLabel("Find columns").fill("kinetic energy");
        await own.getByRole("checkbox", { name: "kinetic energy [J]" }).check();
        await own.getByLabel("Horizontal axis").selectOption({ label: "gravitational energy [J]" });
        await own.getByLabel("Logarithmic vertical axis").check();
        assert.match(await own.locator("figcaption").textContent(), /^kinetic energy over gravitational energy/);
        const { colours } = await compare(browser, await own.locator(".plot-surface").screenshot());
        assert.ok(colours > 10);
        assert.deepEqual(faults, []);
        await page.close();
    });
});

describe("the page", () => {
    test("is reached by keyboard in the order in which it is read", async () => {
        const { page } = await report();
        const stops = await tabStops(page);
        assert.deepEqual(stops.slice(0, 2).map(({ name }) => name), ["Skip to the content", "Last state"]);
        const view = stops.find(({ name }) => name.includes("a 3D view. Arrow keys: turn"));
        // what the picture shows, for those who do not see it
        assert.match(view.description, /^\d+ grains, with 1 wall, in .* by .* by .*, coloured by contact force from .* to .* \S+; \d+ contacts\.$/);
        assert.deepEqual(stops.filter(({ name, inWindow, ring }) => name === "" || !inWindow || !ring), []);
        assert.ok(stops.some(({ role, name }) => role === "application" && name.startsWith("Plot of")), "plots");
        assert.ok(stops.length < 299, "the Tab key leaves the page");
        assert.equal(await page.locator("[tabindex]:not([tabindex='0']):not([tabindex='-1'])").count(), 0);
        await page.close();
    });

    for (const colorScheme of ["light", "dark"]) {
        test(`has nothing that axe-core finds wrong (${colorScheme})`, async () => {
            const { page } = await report({ colorScheme });
            await keep(page, `report-${colorScheme}`);
            assert.deepEqual(await accessibility(page), []);
            await page.close();
        });
    }

    test("is whole at twice the size of its letters, too", async () => {
        // a window of 1280 by 720 at 200 %
        const { page, faults } = await report({ viewport: { width: 640, height: 360 }, deviceScaleFactor: 2 });
        await keep(page, "report-zoomed");
        assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 640);
        assert.deepEqual(faults, []);
        await page.close();
    });

    test("fits a phone", async () => {
        const { page, faults } = await report({ viewport: { width: 400, height: 800 } });
        await keep(page, "report-phone");
        assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 400);
        assert.deepEqual(faults, []);
        await page.close();
    });

    test("prints, with the view as a picture", async () => {
        const { page } = await report();
        const printed = await page.pdf({ format: "A4" });
        assert.ok(printed.length > 50_000, `${printed.length} bytes`);
        assert.match(await page.locator(".print-only").getAttribute("src"), /^data:image\/png/);
        await page.close();
    });

    test("runs no script of a title, and shows a run without contacts", async () => {
        const { page, faults } = await report({}, "DEMETER_RUN_ALONE");
        assert.equal(await page.locator("h1").textContent(), EVIL);
        assert.match(await page.locator("#contacts").textContent(), /No contact carries a force/);
        assert.deepEqual(await accessibility(page), []);
        await keep(page, "report-alone");
        assert.deepEqual(faults, []);
        await page.close();
    });
});
