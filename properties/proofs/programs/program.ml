(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the programs have in common: one line for each error, the exit code 2, and the limits on memory. *)

let refuse message = raise (Words.Invalid message)
let too_small = "the memory is too small for these files"

let say_and_exit name message =
  prerr_endline (name ^ ": " ^ message);
  close_out_noerr stdout; (* what could not be written is not tried again *)
  exit 2

let signals = Sys.[ sigint; sigterm; sighup ]

(* As if it were not handled. *)
let end_by signal =
  Sys.set_signal signal Signal_default;
  Unix.kill (Unix.getpid ()) signal

(* Recursion is as deep as lists are long, so the program runs again, with a higher limit on its stack. Where there is
   no more memory, OCaml's runtime ends that run: what this one says then is one line all the same. *)
let run_again name =
  Unix.putenv "OPLUS_STACK" "unlimited";
  let command = "ulimit -s unlimited 2>/dev/null || ulimit -s $(ulimit -H -s); exec \"$@\"" in
  let shell = [| "sh"; "-c"; command; "sh"; Sys.executable_name |] in
  let arguments = Array.append shell (Array.sub Sys.argv 1 (Array.length Sys.argv - 1)) in
  let reading, writing = Unix.pipe ~cloexec:true () in
  let again = Unix.create_process "/bin/sh" arguments Unix.stdin Unix.stdout writing in
  List.iter (fun s -> Sys.set_signal s (Signal_handle (Unix.kill again))) signals;
  Unix.close writing;
  let said = try input_line (Unix.in_channel_of_descr reading) with End_of_file -> "" in
  let rec ended () = try snd (Unix.waitpid [] again) with Unix.Unix_error (EINTR, _, _) -> ended () in
  match ended () with
  | WEXITED code when code < 2 -> exit code
  | WSIGNALED signal when List.mem signal signals -> end_by signal
  | _ when String.starts_with ~prefix:(name ^ ": ") said -> prerr_endline said; exit 2
  | _ -> say_and_exit name too_small

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
    if Sys.getenv_opt "OPLUS_STACK" = None then run_again name;
    limit_heap ();
    let code = answer (List.tl (Array.to_list Sys.argv)) in
    flush stdout;
    exit code
  with
  | Words.Invalid message -> say message
  | Sys_error why -> cannot_write why
  | Unix.Unix_error (why, _, _) -> say (Unix.error_message why)
  | Out_of_memory | Stack_overflow -> say too_small
