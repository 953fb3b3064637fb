// SPDX-License-Identifier: MIT
// What is drawn: the address holds all of it, and nothing else does.
import {gallery} from "./gallery.js";

export const layers = {
  sum: ["Sum", "--sum", true], holes: ["Holes", "--hole", true],
  dangling: ["Dangling edges, isolated vertices", "--dangling", true],
  convolution: ["Convolution", "--convolution", false],
  reduced: ["Reduced convolution", "--reduced", true],
  cycle: ["Convolution cycle", "--cycle", false], placed: ["−Q + x", "--q", true],
};

const first = () => ({
  p: gallery[0].p, q: gallery[0].q, x: gallery[0].x, step: "1/2", what: "sum", open: true, grid: "", side: "nearest",
  proved: false, s: "", layers: Object.keys(layers).filter((name) => layers[name][2]), cycle: 0, at: 0,
});

/** The state of an example. */
export function stateOf({p, q, x, what = "sum", open = true, grid = "", side = "nearest", layers: shown = first().layers}, {step}) {
  return {...first(), p, q, x, what, open, grid, side, step, layers: [...shown, "placed"]};
}

/** The state in an address; what is missing is as at first. */
export function read(hash) {
  const state = first(), given = new URLSearchParams(hash.replace(/^#/, ""));
  for (const name of ["p", "q", "step", "s", "what", "grid", "side"]) if (given.has(name)) state[name] = given.get(name);
  if (given.has("x")) {
    const [x = "0", y = "0"] = given.get("x").split(",");
    state.x = [x, y];
  }
  for (const name of ["open", "proved"]) if (given.has(name)) state[name] = given.get(name) === "1";
  if (given.has("layers")) state.layers = given.get("layers").split(",").filter((name) => name in layers);
  for (const name of ["cycle", "at"]) state[name] = Math.max(0, parseInt(given.get(name), 10) || 0);
  return state;
}

export function address({p, q, x, step, what, open, grid, side, proved, s, layers: shown, cycle, at}) {
  return "#" + new URLSearchParams({p, q, x: x.join(","), step, open: open ? "1" : "0", layers: shown.join(","), cycle, at,
    ...(what !== "sum" && {what}), ...(grid && {grid, side}), ...(proved && {proved: "1"}), ...(s && {s})});
}
