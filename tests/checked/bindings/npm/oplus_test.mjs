// SPDX-License-Identifier: GPL-3.0-or-later
// node --expose-gc oplus_test.mjs CASES: what the installed module computes, in Node; of tests/corpus/cases.json, what it has
// functions for.
import assert from "node:assert";
import {readFileSync} from "node:fs";

let memory;
const {instantiate} = WebAssembly;
WebAssembly.instantiate = async (...values) => {
  const made = await instantiate(...values);
  memory = made.instance.exports.memory;
  return made;
};
const {OplusError, PlanarSet, asWritten, certificate, closing, complement, cycles, disc, erosion, ifp, minkowskiSum, nfp,
  opening, reflected, rounded, verify, version, wayOut, windingNumber} = await import("oplus");

const set = (shape) => new PlanarSet(shape);
const fails = (call, expected, code = "invalid") => assert.throws(call, (error) => {
  assert(error instanceof OplusError && error instanceof Error, String(error));
  assert.equal(error.code, code);
  assert(!error.message.includes("\n"));
  assert.match(error.message, expected);
  return true;
});

// Cases.
const operations = {read: set, "read a set": set, sum: minkowskiSum, "sum of sets": minkowskiSum, nfp, ifp, erode: erosion,
  open: opening, close: closing, complement, reflect: reflected, "reflect a set": reflected,
  disc: (p, q, {radius, error, disc: side}) => disc(radius, error, {side: side === "inside" ? "contained" : "contain"})};
const {layers, cases} = JSON.parse(readFileSync(process.argv[2], "utf8"));
// What reads regions only, there, reads sets, here; that is told by the operations alone.
const readsMore = /LINESTRING|POINT|LineString|Point/;
let ran = 0;
for (const one of cases) {
  for (const operation of one.run) {
    const compute = operations[operation];
    if (!(one.layers ?? layers[operation]).includes("library") || one.union || one.format === "wkb" || one.p?.includes("\0")) continue;
    if (!operation.includes("set") && readsMore.test((one.p ?? "") + (one.q ?? ""))) continue;
    const name = `${one.name}, ${operation}`;
    if (operation === "verify" && one.reasons) {
      const {isSum, reason} = verify(one.p, one.q, JSON.stringify(one.s), {open: Boolean(one.open)});
      assert.deepEqual([isSum, reason?.split("\n")[0]], [one.reasons.length === 0, one.reasons[0]], name);
    } else if (!compute) {
      continue;
    } else {
      const computed = () => {
        let result = compute(one.p, one.q, {...one, open: Boolean(one.open)});
        if (one.grid) result = rounded(result, one.grid, {side: one.side});
        if (one["complement is"] !== undefined) result = complement(result);
        const digits = one.digits === undefined ? undefined : Number(one.digits);
        return one.format === "geojson" ? result.toGeoJSONText(digits) : result.toWKT(digits);
      };
      // Sets may have more than regions: only what is expected differs.
      const wrong = ({message}) => message.replace(/^file:/, "text:").split("; expected ")[0];
      const expected = one.is ?? one["complement is"];
      if (one.refused !== undefined)
        assert.throws(computed, (error) => {
          assert.equal(wrong(error), wrong({message: one.refused}), name);
          return error instanceof OplusError && error.code === "invalid" && /^[^\n]+$/.test(error.message);
        }, name);
      // A region that is no sum keeps its vertices there; here it has a canonical form.
      else if (/^(read|reflect|complement|disc)$/.test(operation)) assert(set(computed()).equals(expected), `${name}: ${computed()}`);
      else assert.equal(computed(), expected, name);
    }
    ++ran;
  }
}
assert(ran > 400, `${ran} cases`);

