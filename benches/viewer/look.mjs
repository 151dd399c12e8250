// How long a run takes to be seen in `demeter view`, and how smoothly it plays and turns: headless Chromium.
//
//   DEMETER=target/debug/demeter node benches/viewer/look.mjs FOLDER
//
// DEMETER_GPU=1 lets Chromium use the GPU; without it WebGL is drawn by the processor (SwiftShader), which is many times slower.
import { spawn } from "node:child_process";
import { createRequire } from "node:module";
import { executable } from "../../tests/browser/browser.mjs";

const { chromium } = createRequire(new URL("../../tests/browser/browser.mjs", import.meta.url))("playwright-core");
const [folder] = process.argv.slice(2);
const server = spawn(process.env.DEMETER ?? "demeter", ["view", folder, "--no-browser"]);
const started = performance.now();
const address = await new Promise((done) => server.stdout.once("data", (text) => done(String(text).trim())));
const seconds = (from) => ((performance.now() - from) / 1000).toFixed(2);
console.log(`server up after ${seconds(started)} s`);

for (const round of ["first", "again"]) {
    const state = await (await fetch(`${address}api/state?moments=0`)).json();
    const begun = performance.now();
    const bytes = (await (await fetch(`${address}api/frame/${state.moments.steps[1]}`)).arrayBuffer()).byteLength;
    console.log(`a frame from the server, ${round}: ${seconds(begun)} s, ${(bytes / 1e6).toFixed(1)} MB`);
}

const software = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];
const gpu = ["--use-angle=gl-egl", "--enable-gpu", "--ignore-gpu-blocklist"];
const browser = await chromium.launch({ executablePath: executable(), args: ["--no-sandbox", ...(process.env.DEMETER_GPU ? gpu : software)] });
const page = await browser.newPage({ viewport: { width: 1400, height: 900 } });
const begun = performance.now();
await page.goto(address);
const drawn = (at) => page.waitForFunction((k) => document.querySelector(".timeline")?.dataset.shown === String(k), at, { timeout: 120_000, polling: 10 });
await drawn(1);
console.log(`first picture after ${seconds(begun)} s (page, first frame, drawn)`);
const renderer = await page.evaluate(() => {
    const gl = document.createElement("canvas").getContext("webgl2");
    return gl.getParameter(gl.getExtension("WEBGL_debug_renderer_info").UNMASKED_RENDERER_WEBGL);
});
const count = Number(/of (\d+)/.exec(await page.textContent(".time-told"))[1]);
for (const round of ["first time", "second time"]) {
    await page.getByRole("button", { name: "First frame" }).click();
    await drawn(1);
    await page.getByLabel("Frames per second").selectOption("60");
    const from = performance.now();
    await page.getByRole("button", { name: "Play", exact: true }).click();
    await drawn(count);
    console.log(`plays ${((count - 1) / seconds(from)).toFixed(1)} frames per second, ${round}`);
}
await page.locator("canvas").first().focus();
const turned = await page.evaluate(async () => {
    const canvas = document.querySelector("canvas");
    const from = performance.now();
    for (let k = 0; k < 20; k++) {
        canvas.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft", bubbles: true }));
        await new Promise((done) => requestAnimationFrame(() => setTimeout(done, 0)));
    }
    // reading a pixel waits until all is drawn
    const gl = canvas.getContext("webgl2");
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    return 20e3 / (performance.now() - from);
});
console.log(`turns at ${turned.toFixed(1)} pictures per second; drawn by ${renderer}`);
await browser.close();
server.kill("SIGINT");
