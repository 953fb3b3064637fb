// SPDX-License-Identifier: MIT
// Asks the core, which runs in a worker, so that the page answers while it computes.
const worker = new Worker("worker.js", {type: "module"});
let done = null, waiting = null;

worker.onmessage = ({data}) => {
  const told = done;
  done = null;
  told(data);
  if (waiting) {
    const {request, tell} = waiting;
    waiting = null;
    ask(request, tell);
  }
};
worker.onerror = () => done?.({error: "the core has stopped; reload the page", refused: true});

/** Calls tell(answer to request()). While the core is busy, a request takes the place of one that waits; each is made
 * when it is sent, from the state that the last answer left. */
export function ask(request, tell) {
  if (done) {
    waiting = {request, tell};
    return;
  }
  done = tell;
  worker.postMessage(request());
}
