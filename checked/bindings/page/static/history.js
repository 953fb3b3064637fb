// SPDX-License-Identifier: MIT
// What can be undone and done again: addresses, of which only what is computed from counts.
const past = [], future = [];
let now, lastDrag;

const counts = (address) => {
  const all = new URLSearchParams(address);
  for (const view of ["layers", "cycle", "at"]) all.delete(view);
  return all.toString();
};

/** Notes the address of a state that has been reached. All of one drag is one step. */
export function record(address, drag) {
  if (now !== undefined && counts(now) !== counts(address)) {
    if (!drag || drag !== lastDrag) past.push(now);
    future.length = 0;
    lastDrag = drag;
  }
  now = address;
}

/** Takes a step from one list, which leaves one in the other; returns the address to go to, if there is one. */
function step(from, to) {
  if (!from.length) return;
  to.push(now);
  now = from.pop();
  return now;
}

export const canUndo = () => past.length > 0;
export const canRedo = () => future.length > 0;

/** Calls goTo(address) for buttons and keys; in fields of text the keys are the browser's. */
export function listen(goTo) {
  const undo = () => step(past, future), redo = () => step(future, past);
  const go = (way) => {
    const address = way();
    if (address !== undefined) goTo(address);
  };
  document.getElementById("undo").addEventListener("click", () => go(undo));
  document.getElementById("redo").addEventListener("click", () => go(redo));
  addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.target.matches?.("textarea, input:not([type])")) return;
    const letter = event.key.toLowerCase(), way = letter === "z" ? (event.shiftKey ? redo : undo) : letter === "y" ? redo : null;
    if (!way) return;
    event.preventDefault();
    go(way);
  });
}
