// Bundles the page's script with the chart library: node build.mjs OUT_DIRECTORY

import { build } from "esbuild";
import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2];

const result = await build({
  absWorkingDir: here,
  entryPoints: ["src/main.js"],
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  charset: "ascii",
  legalComments: "none",  // The licences stand in the head, in full.
  metafile: true,
  write: false,
});

/** Packages whose code is in the bundle. */
const packages = new Set(Object.entries(Object.values(result.metafile.outputs)[0].inputs)
  .filter(([, { bytesInOutput }]) => bytesInOutput > 0)
  .map(([path]) => path.match(/node_modules\/((?:@[^/]+\/)?[^/]+)/)?.[1])
  .filter((name) => name !== undefined));

function licenceOf(name) {
  const directory = join(here, "node_modules", name);
  const file = readdirSync(directory).find((each) => /^licen[cs]e/i.test(each));
  const { version, license } = JSON.parse(readFileSync(join(directory, "package.json"), "utf8"));
  return { title: `${name} ${version} (${license})`,
           text: file ? readFileSync(join(directory, file), "utf8").trim() : license };
}

/** Packages under one text share it. */
const byText = new Map();
for (const name of [...packages].sort()) {
  const { title, text } = licenceOf(name);
  byText.set(text, [...(byText.get(text) ?? []), title]);
}
const licences = [...byText].map(([text, titles]) => `${titles.join(", ")}\n\n${text}`).join("\n\n");
const head = `/* Made by scripts/report-bundle from harness/report/page; do not edit.\n\n${
  licences.replaceAll("*/", "* /").replaceAll("</", "< /")}\n*/\n`;

if (!existsSync(out)) mkdirSync(out, { recursive: true });
writeFileSync(join(out, "report.js"), head + result.outputFiles[0].text);
writeFileSync(join(out, "report.css"), readFileSync(join(here, "style.css")));
