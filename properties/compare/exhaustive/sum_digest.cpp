// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/exhaustive/sum_digest.hpp"

#include <boost/uuid/name_generator_sha1.hpp>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include "reference/io/writing.hpp"

namespace oplus {

SumDigest::SumDigest(const std::string& hexadecimal) {
  if (hexadecimal.size() != 32 ||
      hexadecimal.find_first_not_of("0123456789abcdef") != std::string::npos)
    throw std::invalid_argument("a digest is 32 hexadecimal digits, not " + hexadecimal);
  words_ = {std::stoull(hexadecimal.substr(16), nullptr, 16),
            std::stoull(hexadecimal.substr(0, 16), nullptr, 16)};
}

void SumDigest::add(std::uint64_t pair, const MinkowskiSum& closed, const MinkowskiSum& open) {
  std::ostringstream text;
  text << pair << '\n';
  write(text, closed, Format::wkt);
  write(text, open, Format::wkt);
  const boost::uuids::uuid hash =
      boost::uuids::name_generator_sha1(boost::uuids::ns::oid())(text.str());
  SumDigest of_pair;
  for (std::size_t i = 0; i < 16; ++i)
    of_pair.words_[i / 8] |= std::uint64_t{hash.data[i]} << (8 * (i % 8));
  add(of_pair);
}

void SumDigest::add(const SumDigest& other) {
  words_[0] += other.words_[0];
  words_[1] += other.words_[1] + (words_[0] < other.words_[0] ? 1 : 0);
}

std::string SumDigest::to_string() const {
  std::ostringstream out;
  out << std::hex << std::setfill('0') << std::setw(16) << words_[1] << std::setw(16) << words_[0];
  return out.str();
}

}  // namespace oplus
