// SPDX-License-Identifier: GPL-3.0-or-later
// npm_sums.mjs FOLDER: sums by the npm modules oplus, clipper2-wasm and clipper-lib, which are installed in a folder, from
// arrays to arrays: milliseconds, in one thread, the median of rounds in which they take turns, and how many times as long
// as oplus the others take. They round to integers, here of 30 bits. A row fails where areas differ by more than that explains.
import {readFileSync} from "node:fs";
import {createRequire} from "node:module";
import path from "node:path";
import {pathToFileURL} from "node:url";

const folder = path.resolve(process.argv[2]), require = createRequire(path.join(folder, "any.js"));
const oplus = await import(pathToFileURL(path.join(folder, "node_modules/oplus/node.js")));
const Clipper = require("clipper-lib");
const clipper2Path = require.resolve("clipper2-wasm");
const clipper2 = await require("clipper2-wasm")({wasmBinary: readFileSync(clipper2Path.replace(/js$/, "wasm"))});
const versionOf = (name) => JSON.parse(readFileSync(path.join(folder, "node_modules", name, "package.json"), "utf8")).version;

// Inputs: rings of numbers.
let state = 1;
const random = (below) => (state = (state * 48271) % 2147483647) % below;
const star = (count, size) => Array.from({length: count}, (_, i) => {
  const radius = size * (i % 2 ? 0.3 : 0.7) + random(size * 0.3), angle = 2 * Math.PI * (i + random(1000) / 2000) / count;
  return [Math.round(radius * Math.cos(angle)), Math.round(radius * Math.sin(angle))];
});
const data = path.join(import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname), "../data");
const published = (name) => [1, 2].map((part) =>
  new oplus.PlanarSet(readFileSync(path.join(data, `${name}_part${part}.dat`), "utf8")).coordinates().polygons[0][0]);
const rows = {
  "published comb": [published("comb")],
  "published fork": [published("fork")],
  "published stars": [published("stars")],
  "star of 100 vertices and star of 30": [[star(100, 1e6), star(30, 1e6)]],
  "2000 pairs of stars of 4 to 8 vertices": Array.from({length: 2000}, () => [star(4 + random(5), 100), star(4 + random(5), 100)]),
};

// Both add boundaries, and are given the larger path, moved to a vertex of the other one, to fill it.
const extent = (ring) => Math.max(...ring.map(([x]) => x)) - Math.min(...ring.map(([x]) => x));
const inOrder = (p, q) => extent(p) < extent(q) ? [p, q] : [q, p];
const toClipper2 = (ring) => clipper2.MakePath64(ring.flat());
const libraries = {
  oplus(p, q) {
    const sum = oplus.minkowskiSum(p, q), {polygons} = sum.coordinates();
    sum.free();
    return polygons.flat();
  },
  "clipper2-wasm"(p, q) {
    const [pattern, ring] = inOrder(p, q), first = pattern[0];
    const a = toClipper2(pattern), b = toClipper2(ring), moved = new clipper2.Paths64();
    const filled = clipper2.TranslatePath64(b, BigInt(first[0]), BigInt(first[1]));
    moved.push_back(filled);
    const swept = clipper2.MinkowskiSum64(a, b, true);
    const sum = clipper2.Union64(swept, moved, clipper2.FillRule.NonZero), rings = [];
    for (let i = 0; i < sum.size(); ++i) {
      const of = sum.get(i), ring = [];
      for (let j = 0; j < of.size(); ++j) {
        const point = of.get(j);
        ring.push([Number(point.x), Number(point.y)]);
        point.delete();
      }
      rings.push(ring);
      of.delete();
    }
    [a, b, moved, filled, swept, sum].forEach((made) => made.delete());
    return rings;
  },
  "clipper-lib"(p, q) {
    const [pattern, ring] = inOrder(p, q).map((one) => one.map(([X, Y]) => ({X, Y})));
    return Clipper.Clipper.MinkowskiSum(pattern, [ring], true).map((one) => one.map(({X, Y}) => [X, Y]));
  },
};

const area = (rings) => rings.reduce((sum, ring) => sum + ring.reduce((twice, [x, y], i) => {
  const [u, v] = ring[(i + 1) % ring.length];
  return twice + (x * v - u * y) / 2;
}, 0), 0);

/** Integers of 30 bits, as the others need them; oplus is given the same. */
function scaled(pair) {
  const factor = 2 ** 29 / Math.max(...pair.flat(2).map(Math.abs));
  return pair.map((ring) => ring.map((point) => point.map((value) => Math.round(value * factor))));
}

const median = (values) => values.sort((a, b) => a - b)[values.length >> 1];
const names = Object.keys(libraries);
console.log(`Node ${process.versions.node}\n`);
console.log(`| sum, ms | ${names.map((name) => `${name} ${versionOf(name)}`).join(" | ")} |\n|---${"|---".repeat(names.length)}|`);
let wrong = 0;
for (const [name, pairs] of Object.entries(rows)) {
  const inputs = pairs.map(scaled), times = Object.fromEntries(names.map((library) => [library, []]));
  const results = Object.fromEntries(names.map((library) => [library, inputs.map(([p, q]) => area(libraries[library](p, q)))]));
  for (const library of names)
    wrong += results[library].filter((found, i) => Math.abs(found - results.oplus[i]) > 1e-5 * results.oplus[i]).length;
  for (let round = 0, since = performance.now(); round < 5 || (round < 50 && performance.now() - since < 3000); ++round)
    for (const library of names) {
      const start = performance.now();
      for (const [p, q] of inputs) libraries[library](p, q);
      times[library].push(performance.now() - start);
    }
  const oplusTime = median(times.oplus), digits = (value) => Number(value.toPrecision(3));
  console.log(`| ${name} | ${names.map((library) => {
    const time = median(times[library]);
    return digits(time) + (library === "oplus" ? "" : ` (${digits(time / oplusTime)} times)`);
  }).join(" | ")} |`);
}
console.log(`\n${wrong} sums whose areas differ`);
process.exit(wrong === 0 ? 0 : 1);
