(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Files, read block by block, and what messages say of them. *)

exception Invalid of string

let longest_text = 1 lsl 27

(* One clear line, whatever is in the text. *)
let quoted word =
  let start = if String.length word > 40 then String.sub word 0 40 ^ "..." else word in
  match word with "" -> "the end of the text" | "\n" -> "the end of the line" | _ -> "'" ^ String.escaped start ^ "'"

let refuse name line wrong expected =
  raise (Invalid (Printf.sprintf "%s:%d: %s; expected %s" (String.escaped name) line wrong expected))

let standard_input = ref (Some stdin)

let open_file = function
  | "-" ->
      let channel = !standard_input in
      standard_input := None;
      (match channel with Some channel -> channel | None -> raise (Invalid "standard input can be read once only"))
  | name -> open_in_bin name

(* What is read from a file that has nothing else in it. `read` takes the name for messages and a function that, given
   the number of the line, returns the next block, which is empty at the end. *)
let read name read =
  match open_file name with
  | exception Sys_error why -> raise (Invalid (String.escaped why))
  | channel ->
      let name = if name = "-" then "standard input" else name in
      let block = Bytes.create 65536 in
      let size = ref 0 in
      let next_block line =
        let count =
          try input channel block 0 (Bytes.length block)
          with Sys_error why -> refuse name line (String.escaped why) "a file that can be read"
        in
        size := !size + count;
        if !size > longest_text then
          refuse name line "the text is too long" (Printf.sprintf "at most %d bytes" longest_text);
        Bytes.sub_string block 0 count
      in
      Fun.protect (fun () -> read name next_block) ~finally:(fun () -> close_in_noerr channel)
