(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Where a result goes. A file is there as a whole or not at all: the text goes to another file beside it, which then
   takes its name. Standard output, a device and another special file are written to, and never replaced. *)

let written name action =
  try action ()
  with Unix.Unix_error (why, _, _) ->
    Program.refuse (Printf.sprintf "cannot write %s: %s" (String.escaped name) (Unix.error_message why))

let write_and_close name channel text =
  try output_string channel text; close_out channel
  with Sys_error why -> Program.refuse (Printf.sprintf "cannot write %s: %s" (String.escaped name) why)

let is_replaced path =
  match Unix.stat path with { st_kind; _ } -> st_kind = S_REG | exception Unix.Unix_error (ENOENT, _, _) -> true

(* As if it were not handled. *)
let end_by signal =
  Sys.set_signal signal Signal_default;
  Unix.kill (Unix.getpid ()) signal

let to_replace name =
  let target = try Unix.realpath name with Unix.Unix_error _ -> name in
  let beside = Printf.sprintf "%s.%d.tmp" target (Unix.getpid ()) in
  let file = Unix.openfile beside [ O_WRONLY; O_CREAT; O_EXCL; O_CLOEXEC ] 0o666 in
  let is_there = ref true in
  let remove () = if !is_there then Unix.unlink beside in
  at_exit remove;
  let ended signal = remove (); is_there := false; end_by signal in
  List.iter (fun signal -> Sys.set_signal signal (Signal_handle ended)) Sys.[ sigint; sigterm; sighup ];
  fun text ->
    write_and_close name (Unix.out_channel_of_descr file) text;
    written name (fun () ->
        (match Unix.stat target with
         | { st_perm; _ } -> Unix.chmod beside st_perm
         | exception Unix.Unix_error (ENOENT, _, _) -> ());
        Unix.rename beside target);
    is_there := false

(* Finds out whether it can be written, before anything is computed. *)
let to_file name =
  if name = "-" then print_string
  else
    written name (fun () ->
        if is_replaced name then to_replace name
        else
          let file = Unix.openfile name [ O_WRONLY; O_CLOEXEC ] 0 in
          fun text -> write_and_close name (Unix.out_channel_of_descr file) text)
