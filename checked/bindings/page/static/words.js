// SPDX-License-Identifier: MIT
// What the page says of what it computes.
export const captions = {sum: "P ⊕ Q", nfp: "P ⊕ −Q, the no-fit polygon", ifp: "The inner-fit polygon", erosion: "The erosion of P by Q",
  opening: "The opening of P by Q", closing: "The closing of P by Q"};

const fits = "Q + x is Q moved by x. It is inside P if and only if x is in the inner-fit polygon";
export const words = {
  sum: "−Q + x is Q turned by half a turn about the origin, then moved by x. It meets P if and only if x = p + q for a point p of P "
    + "and a point q of Q: if and only if x is in the sum.",
  nfp: "Q + x is Q moved by x. It overlaps P if and only if x is in the no-fit polygon, which is P ⊕ −Q; on its boundary the two only touch.",
  ifp: fits + "; segments and points are places where Q just fits.",
  erosion: fits + "; the erosion is that without segments and points.",
  opening: "Q + x is Q moved by x. The opening is the union of all of them that are inside P.",
  closing: "Q + x is Q moved by x. The closing is the erosion by Q of P ⊕ Q, and contains P.",
};

/** What is to be said of the point x. */
export function placementLine({x, placement}, what) {
  const {location, meet, winding, tangents, on_convolution: isOn, move, squared, contact} = placement;
  const isSum = what === "sum", line = `x = (${x.join(", ")}) is ${location} the ${isSum ? "sum" : "result"}.`;
  if (what === "ifp") return `${line} Q + x is ${location === "outside" ? "not " : ""}inside P.`;
  if (winding === undefined) return line;
  return `${line} The interiors of P and ${isSum ? "−Q" : "Q"} + x ${meet ? "meet" : "do not meet"}.`
    + `\nWinding number ${winding}, tangent count ${tangents}${isOn ? ", both on the ray to the right: x is on the convolution." : "."}`
    + (move ? `\nMoved by ${move}, whose squared length is ${squared}, they only touch, in ${contact}.` : "");
}

/** How large the result is, and the convolution. */
export function countsLine({sum, cycles, segments, reduced}) {
  const count = (list, one, many) => `${list.length} ${list.length === 1 ? one : many}`;
  return `Area ${sum.area}; ${count(sum.outer, "outer chain", "outer chains")}, ${count(sum.holes, "hole", "holes")}, `
    + `${count(sum.dangling, "dangling edge", "dangling edges")}, ${count(sum.isolated, "isolated vertex", "isolated vertices")}.`
    + (cycles.length ? ` Convolution: ${segments} segments, ${reduced} of them reduced.` : "");
}

/** A segment of a cycle of the convolution. */
export function segmentLine(cycle, number) {
  const segment = cycle?.[number];
  if (!segment) return "There is no convolution.";
  const [, , , , isReflex, origin, ends] = segment;
  return `Segment ${number + 1} of ${cycle.length}: ${origin}, from ${ends}`
    + (isReflex ? "; reflex vertex, not in the reduced convolution." : ".");
}

export const verdictLines = (verdict) => verdict?.error ?? verdict?.text.trim() ?? "";
