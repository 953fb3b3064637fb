// SPDX-License-Identifier: MIT
import {start} from "./oplus/core.js";

const loaded = start(fetch(new URL("oplus/oplus.wasm.gz", import.meta.url))).then(() => import("./answers.js"));
onmessage = async ({data}) => {
  try {
    const {answer} = await loaded;
    postMessage(answer(data));
  } catch {
    postMessage({error: "the core has stopped; reload the page", refused: true});
  }
};
