// SPDX-License-Identifier: MIT
// What Emscripten made of the core, in Node, browsers and workers: memory and texts.

const encoder = new TextEncoder(), decoder = new TextDecoder();

export class Core {
  constructor(exports) { this.exports = exports; }

  /** Memory moves when it grows, so that views are made anew. */
  view(type, pointer, length) { return new type(this.exports.memory.buffer, pointer, length); }

  /** Returns the text that ends with a zero. */
  text(pointer) {
    const bytes = this.view(Uint8Array, pointer);
    return decoder.decode(bytes.subarray(0, bytes.indexOf(0)));
  }

  /** Returns what a call returns that is given pointers to copies of texts and typed arrays. */
  with(values, call) {
    const pointers = [];
    try {
      for (const value of values) {
        const bytes = typeof value === "string" ? encoder.encode(value + "\0")
          : new Uint8Array(value.buffer, value.byteOffset, value.byteLength);
        const pointer = this.exports.malloc(bytes.length);
        if (pointer === 0) throw new RangeError("out of memory");
        pointers.push(pointer);
        this.view(Uint8Array, pointer, bytes.length).set(bytes);
      }
      return call(...pointers);
    } finally {
      pointers.forEach(this.exports.free);
    }
  }
}

/** What the core may ask of a system: an environment, which is empty, and a place to write why it stops. It opens no files. */
function system(memory) {
  const failed = 8;  // EBADF
  return {
    environ_sizes_get(count, size) {
      memory().setUint32(count, 0, true);
      memory().setUint32(size, 0, true);
      return 0;
    },
    environ_get: () => 0,
    fd_close: () => failed,
    fd_seek: () => failed,
    fd_write: () => failed,
    proc_exit(code) { throw new WebAssembly.RuntimeError(`the core has stopped with code ${code}`); },
  };
}

/** Unpacks what gzip has packed, unless a server's header has had that done. */
const unpacked = (bytes) => new Uint8Array(bytes)[0] !== 0x1f ? bytes
  : new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();

/** Loads a core of bytes, or of what fetch() returns. */
export async function load(source) {
  let exports;
  const response = await source;
  if (response.ok === false) throw new Error(`${response.url}: ${response.status}`);
  const bytes = response.arrayBuffer ? await response.arrayBuffer() : response;
  const imports = {
    env: {emscripten_notify_memory_growth() {}, __call_sighandler() {}},
    wasi_snapshot_preview1: system(() => new DataView(exports.memory.buffer)),
  };
  ({exports} = (await WebAssembly.instantiate(await unpacked(bytes), imports)).instance);
  exports._initialize();
  return new Core(exports);
}
