// SPDX-License-Identifier: MIT
#include <cctype>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reference/chains/near_point.hpp"
#include "reference/chains/nesting.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/io/placed_geometry.hpp"
#include "reference/io/quoting.hpp"

namespace oplus {

namespace {

char upper(char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_sign(char c) { return c == '+' || c == '-'; }

/// Characters with their place, one after another.
class Characters {
 public:
  explicit Characters(const InputText& input) : input_(input) {}

  /// The next one, or the one that many behind it; a zero at the end.
  char peek(std::size_t behind = 0) const {
    return next_ + behind < input_.text.size() ? input_.text[next_ + behind] : '\0';
  }
  bool is_end() const { return next_ == input_.text.size(); }
  Position at() const { return at_; }

  std::string_view take(std::size_t count) {
    const std::string_view taken = input_.text.substr(next_, count);
    for (const char c : taken) at_.pass(c);
    input_.passed(next_, next_ + count);
    next_ += count;
    return taken;
  }

  void skip_blanks() {
    while (is_blank(peek())) take(1);
  }

  /// What comes next up to a blank or a comma, for a message.
  Token word() const {
    std::size_t length = 0;
    while (next_ + length < input_.text.size() && !is_blank(peek(length)) &&
           (length == 0 || peek(length) != ','))
      ++length;
    return {input_.text.substr(next_, length), at_};
  }

  /// The length of the number that comes next: SVG's, or a fraction p/q; zero where none does.
  std::size_t length_of_number() const {
    const auto digits = [&](std::size_t from) {
      std::size_t end = from;
      while (is_digit(peek(end))) ++end;
      return end;
    };
    const std::size_t start = is_sign(peek()) ? 1 : 0;
    std::size_t end = digits(start);
    if (end > start && peek(end) == '/' && is_digit(peek(end + 1))) return digits(end + 1);
    const bool has_point = peek(end) == '.' && (end > start || is_digit(peek(end + 1)));
    if (has_point) end = digits(end + 1);
    if (end == start) return 0;
    if (peek(end) == 'e' || peek(end) == 'E') {
      const std::size_t exponent = end + (is_sign(peek(end + 1)) ? 2 : 1);
      if (is_digit(peek(exponent))) end = digits(exponent);
    }
    return end;
  }

 private:
  const InputText& input_;
  std::size_t next_ = 0;
  Position at_;
};

class SvgPathReader {
 public:
  explicit SvgPathReader(const InputText& input) : input_(input), rest_(input) {}

  std::vector<PlacedChain> read() {
    rest_.skip_blanks();
    while (!rest_.is_end()) {
      command();
      rest_.skip_blanks();
    }
    end_subpath();
    return std::move(subpaths_);
  }

 private:
  void command() {
    ++commands_;
    const Position at = rest_.at();
    const auto which = [&] { return "command " + std::to_string(commands_); };
    letter_ = rest_.peek();
    switch (upper(letter_)) {
      case 'M':
        rest_.take(1);
        end_subpath();
        return arguments([this] {
          Point p = point();
          if (subpath_) return line_to(std::move(p));
          start_ = std::move(p);
          begin_subpath(place_);
        });
      case 'L':
        rest_.take(1);
        return arguments([this] { line_to(point()); });
      case 'H':
        rest_.take(1);
        return arguments([this] { line_to({coordinate('x'), here_.y}); });
      case 'V':
        rest_.take(1);
        return arguments([this] { line_to({here_.x, coordinate('y')}); });
      case 'Z':
        if (!subpath_) begin_subpath(at);
        rest_.take(1);
        return close_subpath();
      case 'C':
      case 'S':
      case 'Q':
      case 'T':
      case 'A':
        input_.refuse(at, which() + ", " + quote({&letter_, 1}) + ", is a curve",
                      "straight segments: M, L, H, V and Z");
      default:
        input_.refuse(at, describe(rest_.word()) + " where " + which() + " should be",
                      "M, L, H, V or Z");
    }
  }

  /// Reads the arguments of a command, once or repeatedly.
  template <typename Read>
  void arguments(Read read) {
    rest_.skip_blanks();
    do {
      place_ = rest_.at();
      read();
    } while (separator() || rest_.length_of_number() > 0);
  }

  /// Passes blanks and a comma; returns whether there was one.
  bool separator() {
    rest_.skip_blanks();
    const bool is_comma = rest_.peek() == ',';
    if (is_comma) rest_.take(1);
    rest_.skip_blanks();
    return is_comma;
  }

  Point point() {
    Point p;
    p.x = coordinate('x');
    separator();
    p.y = coordinate('y');
    return p;
  }

  Rational coordinate(char axis) {
    const auto name = [&] {
      const std::size_t vertices = subpath_ ? subpath_->vertices.size() : 0;
      return coordinate_name(axis, vertices + 1, "subpath " + std::to_string(subpaths_.size() + 1));
    };
    const Position at = rest_.at();
    const std::size_t length = rest_.length_of_number();
    if (length == 0)
      input_.refuse(at, describe(rest_.word()) + " where " + name() + " should be", "a number");
    Rational value;
    put_coordinate(input_, rest_.take(length), at, value, name);
    if (std::islower(static_cast<unsigned char>(letter_)) != 0)
      value += axis == 'x' ? here_.x : here_.y;
    return value;
  }

  void begin_subpath(const Position& at) {
    subpath_.emplace().start = at;
    add(start_, at);
  }

  void line_to(Point p) {
    if (!subpath_) begin_subpath(place_);
    add(std::move(p), place_);
  }

  void add(Point p, const Position& at) {
    here_ = std::move(p);
    subpath_->vertices.push_back(here_);
    subpath_->places.push_back(at);
  }

  void close_subpath() {
    PlacedChain& chain = *subpath_;
    if (chain.vertices.size() > 1 && chain.vertices.front() == chain.vertices.back()) {
      chain.vertices.pop_back();
      chain.places.pop_back();
    }
    subpaths_.push_back(std::move(chain));
    subpath_.reset();
    if (!OPLUS_MUTANT("paths-go-on-where-they-ended",
                      "a relative subpath starts at the last vertex of the one that was closed"))
      here_ = start_;
  }

  void end_subpath() {
    if (!subpath_) return;
    remove_closing_vertex(*subpath_);
    subpaths_.push_back(std::move(*subpath_));
    subpath_.reset();
  }

  const InputText& input_;
  Characters rest_;
  std::size_t commands_ = 0;
  char letter_ = 'M';  ///< of the command that is read
  Position place_;     ///< of its arguments
  Point here_, start_;
  std::optional<PlacedChain> subpath_;
  std::vector<PlacedChain> subpaths_;
};

/// Which of the chains are holes, and which chain is around each, by SVG's default rule, nonzero: one
/// inside another is a hole, or a component in a hole, where it runs the other way round.
struct Roles {
  std::vector<bool> is_hole;
  std::vector<std::optional<std::size_t>> around;
};

///
/// Where edges cross, which is refused unless overlaps are allowed, they need not be known: then the sweep ends,
/// since there may be as many crossings as pairs of edges.
Roles roles_of(const std::vector<PlacedChain>& chains, Overlaps overlaps) {
  std::vector<const Chain*> all;
  for (const PlacedChain& chain : chains) all.push_back(&chain.vertices);
  const SweptChains swept(all);
  Nesting nests(swept);
  sweep(swept.edges, [&](const SweptPlace& place) {
    nests.pass(place);
    return overlaps == Overlaps::allowed || !place.points.empty();
  });
  Roles result;
  for (std::size_t c = 0; c < chains.size(); ++c) result.around.push_back(nests.around(c));
  result.is_hole.resize(chains.size(), false);
  std::vector<bool> is_known(chains.size(), false);
  for (std::size_t c = 0; c < chains.size(); ++c) {
    std::vector<std::size_t> way;  // to one around that is known
    for (std::optional<std::size_t> at = c; at && !is_known[*at]; at = result.around[*at])
      way.push_back(*at);
    for (; !way.empty(); way.pop_back()) {
      const std::size_t here = way.back();
      is_known[here] = true;
      const std::optional<std::size_t> around = result.around[here];
      if (!around) continue;
      const bool runs_as_around =
          (sign_of_area(chains[here].vertices) < 0) == (sign_of_area(chains[*around].vertices) < 0);
      result.is_hole[here] =
          result.is_hole[*around] == runs_as_around &&
          !OPLUS_MUTANT("paths-have-no-holes", "no subpath of an SVG path is read as a hole");
    }
  }
  return result;
}

/// In the order of regions: outer chains as they come, each with its holes.
PlacedGeometry in_components(std::vector<PlacedChain> chains, Overlaps overlaps) {
  PlacedGeometry result;
  result.has_directions = true;
  if (chains.empty()) return result;
  const Roles roles = roles_of(chains, overlaps);
  std::vector<std::vector<std::size_t>> holes_of(chains.size());
  for (std::size_t c = 0; c < chains.size(); ++c) {
    if (!roles.is_hole[c]) continue;
    std::size_t outer = c;
    while (roles.is_hole[outer]) outer = *roles.around[outer];
    holes_of[outer].push_back(c);
  }
  for (std::size_t c = 0; c < chains.size(); ++c) {
    if (roles.is_hole[c]) continue;
    ChainName name{result.next_component(), 0};
    const auto add = [&](std::size_t chain) {
      chains[chain].name = name;
      result.chains.push_back(std::move(chains[chain]));
      ++name.hole;
    };
    add(c);
    for (const std::size_t hole : holes_of[c]) add(hole);
  }
  return result;
}

}  // namespace

bool is_svg_path(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos || upper(text[first]) != 'M') return false;
  return first + 1 == text.size() || std::isalpha(static_cast<unsigned char>(text[first + 1])) == 0;
}

PlacedGeometry parse_svg_path(const InputText& input, Overlaps overlaps) {
  return in_components(SvgPathReader(input).read(), overlaps);
}

}  // namespace oplus
