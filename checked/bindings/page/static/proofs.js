// SPDX-License-Identifier: MIT
// The sum by a proved program, and its certificate checked by another one: what is asked of them, and the lines that tell
// of it.
import {Program} from "./program.js";

const summing = new Program("oplus-proved.js"), checking = new Program("oplus-certified.js");
const pair = ({p, q, open}) => JSON.stringify([p, q, open]);
let sum = {};  // of the pair that was asked about last: its text, or the line that says why there is none
let verdict = {};

export const isBusy = () => summing.isBusy || checking.isBusy;

/** The text of the proved sum of a state, if it is there. */
export const sumOf = (state) => state.proved && sum.pair === pair(state) ? sum.text : undefined;

/** Asks for the sum of a state, unless that was done, and calls tell() when there is more to tell. */
export function prove(state, tell) {
  if (!state.proved) {
    summing.end();
    sum = {};
    return;
  }
  const of = pair(state);
  if (sum.pair === of) return;
  sum = {pair: of, line: "The proved program is computing."};
  summing.ask([state.open ? "open" : "closed", state.p, state.q], ({code, text, ms}) => {
    sum = code ? {pair: of, line: `No proved sum: ${text}.`}
      : {pair: of, text, line: `The proved program has computed this sum in ${ms} ms.`};
    tell();
  });
}

export const lineOfSum = (state) => state.proved ? sum.line ?? "" : "";

/** Asks about a certificate of the core, {certificate: {p, q, sum, text}}, or about a text that was typed in place of it. */
export function check(state, {certificate, error}, typed, tell) {
  const of = pair({...state, open: false}), {p, q, sum: s, text = ""} = certificate ?? {};
  const told = (line, isWrong = false) => {
    verdict = {pair: of, line, isWrong, text};
    tell();
  };
  if (error) {
    told(error, true);
    return;
  }
  checking.ask([p, q, s, typed ?? text], ({code, text: said, ms}) => told(
    code ? `Refused: ${said}.` : `Accepted in ${ms} ms: ${s} is the closed sum of P and Q.`, code !== 0));
  told("The proved checker is checking.");
}

export const verdictOf = (state) => verdict.pair === pair({...state, open: false}) ? verdict : {};

export function cancel() {
  if (summing.isBusy) sum = {...sum, line: "Cancelled."};
  if (checking.isBusy) verdict = {...verdict, line: "Cancelled."};
  summing.end();
  checking.end();
}
