// SPDX-License-Identifier: MIT
#define RAPIDJSON_HAS_STDSTRING 1
#include "checked/bindings/page/answers.hpp"

#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <array>
#include <cmath>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "checked/certificates/certificate.hpp"
#include "checked/collision/collision_test.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "checked/distance/ways_out.hpp"
#include "checked/slide/slide.hpp"
#include "checked/verify/verdict_text.hpp"
#include "checked/verify/verify.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/claimed_sum.hpp"
#include "reference/definitions/tangent_count.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/json_tree.hpp"
#include "reference/io/number.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/unchecked_input.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// JSON with the members of an answer.
class Answer {
 public:
  Answer() { json_.StartObject(); }

  std::string text() {
    json_.EndObject();
    return {buffer_.GetString(), buffer_.GetSize()};
  }

  void key(const char* name) { json_.Key(name); }
  void value(const std::string& text) { json_.String(text); }
  void value(bool is) { json_.Bool(is); }
  void value(int number) { json_.Int(number); }
  void value(std::size_t number) { json_.Uint64(number); }
  /// For the eye. Throws std::range_error for an infinity.
  void value(double number) {
    if (!std::isfinite(number))
      throw std::range_error("a number is beyond all doubles, and cannot be drawn");
    json_.Double(number);
  }
  template <typename Value>
  void member(const char* name, const Value& of_it) {
    key(name);
    value(of_it);
  }
  void member(const char* name, const char* text) { member(name, std::string(text)); }

  template <typename Content>
  void array(const Content& content) {
    json_.StartArray();
    content();
    json_.EndArray();
  }
  template <typename Content>
  void object(const Content& content) {
    json_.StartObject();
    content();
    json_.EndObject();
  }

  void numbers(const Point& p) {
    value(p.x.get_d());
    value(p.y.get_d());
  }
  void value(const Point& p) {
    array([&] { numbers(p); });
  }
  void value(const Segment& s) {
    array([&] {
      numbers(s.source);
      numbers(s.target);
    });
  }
  template <typename Value>
  void value(const std::vector<Value>& values) {
    array([&] {
      for (const Value& one : values) value(one);
    });
  }

 private:
  rapidjson::StringBuffer buffer_;
  rapidjson::Writer<rapidjson::StringBuffer> json_{buffer_};
};

std::string text(const JsonValue& json, const char* name) {
  const auto found = json.member(name);
  return found && found->kind() == JsonValue::Kind::string ? std::string(found->text()) : "";
}

bool flag(const JsonValue& json, const char* name) {
  const auto found = json.member(name);
  return found && found->kind() == JsonValue::Kind::boolean && found->text() == "true";
}

std::size_t index(const JsonValue& json, const char* name) {
  return std::stoul(std::string(json.member(name).value().text()));
}

/// The texts of both items of an array.
std::array<std::string, 2> two(const JsonValue& json, const char* name) {
  auto item = json.member(name).value().begin();
  const std::string first((*item).text());
  return {first, std::string((*++item).text())};
}

Rational number(const std::string& name, const std::string& text) {
  NumberFault fault;
  std::optional<Rational> value = parse_number(text, fault);
  if (!value) throw InvalidInput({name, 0, 0}, fault.wrong, fault.expected);
  return std::move(*value);
}

Rational positive(const std::string& name, const std::string& text) {
  Rational value = number(name, text);
  if (sign(value) <= 0) throw InvalidInput({name, 0, 0}, "it is not positive", "a distance");
  return value;
}

/// How the page says to move what: in steps, that grids are made of.
struct Move {
  Rational step;
  Vector steps;
  bool is_by;  ///< to a point otherwise

  Point operator()(const Point& from) const { return is_by ? from + step * steps : step * steps; }
};

Move move_of(const JsonValue& edit, const Rational& step) {
  const auto [x, y] = two(edit, "at");
  return {step, {std::stod(x), std::stod(y)}, text(edit, "how") == "by"};
}

/// A summand as it was written down.
struct Shape {
  std::string name;
  Region region;
  std::vector<std::string> notes = {};
  std::optional<std::string> defect = {};
};

Chain& chain_of(Region& region, std::size_t number) {
  for (Component& component : region.components) {
    if (number-- == 0) return component.outer;
    if (number < component.holes.size()) return component.holes[number];
    number -= component.holes.size();
  }
  throw InvalidInput({"request", 0, 0}, "it names a chain that is not there", "one that is");
}

/// Removes a vertex; of a hole of three, the hole.
void remove(Shape& shape, Chain& chain, std::size_t vertex) {
  if (chain.size() > 3) {
    chain.erase(chain.begin() + static_cast<std::ptrdiff_t>(vertex));
    return;
  }
  for (Component& component : shape.region.components)
    for (std::size_t h = 0; h < component.holes.size(); ++h)
      if (&component.holes[h] == &chain) {
        component.holes.erase(component.holes.begin() + static_cast<std::ptrdiff_t>(h));
        return;
      }
  throw InvalidInput({shape.name, 0, 0}, "an outer chain of three vertices cannot lose one",
                     "more vertices");
}

