// SPDX-License-Identifier: MIT
#include "checked/certificates/certificate_text.hpp"

#include <algorithm>

#include "reference/io/invalid_input.hpp"

namespace oplus::certificates {

namespace {

// The limits of the checker's reader.
constexpr std::size_t longest_text = std::size_t{1} << 27;
constexpr std::size_t longest_word = 100'000;
constexpr std::size_t deepest_tree = 100'000;

[[noreturn]] void refuse(const std::string& wrong, std::size_t most) {
  throw InvalidInput({"the certificate", 0, 0}, wrong,
                     "at most " + std::to_string(most) + ", the limit of oplus-certified");
}

/// How many cuts are above one another.
std::size_t depth(const Tree& tree) {
  std::vector<std::size_t> open = {0};  // the depths of trees that are to follow, the next one last
  std::size_t deepest = 0;
  for (const Step& step : tree) {
    const std::size_t here = open.back();
    open.pop_back();
    if (!std::holds_alternative<Cut>(step)) continue;
    deepest = std::max(deepest, here + 1);
    open.insert(open.end(), 2, here + 1);
  }
  return deepest;
}

}  // namespace

CertificateText::CertificateText(const char* claim) {
  line("oplus", "certificate", "2");
  line("claim", claim);
}

void CertificateText::end_line() {
  text_.back() = '\n';
  if (text_.size() > longest_text) refuse("a text of more bytes", longest_text);
}

void CertificateText::add_pieces(const ConvexPieces& pieces, const std::vector<Tree>* trees) {
  line("points", pieces.points.size());
  for (const auto& [edge, point] : pieces.points) line(edge, point);
  line("pieces", pieces.pieces.size());
  for (std::size_t i = 0; i < pieces.pieces.size(); ++i) {
    for (const std::uint32_t corner : pieces.pieces[i]) add(corner);
    end_line();
    if (trees == nullptr) continue;
    if (const std::size_t cuts = depth((*trees)[i]); cuts > deepest_tree)
      refuse("a tree of " + std::to_string(cuts) + " cuts above one another", deepest_tree);
    for (const Step& step : (*trees)[i]) {
      if (const auto* cut = std::get_if<Cut>(&step)) {
        line("cut", cut->line.a, cut->line.b, cut->line.c, cut->seam);
      } else {
        line(std::get<PieceSums::Pair>(step));
      }
    }
  }
}

std::string CertificateText::text() && {
  line("end");
  return std::move(text_);
}

void CertificateText::add(const char* word) { (text_ += word) += ' '; }
void CertificateText::add(std::size_t number) { (text_ += std::to_string(number)) += ' '; }
void CertificateText::add(std::uint32_t number) { add(std::size_t{number}); }
void CertificateText::add(const mpz_class& number) { add_number(number.get_str()); }
void CertificateText::add(const Rational& number) { add_number(number.get_str()); }

void CertificateText::add_number(const std::string& word) {
  if (word.size() > longest_word)
    refuse("a number of " + std::to_string(word.size()) + " characters", longest_word);
  (text_ += word) += ' ';
}

void CertificateText::add(const Point& p) {
  add(p.x);
  add(p.y);
}

void CertificateText::add(const Chain& chain) {
  for (const Point& v : chain) add(v);
}

void CertificateText::add(const PieceSums::Pair& pair) {
  add("in");
  add(pair.i);
  add(pair.j);
}

void CertificateText::add(const DanglingEdge& edge) {
  add("on");
  add(edge.number);
}

void CertificateText::add(const IsolatedVertex& vertex) {
  add("point");
  add(vertex.number);
}

/// An interval that is where the point before it is, is left out.
void CertificateText::add(const Seam& seam) {
  const auto add_place = [&](const auto& place) {
    std::visit([&](const auto& where) { add(where); }, place);
  };
  for (std::size_t i = 0; i < seam.intervals.size(); ++i) {
    if (i > 0) {
      const auto& [coordinate, place] = seam.points[i - 1];
      if (!std::holds_alternative<IsolatedVertex>(place)) {
        add("at");
        add(coordinate);
      }
      add_place(place);
      if (seam.intervals[i] == place) continue;
    }
    add_place(seam.intervals[i]);
  }
}

}  // namespace oplus::certificates
