// SPDX-License-Identifier: MIT
#include "checked/certificates/certificate.hpp"

#include <algorithm>
#include <set>

#include "checked/certificates/certificate_text.hpp"
#include "checked/certificates/frame_square.hpp"
#include "checked/certificates/unit.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus::certificates {

namespace {

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

double largest_coordinate(const ConvexPieces& pieces, const ShiftedDoubles& doubles) {
  double largest = 0;
  for (const Point& p : pieces.vertices) {
    const Place near = doubles.near(p);
    largest = std::max({largest, std::abs(near.x), std::abs(near.y)});
  }
  return largest;
}

/// Those whose seam is not the usual one.
std::vector<Certificate::Diagonal> diagonals(const Certificate& of, Seams& seams,
                                             const ShiftedDoubles& doubles) {
  const auto corner = [&](std::uint32_t vertex) {
    return std::make_shared<const CellCorner>(homogeneous(of.sum.vertices[vertex]), doubles);
  };
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  std::vector<Certificate::Diagonal> result;
  for (std::size_t i = 0; i < of.sum.pieces.size(); ++i) {
    const ConvexPiece& piece = of.sum.pieces[i];
    for (std::size_t k = 0; k < piece.size(); ++k) {
      const std::uint32_t from = piece[k], to = piece[next(k, piece.size())];
      if (sides.erase({to, from}) == 0) {
        sides.emplace(from, to);
        continue;
      }
      const auto a = corner(from), b = corner(to);
      Seam seam = seams.seam(a, b, line_through(a->exact, b->exact), first_leaf(of.trees[i]));
      if (!seam.is_usual()) result.push_back({from, to, std::move(seam)});
    }
  }
  return result;
}

Certificate made(Claim claim, const Region& p, const Region& q, const ClaimedSum& s) {
  Certificate result;
  result.claim = claim;
  result.p.pieces = pieces_of_summand(p);
  result.q.pieces = pieces_of_summand(q);
  result.sum = pieces::convex_pieces(s.region, most_corners_of_sum);
  result.p.links = links(result.p.pieces);
  result.q.links = links(result.q.pieces);

  std::vector<Point> all;
  for (const ConvexPieces* pieces : {&result.p.pieces, &result.q.pieces, &result.sum})
    all.insert(all.end(), pieces->vertices.begin(), pieces->vertices.end());
  const ShiftedDoubles doubles(all);
  result.unit = unit({&p, &q}, doubles);
  const double largest = std::max(
      largest_coordinate(result.p.pieces, doubles) + largest_coordinate(result.q.pieces, doubles),
      largest_coordinate(result.sum, doubles));
  PieceSums sums(result.p.pieces, result.q.pieces, doubles, largest);
  Seams seams(sums, doubles, s);
  const bool is_open = claim != Claim::sum;
  CellTrees trees(sums, doubles, is_open ? &seams : nullptr);
  std::vector<Point> corners;
  for (const ConvexPiece& piece : result.sum.pieces) {
    corners.clear();
    for (const std::uint32_t corner : piece) corners.push_back(result.sum.vertices[corner]);
    result.trees.push_back(trees.tree(corners));
  }
  if (is_open) result.diagonals = diagonals(result, seams, doubles);
  return result;
}

}  // namespace

std::optional<Point> repeated_vertex(const Region& s) {
  for (const Segment& e : edges(s))
    if (e.source == e.target) return e.source;
  return std::nullopt;
}

Certificate certificate(const Region& p, const Region& q, const Region& s) {
  return made(Claim::sum, p, q, {s, {}, {}});
}

Certificate open_certificate(const Region& p, const Region& q, const ClaimedSum& s) {
  return made(Claim::open_sum, p, q, s);
}

Certificate no_fit_certificate(const Region& p, const Region& q, const ClaimedSum& s) {
  return made(Claim::no_fit, p, reflected(q), s);
}

// x is no place of q iff it is in the open sum of what is outside of p, within a square, and -q; or so far away that
// x + q does not meet p. There the sum is that of the whole square and -q.
Certificate inner_fit_certificate(const Region& p, const Region& q, const ClaimedSum& s,
                                  const SumOf& sum) {
  const Rational k = (OPLUS_MUTANT("inner-fits-have-another-frame",
                                   "the certificate of an inner-fit polygon is for another square")
                          ? 4
                          : 5) *
                     frame_size({&p, &q});
  const Region opposite = reflected(q);
  const PlanarSet around = sum(polygon(square(k)), opposite, Boundary::open);
  ClaimedSum outer{region_of(around), around.dangling_edges, around.isolated_vertices};
  ClaimedSum open = outer;
  std::vector<Chain>& holes = open.region.components.back().holes;
  for (const Chain& chain : chains(s.region)) holes.push_back(turned(chain));
  open.dangling_edges.insert(open.dangling_edges.end(), s.dangling_edges.begin(),
                             s.dangling_edges.end());
  open.isolated_vertices.insert(open.isolated_vertices.end(), s.isolated_vertices.begin(),
                                s.isolated_vertices.end());
  Certificate result = made(Claim::inner_fit, complement_in_square(k, p), opposite, open);
  result.outer = std::move(outer);
  return result;
}

std::string written(const Certificate& certificate) {
  constexpr const char* names[] = {"sum", "open-sum", "nfp", "ifp"};
  CertificateText text(names[static_cast<int>(certificate.claim)]);
  if (certificate.claim == Claim::inner_fit) {
    const auto& [region, edges, points] = certificate.outer;
    const std::vector<Chain> outer = chains(region);
    text.line("outer", outer.size());
    for (const Chain& chain : outer) text.line(chain);
    text.line("outer-edges", edges.size());
    for (const Segment& edge : edges) text.line(edge.source, edge.target);
    text.line("outer-points", points.size());
    for (const Point& point : points) text.line(point);
  }
  text.line("unit", certificate.unit);
  for (const auto& [name, summand] :
       {std::pair("p", &certificate.p), std::pair("q", &certificate.q)}) {
    text.line("summand", name);
    text.add_pieces(summand->pieces, nullptr);
    text.line("links", summand->links.size());
    for (const auto& [reached, next] : summand->links) text.line(reached, next);
  }
  text.line("sum");
  text.add_pieces(certificate.sum, &certificate.trees);
  if (certificate.claim != Claim::sum) {
    text.line("seams", certificate.diagonals.size());
    for (const auto& [from, to, seam] : certificate.diagonals) text.line(from, to, seam);
  }
  return std::move(text).text();
}

}  // namespace oplus::certificates
