// SPDX-License-Identifier: MIT
// P and Q as they are written: chains {kind, vertices} in their order, exact, which may be no valid set.
import {asWritten} from "./oplus/oplus.js";
import {addPoints, integer, middle, multiply, negative, written} from "./numbers.js";

export const isRing = ({kind}) => kind === "outer" || kind === "hole";

/** Segments one after another are one line. */
function joined(chains) {
  const result = [];
  for (const {kind, vertices} of chains) {
    const last = result.at(-1), [start, end] = vertices;
    const goesOn = kind === "line" && last?.kind === "line" && last.vertices.at(-1).every((c, i) => written(c) === written(start[i]));
    if (goesOn) last.vertices.push(end);
    else result.push({kind, vertices: [...vertices]});
  }
  return result;
}

/** Returns {chains, notes, fault}; throws where the syntax is wrong. */
export function read(text) {
  const {chains, ...said} = asWritten(text);
  return {chains: joined(chains), ...said};
}

export function wkt(chains) {
  const row = (vertices) => `(${vertices.map((v) => v.map(written).join(" ")).join(", ")})`;
  const polygons = [], others = [];
  for (const {kind, vertices} of chains) {
    if (kind === "outer") polygons.push([]);
    if (kind === "outer" || kind === "hole") polygons.at(-1).push(row([...vertices, vertices[0]]));
    else others.push(`${kind === "line" ? "LINESTRING" : "POINT"} ${row(vertices)}`);
  }
  const rings = polygons.map((polygon) => `(${polygon.join(", ")})`);
  const region = rings.length > 1 ? `MULTIPOLYGON (${rings.join(", ")})` : rings.length ? `POLYGON ${rings[0]}` : null;
  const all = region ? [region, ...others] : others;
  return all.length > 1 ? `GEOMETRYCOLLECTION (${all.join(", ")})` : all[0] ?? "POLYGON EMPTY";
}

export const names = (chains) => {
  let component = 0, hole = 0;
  const others = {line: 0, point: 0};
  return chains.map(({kind}) => {
    if (kind === "hole") return `hole ${++hole} of component ${component}`;
    if (kind !== "outer") return `${kind} ${++others[kind]}`;
    hole = 0;
    return `outer chain of component ${++component}`;
  });
};

const mapped = (chains, map) => chains.map(({kind, vertices}) => ({kind, vertices: vertices.map(map)}));
export const reflected = (chains) => mapped(chains, (vertex) => vertex.map(negative));

/** Where a move by steps of a grid takes a point: by them, or to them. */
export function moved(point, {how, at}, step) {
  const steps = at.map((count) => multiply(integer(count), step));
  return how === "by" ? addPoints(point, steps) : steps;
}

// Without `with` and `toSpliced`, which Debian's Node does not have.
const replaced = (list, at, value) => list.map((old, i) => i === at ? value : old);
const removed = (list, at) => list.filter((_, i) => i !== at);

/** Removes a vertex; of a hole with three, the hole, and likewise lines and points where other chains stay. */
function without(chains, chain, vertex) {
  const {kind, vertices} = chains[chain], fewest = {outer: 3, hole: 3, line: 2, point: 1}[kind];
  if (vertices.length > fewest) return replaced(chains, chain, {kind, vertices: removed(vertices, vertex)});
  if (kind === "outer") throw new RangeError("an outer chain of three vertices cannot lose one; expected more vertices");
  if (chains.length === 1) throw new RangeError(`the only ${kind} cannot be removed; expected another chain`);
  return removed(chains, chain);
}

/** Adds a vertex in the middle of the edge that follows; at the end of a line, one further on. */
function withOneMore({kind, vertices}, vertex) {
  if (kind === "point") throw new RangeError("a point has no edge; expected a vertex of an edge");
  const here = vertices[vertex], isEnd = kind === "line" && vertex === vertices.length - 1;
  const added = isEnd ? addPoints(here, addPoints(here, vertices[vertex - 1].map(negative)))
    : middle(here, vertices[(vertex + 1) % vertices.length]);
  return {kind, vertices: [...vertices.slice(0, vertex + 1), added, ...vertices.slice(vertex + 1)]};
}

/** What an edit of the page makes of chains. */
export function edited(chains, {chain, vertex, ...edit}, step) {
  if (vertex === undefined) return mapped(chains, (one) => moved(one, edit, step));
  const one = chains[chain];
  if (!one?.vertices[vertex]) throw new RangeError("the edit names a vertex that is not there; expected one that is");
  if (edit.how === "remove") return without(chains, chain, vertex);
  const changed = edit.how === "add" ? withOneMore(one, vertex)
    : {...one, vertices: replaced(one.vertices, vertex, moved(one.vertices[vertex], edit, step))};
  return replaced(chains, chain, changed);
}
