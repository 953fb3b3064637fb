// SPDX-License-Identifier: MIT
// Ten examples, each a statement of docs/theorems or docs/findings.md: what it is called there, a sentence on what is to
// be seen, and what of the state it sets.
const square = "POLYGON((0 0,2 0,2 2,0 2,0 0))";
const diamondHole = (side) => {
  const middle = side / 2;
  return `POLYGON((0 0,${side} 0,${side} ${side},0 ${side},0 0),(0 ${middle},${middle} ${side},${side} ${middle},${middle} 0,0 ${middle}))`;
};

export const gallery = [
  {title: "Room and diamond", statement: "Theorem 3.2.8",
    text: "The door is exactly as wide as the diamond. The open sum keeps the way through it, a dangling edge, and it lies on "
      + "segments of the convolution with opposite directions.",
    p: "POLYGON((0 0,7 0,7 6,4 6,4 5,6 5,6 1,1 1,1 5,3 5,3 6,0 6,0 0))", q: "POLYGON((0 0.5,0.5 0,1 0.5,0.5 1,0 0.5))",
    x: ["7/2", "3"], open: true},
  {title: "Frame and square", statement: "Theorem 3.2.10",
    text: "The square fits into the frame in one place only: an isolated vertex of the open sum, in which segments of at least "
      + "three directions meet.",
    p: "POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,1 3,3 3,3 1,1 1))", q: square, x: ["3", "3"], open: true},
  {title: "One cycle of ten", statement: "Finding: Corollary 4.1.9",
    text: "By the corollary, the convolution has a cycle of 3 + 4 segments. It has one cycle only, of ten: twice round the "
      + "triangle, once round the arrow head.",
    p: "POLYGON((0 0,1 0,0 1,0 0))", q: "POLYGON((0 0,2 1,0 2,1 1,0 0))", x: ["1", "1"], open: false, layers: ["sum", "convolution", "cycle"]},
  {title: "Isolated vertices off the reduced convolution", statement: "Finding: Theorem 2.3.2",
    text: "The open sum has four isolated vertices. No segment of the reduced convolution passes through any of them, since "
      + "chains of both touch; segments of the full one do.",
    p: diamondHole(8), q: diamondHole(8), x: ["4", "4"], open: true, layers: ["dangling", "reduced"]},
  {title: "Sides cross, interiors do not meet", statement: "Finding: Observation 2.2.4",
    text: "At x = (3, 3) the upper side of P crosses the left side of −Q + x properly, and still their interiors do not meet: "
      + "there both holes have a vertex.",
    p: diamondHole(2), q: diamondHole(2), x: ["3", "3"], open: true},
  {title: "A hole that begins where chains touch", statement: "Finding: Lemma 2.2.9",
    text: "Both edges at Q's vertex (0, 0) slide along P's lower edge. The lemma has all of that inside the sum; (3, 0), where "
      + "P's hole touches, is a vertex of the sum's hole.",
    p: "POLYGON((0 0,6 0,6 6,0 6,0 0),(3 0,1 3,5 3,3 0))", q: "POLYGON((0 0,-1 -2,0 -1,0 0))", x: ["3", "0"], open: false},
  {title: "The fork", statement: "Section 6.1.4",
    text: "A fork with three teeth on each arm, and the L that fits it: each tooth becomes a bar, and three bars that cross three "
      + "others leave exactly nine holes.",
    p: "POLYGON((-12 -12,9 -12,9 0,8 0,8 -11,6 -11,6 0,5 0,5 -11,3 -11,3 0,2 0,2 -11,0 -11,0 0,-11 0,-11 2,0 2,0 3,-11 3,-11 5,0 5,0 6,"
      + "-11 6,-11 8,0 8,0 9,-12 9,-12 -12))",
    q: "POLYGON((0 0,11 0,11 1,1 1,1 11,0 11,0 0))", x: ["3/2", "3/2"], open: false},
  {title: "Where a part fits in", statement: "Fact: inner fit",
    text: "All places of the square inside P. It just fits into the slot, where it can slide: a segment; and into the lone square: "
      + "a point.",
    p: "MULTIPOLYGON(((0 0,5 0,5 3,8 3,8 5,5 5,5 6,0 6,0 0)),((9 0,11 0,11 2,9 2,9 0)))", q: square, x: ["5", "3"], what: "ifp"},
  {title: "Rounded outwards", statement: "Law: rounding",
    text: "Coordinates of this sum are thirds and sevenths. On the grid of halves it is rounded to a set that contains it; the "
      + "dashed line is the exact one.",
    p: "POLYGON((0 0,13/3 1/7,10/3 3,1/3 8/3,0 0))", q: "POLYGON((0 0,9/7 1/3,1/3 8/7,0 0))", x: ["2", "2"], open: false, grid: "1/2",
    side: "contain"},
  {title: "A tool on its path", statement: "Fact: closed sets",
    text: "P is a line string, the path of a tool, and Q the tool: the sum is what the tool covers on its way.",
    p: "LINESTRING(0 0,5 0,5 3,2 3,2 6)", q: "POLYGON((-0.5 -1,0.5 -1,1 0.5,0 1,-1 0.5,-0.5 -1))", x: ["2", "3"], open: false},
];

/** A small picture of P and Q, of the numbers in their texts. */
function thumbnail({p, q}) {
  const number = (text) => text.split("/").map(Number).reduce((a, b) => a / b);
  const chains = (text) => [...text.matchAll(/\(([^()]+)\)/g)].map(([, row]) => row.split(",").map((v) => v.trim().split(" ").map(number)));
  const all = [...chains(p), ...chains(q)].flat(), side = (i) => all.map((v) => v[i]);
  const [left, right, low, high] = [Math.min(...side(0)), Math.max(...side(0)), Math.min(...side(1)), Math.max(...side(1))];
  const path = (text) => chains(text).map((chain) => "M" + chain.map(([x, y]) => `${x},${-y}`).join("L")).join("");
  const margin = 0.05 * Math.max(right - left, high - low);
  return `<svg viewBox="${left - margin} ${-high - margin} ${right - left + 2 * margin} ${high - low + 2 * margin}" aria-hidden="true">`
    + `<path class="p${p.startsWith("LINE") ? " line" : ""}" fill-rule="evenodd" d="${path(p)}"/><path class="q" fill-rule="evenodd" d="${path(q)}"/></svg>`;
}

/** Makes a button for each, and calls choose(example). */
export function show(list, choose) {
  for (const example of gallery) {
    const button = Object.assign(document.createElement("button"), {type: "button", className: "example"});
    button.innerHTML = thumbnail(example);
    const title = Object.assign(document.createElement("span"), {textContent: example.title});
    const statement = Object.assign(document.createElement("small"), {textContent: example.statement});
    button.append(title, statement);
    button.addEventListener("click", () => choose(example));
    list.appendChild(document.createElement("li")).append(button);
  }
}
