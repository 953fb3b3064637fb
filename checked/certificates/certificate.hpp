// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "checked/certificates/cell_trees.hpp"

namespace oplus::certificates {

/// What shows a program that is proved to be right that S is the sum of the closed regions P and Q:
/// docs/certificates.md.
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

  mpz_class unit;  ///< boxes of the checker are integers divided by this
  PiecesOfSummand p;
  PiecesOfSummand q;
  ConvexPieces sum;
  std::vector<Tree> trees;  ///< of the sum's pieces
};

/// Returns a vertex that equals the next one. There is no edge between the two, so no certificate.
std::optional<Point> repeated_vertex(const Region& s);

/// Requires: p and q are valid, and so is s but that its chains may touch themselves; no vertex
/// is repeated. That s is part of P ⊕ Q is seen, that it is all of it is not. Throws PointOutsideSum.
Certificate certificate(const Region& p, const Region& q, const Region& s);

/// The text of a file. Throws InvalidInput where it is larger than what oplus-certified reads.
std::string written(const Certificate& certificate);

}  // namespace oplus::certificates
