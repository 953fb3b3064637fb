// SPDX-License-Identifier: MIT
// What the page asks, answered by the module `oplus`: docs/web.md. Runs in a worker.
import {PlanarSet, certificate, closing, cycles, erosion, ifp, minkowskiSum, nfp, opening, reflected as turned, rounded,
  verify, wayOut, windingNumber} from "./oplus/oplus.js";
import {addPoints, double, doubles, number, written, writtenPoint} from "./numbers.js";
import {edited, isRing, moved, names, read, reflected, wkt} from "./shapes.js";

const operations = {sum: minkowskiSum, nfp, ifp, erosion, opening, closing};

/** Calls, and has messages say what this is called here. */
function named(name, call) {
  try {
    return call();
  } catch (error) {
    error.message = error.message.replace(/^text:/, `${name}:`);
    throw error;
  }
}

function positive(name, text) {
  const value = numberCalled(name, text);
  if (value.n <= 0n) throw new RangeError(`${name}: it is not positive; expected a distance`);
  return value;
}

/** A number, as the core reads numbers. */
function numberCalled(name, text) {
  const [x] = named(name, () => new PlanarSet({type: "Point", coordinates: [text, "0"]})).coordinates({exact: true}).points[0];
  return x;
}

/** A summand, edited: its chains, and its set if it is valid. */
function shape(name, {[name.toLowerCase()]: given, edit}, step) {
  let now = named(name, () => read(given)), text = given;
  if (edit?.of === name.toLowerCase()) {
    text = wkt(named(name, () => edited(now.chains, edit, step)));
    now = read(text);
  }
  const {chains, notes, fault} = now, called = (line) => line.replace(/^text:/, `${name}:`);
  const missing = chains.findIndex(({vertices}) => vertices.length === 0);
  if (missing >= 0) throw new RangeError(`${name}: ${names(chains)[missing]} is missing, so the region is unbounded; expected a bounded region`);
  const isRegion = chains.every(isRing);
  return {name, chains, isRegion, text: wkt(chains), notes: notes.map(called), error: fault && called(fault),
    set: fault ? undefined : new PlanarSet(text)};
}

function shown({chains, text, notes, error}) {
  const vertices = chains.reduce((all, {vertices: {length}}) => all + length, 0);
  return {wkt: text, vertices: `${vertices} ${vertices === 1 ? "vertex" : "vertices"}`, notes, ...(error && {error}),
    kinds: chains.map(({kind}) => kind), names: names(chains),
    chains: chains.map((chain) => chain.vertices.map(doubles)), points: chains.map((chain) => chain.vertices.map(writtenPoint))};
}

/** What drawings need of a set. */
function drawn({polygons, lines, points}) {
  const segments = lines.map((line) => line.flat());
  for (const one of [polygons, lines, points].flat(9))
    if (!Number.isFinite(one)) throw new RangeError("a number is beyond all doubles, and cannot be drawn");
  return {outer: polygons.map(([outer]) => outer), holes: polygons.flatMap(([, ...holes]) => holes), dangling: segments, isolated: points};
}

/** Chains as they are written, for drawings. */
function drawnChains(chains) {
  const of = (wanted) => chains.filter(({kind}) => kind === wanted).map(({vertices}) => vertices.map(doubles));
  const polygons = [];
  for (const {kind, vertices} of chains) {
    if (kind === "outer") polygons.push([vertices.map(doubles)]);
    else if (kind === "hole") polygons.at(-1).push(vertices.map(doubles));
  }
  const segments = of("line").flatMap((line) => line.slice(1).map((end, i) => [line[i], end]));
  return {polygons, lines: segments, points: of("point").map(([point]) => point)};
}

/** The sum that a proved program has written. Lines and points of an open one are in its region, so it is not read as a set. */
function givenSum(text, set, p, r, open) {
  const {chains} = read(text), region = new PlanarSet(wkt(chains.filter(isRing)));
  const isSame = chains.every(isRing) ? set.equals(region) : verify(p.set, r.set, text, {open}).isSum;
  return {wkt: text, geojson: (isSame ? set : new PlanarSet(text)).toGeoJSONText(), same: isSame, area: written(region.exactArea),
    ...drawn({...drawnChains(chains), polygons: region.coordinates().polygons})};
}

/** The cycles of the convolution of P and R, segment by segment. */
function convolution(p, r) {
  const label = ([chain, vertex]) => `${vertex + 1}${chain === 0 ? "" : ` of chain ${chain + 1}`}`;
  return cycles(p.text, r.text).map((cycle) => cycle.map(({edgeOf, edge, vertex, isReflex}) => {
    const [one, other] = edgeOf === "P" ? [p, r] : [r, p], ring = one.chains[edge[0]].vertices;
    const at = other.chains[vertex[0]].vertices[vertex[1]];
    const [a, b] = [ring[edge[1]], ring[(edge[1] + 1) % ring.length]].map((end) => addPoints(end, at));
    return [...doubles(a), ...doubles(b), isReflex, `edge ${label(edge)} of ${one.name} + vertex ${label(vertex)} of ${other.name}`,
      `${writtenPoint(a)} to ${writtenPoint(b)}`];
  }));
}

