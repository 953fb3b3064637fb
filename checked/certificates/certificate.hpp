// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "checked/certificates/cell_trees.hpp"
#include "checked/operations/sum_of.hpp"

namespace oplus::certificates {

/// What a certificate shows of a set S.
enum class Claim {
  sum,        ///< it is the sum of the closed regions P and Q,
  open_sum,   ///< or that of their interiors;
  no_fit,     ///< it is where Q, moved, overlaps P,
  inner_fit,  ///< or where it is inside P
};

/// What shows a program that is proved to be right that a claim holds: docs/certificates.md. For no-fit and inner-fit
/// polygons it is the certificate of an open sum that they are made of.
struct Certificate {
  struct Link {
    std::uint32_t reached;
    std::uint32_t next;
    friend bool operator==(const Link&, const Link&) = default;
  };
  struct PiecesOfSummand {
    ConvexPieces pieces;
    std::vector<Link> links;  ///< each to a piece that has a corner of one that is reached
  };
  /// A side of two of the sum's pieces, between the corners `from` and `to`.
  struct Diagonal {
    std::uint32_t from;
    std::uint32_t to;
    Seam seam;
  };

  Claim claim = Claim::sum;
  ClaimedSum outer;  ///< of an inner-fit polygon: the parts of the open sum that are far from it
  mpz_class unit;    ///< boxes of the checker are integers divided by this
  PiecesOfSummand p;
  PiecesOfSummand q;
  ConvexPieces sum;
  std::vector<Tree> trees;  ///< of the sum's pieces
  /// Of an open sum, those whose seam is not one interval in the pair of the first leaf of the later piece's tree.
  std::vector<Diagonal> diagonals;
};

/// Returns a vertex that equals the next one. There is no edge between the two, so no certificate.
std::optional<Point> repeated_vertex(const Region& s);

// Each requires: p and q are valid and bounded; s may have chains that touch themselves, but no vertex that equals the
// next one. That nothing else is in s is seen, that nothing is left out is not. Throws PointOutsideSum.

/// Of P ⊕ Q.
Certificate certificate(const Region& p, const Region& q, const Region& s);

/// Of the sum of the interiors: of chains, dangling edges and isolated vertices.
Certificate open_certificate(const Region& p, const Region& q, const ClaimedSum& s);

/// That an open set is the no-fit polygon of p and q.
Certificate no_fit_certificate(const Region& p, const Region& q, const ClaimedSum& s);

/// That a closed set is the inner-fit polygon of p and q. Requires also: q is not empty. `sum` is called once, for
/// a square and -q.
Certificate inner_fit_certificate(const Region& p, const Region& q, const ClaimedSum& s,
                                  const SumOf& sum);

/// The text of a file. Throws InvalidInput where it is larger than what oplus-certified reads.
std::string written(const Certificate& certificate);

}  // namespace oplus::certificates
