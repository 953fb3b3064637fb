// SPDX-License-Identifier: MIT
import load from "./oplus.js";

const core = load();
onmessage = async ({data}) => {
  try {
    const text = (await core).ccall("oplus_answer", "string", ["string"], [JSON.stringify(data)]);
    postMessage(JSON.parse(text));
  } catch (failure) {  // A number beyond all doubles is no JSON.
    const error = failure instanceof SyntaxError ? "a number is beyond all doubles, and cannot be drawn"
      : "the core has stopped; reload the page";
    postMessage({error, refused: true});
  }
};
