// SPDX-License-Identifier: MIT
import {readFile} from "node:fs/promises";
import {start} from "./core.js";

await start(new Uint8Array(await readFile(new URL("./oplus.wasm", import.meta.url))));
export * from "./oplus.js";
