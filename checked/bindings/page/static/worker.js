// SPDX-License-Identifier: MIT
import load from "./oplus.js";

const core = load();
onmessage = async ({data}) => {
  try {
    const text = (await core).ccall("oplus_answer", "string", ["string"], [JSON.stringify(data)]);
    postMessage(JSON.parse(text));
  } catch {
    postMessage({error: "the core has stopped; reload the page", refused: true});
  }
};