void edit(Shape& shape, const JsonValue& edit, const Rational& step) {
  const std::string how = text(edit, "how");
  if (!edit.member("vertex")) {
    shape.region = mapped(std::move(shape.region), move_of(edit, step));
    return;
  }
  Chain& chain = chain_of(shape.region, index(edit, "chain"));
  const std::size_t vertex = index(edit, "vertex");
  if (vertex >= chain.size())
    throw InvalidInput({"request", 0, 0}, "it names a vertex that is not there", "one that is");
  if (how == "remove")
    remove(shape, chain, vertex);
  else if (how == "add")
    chain.insert(chain.begin() + static_cast<std::ptrdiff_t>(vertex) + 1,
                 midpoint(chain[vertex], chain[next(vertex, chain.size())]));
  else
    chain[vertex] = move_of(edit, step)(chain[vertex]);
}

/// The summand of a request, edited, and turned the right way if it is valid.
Shape shape(const std::string& name, const JsonValue& request, const char* member,
            const Rational& step) {
  const std::string given = text(request, member);
  UncheckedInput input = read_unchecked(given, name);
  const auto asked = request.member("edit");
  const bool is_edited = asked && text(*asked, "of") == member;
  for (const PlacedChain& chain : input.geometry.chains)
    if (chain.is_open || chain.vertices.empty()) read_region(given, name);  // throws
  Shape result{name, take_region(input.geometry)};
  try {
    if (is_edited) edit(result, *asked, step);
    ReadRegion read =
        is_edited ? oriented_and_checked(result.region, name) : read_region(given, name);
    result.region = std::move(read.region);
    result.notes = std::move(read.notes);
  } catch (const InvalidInput& invalid) {
    result.defect = invalid.what();
  }
  return result;
}

void put(Answer& answer, const char* member, const Shape& shape) {
  answer.key(member);
  answer.object([&] {
    answer.member("wkt", wkt(shape.region));
    answer.member("vertices", counted(vertex_count(shape.region), "vertex", "vertices"));
    answer.member("notes", shape.notes);
    if (shape.defect) answer.member("error", *shape.defect);
    answer.key("chains");
    answer.value(chains(shape.region));
    answer.key("points");
    answer.array([&] {
      for (const Chain& chain : chains(shape.region))
        answer.array([&] {
          for (const Point& p : chain) answer.value(to_string(p));
        });
    });
    answer.key("names");
    answer.array([&] {
      for (std::size_t c = 0; c < shape.region.components.size(); ++c)
        for (std::size_t h = 0; h <= shape.region.components[c].holes.size(); ++h)
          answer.value(describe(ChainName{c + 1, h}));
    });
  });
}

/// A sum and its text; of another program's, whether the core's is the same set.
struct WrittenSum {
  PlanarSet set;
  std::string wkt;
  std::optional<bool> is_same = {};
};

WrittenSum written_sum(PlanarSet set) {
  std::string text = wkt(set);
  return {std::move(set), std::move(text)};
}

/// What another program has written, with its text as it is.
WrittenSum given_sum(const std::string& text, const PlanarSet& core) {
  PlanarSet set = read_sum(text, "sum").sum;
  const bool is_same = set == core;
  return {std::move(set), text, is_same};
}

void put(Answer& answer, const WrittenSum& written) {
  const PlanarSet& sum = written.set;
  answer.key("sum");
  answer.object([&] {
    answer.member("wkt", written.wkt);
    if (written.is_same) answer.member("same", *written.is_same);
    answer.member("area", to_string(area(sum)));
    answer.member("outer", sum.outer);
    answer.member("holes", sum.holes);
    answer.member("dangling", sum.dangling_edges);
    answer.member("isolated", sum.isolated_vertices);
  });
}

void put(Answer& answer, const ConvolutionCycles& traced) {
  std::size_t all = 0, reduced = 0;
  answer.key("cycles");
  answer.array([&] {
    for (const ConvolutionCycle& cycle : traced.cycles)
      answer.array([&] {
        for (const ConvolutionSegment& one : cycle) {
          const Segment& segment = one.segment;
          const Origin& origin = one.origin;
          ++all;
          if (!one.vertex_is_reflex) ++reduced;
          const bool of_p = origin.edge_of == Summand::P;
          const auto named = [](const char* what, const VertexIndex& i) {
            return std::string(what) + std::to_string(i.vertex + 1) +
                   (i.chain == 0 ? "" : " of chain " + std::to_string(i.chain + 1));
          };
          answer.array([&] {
            answer.numbers(segment.source);
            answer.numbers(segment.target);
            answer.value(one.vertex_is_reflex);
            answer.value(named("edge ", origin.edge) + (of_p ? " of P + " : " of Q + ") +
                         named("vertex ", origin.vertex) + (of_p ? " of Q" : " of P"));
            answer.value(to_string(segment.source) + " to " + to_string(segment.target));
          });
        }
      });
  });
  answer.member("segments", all);
  answer.member("reduced", reduced);
}

