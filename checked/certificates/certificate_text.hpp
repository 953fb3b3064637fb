// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "checked/certificates/cell_trees.hpp"

namespace oplus::certificates {

/// The text of a certificate while it is written: lines of words and numbers. Throws InvalidInput where it would be
/// larger than what oplus-certified reads.
class CertificateText {
 public:
  /// Starts with the version and the claim.
  explicit CertificateText(const char* claim);

  template <typename... Words>
  void line(const Words&... words) {
    (add(words), ...);
    end_line();
  }

  /// Each with its tree, if there are any.
  void add_pieces(const ConvexPieces& pieces, const std::vector<Tree>* trees);

  /// All of it, and the end.
  std::string text() &&;

 private:
  void add(const char* word);
  void add(std::size_t number);
  void add(std::uint32_t number);
  void add(const mpz_class& number);
  void add(const Rational& number);
  void add(const Point& p);
  void add(const Chain& chain);
  void add(const PieceSums::Pair& pair);
  void add(const DanglingEdge& edge);
  void add(const IsolatedVertex& vertex);
  void add(const Seam& seam);
  void add_number(const std::string& word);
  void end_line();

  std::string text_;
};

}  // namespace oplus::certificates