// What sets are made from.
const square = [[0, 0], [4, 0], [4, 4], [0, 4]], hole = [[1, 1], [1, 2], [2, 2], [2, 1]];
const sameAs = (shape, wkt) => assert.equal(set(shape).toWKT(), wkt);
const written = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))";
sameAs(square, written);
sameAs([...square, [0, 0]], written);
sameAs(square.map(([x, y]) => [BigInt(x), String(y)]), written);
sameAs(" M 0 0 h 4 v 4 h -4 z", written);
sameAs({type: "Feature", properties: {n: 1, d: 2}, geometry: {type: "Polygon", coordinates: [[...square, [0, 0]]]}}, written);
sameAs([square, hole], "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 2 1, 1 1))");
sameAs([[square], [[[9, 9], [10, 9], [9, 10]]]], "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0)), ((9 9, 10 9, 9 10, 9 9)))");
sameAs([[0, 0], [{n: 1n, d: 3n}, 0], [0, {s: -1n, n: 1n, d: 3n}]], "POLYGON ((0 -1/3, 1/3 0, 0 0, 0 -1/3))");
sameAs([], "POLYGON EMPTY");
sameAs({type: "MultiPoint", coordinates: [[1, 2], ["1/3", 4n]]}, "GEOMETRYCOLLECTION (POINT (1/3 4), POINT (1 2))");
sameAs([[0, 0], [1e23, 0], [0, "1"]], "POLYGON ((0 0, 99999999999999991611392 0, 0 1, 0 0))");
const tenth = {n: 3602879701896397n, d: 36028797018963968n};
for (const shape of [[[0, 0], [0.1, 0], [0, 1]], [[0, 0], [0.1, 0], [0, "1"]],
  {type: "Polygon", coordinates: [[[0, 0], [0.1, 0], [0, 1], [0, 0]]]}])
  assert.deepEqual(set(shape).coordinates({exact: true}).polygons[0][0][1], [tenth, {n: 0n, d: 1n}]);
assert.deepEqual(set([[0, 0], ["0.1", 0], [0, 1]]).coordinates({exact: true}).polygons[0][0][1][0], {n: 1n, d: 10n});
for (const small of [5e-324, -2.5e-320]) assert.equal(set([[0, 0], [small, 0], [0, "1"]]).area, set([[0, 0], [small, 0], [0, 1]]).area);

// What is read of them.
const frame = set([[[0, 0], [5, 0], [5, 5], [0, 5]], [[1, 1], [1, 4], [4, 4], [4, 1]]]);
const part = [[0, 0], [3, 0], [3, 3], [0, 3]];
const fits = nfp(frame, part);
assert.deepEqual(fits.coordinates(), {polygons: [[[[-3, -3], [5, -3], [5, 5], [-3, 5]]]], lines: [], points: [[1, 1]]});
assert.deepEqual(ifp([[0, 0], [5, 0], [5, 3], [0, 3]], part).coordinates().lines, [[[0, 0], [2, 0]]]);
assert.deepEqual(frame.coordinates().polygons[0][1], [[1, 1], [1, 4], [4, 4], [4, 1]]);
assert.deepEqual(fits.toGeoJSON().type, "GeometryCollection");
assert.equal(fits.locate([1, 1]), "boundary");
assert.equal(frame.locate([1n, "5/2"]), "boundary");
assert(!fits.contains([1, 1]) && fits.contains([0.5, 0.5]) && frame.contains([1, 1]));
assert.equal(frame.area, 16);
assert.deepEqual(set([[0, 0], [1, 0], [0, "2/3"]]).exactArea, {n: 1n, d: 3n});
assert.equal(`${minkowskiSum(square, square)}`, "POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0))");
assert(minkowskiSum(square, reflected(square)).equals([[-4, -4], [4, -4], [4, 4], [-4, 4]]));
assert.deepEqual(verify(square, square, minkowskiSum(square, square)), {isSum: true});
assert.match(verify(square, square, square).reason, /^not in given: |^missing|:/);
assert.equal(rounded(set([[0, 0], ["1/3", 0], [0, 1]]), "0.25").area, 0.125);
assert.match(version(), /^\d+\.\d+\.\d+$/);

