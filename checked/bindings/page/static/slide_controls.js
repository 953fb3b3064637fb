// SPDX-License-Identifier: MIT
// What starts, stops and steers the animation.
import {ask} from "./asking.js";
import {Clock, partOf, pathOf} from "./sliding.js";

const $ = (id) => document.getElementById(id);

export class SlideControls {
  /** now() returns {valid, what, q}: the last valid answer, the operation, and the text of Q; draw() draws all again. */
  constructor(now, drawing, draw) {
    Object.assign(this, {now, drawing, draw, shown: null});  // shown: {of, at, swept}
    this.clock = new Clock((part) => this.show(part));
    $("play").addEventListener("click", () => {
      if (this.clock.isRunning) this.clock.stop();
      else this.clock.run();
      this.tell();
    });
    $("slide").addEventListener("input", () => {
      this.clock.stop();
      this.clock.part = $("slide").value / 1000;
      this.show(this.clock.part);
    });
    $("unslide").addEventListener("click", () => this.end());
  }

  /** What it is about: of others, nothing is shown. */
  get about() {
    const {valid, what} = this.now();
    return valid && JSON.stringify([valid.p.wkt, valid.q.wkt, what, valid.sum.wkt]);
  }

  show(part) {
    const {valid, what} = this.now(), path = valid ? pathOf(valid, what) : [];
    if (!path.length || !valid.q.chains.length) {
      this.end();
      return;
    }
    const {lines, at} = partOf(path, part), of = this.about;
    $("slide").value = Math.round(1000 * part);
    $("slide").setAttribute("aria-valuetext", `${Math.round(100 * part)} % of the way`);
    ask(() => ({lines, q: this.now().q}), ({swept, error}) => {
      if (error || of !== this.about) {
        this.end();
        return;
      }
      if (!this.shown) this.fit(path);
      this.shown = {of, at, swept};
      this.draw();
      this.tell();
    }, true);
  }

  /** Fits the drawing to P, Q, and Q at all vertices of the path. */
  fit(path) {
    const {valid} = this.now(), [xs, ys] = [0, 1].map((i) => valid.q.chains.flat().map((v) => v[i]));
    const corners = [[Math.min(...xs), Math.min(...ys)], [Math.max(...xs), Math.max(...ys)]];
    const moved = path.flat().flatMap(([x, y]) => corners.map(([a, b]) => [x + a, y + b]));
    this.drawing.fit([...valid.p.chains, ...valid.q.chains, moved].flat());
  }

  /** Ends where it is about another P or Q by now. */
  check() {
    if (this.shown && this.shown.of !== this.about) this.end();
  }

  end() {
    this.clock.stop();
    this.clock.part = 0;
    this.shown = null;
    $("slide").value = 0;
    this.draw();
    this.tell();
  }

  tell() {
    $("play").textContent = this.clock.isRunning ? "Pause" : "Slide Q";
    $("play").setAttribute("aria-pressed", this.clock.isRunning);
    $("unslide").disabled = !this.shown;
  }
}
