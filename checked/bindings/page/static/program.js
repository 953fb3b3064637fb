// SPDX-License-Identifier: MIT
// A proved program, in a worker of its own: made when it is first asked, ended when what it computes is not wanted.
export class Program {
  constructor(file) { this.file = file; }

  get isBusy() { return Boolean(this.tell); }

  /** Calls tell({code, text, ms}), as the program would answer on the command line, unless it is asked again or ended. */
  ask(texts, tell) {
    if (this.isBusy) this.end();
    const worker = this.worker ??= new Worker(this.file), since = performance.now();
    const answered = (code, text) => {
      if (this.worker !== worker) return;
      this.tell = null;
      tell({code, text, ms: Math.round(performance.now() - since)});
    };
    this.tell = tell;
    worker.onmessage = ({data: {code, text}}) => answered(code, text.trim());
    worker.onerror = (event) => {  // an event without a message is about the file
      answered(2, event.message ? "the program has stopped" : "this page was built without the program");
      this.end();
    };
    worker.postMessage(texts);
  }

  end() {
    this.worker?.terminate();
    this.worker = this.tell = null;
  }
}
