// SPDX-License-Identifier: MIT
import {load} from "./load.js";

const loaded = load(fetch(new URL("oplus.wasm", import.meta.url)));
onmessage = async ({data}) => {
  try {
    const core = await loaded;
    const text = core.with([JSON.stringify(data)], (request) => core.text(core.exports.oplus_answer(request)));
    postMessage(JSON.parse(text));
  } catch {
    postMessage({error: "the core has stopped; reload the page", refused: true});
  }
};
