(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the programs have in common: one line for each error, the exit code 2, and the limits on memory. *)

let refuse message = raise (Files.Invalid message)
let too_small = "the memory is too small for these files"

let say_and_exit name message =
  (try flush stdout with Sys_error _ -> ());
  prerr_endline (name ^ ": " ^ message);
  close_out_noerr stdout; (* what could not be written is not tried again *)
  try exit 2 with Out_of_memory -> Unix._exit 2

external watch_stack : unit -> unit = "oplus_watch_stack"

(* A heap of 4 GB is more than any sensible input needs. *)
let limit_heap () =
  Gc.set { (Gc.get ()) with space_overhead = 200 };
  ignore (Gc.create_alarm (fun () -> if (Gc.quick_stat ()).heap_words > 1 lsl 29 then raise Out_of_memory))

(* Ends with the exit code that the arguments are answered with. *)
let run name answer =
  let say = say_and_exit name in
  let cannot_write why = say ("cannot write standard output: " ^ why) in
  try
    Sys.set_signal Sys.sigpipe Sys.Signal_ignore;
    (match Unix.fstat Unix.stdout with
     | exception Unix.Unix_error (why, _, _) -> cannot_write (Unix.error_message why)
     | _ -> ());
    watch_stack ();
    limit_heap ();
    let code = answer (List.tl (Array.to_list Sys.argv)) in
    flush stdout;
    exit code
  with
  | Files.Invalid message -> say message
  | Sys_error why -> cannot_write why
  | Unix.Unix_error (why, _, _) -> say (Unix.error_message why)
  | Out_of_memory | Stack_overflow -> say too_small
