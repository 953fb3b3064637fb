// SPDX-License-Identifier: MIT
// What users call: README.md, oplus.d.ts.
import {OplusError, call, chains, double, free, integer, pointer, text, version} from "./core.js";

export {OplusError, version};

const kinds = {outer: 0, hole: 1, line: 2, point: 3};
const sides = ["nearest", "contain", "contained"];

const isFraction = (value) => typeof value === "object" && value !== null && "n" in value && "d" in value;

/** A number for exactly what it is, as text. */
function exact(value) {
  if (isFraction(value)) return `${BigInt(value.s ?? 1) * BigInt(value.n)}/${BigInt(value.d)}`;
  if (typeof value !== "number" || Number.isSafeInteger(value) || !Number.isFinite(value)) return String(value);
  let denominator = 1n;
  for (; !Number.isInteger(value); value *= 2) denominator *= 2n;
  return `${BigInt(value)}/${denominator}`;
}

/** JSON with the same numbers. */
const json = (value) => JSON.stringify(value, (_, inner) =>
  typeof inner === "bigint" || (typeof inner === "number" && !Number.isSafeInteger(inner)) || isFraction(inner) ? exact(inner) : inner);

const textOf = (shape) => shape instanceof PlanarSet ? shape.toWKT() : typeof shape === "string" ? shape : json(shape);

const isNumeric = (point) => Array.isArray(point) && point.length === 2 && point.every((value) => typeof value === "number");
const isRing = (ring) => Array.isArray(ring) && ring.length > 0 && ring.every(isNumeric);
const isPolygon = (polygon) => Array.isArray(polygon) && polygon.length > 0 && polygon.every(isRing);

/** Arrays of numbers as polygons, or undefined. */
function polygonsOf(shape) {
  if (isRing(shape)) return [[shape]];
  if (isPolygon(shape)) return [shape];
  if (Array.isArray(shape) && shape.length > 0 && shape.every(isPolygon)) return shape;
}

const same = (a, b) => a[0] === b[0] && a[1] === b[1];

/** Returns the handle of a new set. */
function read(shape) {
  const polygons = polygonsOf(shape);
  if (!polygons)
    return call(typeof shape === "string" && /^\s*m[\s\d.+-]/i.test(shape) ? "read" : "read_set", [textOf(shape)], pointer);
  // The last vertex may be the first one again.
  const rings = polygons.flat().map((ring) => ring.length > 1 && same(ring[0], ring.at(-1)) ? ring.slice(0, -1) : ring);
  const roles = polygons.flatMap((polygon) => polygon.map((_, i) => i === 0 ? kinds.outer : kinds.hole));
  return call("from_doubles", [Float64Array.from(rings.flat(2)), Uint32Array.from(rings, (ring) => ring.length),
    Int32Array.from(roles), rings.length], pointer);
}

const finalized = new FinalizationRegistry(free);
const internal = Symbol("handle");

/** Calls with handles of shapes. */
function using(shapes, compute) {
  const made = [];
  try {
    return compute(...shapes.map((shape) => {
      if (shape instanceof PlanarSet) return shape[internal];
      made.push(read(shape));
      return made.at(-1);
    }));
  } finally {
    made.forEach(free);
  }
}

const make = (name, shapes, values = []) =>
  using(shapes, (...handles) => new PlanarSet({[internal]: call(name, [...handles, ...values], pointer)}));

function fraction(written) {
  const [n, d = "1"] = written.split("/");
  return {n: BigInt(n), d: BigInt(d)};
}

const place = ([x, y]) => [exact(x), exact(y)];

export class PlanarSet {
  #handle;

