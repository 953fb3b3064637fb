// SPDX-License-Identifier: MIT
// The convolution, and what is asked of a place.
#include "checked/bindings/c/set.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "checked/distance/ways_out.hpp"
#include "reference/definitions/tangent_count.hpp"
#include "reference/definitions/winding_number.hpp"

namespace {

using namespace oplus;

const Region& region(const oplus_set* handle, const char* name) {
  return c::region(handle, name).region();
}

ValidRegion read(const char* text, const char* name) { return read_text(&c::given(text, name)); }

Point point(const char* x, const char* y) {
  return Coordinates(&c::given(x, "x"), &c::given(y, "y")).point();
}

}  // namespace

oplus_code oplus_cycles(const char* p, const char* q, char** cycles) {
  return c::put(cycles, [&] {
    std::string all;
    for (const ConvolutionCycle& cycle :
         convolution_cycles(read(p, "p").region(), read(q, "q").region()).cycles) {
      for (const auto& [segment, origin, is_reflex] : cycle)
        for (const std::size_t number :
             {origin.edge_of == Summand::P ? std::size_t{0} : std::size_t{1}, origin.edge.chain,
              origin.edge.vertex, origin.vertex.chain, origin.vertex.vertex,
              std::size_t{is_reflex}})
          all += std::to_string(number) + ' ';
      all.back() = '\n';
    }
    return all;
  });
}

oplus_code oplus_winding(const oplus_set* p, const oplus_set* q, const char* x, const char* y,
                         int* winding, int* tangents, int* on_convolution) {
  return c::code_of([&] {
    const Region &of_p = region(p, "p"), &of_q = region(q, "q");
    const Point at = point(x, y);
    const std::vector<Segment> convolution =
        segments(full_convolution(convolution_cycles(of_p, of_q)));
    int &is_on = c::given(on_convolution, "on_convolution"), &turns = c::given(winding, "winding");
    c::given(tangents, "tangents") = tangent_count(at, of_p, of_q, {1, 0});
    turns = winding_number(at, convolution);
    is_on = lies_on_one(at, convolution) ? 1 : 0;
  });
}

oplus_code oplus_way_out(const oplus_set* p, const oplus_set* q, const char* x, const char* y,
                         char** way) {
  return c::put(way, [&] {
    const Point at = point(x, y);
    const ValidSet no_fit = nfp(c::region(p, "p"), c::region(q, "q"));
    const Overlap out =
        WaysOut(edges(region(p, "p")), edges(region(q, "q")), no_fit.value()).from(at);
    std::string text;
    c::append(text, out.move);
    c::append(text, out.squared_depth);
    c::append(text, out.contact);
    return text;
  });
}
