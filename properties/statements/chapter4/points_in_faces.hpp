// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/definitions/segment.hpp"

namespace oplus {

/// Returns a point in every face of the segments' arrangement, one for each connected part of the
/// face's boundary. None is on a segment, nor on one of `avoided`.
std::vector<Point> points_in_faces(const std::vector<Segment>& segments,
                                   const std::vector<Segment>& avoided);

}  // namespace oplus