  constructor(shape) {
    this.#handle = shape?.[internal] ?? read(shape);
    finalized.register(this, this.#handle, this);
  }

  get [internal]() {
    if (this.#handle === 0) throw new OplusError("the set has been freed", "invalid");
    return this.#handle;
  }

  free() {
    finalized.unregister(this);
    free(this.#handle);
    this.#handle = 0;
  }

  toWKT(digits = -1) { return call("wkt", [this[internal], digits], text); }
  toString() { return this.toWKT(); }
  toGeoJSONText(digits = -1) { return call("geojson", [this[internal], digits], text); }
  toGeoJSON(digits = -1) { return JSON.parse(this.toGeoJSONText(digits)); }

  coordinates({exact: isExact = false} = {}) {
    const written = isExact ? call("fractions", [this[internal]], text).split(" ").map(fraction) : [];
    const result = {polygons: [], lines: [], points: []};
    let at = 0;
    for (const [kind, xy] of chains(this[internal])) {
      const vertices = pairs(isExact ? written.slice(at, at += xy.length) : xy);
      if (kind === kinds.outer) result.polygons.push([vertices]);
      else if (kind === kinds.hole) result.polygons.at(-1).push(vertices);
      else if (kind === kinds.line) result.lines.push(vertices);
      else result.points.push(vertices[0]);
    }
    return result;
  }

  get area() { return call("area", [this[internal]], () => { const area = double(); text(8); return area; }); }
  get exactArea() { return fraction(call("area", [this[internal]], () => text(8))); }
  locate(point) { return ["outside", "boundary", "inside"][call("locate", [this[internal], ...place(point)], integer)]; }
  contains([x, y]) { return call("contains", [this[internal], x, y], integer) === 1; }
  equals(other) { return using([this, other], (a, b) => call("equal", [a, b], integer) === 1); }
}

export const minkowskiSum = (p, q, {open = false} = {}) => make("sum", [p, q], [Number(open)]);
export const nfp = (p, q) => make("nfp", [p, q]);
export const ifp = (p, q) => make("ifp", [p, q]);
export const erosion = (p, q) => make("erosion", [p, q]);
export const opening = (p, q) => make("opening", [p, q]);
export const closing = (p, q) => make("closing", [p, q]);
export const reflected = (p) => make("reflected", [p]);
export const complement = (p) => make("complement", [p]);

export function rounded(p, step, {side = "nearest"} = {}) { return make("rounded", [p], [exact(step), sides.indexOf(side)]); }

export function disc(radius, error, {side = "contain"} = {}) {
  return make("disc", [], [exact(radius), sides.indexOf(side), exact(error)]);
}

/** The numbers of a line that C writes. */
const numbersOf = (line) => line.split(" ").map(fraction);
const linesOf = (written) => written.split("\n").slice(0, -1);

function pairs(numbers) {
  const result = [];
  for (let i = 0; i < numbers.length; i += 2) result.push([numbers[i], numbers[i + 1]]);
  return result;
}

export function asWritten(shape) {
  return call("as_written", [textOf(shape)], () => {
    const [lines, notes, fault] = [text(), text(8), text(16)];
    const chains = linesOf(lines).map((line) => {
      const [kind, ...numbers] = line.split(" ");
      return {kind: Object.keys(kinds)[kind], vertices: pairs(numbers.map(fraction))};
    });
    return {chains, notes: linesOf(notes), ...(fault && {fault})};
  });
}

export function cycles(p, q) {
  return linesOf(call("cycles", [textOf(p), textOf(q)], text)).map((line) => {
    const numbers = line.trim().split(" ").map(Number), cycle = [];
    for (let i = 0; i < numbers.length; i += 6) {
      const [of, edgeChain, edge, vertexChain, vertex, isReflex] = numbers.slice(i, i + 6);
      cycle.push({edgeOf: "PQ"[of], edge: [edgeChain, edge], vertex: [vertexChain, vertex], isReflex: isReflex === 1});
    }
    return cycle;
  });
}

export const windingNumber = (p, q, x) => using([p, q], (...both) => call("winding", [...both, ...place(x)],
  () => ({winding: integer(), tangents: integer(8), onConvolution: integer(16) === 1})));

export function wayOut(p, q, x = [0, 0]) {
  const [move, [squaredLength, ...contact]] = using([p, q], (...both) => {
    const numbers = numbersOf(call("way_out", [...both, ...place(x)], text));
    return [numbers.slice(0, 2), numbers.slice(2)];
  });
  return {move, squaredLength, contact};
}

export const certificate = (p, q, claimed, {open = false} = {}) =>
  using([p, q], (...both) => call("certify", [...both, textOf(claimed), Number(open)], text));

export function verify(p, q, claimed, {open = false} = {}) {
  return using([p, q], (...both) => call("verify", [...both, textOf(claimed), Number(open)], () => {
    const isSum = integer() === 1, reason = text(8);
    return isSum ? {isSum} : {isSum, reason};
  }));
}
