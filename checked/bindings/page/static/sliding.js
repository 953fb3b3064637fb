// SPDX-License-Identifier: MIT
// The animation: Q slides along a path, and the core computes what it has swept. Nothing is computed here but how far it is.

/** The lines of a path up to a part of its length, and its end. */
export function partOf(chains, part) {
  const length = ([a, b], [c, d]) => Math.hypot(c - a, d - b);
  const whole = chains.reduce((all, chain) => chain.slice(1).reduce((sum, end, i) => sum + length(chain[i], end), all), 0);
  let left = part * whole;
  const lines = [];
  for (const chain of chains) {
    const line = [chain[0]];
    lines.push(line);
    for (let i = 1; i < chain.length; ++i) {
      const [start, end] = [chain[i - 1], chain[i]], far = length(start, end);
      if (far > left) {
        const at = start.map((c, k) => c + left / far * (end[k] - c));
        line.push(at);
        return {lines, at};
      }
      line.push(end);
      left -= far;
    }
  }
  return {lines, at: lines.at(-1).at(-1)};
}

const closed = (chains) => chains.map((chain) => [...chain, chain[0]]);

/** Along what Q slides: the boundary of P, on which it sweeps the rim of the sum; else the boundary of the places. */
export function pathOf({p, sum}, what) {
  if (what === "sum") {
    const isRing = (i) => ["outer", "hole"].includes(p.kinds[i]);
    return p.chains.map((chain, i) => isRing(i) ? [...chain, chain[0]] : chain);
  }
  return [...closed([...sum.outer, ...sum.holes]), ...sum.dangling.map(([a, b, c, d]) => [[a, b], [c, d]]), ...sum.isolated.map((p) => [p, p])];
}

const seconds = 8;  // for all of a path

/** A clock that calls show(part of the way), from 0 to 1, while it runs. */
export class Clock {
  constructor(show) {
    this.show = show;
    this.part = 0;
  }

  get isRunning() { return Boolean(this.frame); }

  run() {
    if (this.part >= 1) this.part = 0;
    let before = performance.now();
    const tick = (now) => {
      this.part = Math.min(1, this.part + Math.max(0, now - before) / 1000 / seconds);
      before = now;
      this.frame = this.part < 1 ? requestAnimationFrame(tick) : 0;
      this.show(this.part);
    };
    this.frame = requestAnimationFrame(tick);
  }

  stop() {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
  }
}
