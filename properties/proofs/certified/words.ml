(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A certificate as a list of words. A line's end is a word of its own. *)

type t = {
  name : string;
  next_block : int -> string;
  mutable block : string;
  mutable next : int; (* place in the block *)
  mutable line : int; (* of the next byte *)
  mutable word : string; (* the word that comes next; empty at the end *)
  mutable line_of_word : int;
}

let longest_word = 100_000
let refuse text wrong expected = Files.refuse text.name text.line_of_word wrong expected
let refuse_word text expected = refuse text (Files.quoted text.word) expected

(* Whether there is a next byte. *)
let more text =
  text.next < String.length text.block
  || begin
       text.block <- text.next_block text.line;
       text.next <- 0;
       text.block <> ""
     end

let is_blank c = c = ' ' || c = '\t' || c = '\r'

(* Takes the word. The next one is what comes up to a blank or the line's end. *)
let rec advance text =
  text.line_of_word <- text.line;
  if not (more text) then text.word <- ""
  else
    match text.block.[text.next] with
    | '\n' ->
        text.line <- text.line + 1;
        text.next <- text.next + 1;
        text.word <- "\n"
    | c when is_blank c ->
        text.next <- text.next + 1;
        advance text
    | _ ->
        let word = Buffer.create 16 in
        let ends c = is_blank c || c = '\n' in
        while more text && not (ends text.block.[text.next]) do
          if Buffer.length word = longest_word then
            refuse text (Files.quoted (Buffer.contents word)) (Printf.sprintf "words of at most %d bytes" longest_word);
          Buffer.add_char word text.block.[text.next];
          text.next <- text.next + 1
        done;
        text.word <- Buffer.contents word

let take text =
  let word = text.word in
  advance text;
  word

let expect text word = if text.word = word then advance text else refuse_word text (Files.quoted word)

(* What is read from a file that has nothing else in it. *)
let read_file file read =
  Files.read file (fun name next_block ->
      let text = { name; next_block; block = ""; next = 0; line = 1; word = ""; line_of_word = 1 } in
      advance text;
      let value = read text in
      expect text "";
      value)

(* Numbers *)

let is_digit c = '0' <= c && c <= '9'

(* As in regions. *)
let take_number text =
  let bytes = List.map (fun c -> Z.of_int (Char.code c)) (List.of_seq (String.to_seq text.word)) in
  match Proved.number_in bytes with
  | Inl number -> advance text; number
  | Inr what -> Regions.refuse text.name { in_line = Z.of_int text.line_of_word; at_word = bytes; what }

let is_natural word = word <> "" && String.for_all is_digit word

(* Takes digits. *)
let take_natural text =
  if not (is_natural text.word) then refuse_word text "a number that is not negative";
  Z.of_string (take text)

(* Takes digits that stand for a number of things in this text. *)
let take_count text =
  match int_of_string_opt text.word with
  | Some n when is_natural text.word && n <= Files.longest_text -> advance text; n
  | _ -> refuse_word text (Printf.sprintf "a number from 0 to %d" Files.longest_text)
