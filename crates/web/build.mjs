// Bundles the pages into dist/, which is committed: building Demeter needs no Node.
//
//   node build.mjs           writes dist/
//   node build.mjs --check   writes nothing; fails when dist/ is not what the sources make
import { build } from "esbuild";
import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const dist = join(here, "dist");
const check = process.argv.includes("--check");
// every page that has an entry point; each becomes NAME.js and NAME.css
const pages = ["report", "viewer"].filter((name) => existsSync(join(here, "page", `${name}.ts`)));
const bundled = ["three", "uplot", "fflate", "webm-muxer"];

const licences = bundled
    .map((name) => {
        const folder = join(here, "node_modules", name);
        const { version } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
        return `${name} ${version}\n\n${readFileSync(join(folder, "LICENSE"), "utf8").trim()}\n`;
    })
    .join("\n---\n\n");
const banner = `/*! This page holds these libraries:\n\n${licences.replaceAll("*/", "* /")}*/`;

const result = await build({
    absWorkingDir: here,
    entryPoints: pages.map((name) => `page/${name}.ts`),
    outdir: dist,
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: ["es2022"],
    charset: "ascii",
    legalComments: "none",
    banner: { js: banner },
});

const files = new Map(result.outputFiles.map((file) => [file.path, file.text]));
for (const [path, text] of [...files]) {
    // closing tags would end the element that holds the text; the hash goes into the page's Content-Security-Policy
    if (/<\/(script|style)/i.test(text)) {
        throw new Error(`${path} holds a closing tag and cannot be put into a page`);
    }
    files.set(`${path}.sha256`, createHash("sha256").update(text).digest("base64"));
}
files.set(join(dist, "LICENCES.txt"), licences);

const stale = [...files].filter(([path, text]) => !existsSync(path) || readFileSync(path, "utf8") !== text);
if (check && stale.length > 0) {
    console.error(`not what the sources make: ${stale.map(([path]) => path).join(", ")}`);
    console.error("run: cargo xtask web");
    process.exit(1);
}
if (!check) {
    mkdirSync(dist, { recursive: true });
    for (const [path, text] of stale) {
        writeFileSync(path, text);
    }
    for (const [path, text] of files) {
        console.log(`${path.slice(here.length + 1)}  ${(text.length / 1024).toFixed(0)} KiB`);
    }
}
