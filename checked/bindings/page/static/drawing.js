// SPDX-License-Identifier: MIT
// Draws what the core answers. Coordinates are doubles, for the eye only.
const svgs = "http://www.w3.org/2000/svg";

export function element(name, attributes = {}, ...children) {
  const made = document.createElementNS(svgs, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

/** An SVG element with a scale and a middle: y is upwards. */
export class Drawing {
  constructor(svg) {
    this.svg = svg;
    this.content = svg.appendChild(element("g"));
    this.handles = svg.appendChild(element("g"));
    this.scale = 40;
    this.middle = [0, 0];
    svg.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.zoom(event.deltaY < 0 ? 1.2 : 1 / 1.2, this.place(event));
    }, {passive: false});
    // A mouse drags the ground; a finger scrolls the page there.
    let held = null;
    svg.addEventListener("pointerdown", (event) => {
      if (event.pointerType === "touch" || event.button || event.target.closest(".handle, [data-of]")) return;
      svg.setPointerCapture(event.pointerId);
      held = this.place(event);
    });
    svg.addEventListener("pointermove", (event) => {
      if (!held) return;
      const place = this.place(event);
      this.middle = this.middle.map((c, i) => c + held[i] - place[i]);
      this.redraw?.();
    });
    for (const end of ["pointerup", "pointercancel"]) svg.addEventListener(end, () => { held = null; });
  }

  get size() { return [this.svg.clientWidth || 300, this.svg.clientHeight || 300]; }

  fit(points) {
    const finite = points.filter((p) => p.every(Number.isFinite));
    const side = (i) => {
      const all = finite.map((p) => p[i]);
      return all.length ? [Math.min(...all), Math.max(...all)] : [-1, 1];
    };
    const [[left, right], [low, high]] = [side(0), side(1)];
    const [width, height] = this.size;
    const scale = Math.min((width - 50) / (right - left), (height - 50) / (high - low));
    this.scale = Number.isFinite(scale) && scale > 0 ? scale : 40;
    this.middle = [(left + right) / 2, (low + high) / 2];
  }

  /** `fixed` stays where it is. */
  zoom(factor, fixed = this.middle) {
    this.scale *= factor;
    this.middle = this.middle.map((c, i) => fixed[i] + (c - fixed[i]) / factor);
    this.redraw?.();
  }

  pixel([x, y]) {
    const [width, height] = this.size;
    return [width / 2 + (x - this.middle[0]) * this.scale, height / 2 - (y - this.middle[1]) * this.scale]
      .map((c) => Math.max(-1e6, Math.min(1e6, c)));
  }

  /** Where a pointer is. */
  place(event) {
    const box = this.svg.getBoundingClientRect(), [width, height] = this.size;
    return [this.middle[0] + (event.clientX - box.left - this.svg.clientLeft - width / 2) / this.scale,
      this.middle[1] - (event.clientY - box.top - this.svg.clientTop - height / 2) / this.scale];
  }

  way(chain) { return chain.length ? "M" + chain.map((p) => this.pixel(p).join()).join("L") : ""; }
  path(chains) { return chains.filter((chain) => chain.length).map((chain) => this.way(chain) + "Z").join(""); }
  shape(chains, kinds) { return chains.map((chain, i) => this.way(chain) + (kinds[i] === "line" ? "" : "Z")).join(""); }

  lines(segments) {
    return segments.map(([a, b, c, d]) => `M${this.pixel([a, b])}L${this.pixel([c, d])}`).join("");
  }

  clear() { this.content.replaceChildren(); }

  add(name, attributes) { return this.content.appendChild(element(name, attributes)); }

  /** A mark of a point, that a path draws around (0, 0). */
  mark(point, kind, d) {
    const [x, y] = this.pixel(point);
    this.add("path", {class: kind, d, transform: `translate(${x} ${y})`});
  }
  origin() { this.mark([0, 0], "origin", "M-6,0H6M0,-6V6"); }
  cross(point, kind) { this.mark(point, kind, "M-6,-6L6,6M-6,6L6,-6"); }

  arrow([a, b, c, d]) {
    const [x, y] = this.pixel([(a + c) / 2, (b + d) / 2]);
    const turn = Math.atan2(b - d, c - a) * 180 / Math.PI;
    this.add("path", {class: "arrow", d: "M-7,-8L10,0L-7,8Z", transform: `translate(${x} ${y}) rotate(${turn})`});
  }
}

