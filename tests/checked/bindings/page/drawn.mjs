// SPDX-License-Identifier: GPL-3.0-or-later
// What an answer draws and counts follows from its WKT, P, Q and x, in doubles: chains, the area, what is
// at x, and the cycles.
import assert from "node:assert";

const number = (text) => text.split("/").map(Number).reduce((n, d) => n / d);
const cross = ([a, b], [c, d], [e, f]) => (c - a) * (f - b) - (d - b) * (e - a);
const area = (ring) => ring.reduce((all, _, i) => all + cross(ring[0], ring.at(i - 1), ring[i]), 0) / 2;
const crosses = ([x, y], ring) => ring.filter(([c, d], i) => {
  const [a, b] = ring.at(i - 1);
  return (b > y) !== (d > y) && x < a + (y - b) / (d - b) * (c - a);
}).length;

/** Throws if it does not; x is what was asked for, as texts. Says whether x is in the sum, if it is off the convolution. */
export function followsFromWkt(answer, asked, name) {
  const {p, q, x, at, sum, placement, cycles, segments, reduced} = answer;
  const same = (a, b) => {
    const [one, other] = [a.flat(3), b.flat(3)], most = 1e-9 * Math.max(1, ...one.map(Math.abs));
    assert(one.length === other.length && one.every((c, i) => Math.abs(c - other[i]) <= most), `${one} is not ${other}, ${name}`);
  };
  const parts = [...sum.wkt.matchAll(/(LINESTRING|POINT)? ?\(([^()]+)\)/g)]
    .map(([, kind, text]) => [kind, text.split(",").map((vertex) => vertex.trim().split(" ").map(number))]);
  const of = (kind) => parts.filter(([is]) => is === kind).map(([, vertices]) => vertices);
  const rings = of(undefined).map((ring) => ring.slice(1));
  const whole = [number(sum.area)], areaOf = (chains) => chains.reduce((all, chain) => all + area(chain), 0);
  same([areaOf(rings)], whole);
  // Chains may touch, and be cut there otherwise than in WKT.
  same([areaOf([...sum.outer, ...sum.holes])], whole);
  assert(sum.outer.every((chain) => area(chain) > 0) && sum.holes.every((chain) => area(chain) < 0), name);
  const vertices = (chains) => [...new Set(chains.flat().map((v) => v.map((c) => c.toPrecision(12)).join()))];
  assert.deepEqual(vertices([...sum.outer, ...sum.holes]).filter((v) => !vertices(rings).includes(v)), [], name);
  same(sum.dangling, of("LINESTRING"));
  same(sum.isolated, of("POINT"));

  same(at, asked.map(number));
  same(x.map(number), at);
  same(placement.q, q.chains.map((chain) => chain.map(([i, j]) => [at[0] - i, at[1] - j])));

  const vertex = (of, chain, i) => {
    const ring = {P: p, Q: q}[of].chains[(chain ?? 1) - 1];
    return [-2, -1, 0].map((step) => ring.at((Number(i) + step) % ring.length));
  };
  const named = /^edge (\d+)(?: of chain (\d+))? of ([PQ]) \+ vertex (\d+)(?: of chain (\d+))? of ([PQ])$/;
  for (const cycle of cycles) cycle.forEach(([a, b, c, d, isReflex, origin], i) => {
    const [, edge, edgeChain, edgeOf, v, vertexChain, vertexOf] = origin.match(named);
    assert.notEqual(edgeOf, vertexOf, name);
    const [, start, end] = vertex(edgeOf, edgeChain, edge), around = vertex(vertexOf, vertexChain, v);
    same([a, b, c, d], [start, end].map((e) => [e[0] + around[1][0], e[1] + around[1][1]]));
    assert.equal(isReflex, cross(...around) < 0, `${origin}, ${name}`);
    same(cycle.at(i - 1).slice(2, 4), [a, b]);
  });
  assert.equal(segments, cycles.flat().length, name);
  assert.equal(reduced, cycles.flat().filter(([, , , , isReflex]) => !isReflex).length, name);

  // Near x, doubles of large coordinates say nothing.
  if (placement.on_convolution || rings.flat(2).some((c) => Math.abs(c) > 1e12)) return undefined;
  const isIn = rings.reduce((all, ring) => all + crosses(at, ring), 0) % 2 === 1;
  assert.deepEqual([placement.location, placement.meet, placement.winding > 0],
                   [isIn ? "inside" : "outside", isIn, isIn], name);
  return isIn;
}
