// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/sum_digest.hpp"

#include <boost/uuid/name_generator_sha1.hpp>
#include <stdexcept>

#include "properties/compare/values_in_words.hpp"
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

}  // namespace oplus
