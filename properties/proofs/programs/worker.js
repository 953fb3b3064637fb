// SPDX-License-Identifier: GPL-3.0-or-later
// How a worker's messages, arrays of texts, come to worker.ml, and what it answers goes back.

//Provides: oplus_on_message
//Requires: caml_callback, caml_string_of_jsstring, caml_jsstring_of_string
function oplus_on_message(answer) {
  globalThis.onmessage = function (event) {
    var answered = caml_callback(answer, [[0].concat(event.data.map(caml_string_of_jsstring))]);
    globalThis.postMessage({code: answered[1], text: caml_jsstring_of_string(answered[2])});
  };
  return 0;
}
