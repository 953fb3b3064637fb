#!/usr/bin/env node
// SPDX-License-Identifier: GPL-3.0-or-later
// sum.mjs P Q: the closed Minkowski sum of two files of WKT by Clipper2. Its MinkowskiSum sums boundaries,
// and takes one path. So the sums with each path are united with the paths, moved to the pattern's
// first vertex, as Clipper 6 did and as is suggested in Clipper2's issue 719; complete unless the paths fit
// into the pattern. The larger summand is the paths, as in ../clipper_method.hpp. Written are chains, in
// SVG, since Clipper2's may touch themselves, which WKT's rings may not.
import { readFileSync } from 'node:fs';
import clipper2 from 'clipper2-wasm';

const most = 0x3fffffffn;  // as for Clipper 6

class Refused extends Error {}
class Invalid extends Error {}

const abs = (a) => (a < 0n ? -a : a);
const gcd = (a, b) => (b === 0n ? abs(a) : gcd(b, a % b));
const max = (numbers) => numbers.reduce((a, b) => (a > b ? a : b));
const min = (numbers) => numbers.reduce((a, b) => (a < b ? a : b));

/// [numerator, denominator], in lowest terms.
function rational(text) {
  const [, sign, whole, decimals = '', divisor = '1'] =
    text.match(/^(-?)(\d+)(?:\.(\d+))?(?:\/(\d+))?$/) ?? [];
  if (whole === undefined || BigInt(divisor) === 0n) throw new Invalid(`not a coordinate: ${text}`);
  const numerator = BigInt(sign + whole + decimals);
  const denominator = BigInt(divisor) * 10n ** BigInt(decimals.length);
  const common = gcd(numerator, denominator);
  return [numerator / common, denominator / common];
}

/// The chains of a polygon, without the repeated last vertex.
function polygon(file) {
  const text = readFileSync(file, 'utf8').trim();
  if (/^MULTIPOLYGON|EMPTY$/.test(text)) throw new Refused('supports one component only');
  if (!/^POLYGON\s*\(\s*\([^()]*\)(\s*,\s*\([^()]*\))*\s*\)$/.test(text))
    throw new Invalid(`${file}: expected POLYGON (...)`);
  return text.match(/\([^()]*\)/g).map((ring) => {
    const chain = ring.slice(1, -1).split(',').map((vertex) => vertex.trim().split(/\s+/).map(rational));
    if (chain.some((vertex) => vertex.length !== 2)) throw new Invalid(`${file}: expected x y`);
    return chain.slice(0, -1);
  });
}

/// The largest power of two, times the common denominator, with which summands and sum are at most `most`.
function scaleOf(summands) {
  const all = summands.map((chains) => chains.flat(2));
  const denominator = all.flat().reduce((a, [, d]) => (a / gcd(a, d)) * d, 1n);
  const reach = all
    .map((numbers) => max(numbers.map(([n, d]) => abs((n * denominator) / d))))
    .reduce((a, b) => a + b);
  if (reach > most) throw new Refused('does not support such large coordinates');
  let power = 1n;
  while (reach > 0n && 2n * power * reach <= most) power *= 2n;
  return denominator * power;
}

function mayFitInto(inner, outer) {
  const extent = (chains, axis) => {
    const values = chains[0].map((vertex) => vertex[axis]);
    return max(values) - min(values);
  };
  return [0, 1].every((axis) => extent(inner, axis) < extent(outer, axis));
}

/// Simple chains: one that returns to a vertex is two.
function simpleChains(path) {
  const chains = [];
  const open = [];
  for (const vertex of path) {
    const start = open.findIndex(([x, y]) => x === vertex[0] && y === vertex[1]);
    if (start >= 0) chains.push(open.splice(start));
    open.push(vertex);
  }
  return [...chains, open];
}

async function sum(files) {
  const given = files.map(polygon);
  const scale = scaleOf(given);
  const [p, q] = given.map((chains) =>
    chains.map((chain) => chain.map((vertex) => vertex.map(([n, d]) => (n * scale) / d))));
  const [paths, pattern] = mayFitInto(p, q) ? [q, p] : [p, q];
  if (pattern.length > 1) throw new Refused('does not support holes in the smaller summand');

  const library = await clipper2();
  const pathOf = (chain) => library.MakePath64(chain.flat());
  const [x, y] = pattern[0][0];
  const subjects = new library.Paths64();
  const clips = new library.Paths64();
  for (const chain of paths) {
    const swept = library.MinkowskiSum64(pathOf(pattern[0]), pathOf(chain), true);
    for (let i = 0; i < swept.size(); ++i) subjects.push_back(swept.get(i));
    clips.push_back(library.TranslatePath64(pathOf(chain), x, y));
  }
  const union = library.Union64(subjects, clips, library.FillRule.NonZero);

  const coordinate = (value) => `${value}/${scale}`;
  const lines = [];
  for (let i = 0; i < union.size(); ++i) {
    const path = union.get(i);
    const vertices = [];
    for (let j = 0; j < path.size(); ++j) vertices.push([path.get(j).x, path.get(j).y]);
    for (const chain of simpleChains(vertices))
      lines.push(`M ${chain.map((vertex) => vertex.map(coordinate).join(' ')).join(' L ')} Z`);
  }
  return lines.join('\n');
}

try {
  if (process.argv.length !== 4) throw new Invalid('usage: sum.mjs P Q');
  console.log(await sum(process.argv.slice(2)));
} catch (error) {
  if (error instanceof Refused) {
    console.error(error.message);
    process.exitCode = 77;
  } else if (error instanceof Invalid || error.code === 'ENOENT') {
    console.error(`clipper2: ${error.message}`);
    process.exitCode = 2;
  } else {
    throw error;
  }
}
