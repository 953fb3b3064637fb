// SPDX-License-Identifier: MIT
// What is drawn: the address holds all of it, and nothing else does.
export const examples = {
  "Room and diamond": ["POLYGON((0 0,7 0,7 6,4 6,4 5,6 5,6 1,1 1,1 5,3 5,3 6,0 6,0 0))", "POLYGON((0 0.5,0.5 0,1 0.5,0.5 1,0 0.5))"],
  "Frame and square": ["POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,1 3,3 3,3 1,1 1))", "POLYGON((0 0,2 0,2 2,0 2,0 0))"],
  "Reflex vertices": ["POLYGON((0 0,6 0,6 4,4 4,4 2,2 2,2 4,0 4,0 0))", "POLYGON((0 0,3 0,1 1,0 3,0 0))"],
  "Triangles": ["POLYGON((0 0,4 0,1 3,0 0))", "POLYGON((0 0,2 1,0 2,0 0))"],
};
export const layers = {
  sum: ["Sum", "--sum", true], holes: ["Holes", "--hole", true],
  dangling: ["Dangling edges, isolated vertices", "--dangling", true],
  convolution: ["Convolution", "--convolution", false],
  reduced: ["Reduced convolution", "--reduced", true],
  cycle: ["Convolution cycle", "--cycle", false], placed: ["−Q + x", "--q", true],
};

const first = () => ({
  p: examples["Room and diamond"][0], q: examples["Room and diamond"][1], x: ["7/2", "3"], step: "1/2",
  open: true, proved: false, s: "", layers: Object.keys(layers).filter((name) => layers[name][2]), cycle: 0, at: 0,
});

/** The state in an address; what is missing is as at first. */
export function read(hash) {
  const state = first(), given = new URLSearchParams(hash.replace(/^#/, ""));
  for (const name of ["p", "q", "step", "s"]) if (given.has(name)) state[name] = given.get(name);
  if (given.has("x")) {
    const [x = "0", y = "0"] = given.get("x").split(",");
    state.x = [x, y];
  }
  for (const name of ["open", "proved"]) if (given.has(name)) state[name] = given.get(name) === "1";
  if (given.has("layers")) state.layers = given.get("layers").split(",").filter((name) => name in layers);
  for (const name of ["cycle", "at"]) state[name] = Math.max(0, parseInt(given.get(name), 10) || 0);
  return state;
}

export function write(state) {
  const {p, q, s, step, cycle, at} = state;
  const text = new URLSearchParams({p, q, x: state.x.join(","), step, open: state.open ? "1" : "0",
    layers: state.layers.join(","), cycle, at, ...(state.proved && {proved: "1"}), ...(s && {s})});
  history.replaceState(null, "", "#" + text);
}