// The convolution, and what is asked of a place.
const whole = (...numbers) => numbers.map((value) => ({n: BigInt(value), d: 1n})), triangle = [[0, 0], [2, 0], [0, 2]];
assert.deepEqual(asWritten("POLYGON((0 0,0 1,1 0,0 0))"), {chains: [{kind: "outer", vertices: [whole(0, 0), whole(1, 0), whole(0, 1)]}],
  notes: ["text: outer chain of component 1 was clockwise; turned"]});
const crossed = asWritten("POLYGON((0 0,4 4,4 0,0 4,0 0))");
assert.match(crossed.fault, /cross/);
assert.equal(crossed.chains[0].vertices.length, 4);
assert.deepEqual(asWritten("MULTIPOINT(1 2)").chains, [{kind: "point", vertices: [whole(1, 2)]}]);
const traced = cycles("POLYGON((0 0,4 0,4 4,0 4,0 0))", "POLYGON((0 0,2 0,0 2,0 0))");
assert.deepEqual([traced.length, traced[0].length], [1, 7]);
assert.deepEqual(traced[0].filter(({edgeOf}) => edgeOf === "Q").map(({edge}) => edge).sort(), [[0, 0], [0, 1], [0, 2]]);
assert(traced[0].every(({isReflex, vertex: [chain]}) => !isReflex && chain === 0));
assert.deepEqual(windingNumber(square, triangle, ["1/2", 1]), {winding: 1, tangents: 1, onConvolution: false});
assert.deepEqual(windingNumber(square, triangle, [0, 1]).onConvolution, true);
assert.deepEqual(wayOut(square, square, [3, "1/2"]), {move: whole(1, 0), squaredLength: whole(1)[0], contact: wayOut(square, square, [3, "1/2"]).contact});
assert.deepEqual(wayOut(square, square, [9, 0]).move, whole(-5, 0));
fails(() => wayOut([], square), /./);
assert.match(certificate(square, square, "POLYGON((0 0,8 0,8 8,0 8,0 0))"), /^oplus certificate /);
fails(() => certificate(square, square, square), /./);
assert.match(verify(square, square, square).reason, /^witness: \(.*, .*\) /m);

// What is wrong.
fails(() => set([[0, 0], [4, 4], [4, 0], [0, 4]]), /edges/);
fails(() => set([[0, 0], [1, 0], [0, NaN]]), /not a number|infinite/);
fails(() => set([[0, 0], [1, 0, 5], [0, "x"]]), /./);
fails(() => set("POLYGON((0 0,1\n0))"), /^text:/);
fails(() => set("POINT(0 0)\0"), /zero/);
fails(() => set(null), /./);
fails(() => set({}), /./);
fails(() => ifp("POINT(0 0)", square), /^p: it has lines or points/);
fails(() => disc(1, 0), /positive/);
fails(() => rounded(square, 1, {side: "above"}), /side/);
const freed = set(square);
freed.free();
fails(() => freed.area, /freed/);

// What is freed is used again: what is freed by hand, what is only named in a call, and what the garbage collector finds.
const size = () => memory.buffer.byteLength;
const many = Array.from({length: 1000}, (_, i) => [i, i * i]);
minkowskiSum(many, square).free();
const before = size();
for (let i = 0; i < 300; ++i) {
  const sum = minkowskiSum(many, square);
  if (i % 3 === 0) fails(() => minkowskiSum(many, "POINT"), /^text:/);
  sum.free();
}
assert(size() <= 2 * before, `${size()} bytes after ${before}`);
for (let i = 0; i < 1000; ++i) {
  set(many);
  if (i % 100 !== 0) continue;
  globalThis.gc();
  await new Promise((resolve) => setTimeout(resolve));
}
assert(size() <= 4 * before, `${size()} bytes after ${before}`);
console.log(`oplus ${version()} in Node ${process.version}: ${ran} cases`);
