// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/convolution_arrangement.hpp"

#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <boost/container_hash/hash.hpp>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include "checked/sweep/non_crossing_traits.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = NonCrossingTraits<Kernel>;
/// Each cell carries its index.
using Cells = CGAL::Arr_extended_dcel<Traits, std::uint32_t, std::uint32_t, std::uint32_t>;
using Arrangement = CGAL::Arrangement_2<Traits, Cells>;

static_assert(std::is_same_v<Kernel::FT::ET, Rational>, "CGAL is compiled with CGAL_USE_GMPXX");

Kernel::FT number(const Rational& value) {
  if (OPLUS_MUTANT("arrangements-cut-fractions-off",
                   "an arrangement has integer parts of coordinates"))
    return Rational(mpz_class(value));
  return value;
}
Rational number(const Kernel::FT& value) { return CGAL::exact(value); }

/// CGAL 5.5 intersects lines in intervals, and where those overflow it finds no intersection
/// (docs/findings.md). So coordinates are divided by a power of two that makes none larger than
/// one, if there are such as could come near: products of three must be doubles.
class Scale {
 public:
  explicit Scale(const std::vector<ConvolutionSegment>& segments) {
    std::size_t bits = 0;
    for (const ConvolutionSegment& s : segments) {
      for (const Point& p : {s.segment.source, s.segment.target})
        bits = std::max({bits, bits_of(p.x), bits_of(p.y)});
    }
    if (bits > 256) shift_ = static_cast<mp_bitcnt_t>(bits);
  }

  Kernel::Point_2 scaled(const Point& p) const {
    if (shift_ == 0) return {number(p.x), number(p.y)};
    return {number(Rational(p.x >> shift_)), number(Rational(p.y >> shift_))};
  }
  Point original(const Kernel::Point_2& p) const {
    if (shift_ == 0 || OPLUS_MUTANT("coordinates-stay-scaled",
                                    "coordinates beyond what a double holds are not scaled back"))
      return {number(p.x()), number(p.y())};
    return {Rational(number(p.x()) << shift_), Rational(number(p.y()) << shift_)};
  }

 private:
  /// 2 to this power is larger than the value.
  static std::size_t bits_of(const Rational& value) {
    const std::size_t numerator = mpz_sizeinbase(value.get_num_mpz_t(), 2);
    const std::size_t denominator = mpz_sizeinbase(value.get_den_mpz_t(), 2);
    return numerator + 1 > denominator ? numerator + 1 - denominator : 0;
  }

  mp_bitcnt_t shift_ = 0;
};

/// A curve a strand. A segment's edge belongs to a chain, translated by the segment's vertex; a
/// strand of several segments belongs to no chain.
std::vector<Traits::X_monotone_curve_2> curves(const std::vector<Strand>& strands,
                                               const std::vector<ConvolutionSegment>& segments,
                                               const Scale& scale) {
  using Name = std::tuple<bool, std::size_t, std::size_t, std::size_t>;
  std::unordered_map<Name, TranslatedChain, boost::hash<Name>> names;
  const auto chain_of = [&](const Strand& strand) {
    if (strand.along.size() + strand.against.size() > 1) return no_chain;
    const auto& [edge_of, edge, vertex] =
        segments[strand.along.empty() ? strand.against[0] : strand.along[0]].origin;
    const auto next_name = static_cast<TranslatedChain>(names.size() + 1);
    const Name name{edge_of == Summand::P, edge.chain, vertex.chain, vertex.vertex};
    return names.try_emplace(name, next_name).first->second;
  };
  std::vector<Traits::X_monotone_curve_2> result;
  result.reserve(strands.size());
  for (std::uint32_t i = 0; i < strands.size(); ++i) {
    const auto& [source, target] = strands[i].segment;
    result.emplace_back(CGAL::Arr_segment_2<Kernel>(scale.scaled(source), scale.scaled(target)),
                        chain_of(strands[i]), i);
  }
  return result;
}

/// Gives every cell its index: the unbounded face zero, halfedges in pairs, the one from the
/// smaller end first.
void number_cells(Arrangement& arrangement) {
  std::uint32_t index = 0;
  for (const auto v : arrangement.vertex_handles()) v->set_data(index++);
  index = 0;
  for (const auto e : arrangement.edge_handles()) {
    const bool to_the_right = e->direction() == CGAL::ARR_LEFT_TO_RIGHT;
    e->set_data(to_the_right ? index : index + 1);
    e->twin()->set_data(to_the_right ? index + 1 : index);
    index += 2;
  }
  index = ConvolutionArrangement::unbounded;
  arrangement.unbounded_face()->set_data(index++);
  for (const auto f : arrangement.face_handles()) {
    if (!f->is_unbounded()) f->set_data(index++);
  }
}

}  // namespace

struct ConvolutionArrangement::Points {
  Scale scale;
  std::vector<Kernel::Point_2> of_vertex;
};

ConvolutionArrangement::ConvolutionArrangement(std::vector<ConvolutionSegment> segments)
    : segments_(std::move(segments)),
      strands_(strands(oplus::segments(segments_))),
      points_(std::make_unique<Points>(Points{Scale(segments_), {}})) {
  Arrangement arrangement;
  {
    const std::vector<Traits::X_monotone_curve_2> labelled =
        curves(strands_, segments_, points_->scale);
    CGAL::insert(arrangement, labelled.begin(), labelled.end());
  }
  number_cells(arrangement);

  leaving_.resize(arrangement.number_of_vertices());
  points_->of_vertex.resize(arrangement.number_of_vertices());
  for (const auto v : arrangement.vertex_handles()) points_->of_vertex[v->data()] = v->point();
  halfedges_.resize(arrangement.number_of_halfedges());
  strand_of_edge_.resize(arrangement.number_of_edges());
  for (const auto h : arrangement.halfedge_handles()) {
    halfedges_[h->data()] = {h->source()->data(), h->next()->data(), h->face()->data()};
    strand_of_edge_[h->data() / 2] = h->curve().strand();
    leaving_[h->source()->data()] = h->data();
  }
  boundaries_.resize(arrangement.number_of_faces());
  for (const auto f : arrangement.face_handles()) {
    std::vector<Halfedge>& of_face = boundaries_[f->data()];
    for (auto ccb = f->outer_ccbs_begin(); ccb != f->outer_ccbs_end(); ++ccb)
      of_face.push_back((*ccb)->data());
    for (auto ccb = f->inner_ccbs_begin(); ccb != f->inner_ccbs_end(); ++ccb)
      of_face.push_back((*ccb)->data());
  }
}

ConvolutionArrangement::ConvolutionArrangement(ConvolutionArrangement&&) noexcept = default;
ConvolutionArrangement::~ConvolutionArrangement() = default;

Point ConvolutionArrangement::point(Vertex v) const {
  return points_->scale.original(points_->of_vertex[v]);
}

}  // namespace oplus
