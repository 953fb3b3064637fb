// SPDX-License-Identifier: MIT
// Asks the core, which runs in a worker, so that the page answers while it computes.
const worker = new Worker("worker.js", {type: "module"});
const waiting = [];
let done = null, late = 0, tellLate = () => {};

worker.onmessage = ({data}) => {
  const told = done;
  done = null;
  clearTimeout(late);
  told(data);
  const next = waiting.shift();
  if (next) ask(next.request, next.tell, next.isMove);
};
worker.onerror = () => done?.({error: "the core has stopped; reload the page", refused: true});

/** Has tell() called when an answer takes half a second. */
export function onLate(tell) { tellLate = tell; }

/** Calls tell(answer to request()). Requests wait while the core is busy, of moves in a row the last one only; each is
 * made when it is sent, from the state that the last answer left. */
export function ask(request, tell, isMove) {
  if (done) {
    if (isMove && waiting.at(-1)?.isMove) waiting.pop();
    waiting.push({request, tell, isMove});
    return;
  }
  done = tell;
  late = setTimeout(tellLate, 500);
  worker.postMessage(request());
}
