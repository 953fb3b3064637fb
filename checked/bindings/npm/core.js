// SPDX-License-Identifier: MIT
// The C interface, oplus.h, as functions that throw.
import {load} from "./load.js";

let core, out;

export async function start(source) {
  core = await load(source);
  // Where functions put their results: three of at most eight bytes each.
  out = core.exports.malloc(24);
}

/** What is thrown for bad input ("invalid"), too little memory ("memory"), and faults of oplus ("failed"). */
export class OplusError extends Error {
  constructor(message, code) {
    super(message);
    this.name = "OplusError";
    this.code = code;
  }
}

/** Calls a function of oplus.h with numbers, strings and typed arrays; `result` reads what it has put into `out`. */
export function call(name, values, result) {
  const copied = values.filter((value) => typeof value === "string" || ArrayBuffer.isView(value));
  // To C, a text ends there.
  if (copied.some((value) => typeof value === "string" && value.includes("\0")))
    throw new OplusError("text: it has a zero character; expected none", "invalid");
  return core.with(copied, (...pointers) => {
    const code = core.exports[`oplus_${name}`](...values.map((value) => copied.includes(value) ? pointers.shift() : value),
      out, out + 8, out + 16);
    if (code !== 0)
      throw new OplusError(core.text(core.exports.oplus_message()), ["", "invalid", "memory", "failed"][code]);
    return result();
  });
}

export const pointer = () => core.view(Uint32Array, out, 1)[0];
export const integer = (place = 0) => core.view(Int32Array, out + place, 1)[0];
export const double = () => core.view(Float64Array, out, 1)[0];

/** The text at a place of `out`, which is freed. */
export function text(place = 0) {
  const at = core.view(Uint32Array, out + place, 1)[0], copy = core.text(at);
  core.exports.oplus_free_text(at);
  return copy;
}

export const free = (handle) => core.exports.oplus_free(handle);
export const version = () => core.text(core.exports.oplus_version());

/** The chains of a set: [kind, Float64Array of coordinates]. */
export function chains(handle) {
  const [count, vertices] = call("sizes", [handle], () => [pointer(), core.view(Uint32Array, out + 8, 1)[0]]);
  return core.with([new Int32Array(count), new Uint32Array(count), new Float64Array(2 * vertices)], (kinds, lengths, xy) => {
    core.exports.oplus_to_doubles(handle, kinds, lengths, xy);
    const all = core.view(Float64Array, xy, 2 * vertices).slice();
    let at = 0;
    return Array.from(core.view(Uint32Array, lengths, count), (length, i) =>
      [core.view(Int32Array, kinds + 4 * i, 1)[0], all.subarray(at, at += 2 * length)]);
  });
}
