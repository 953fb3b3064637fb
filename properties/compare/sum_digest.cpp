// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/sum_digest.hpp"

#include <boost/uuid/name_generator_sha1.hpp>
#include <stdexcept>
#include <string_view>

#include "reference/io/writing.hpp"

namespace oplus {

namespace {

constexpr std::string_view digits = "0123456789abcdef";

}  // namespace

SumDigest::SumDigest(const std::string& hexadecimal) {
  if (hexadecimal.size() != 32 || hexadecimal.find_first_not_of(digits) != std::string::npos)
    throw std::invalid_argument("a digest is 32 hexadecimal digits, not " + hexadecimal);
  for (const char digit : hexadecimal) sum_ = sum_ * 16 + digits.find(digit);
}

void SumDigest::add(std::size_t pair, const MinkowskiSum& closed, const MinkowskiSum& open) {
  const boost::uuids::uuid hash = boost::uuids::name_generator_sha1(boost::uuids::ns::oid())(
      std::to_string(pair) + '\n' + written(closed, Format::wkt) + written(open, Format::wkt));
  SumDigest of_pair;
  for (std::size_t i = hash.size(); i > 0; --i)
    of_pair.sum_ = of_pair.sum_ * 256 + hash.data[i - 1];
  add(of_pair);
}

void SumDigest::add(const SumDigest& other) { sum_ += other.sum_; }

std::string SumDigest::to_string() const {
  std::string text(32, '0');
  auto left = sum_;
  for (std::size_t i = text.size(); i > 0; left /= 16)
    text[--i] = digits[static_cast<std::size_t>(left % 16)];
  return text;
}

}  // namespace oplus