/** Of P and another set, whether they can be parted, and how. */
function parted(p, q, x) {
  try {
    const {move, squaredLength, contact} = wayOut(p, q, x);
    return {move: writtenPoint(move), squared: written(squaredLength), contact: writtenPoint(contact)};
  } catch (error) {
    if (error.code === "invalid") return {};  // one of them is empty
    throw error;
  }
}

/** What x says: of P and the placed Q for sums and no-fits; `set` is the result. */
function placement(p, q, r, x, set, what) {
  const isSum = what === "sum", at = doubles(x);
  const q_at = q.chains.map(({vertices}) => vertices.map((v) => doubles(v).map((c, i) => isSum ? at[i] - c : at[i] + c)));
  const location = {boundary: "on the boundary of"}[set.locate(x)] ?? set.locate(x);
  const result = {q: q_at, location};
  if (!p.isRegion || !q.isRegion || !(isSum || what === "nfp")) return result;
  const {winding, tangents, onConvolution} = windingNumber(p.set, r.set, x);
  return {...result, winding, tangents, on_convolution: onConvolution,
    meet: minkowskiSum(p.set, r.set, {open: true}).locate(x) === "inside",
    ...parted(p.set, isSum ? turned(q.set) : q.set, x)};
}

function verdict(p, r, open, text) {
  try {
    const given = named("S", () => read(text)), {isSum, reason} = named("S", () => verify(p.set, r.set, text, {open}));
    const {polygons, lines, points} = drawnChains(given.chains);
    const [, ...witness] = reason?.match(/^witness: \((.+?), (.+?)\)/m) ?? [];
    return {chains: polygons.flat(), dangling: lines.map((line) => line.flat()), isolated: points, is_sum: isSum,
      text: isSum ? "yes\n" : `no: ${reason}`, ...(!isSum && {witness: witness.map((c) => double(number(c)))})};
  } catch (error) {
    if (error.code === "invalid") return {error: error.message};
    throw error;
  }
}

function all(request) {
  const {what = "sum", open, sum: given, s, grid, side, edit} = request;
  if (!Object.hasOwn(operations, what)) throw new RangeError(`'${what}' is no operation; expected ${Object.keys(operations).join(", ")}`);
  const step = positive("step", request.step), p = shape("P", request, step), q = shape("Q", request, step);
  let x = request.x.map((c, i) => numberCalled("x", c));
  if (edit?.of === "x") x = moved(x, edit, step);
  const result = {step: double(step), p: shown(p), q: shown(q), x: x.map(written), at: doubles(x)};
  const error = p.error ?? q.error;
  if (error) return {...result, error};

  const isSum = what === "sum";
  /** What P is summed with: of a no-fit polygon, −Q. */
  const r = isSum ? q : {...q, name: "−Q", chains: reflected(q.chains), set: turned(q.set)};
  if (!isSum) r.text = wkt(r.chains);
  const exact = operations[what](p.set, q.set, isSum ? {open} : {}), set = grid ? rounded(exact, grid, {side}) : exact;
  const hasConvolution = (isSum || what === "nfp") && p.isRegion && q.isRegion;
  result.sum = given ? givenSum(given, exact, p, r, open)
    : {wkt: set.toWKT(), geojson: set.toGeoJSONText(), area: written(set.exactArea), ...drawn(set.coordinates())};
  if (grid) result.exact = drawn(exact.coordinates());
  result.cycles = hasConvolution ? convolution(p, r) : [];
  const flat = result.cycles.flat();
  result.segments = flat.length;
  result.reduced = flat.filter(([, , , , isReflex]) => !isReflex).length;
  result.placement = placement(p, q, r, x, exact, what);
  if (s && (isSum || what === "nfp")) result.verdict = verdict(p, r, isSum ? open : true, s);
  return result;
}

/** What Q sweeps on lines of doubles: the sum of the two. */
const swept = ({lines, q}) => ({swept: drawn(minkowskiSum({type: "MultiLineString", coordinates: lines}, q).coordinates())});

/** A certificate of the closed sum, and the texts that it is of. */
function certified([p, q]) {
  const sets = [p, q].map((text) => new PlanarSet(text)), sum = minkowskiSum(...sets).toWKT(), [of_p, of_q] = sets.map(String);
  return {certificate: {p: of_p, q: of_q, sum, text: certificate(...sets, sum)}};
}

export function answer(request) {
  try {
    return request.lines ? swept(request) : request.certify ? certified(request.certify) : all(request);
  } catch (error) {
    if (error instanceof WebAssembly.RuntimeError) throw error;
    return {error: error.message, refused: true};
  }
}