void put_placement(Answer& answer, const Region& p, const Region& q, const Point& x,
                   const PlanarSet& sum, const PlanarSet& open_sum,
                   const ConvolutionCycles& traced) {
  const std::vector<Segment> convolution = segments(full_convolution(traced));
  const Location location = locate(x, region_of(sum));
  answer.key("placement");
  answer.object([&] {
    answer.member("q", chains(translated(reflected(q), x)));
    answer.member("winding", winding_number(x, convolution));
    answer.member("tangents", tangent_count(x, p, q, {1, 0}));
    answer.member("on_convolution", lies_on_one(x, convolution));
    answer.member("location", location == Location::inside     ? "inside"
                              : location == Location::boundary ? "on the boundary of"
                                                               : "outside");
    answer.member("meet", hierarchy_collision(p, q)->interiors_meet_at(x));
    if (open_sum.outer.empty()) return;
    const Overlap nearest = WaysOut(edges(p), edges(reflected(q)), open_sum).from(x);
    answer.member("move", to_string(nearest.move));
    answer.member("squared", to_string(nearest.squared_depth));
    answer.member("contact", to_string(nearest.contact));
  });
}

void put_verdict(Answer& answer, const Region& p, const Region& q, Boundary boundary,
                 const std::string& given_text) {
  answer.key("verdict");
  answer.object([&] {
    try {
      const ClaimedSum given = read_unchecked_sum(given_text, "S");
      answer.member("chains", chains(given.region));
      answer.member("dangling", given.dangling_edges);
      answer.member("isolated", given.isolated_vertices);
      const Verdict verdict = verify(p, q, boundary, given);
      answer.member("is_sum", verdict.is_sum());
      answer.member("text", text_of(verdict));
      answer.member("notes", verdict.notes);
      if (!verdict.is_sum()) answer.member("witness", verdict.reasons.front().witness);
    } catch (const InvalidInput& invalid) {
      answer.member("error", invalid.what());
    }
  });
}

/// Of the closed sum, which is written with it.
void put_certificate(Answer& answer, const Region& p, const Region& q, const PlanarSet& sum) {
  answer.key("certificate");
  answer.object([&] {
    try {
      const Region s = region_of(sum);
      answer.member("text", written(certificates::certificate(p, q, s)));
      answer.member("sum", wkt(s));
    } catch (const InvalidInput& too_large) {
      answer.member("error", too_large.what());
    }
  });
}

Point point_x(const JsonValue& request, const Rational& step) {
  const auto [x, y] = two(request, "x");
  Point point{number("x", x), number("x", y)};
  if (const auto edit = request.member("edit"); edit && text(*edit, "of") == "x")
    point = move_of(*edit, step)(point);
  return point;
}

void put_all(Answer& answer, const JsonValue& request) {
  const Rational step = positive("step", text(request, "step"));
  answer.member("step", step.get_d());
  const Shape p = shape("P", request, "p", step);
  const Shape q = shape("Q", request, "q", step);
  const Point x = point_x(request, step);
  put(answer, "p", p);
  put(answer, "q", q);
  answer.key("x");
  answer.array([&] {
    answer.value(to_string(x.x));
    answer.value(to_string(x.y));
  });
  answer.member("at", x);
  if (p.defect || q.defect) {
    answer.member("error", p.defect ? *p.defect : *q.defect);
    return;
  }
  const Boundary boundary = flag(request, "open") ? Boundary::open : Boundary::closed;
  const auto sum_of = [&](Boundary of) { return slide_sum(p.region, q.region, of).sum; };
  const std::string given = text(request, "sum");
  PlanarSet core = sum_of(boundary);
  const WrittenSum sum = given.empty() ? written_sum(std::move(core)) : given_sum(given, core);
  const ConvolutionCycles traced = convolution_cycles(p.region, q.region);
  put(answer, sum);
  put(answer, traced);
  put_placement(answer, p.region, q.region, x, sum.set, sum_of(Boundary::open), traced);
  if (flag(request, "certificate"))
    put_certificate(answer, p.region, q.region,
                    boundary == Boundary::closed ? sum.set : sum_of(Boundary::closed));
  if (const std::string s = text(request, "s"); !s.empty())
    put_verdict(answer, p.region, q.region, boundary, s);
}

}  // namespace

std::string answer(const std::string& request) {
  try {
    Answer answer;
    put_all(answer, JsonTree(InputText{"request", request}).root());
    return answer.text();
  } catch (const std::exception& failed) {
    Answer answer;
    answer.member("error", failed.what());
    answer.member("refused", true);
    return answer.text();
  }
}

}  // namespace oplus

const char* oplus_answer(const char* request) {
  static std::string kept;
  kept = oplus::answer(request);
  return kept.c_str();
}
