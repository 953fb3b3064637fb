(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A program as a browser's worker: it is sent texts, and answers as it would on the command line, with an exit code and
   a text. *)
open Js_of_ocaml

(* A file with that name and text, which js_of_ocaml keeps in memory. *)
let file name content =
  if Sys.file_exists name then Sys.remove name;
  Sys_js.create_file ~name ~content;
  name

let run answer =
  Worker.set_onmessage (fun texts ->
      let code, text =
        try answer (Array.map Js.to_string (Js.to_array texts)) with
        | Files.Invalid message -> (2, message)
        | Stack_overflow -> (2, "P and Q are too large for this browser's stack")
      in
      Worker.post_message Js.Unsafe.(obj [| ("code", inject code); ("text", inject (Js.string text)) |]))
