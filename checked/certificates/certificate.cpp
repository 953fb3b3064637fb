// SPDX-License-Identifier: MIT
#include "checked/certificates/certificate.hpp"

#include <algorithm>

#include "reference/io/invalid_input.hpp"

namespace oplus::certificates {

namespace {

/// To check whether a point is in a sum of two pieces takes as long as the product of their sizes.
constexpr std::uint32_t most_corners_of_summands = 8;

/// To check whether a piece is convex takes as long as the square of its size. Smaller pieces would be long
/// and thin where many vertices are on a line, and each would be cut into many cells.
constexpr std::uint32_t most_corners_of_sum = 256;

/// Breadth first, from the first piece and from each that is not reached otherwise.
std::vector<Certificate::Link> links(const ConvexPieces& pieces) {
  std::vector<std::vector<std::uint32_t>> at_vertex(pieces.vertices.size());
  const auto size = static_cast<std::uint32_t>(pieces.pieces.size());
  for (std::uint32_t i = 0; i < size; ++i)
    for (const std::uint32_t corner : pieces.pieces[i]) at_vertex[corner].push_back(i);
  std::vector<Certificate::Link> result;
  std::vector<bool> is_reached(size, false);
  std::vector<std::uint32_t> reached;
  for (std::uint32_t root = 0; root < size; ++root) {
    if (is_reached[root]) continue;
    is_reached[root] = true;
    reached = {root};
    for (std::size_t k = 0; k < reached.size(); ++k) {
      const std::uint32_t from = reached[k];
      for (const std::uint32_t corner : pieces.pieces[from]) {
        for (const std::uint32_t to : at_vertex[corner]) {
          if (is_reached[to]) continue;
          is_reached[to] = true;
          result.push_back({from, to});
          reached.push_back(to);
        }
        at_vertex[corner].clear();
      }
    }
  }
  return result;
}

/// The common denominator of the coordinates, with which boxes are exact; where that is long, a power of two with
/// which they are as exact as doubles.
mpz_class unit(const Region& p, const Region& q, const ShiftedDoubles& doubles) {
  constexpr std::size_t most_bits = 64;
  mpz_class common = 1;
  for (const Region* region : {&p, &q})
    for (const Chain& chain : chains(*region))
      for (const Point& v : chain)
        for (const Rational* x : {&v.x, &v.y}) {
          if (x->get_den() == 1) continue;
          common = lcm(common, x->get_den());
          if (mpz_sizeinbase(common.get_mpz_t(), 2) > most_bits)
            return mpz_class(1) << static_cast<unsigned long>(std::max(0L, 53 - doubles.bits()));
        }
  return common;
}

double largest_coordinate(const ConvexPieces& pieces, const ShiftedDoubles& doubles) {
  double largest = 0;
  for (const Point& p : pieces.vertices) {
    const Place near = doubles.near(p);
    largest = std::max({largest, std::abs(near.x), std::abs(near.y)});
  }
  return largest;
}

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
    if (!std::holds_alternative<IntegerLine>(step)) continue;
    deepest = std::max(deepest, here + 1);
    open.insert(open.end(), 2, here + 1);
  }
  return deepest;
}

class Text {
 public:
  template <typename... Words>
  void line(const Words&... words) {
    (add(words), ...);
    text_.back() = '\n';
    if (text_.size() > longest_text) refuse("a text of more bytes", longest_text);
  }

  void add_pieces(const ConvexPieces& pieces, const std::vector<Tree>* trees) {
    line("points", pieces.points.size());
    for (const auto& [edge, point] : pieces.points) line(edge, point.x, point.y);
    line("pieces", pieces.pieces.size());
    for (std::size_t i = 0; i < pieces.pieces.size(); ++i) {
      for (const std::uint32_t corner : pieces.pieces[i]) add(corner);
      text_.back() = '\n';
      if (trees == nullptr) continue;
      if (const std::size_t cuts = depth((*trees)[i]); cuts > deepest_tree)
        refuse("a tree of " + std::to_string(cuts) + " cuts above one another", deepest_tree);
      for (const Step& step : (*trees)[i]) {
        if (const auto* cut = std::get_if<IntegerLine>(&step))
          line("cut", cut->a, cut->b, cut->c);
        else
          line("in", std::get<PieceSums::Pair>(step).i, std::get<PieceSums::Pair>(step).j);
      }
    }
  }

  void add_summand(const char* name, const Certificate::PiecesOfSummand& summand) {
    line("summand", name);
    add_pieces(summand.pieces, nullptr);
    line("links", summand.links.size());
    for (const auto& [reached, next] : summand.links) line(reached, next);
  }

  std::string text() && { return std::move(text_); }

 private:
  void add(const char* word) { (text_ += word) += ' '; }
  void add(std::size_t number) { (text_ += std::to_string(number)) += ' '; }
  void add(std::uint32_t number) { add(std::size_t{number}); }
  void add(const mpz_class& number) { add_number(number.get_str()); }
  void add(const Rational& number) { add_number(number.get_str()); }
  void add_number(const std::string& word) {
    if (word.size() > longest_word)
      refuse("a number of " + std::to_string(word.size()) + " characters", longest_word);
    (text_ += word) += ' ';
  }

  std::string text_;
};

}  // namespace

std::optional<Point> repeated_vertex(const Region& s) {
  for (const Segment& e : edges(s))
    if (e.source == e.target) return e.source;
  return std::nullopt;
}

Certificate certificate(const Region& p, const Region& q, const Region& s) {
  Certificate result;
  result.p.pieces = pieces::convex_pieces(p, most_corners_of_summands);
  result.q.pieces = pieces::convex_pieces(q, most_corners_of_summands);
  result.sum = pieces::convex_pieces(s, most_corners_of_sum);
  result.p.links = links(result.p.pieces);
  result.q.links = links(result.q.pieces);

  std::vector<Point> all;
  for (const ConvexPieces* pieces : {&result.p.pieces, &result.q.pieces, &result.sum})
    all.insert(all.end(), pieces->vertices.begin(), pieces->vertices.end());
  const ShiftedDoubles doubles(all);
  result.unit = unit(p, q, doubles);
  const double largest = std::max(
      largest_coordinate(result.p.pieces, doubles) + largest_coordinate(result.q.pieces, doubles),
      largest_coordinate(result.sum, doubles));
  PieceSums sums(result.p.pieces, result.q.pieces, doubles);
  CellTrees trees(sums, doubles, largest);
  std::vector<Point> corners;
  for (const ConvexPiece& piece : result.sum.pieces) {
    corners.clear();
    for (const std::uint32_t corner : piece) corners.push_back(result.sum.vertices[corner]);
    result.trees.push_back(trees.tree(corners));
  }
  return result;
}

std::string written(const Certificate& certificate) {
  Text text;
  text.line("oplus", "certificate", "1");
  text.line("unit", certificate.unit);
  text.add_summand("p", certificate.p);
  text.add_summand("q", certificate.q);
  text.line("sum");
  text.add_pieces(certificate.sum, &certificate.trees);
  text.line("end");
  return std::move(text).text();
}

}  // namespace oplus::certificates
