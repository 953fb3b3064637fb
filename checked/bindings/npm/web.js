// SPDX-License-Identifier: MIT
import {start} from "./core.js";

await start(fetch(new URL("./oplus.wasm", import.meta.url)));
export * from "./oplus.js";
