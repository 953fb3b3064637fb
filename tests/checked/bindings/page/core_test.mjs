// SPDX-License-Identifier: GPL-3.0-or-later
// core_test.mjs FOLDER OPLUS CORPUS CASES: what the page's worker answers is what the program `oplus` does, and
// what tests/corpus/cases.json says. The proved programs beside it compute the same sums, and accept its certificates.
// Coordinates of 10^7 and more need more bits than a long has there: edges cross in long fractions.
import assert from "node:assert";
import {execFileSync} from "node:child_process";
import {cpSync, mkdtempSync, readFileSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import path from "node:path";
import {pathToFileURL} from "node:url";
import vm from "node:vm";
import {followsFromWkt} from "./drawn.mjs";

const [folder, oplus, corpus, casesFile] = process.argv.slice(2);
const scratch = mkdtempSync(path.join(tmpdir(), "oplus-web-"));
cpSync(folder, path.join(scratch, "page"), {recursive: true});
// Browsers need no such word.
writeFileSync(path.join(scratch, "page/package.json"), '{"type": "module"}');
const module = (name) => import(pathToFileURL(path.join(scratch, "page", name)));
await (await module("oplus/core.js")).start(new Uint8Array(readFileSync(path.join(folder, "oplus/oplus.wasm.gz"))));
const {answer} = await module("answers.js");

/** As the worker is asked, and answers. */
const ask = (request) => structuredClone(answer({x: ["1/2", "1/3"], step: "1", s: "", open: false, ...request}));
/** A proved program, as a function of what its worker is sent. */
const program = (name) => {
  let answer;
  const worker = vm.createContext({onmessage: null, postMessage: ({code, text}) => { answer = {code, text: text.trim()}; }});
  vm.runInContext(readFileSync(path.join(folder, name), "utf8"), worker);
  return (...data) => {
    worker.onmessage({data});
    return answer;
  };
};
const proved = program("oplus-proved.js"), certified = program("oplus-certified.js");
const run = (...words) => {
  try {
    return execFileSync(oplus, words, {encoding: "utf8", stdio: ["ignore", "pipe", "pipe"]});
  } catch (failed) {
    return failed.stdout;
  }
};
const file = (name, text) => {
  writeFileSync(path.join(scratch, name), text);
  return path.join(scratch, name);
};

const pairs = readFileSync(corpus, "utf8").replace(/^#.*\n/gm, "").replace(/\n[ \t]+/g, " ").split(/\n\n+/)
  .map((block) => Object.fromEntries(block.trim().split("\n").map((line) => line.split(/: (.*)/s))))
  .filter(({P, Q}) => /^(MULTI)?POLYGON/.test(P ?? "") && /^(MULTI)?POLYGON/.test(Q ?? ""));
assert(pairs.length >= 20, `${pairs.length} pairs in the corpus`);
for (const size of ["1000003", "1000000007", "1000000000000037", "1000000000000000003"]) {
  const at = (i, j) => `${BigInt(size) * BigInt(i) + BigInt(j * j)} ${BigInt(size) * BigInt(j) - BigInt(3 * i)}`;
  const ring = (...corners) => `POLYGON((${[...corners, corners[0]].map(([i, j]) => at(i, j)).join(", ")}))`;
  pairs.push({name: size, P: ring([-40, 0], [-10, 0], [-10, 40], [-20, 13], [-29, 41], [-40, 40]),
    Q: ring([0, 0], [2, -1], [5, 3], [1, 1], [-2, 2])});
}
const isSmall = ({P, Q}) => (P + Q).length < 4000;

const verdict = (s, asked, words, name) => {
  const {is_sum, text, witness} = ask({...asked, s}).verdict, said = run("verify", ...words);
  assert.equal(text, said.replace(/^note: .*\n/gm, ""), name);
  assert.equal(is_sum, said.startsWith("yes"), name);
  assert.equal(witness?.length, is_sum ? undefined : 2, name);
};

/** The proved sum is the core's set, and its certificates are accepted, other ones not; `expected` is what `oplus` wrote. */
const proofs = (pair, open, {p, q, sum}, expected) => {
  const name = `${pair.name}, open: ${open}`, asked = {p: pair.P, q: pair.Q, open};
  const {code, text} = proved(open ? "open" : "closed", p.wkt, q.wkt);
  assert.equal(code, 0, `${name}: ${text}`);
  assert(ask({...asked, s: text}).verdict.is_sum, `${name}: ${text}`);
  const {wkt, same, ...shown} = ask({...asked, sum: text}).sum;
  assert.deepEqual({wkt, same, ...shown}, {...sum, wkt: text, same: true}, name);
  assert.equal(ask({...asked, sum: p.wkt}).sum.same, p.wkt === expected, name);
  const {p: ofP, q: ofQ, sum: ofSum, text: certificate} = ask({certify: [p.wkt, q.wkt]}).certificate;
  assert.deepEqual(certified(ofP, ofQ, ofSum, certificate), {code: 0, text: "certified: S is the Minkowski sum of P and Q"}, name);
  const moved = certificate.replace(/^in \d+ \d+$/m, "in 0 7777");
  if (moved !== certificate) assert.equal(certified(ofP, ofQ, ofSum, moved).code, 1, name);
  if (ofP !== ofSum) assert.notEqual(certified(ofP, ofQ, ofP, certificate).code, 0, name);
};

let compared = 0, asProved = 0;
const places = new Set();
for (const pair of pairs.filter(isSmall)) {
  const {name, P, Q} = pair, p = file("p.wkt", P), q = file("q.wkt", Q);
  for (const open of [false, true]) {
    const kind = open ? ["--open"] : [];
    const expected = run("sum", p, q, ...kind).trim();
    const answer = ask({p: P, q: Q, open});
    assert.equal(answer.error, undefined, name);
    assert.equal(answer.sum.wkt, expected, `${name}, open: ${open}`);
    const {winding, tangents} = answer.placement;
    assert.equal(winding, tangents, `winding number and tangent count, ${name}`);
    for (const x of [["1/2", "1/3"], ["-7/3", "5/2"]])
      places.add(followsFromWkt(ask({p: P, q: Q, open, x}), x, name));
    verdict(expected, {p: P, q: Q, open}, [p, q, file("s.wkt", expected), ...kind], name);
    verdict(P, {p: P, q: Q, open}, [p, q, p, ...kind], `${name}, P as its sum`);
    if ((P + Q).length < 1000) {
      proofs(pair, open, answer, expected);
      ++asProved;
    }
    ++compared;
  }
}

assert(places.has(true) && places.has(false), "x is always inside, or always outside");
const corner = ask({p: "POLYGON((0 0,4 0,0 4,0 0))", q: "POLYGON((0 0,2 0,0 2,0 0))", x: ["0", "3"]}).placement;
assert.deepEqual([corner.location, corner.meet, corner.on_convolution], ["on the boundary of", false, true]);
assert.deepEqual([corner.move, corner.squared], ["(0, 0)", "0"]);
assert.equal(ask({p: "POLYGON EMPTY", q: "POLYGON((0 0,2 0,0 2,0 0))"}).placement.move, undefined);
const across = ask({p: "POLYGON((0 0,4 0,4 4,0 4,0 0))", q: "POLYGON((0 0,1 1.5,-1 1.5,0 0))", x: ["2", "1/2"]}).placement;
assert.deepEqual([across.move, across.squared, across.contact], ["(0, -0.5)", "0.25", "(2, 0)"]);

const square = "POLYGON((0 0,4 0,4 4,0 4,0 0))";
const {layers, cases} = JSON.parse(readFileSync(casesFile, "utf8"));
// A summand is named in the cases as a file is. The page reads sets: of a region, they expect less.
const inFile = (said) => said.replace(/^[PQS]:/, "file:"), wrong = (said) => inFile(said).split("; expected ")[0].replace(/^file:\d+:\d+: (.* is missing, so)/, "file: $1");
const whats = {sum: "sum", "sum of sets": "sum", nfp: "nfp", ifp: "ifp", erode: "erosion", open: "opening", close: "closing"};
const found = ({p, q, s, open, grid, side}, operation) => {
  const answer = ask({p, q: q ?? square, s: s ? JSON.stringify(s) : "", open: open ?? false, what: whats[operation], grid, side});
  const notes = answer.p?.notes.map(inFile), error = answer.p?.error ?? answer.error;
  if (error !== undefined)
    return {refused: wrong(error)};
  if (operation === "verify")
    return {first: answer.verdict.text.split("\n")[0]};
  return {is: operation === "read" ? answer.p.wkt : answer.sum.wkt, notes};
};
let ran = 0;
for (const one of cases) {
  for (const operation of one.run.filter((name) => (one.layers ?? layers[name]).includes("page"))) {
    // No region there, a set here.
    if (!operation.includes("set") && one.refused !== undefined && /LINESTRING|POINT|LineString|Point/.test(one.p + one.q)) continue;
    // What the page does not ask for; and a text ends with a zero, to C.
    if (one.p?.includes("\0") || one.format || one.digits !== undefined || one["complement is"] !== undefined || one.union) continue;
    ++ran;
    assert(operation in whats || operation === "read" || operation === "verify", operation);
    const {is, refused, reasons, notes} = one, result = found(one, operation);
    if (refused === undefined && /is missing, so the region is unbounded$/.test(result.refused)) continue;  // other layers take them
    const expected = refused !== undefined ? {refused: wrong(refused)} :
      reasons !== undefined ? {first: reasons.length ? `no: ${reasons[0]}` : "yes"} : {is, notes: notes ?? result.notes};
    assert.deepEqual(result, expected, `${one.name}, ${operation}`);
  }
}
assert(ran > 200, `${ran} cases`);

assert.match(ask({p: "POINT(0 0)\0", q: square}).error, /zero/);
assert(ask({p: square, q: square, step: "0"}).refused);
assert(ask({p: square, q: square, x: ["a", "1"]}).refused);
for (const beyond of [{x: ["1e400", "1"]}, {p: "POLYGON((0 0,1e400 0,0 1,0 0))"}, {s: "POLYGON((0 0,1e400 0,0 1,0 0))"}])
  assert.match(ask({p: square, q: square, ...beyond}).error ?? "", /^a number is beyond all doubles/);
assert(ask({p: square, q: square, s: "POLYGON"}).verdict.error);

// Edits are exact.
const edited = (edit, p = square, step = "1/3") => ask({p, q: square, step, edit: {of: "p", chain: 0, ...edit}});
assert.equal(edited({vertex: 1, how: "by", at: [1, 0]}).p.points[0][1], "(13/3, 0)");
assert.equal(edited({vertex: 1, how: "to", at: [7, 1]}).p.points[0][1], "(7/3, 1/3)");
assert.equal(edited({vertex: 3, how: "add"}).p.points[0][4], "(0, 2)");
assert.equal(edited({how: "by", at: [1, 1]}).p.points[0][2], "(13/3, 13/3)");
assert.equal(edited({vertex: 3, how: "remove"}).p.chains[0].length, 3);
assert(edited({vertex: 0, how: "remove"}, "POLYGON((0 0,1 0,0 1,0 0))").refused);
assert.equal(edited({vertex: 2, how: "remove", chain: 1}, "POLYGON((0 0,9 0,0 9,0 0),(1 1,1 2,2 1,1 1))").p.chains.length, 1);
const bent = "LINESTRING(0 0,1 0,1 1/3)";
assert.equal(edited({vertex: 2, how: "add"}, bent).p.wkt, "LINESTRING (0 0, 1 0, 1 1/3, 1 2/3)");
assert.equal(edited({vertex: 0, how: "remove"}, bent).p.wkt, "LINESTRING (1 0, 1 1/3)");
assert.equal(edited({vertex: 0, how: "to", at: [-1, 2]}, "POINT(5 5)").p.wkt, "POINT (-1/3 2/3)");
assert(edited({vertex: 0, how: "remove"}, "POINT(5 5)").refused);

// What Q sweeps on lines is the sum of the two.
const lines = [[[0, 0], [3.5, 0], [3.5, 2]], [[7, 7], [8, 9]]], tool = "POLYGON((0 0,1 0,0.25 1,0 0))";
const wkt = `MULTILINESTRING(${lines.map((line) => `(${line.map((v) => v.join(" "))})`)})`;
const {swept} = ask({lines, q: tool});
assert.deepEqual(swept, Object.fromEntries(Object.keys(swept).map((name) => [name, ask({p: wkt, q: tool}).sum[name]])));
assert.equal(ask({p: wkt, q: tool}).sum.wkt, run("sum", file("p.wkt", wkt), file("q.wkt", tool)).trim());

// Other operations are those of the program, the no-fit polygon with its convolution.
for (const [what, command] of [["nfp", "nfp"], ["ifp", "ifp"], ["erosion", "erode"], ["opening", "open"], ["closing", "close"]])
  for (const {name, P, Q} of pairs.filter(isSmall).slice(0, 12)) {
    const {sum, placement, cycles} = ask({p: P, q: Q, what}), words = [file("p.wkt", P), file("q.wkt", Q)];
    assert.equal(sum.wkt, run(command, ...words).trim(), `${command}, ${name}`);
    assert.equal(cycles.length > 0, what === "nfp", `${command}, ${name}`);
    if (what !== "nfp") continue;
    assert.equal(placement.winding, placement.tangents, name);
    assert.equal(placement.meet, placement.winding > 0 && placement.location === "inside", name);
  }
assert(ask({p: square, q: square, what: "toString"}).refused);
const rough = ask({p: "POLYGON((0 0,1/3 0,0 1/3,0 0))", q: square, grid: "1/2", side: "contain"});
assert.equal(rough.sum.wkt, run("sum", file("p.wkt", "POLYGON((0 0,1/3 0,0 1/3,0 0))"), file("q.wkt", square), "--grid", "1/2", "--side", "contain").trim());
assert.deepEqual(rough.exact.outer[0][1], [13 / 3, 0]);
assert(asProved >= 30, `${asProved} proved sums`);
console.log(`${compared} sums compared, ${asProved} of them with proved ones, ${ran} cases`);
