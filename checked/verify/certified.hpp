// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Interval_nt.h>
#include <CGAL/mpq_class.h>

#include "reference/definitions/segment.hpp"

namespace oplus {

/// Certified double intervals. Requires, while one is computed with: a live
/// CGAL::Protect_FPU_rounding<true>.
using CertifiedNumber = CGAL::Interval_nt<false>;

struct CertifiedPoint {
  CertifiedNumber x;
  CertifiedNumber y;
};

struct CertifiedSegment {
  CertifiedPoint source;
  CertifiedPoint target;
};

inline CertifiedNumber certified(const Rational& value) { return {CGAL::to_interval(value)}; }
inline CertifiedPoint certified(const Point& p) { return {certified(p.x), certified(p.y)}; }

inline CertifiedPoint operator+(const CertifiedPoint& a, const CertifiedPoint& b) {
  return {a.x + b.x, a.y + b.y};
}
inline CertifiedPoint operator-(const CertifiedPoint& a, const CertifiedPoint& b) {
  return {a.x - b.x, a.y - b.y};
}

inline CertifiedNumber cross(const CertifiedPoint& u, const CertifiedPoint& v) {
  return u.x * v.y - u.y * v.x;
}

/// Whether a and b certainly cross in inner points of both.
inline bool certainly_cross(const CertifiedSegment& a, const CertifiedSegment& b) {
  const CertifiedPoint u = a.target - a.source;
  const CertifiedNumber s = cross(u, b.source - a.source);
  const CertifiedNumber t = cross(u, b.target - a.source);
  if (!((s.inf() > 0 && t.sup() < 0) || (s.sup() < 0 && t.inf() > 0))) return false;
  const CertifiedPoint v = b.target - b.source;
  const CertifiedNumber p = cross(v, a.source - b.source);
  const CertifiedNumber q = cross(v, a.target - b.source);
  return (p.inf() > 0 && q.sup() < 0) || (p.sup() < 0 && q.inf() > 0);
}

}  // namespace oplus
