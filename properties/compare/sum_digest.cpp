// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/sum_digest.hpp"

#include <boost/uuid/name_generator_sha1.hpp>
#include <stdexcept>

#include "properties/compare/failure_kind.hpp"
#include "reference/definitions/unbounded.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

std::string text(const PlanarSet& sum) {
  return can_hold(Format::wkt, sum) ? written(sum, Format::wkt) : in_words(sum);
}

}  // namespace

SumDigest::SumDigest(const std::string& hexadecimal) {
  if (hexadecimal.size() != 32 ||
      hexadecimal.find_first_not_of("0123456789abcdef") != std::string::npos)
    throw std::invalid_argument("a digest is 32 hexadecimal digits, not " + hexadecimal);
  sum_ = mpz_class(hexadecimal, 16);
}

void SumDigest::add(std::size_t pair, const PlanarSet& closed, const PlanarSet& open) {
  const boost::uuids::uuid hash = boost::uuids::name_generator_sha1(boost::uuids::ns::oid())(
      std::to_string(pair) + '\n' + text(closed) + text(open));
  SumDigest of_pair;
  mpz_import(of_pair.sum_.get_mpz_t(), hash.size(), -1, 1, 0, 0, hash.data);
  add(of_pair);
}

void SumDigest::add(const SumDigest& other) {
  sum_ += other.sum_;
  mpz_fdiv_r_2exp(sum_.get_mpz_t(), sum_.get_mpz_t(), 128);
}

std::string SumDigest::to_string() const {
  const std::string digits = sum_.get_str(16);
  return std::string(32 - digits.size(), '0') + digits;
}

std::string in_words(const Region& region) {
  return written(region, is_unbounded(region) ? Format::dat : Format::wkt);
}

std::string in_words(const PlanarSet& sum) {
  if (can_hold(Format::wkt, sum) && !malformed(sum)) return written(sum, Format::wkt);
  std::string text = sum.is_unbounded ? "unbounded\n" : "";
  const auto add = [&](const std::string& what, const Chain& points) {
    text += what;
    for (const Point& p : points) text += " " + to_string(p);
    text += "\n";
  };
  for (const Chain& chain : sum.outer) add("outer chain", chain);
  for (const Chain& chain : sum.holes) add("hole", chain);
  for (const Segment& s : sum.dangling_edges) add("dangling edge", {s.source, s.target});
  for (const Point& p : sum.isolated_vertices) add("isolated vertex", {p});
  return text;
}

}  // namespace oplus
