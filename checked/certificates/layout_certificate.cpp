// SPDX-License-Identifier: MIT
#include "checked/certificates/layout_certificate.hpp"

#include "checked/certificates/certificate_text.hpp"
#include "checked/certificates/frame_square.hpp"
#include "checked/certificates/unit.hpp"

namespace oplus::certificates {

std::string layout_certificate(const std::optional<Region>& container,
                               const std::vector<Region>& parts) {
  std::vector<const Region*> all;
  if (container) all.push_back(&*container);
  for (const Region& part : parts) all.push_back(&part);
  const Rational size = frame_size(all);
  const Region outside = container ? complement_in_square(2 * size, *container) : Region();
  const Point farthest{size, size};
  CertificateText text("layout");
  text.line("unit", unit(all, ShiftedDoubles(std::span(&farthest, 1))));
  text.line("container");
  text.add_pieces(pieces_of_summand(outside), nullptr);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text.line("part", i);
    text.add_pieces(pieces_of_summand(parts[i]), nullptr);
  }
  return std::move(text).text();
}

}  // namespace oplus::certificates
