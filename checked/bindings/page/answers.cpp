// SPDX-License-Identifier: MIT
#include "checked/bindings/page/answers.hpp"

#include <rapidjson/document.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <cmath>
#include <cstdint>
#include <exception>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "checked/collision/collision_test.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "checked/slide/slide.hpp"
#include "checked/verify/verdict_text.hpp"
#include "checked/verify/verify.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/given_sum.hpp"
#include "reference/definitions/tangent_count.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/number.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/unchecked_input.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

using Json = rapidjson::Value;

/// JSON with the members of an answer.
class Answer {
 public:
  Answer() { writer_.StartObject(); }

  std::string text() {
    writer_.EndObject();
    return {buffer_.GetString(), buffer_.GetSize()};
  }

  void key(const char* name) { writer_.Key(name); }
  void value(const std::string& text) {
    writer_.String(text.data(), static_cast<rapidjson::SizeType>(text.size()));
  }
  void value(bool is) { writer_.Bool(is); }
  void value(int number) { writer_.Int(number); }
  void value(std::size_t number) { writer_.Uint64(number); }
  /// For the eye. Throws std::range_error for an infinity.
  void value(double number) {
    if (!std::isfinite(number))
      throw std::range_error("a number is beyond all doubles, and cannot be drawn");
    writer_.Double(number);
  }
  template <typename Value>
  void member(const char* name, const Value& of_it) {
    key(name);
    value(of_it);
  }
  void member(const char* name, const char* text) { member(name, std::string(text)); }

  template <typename Content>
  void array(const Content& content) {
    writer_.StartArray();
    content();
    writer_.EndArray();
  }
  template <typename Content>
  void object(const Content& content) {
    writer_.StartObject();
    content();
    writer_.EndObject();
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
  rapidjson::Writer<rapidjson::StringBuffer> writer_{buffer_};
};

std::string text(const Json& json, const char* name) {
  const auto found = json.FindMember(name);
  if (found == json.MemberEnd() || !found->value.IsString()) return {};
  return {found->value.GetString(), found->value.GetStringLength()};
}

bool flag(const Json& json, const char* name) {
  const auto found = json.FindMember(name);
  return found != json.MemberEnd() && found->value.IsBool() && found->value.GetBool();
}

std::size_t index(const Json& json, const char* name) { return json[name].GetUint(); }

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

Move move_of(const Json& edit, const Rational& step) {
  const Json& at = edit["at"];
  return {step, {at[0].GetDouble(), at[1].GetDouble()}, text(edit, "how") == "by"};
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

void edit(Shape& shape, const Json& edit, const Rational& step) {
  const std::string how = text(edit, "how");
  if (!edit.HasMember("vertex")) {
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
Shape shape(const std::string& name, const Json& request, const char* member,
            const Rational& step) {
  const std::string given = text(request, member);
  UncheckedInput input = read_unchecked(given, name);
  const bool is_edited = request.HasMember("edit") && text(request["edit"], "of") == member;
  for (const PlacedChain& chain : input.geometry.chains)
    if (chain.is_open || chain.vertices.empty()) read_region(given, name);  // throws
  Shape result{name, take_region(input.geometry)};
  try {
    if (is_edited) edit(result, request["edit"], step);
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

void put(Answer& answer, const MinkowskiSum& sum) {
  answer.key("sum");
  answer.object([&] {
    answer.member("wkt", wkt(sum));
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
                   const MinkowskiSum& sum, const ConvolutionCycles& traced) {
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
  });
}

void put_verdict(Answer& answer, const Region& p, const Region& q, Boundary boundary,
                 const std::string& given_text) {
  answer.key("verdict");
  answer.object([&] {
    try {
      const GivenSum given = read_unchecked_sum(given_text, "S");
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

Point point_x(const Json& request, const Rational& step) {
  const Json& x = request["x"];
  Point point{number("x", x[0].GetString()), number("x", x[1].GetString())};
  if (request.HasMember("edit") && text(request["edit"], "of") == "x")
    point = move_of(request["edit"], step)(point);
  return point;
}

void put_all(Answer& answer, const Json& request) {
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
  const MinkowskiSum sum = slide_sum(p.region, q.region, boundary).sum;
  const ConvolutionCycles traced = convolution_cycles(p.region, q.region);
  put(answer, sum);
  put(answer, traced);
  put_placement(answer, p.region, q.region, x, sum, traced);
  if (const std::string s = text(request, "s"); !s.empty())
    put_verdict(answer, p.region, q.region, boundary, s);
}

}  // namespace

std::string answer(const std::string& request) {
  rapidjson::Document json;
  json.Parse(request.data(), request.size());
  try {
    Answer answer;
    put_all(answer, json);
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