export function drawSummands(drawing, answer, layers) {
  drawing.clear();
  for (const of of ["p", "q"]) {
    const shape = answer[of], wrong = shape.error ? " invalid" : "";
    const isRing = (_, i) => ["outer", "hole"].includes(shape.kinds[i]);
    drawing.add("path", {class: of + wrong, d: drawing.path(shape.chains.filter(isRing)), "fill-rule": "evenodd", "data-of": of});
    const lines = shape.chains.filter((_, i) => shape.kinds[i] === "line");
    if (lines.length) drawing.add("path", {class: of + " line" + wrong, d: lines.map((line) => drawing.way(line)).join(""), "data-of": of});
  }
  if (answer.placement && layers.includes("placed"))
    drawing.add("path", {class: "placed", d: drawing.shape(answer.placement.q, answer.q.kinds)});
  drawing.origin();
}

export function drawSum(drawing, answer, layers, walk, isStale) {
  drawing.clear();
  const {sum, cycles, verdict} = answer;
  const shown = (name) => layers.includes(name);
  if (shown("sum")) drawing.add("path", {class: "area" + (isStale ? " stale" : ""),
    d: drawing.path([...sum.outer, ...sum.holes]), "data-layer": "sum"});
  if (answer.exact) drawing.add("path", {class: "exact", d: drawing.path([...answer.exact.outer, ...answer.exact.holes])
    + drawing.lines(answer.exact.dangling), "data-layer": "exact"});
  if (shown("holes")) drawing.add("path", {class: "hole", d: drawing.path(sum.holes), "data-layer": "holes"});
  const all = cycles.flat();
  if (shown("convolution"))
    drawing.add("path", {class: "convolution", d: drawing.lines(all), "data-layer": "convolution"});
  if (shown("reduced"))
    drawing.add("path", {class: "reduced", d: drawing.lines(all.filter((s) => !s[4])), "data-layer": "reduced"});
  if (shown("dangling")) {
    drawing.add("path", {class: "dangling", d: drawing.lines(sum.dangling), "data-layer": "dangling"});
    for (const point of sum.isolated) {
      const [cx, cy] = drawing.pixel(point);
      drawing.add("circle", {class: "isolated", cx, cy, r: 6});
    }
  }
  if (shown("cycle") && cycles.length) {
    const cycle = cycles[walk.cycle];
    drawing.add("path", {class: "walked", d: drawing.lines(cycle.slice(0, walk.at + 1)), "data-layer": "cycle"});
    drawing.add("path", {class: "current", d: drawing.lines([cycle[walk.at]])});
    drawing.arrow(cycle[walk.at]);
  }
  if (verdict && !isStale) {
    drawing.add("path", {class: "given", d: drawing.path(verdict.chains ?? []) + drawing.lines(verdict.dangling ?? []),
      "data-layer": "given"});
    for (const point of verdict.isolated ?? []) drawing.mark(point, "given", "M-7,0A7,7 0 1 0 7,0A7,7 0 1 0 -7,0");
    if (verdict.witness) drawing.cross(verdict.witness, "witness");
  }
  drawing.origin();
}

/** Q on its way, and what it has swept. */
export function drawSlide(drawing, {at, swept}, q) {
  drawing.add("path", {class: "swept", d: drawing.path([...swept.outer, ...swept.holes]) + drawing.lines(swept.dangling), "data-layer": "swept"});
  const moved = q.chains.map((chain) => chain.map((v) => v.map((c, i) => c + at[i])));
  drawing.add("path", {class: "q slid", d: drawing.shape(moved, q.kinds), "fill-rule": "evenodd", "data-layer": "slid"});
}
