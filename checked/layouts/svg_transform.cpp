// SPDX-License-Identifier: MIT
#include "checked/layouts/svg_transform.hpp"

#include "checked/operations/image.hpp"
#include "reference/io/quoting.hpp"

namespace oplus::layouts {

AffineMap svg_transform(Builder& builder, std::string_view text) {
  const InputText input{builder.input.name, text};
  Tokenizer tokens(input, "(),");
  AffineMap all;
  while (!tokens.peek().is_end()) {
    const Token name = tokens.take();
    if (name.text == ",") continue;
    if (const Token open = tokens.take(); open.text != "(")
      input.refuse(open.at, describe(open) + " after " + quote(name.text), "'('");
    std::vector<Rational> n;
    while (tokens.peek().text != ")") {
      const Token token = tokens.take();
      if (token.is_end()) input.refuse(token.at, "the end of a transform", "')'");
      if (token.text != ",")
        put_coordinate(input, token.text, token.at, n.emplace_back(),
                       [&] { return "a number of " + one_line(name.text); });
    }
    tokens.take();
    const auto is = [&](const char* step, std::size_t least, std::size_t most) {
      return name.text == step && (n.size() == least || n.size() == most);
    };
    const auto moved = [](Rational x, Rational y) {
      return AffineMap{1, 0, 0, 1, {std::move(x), std::move(y)}};
    };
    if (is("translate", 1, 2))
      all = all * moved(n[0], n.size() == 2 ? n[1] : Rational(0));
    else if (is("scale", 1, 2))
      all = all * AffineMap{n[0], 0, 0, n.back(), {}};
    else if (is("matrix", 6, 6))
      all = all * AffineMap{n[0], n[2], n[1], n[3], {n[4], n[5]}};
    else if (is("rotate", 1, 1))
      all = all * builder.rotation(n[0]);
    else if (is("rotate", 3, 3))
      all = all * moved(n[1], n[2]) * builder.rotation(n[0]) * moved(-n[1], -n[2]);
    else
      input.refuse(name.at, quote(name.text) + " of " + std::to_string(n.size()) + " numbers",
                   "translate, scale, rotate or matrix of as many as it takes");
  }
  return all;
}

}  // namespace oplus::layouts
