(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A text as a list of words and what messages say of it. The text is read in one pass and never held as a
   whole, so that a text without an end is refused, like any that is longer than all that are sensible. *)

exception Invalid of string

type t = {
  name : string;
  channel : in_channel;
  block : Bytes.t;
  mutable filled : int; (* bytes of the block *)
  mutable next : int; (* place in the block *)
  mutable size : int; (* bytes read, or stood for by exponents *)
  mutable line : int; (* of the next byte *)
  symbols : string; (* characters that are words of their own *)
  mutable word : string; (* the word that comes next; empty at the end *)
  mutable line_of_word : int;
}

let longest_text = 1 lsl 27
let longest_word = 100_000

(* One clear line, whatever is in the text. *)
let quoted word =
  let start = if String.length word > 40 then String.sub word 0 40 ^ "..." else word in
  match word with "" -> "the end of the text" | "\n" -> "the end of the line" | _ -> "'" ^ String.escaped start ^ "'"

let refuse_line name line wrong expected =
  raise (Invalid (Printf.sprintf "%s:%d: %s; expected %s" (String.escaped name) line wrong expected))

let refuse text wrong expected = refuse_line text.name text.line_of_word wrong expected
let refuse_word text expected = refuse text (quoted text.word) expected

(* Counts what is read. *)
let count text bytes =
  text.size <- text.size + bytes;
  if text.size > longest_text then
    refuse text "the text is too long" (Printf.sprintf "at most %d bytes; an exponent counts as so many" longest_text)

(* Whether there is a next byte. *)
let more text =
  text.next < text.filled
  || begin
       text.filled <- (try input text.channel text.block 0 (Bytes.length text.block)
                       with Sys_error why -> refuse text (String.escaped why) "a file that can be read");
       text.next <- 0;
       count text text.filled;
       text.filled > 0
     end

let is_blank c = c = ' ' || c = '\t' || c = '\r' || c = '\n'

(* Takes the word. The next one is what comes up to a blank or a symbol. *)
let rec advance text =
  text.line_of_word <- text.line;
  if not (more text) then text.word <- ""
  else
    let c = Bytes.get text.block text.next in
    if c = '\n' then text.line <- text.line + 1;
    if String.contains text.symbols c then begin
      text.next <- text.next + 1;
      text.word <- String.make 1 c
    end
    else if is_blank c then begin
      text.next <- text.next + 1;
      advance text
    end
    else begin
      let word = Buffer.create 16 in
      let ends c = is_blank c || String.contains text.symbols c in
      while more text && not (ends (Bytes.get text.block text.next)) do
        if Buffer.length word = longest_word then
          refuse text (quoted (Buffer.contents word)) (Printf.sprintf "words of at most %d bytes" longest_word);
        Buffer.add_char word (Bytes.get text.block text.next);
        text.next <- text.next + 1
      done;
      text.word <- Buffer.contents word
    end

let take text =
  let word = text.word in
  advance text;
  word

let expect text word = if text.word = word then advance text else refuse_word text (quoted word)

let standard_input = ref (Some stdin)

let open_file = function
  | "-" ->
      let channel = !standard_input in
      standard_input := None;
      (match channel with Some channel -> channel | None -> raise (Invalid "standard input can be read once only"))
  | name -> open_in_bin name

(* What is read from a file that has nothing else in it. *)
let read_file name symbols read =
  match open_file name with
  | exception Sys_error why -> raise (Invalid (String.escaped why))
  | channel ->
      let block = Bytes.create 65536 in
      let text =
        { name = (if name = "-" then "standard input" else name); channel; block; filled = 0; next = 0; size = 0; line = 1; symbols; word = ""; line_of_word = 1 }
      in
      let whole () =
        advance text;
        let value = read text in
        expect text "";
        value
      in
      Fun.protect whole ~finally:(fun () -> close_in_noerr channel)

(* Numbers *)

let is_digit c = '0' <= c && c <= '9'

(* The end of the digits that start there. *)
let rec end_of_digits word i = if i < String.length word && is_digit word.[i] then end_of_digits word (i + 1) else i

let has word i characters = i < String.length word && String.contains characters word.[i]
let largest_exponent = 4096

(* Takes an integer, a decimal, which may have an exponent, or a fraction p/q. *)
let take_number text =
  let word = text.word in
  let length = String.length word in
  let part first last = String.sub word first (last - first) in
  let wrong () = refuse_word text "an integer, a decimal or a fraction p/q" in
  let start = if has word 0 "+-" then 1 else 0 in
  let whole = end_of_digits word start in
  let value =
    if has word whole "/" then begin
      let stop = end_of_digits word (whole + 1) in
      if whole = start || stop = whole + 1 || stop < length then wrong ();
      let denominator = Z.of_string (part (whole + 1) stop) in
      if Z.equal denominator Z.zero then refuse_word text "a fraction p/q with q > 0";
      Q.make (Z.of_string (part start whole)) denominator
    end
    else begin
      let point = if has word whole "." then end_of_digits word (whole + 1) else whole in
      let decimals = part (min point (whole + 1)) point in
      let digits = part start whole ^ decimals in
      let sign = if has word point "eE" && has word (point + 1) "+-" then 1 else 0 in
      let exponent = if has word point "eE" then point + 1 + sign else point in
      let stop = end_of_digits word exponent in
      if digits = "" || stop < length || (exponent > point && stop = exponent) || (exponent = point && stop > point)
      then wrong ();
      let size =
        if exponent = point then 0
        else
          match int_of_string_opt (part exponent stop) with
          | Some size when size <= largest_exponent -> size
          | _ -> refuse_word text (Printf.sprintf "an exponent from -%d to %d" largest_exponent largest_exponent)
      in
      count text size;
      let shift = (if has word (point + 1) "-" then -size else size) - String.length decimals in
      let power = Z.pow (Z.of_int 10) (abs shift) in
      let digits = Z.of_string digits in
      if shift < 0 then Q.make digits power else Q.of_bigint (Z.mul digits power)
    end
  in
  advance text;
  if has word 0 "-" then Q.neg value else value

let is_natural word = word <> "" && end_of_digits word 0 = String.length word

(* Takes digits. *)
let take_natural text =
  if not (is_natural text.word) then refuse_word text "a number that is not negative";
  Z.of_string (take text)

(* Takes digits that stand for a number of things in this text. *)
let take_count text =
  match int_of_string_opt text.word with
  | Some n when is_natural text.word && n <= longest_text -> advance text; n
  | _ -> refuse_word text (Printf.sprintf "a number from 0 to %d" longest_text)
