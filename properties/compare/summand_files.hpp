// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reference/definitions/region.hpp"

namespace oplus {

/// A pair in two files of a folder of its own, all of which goes with it. Their names need no quotes in
/// a shell.
class SummandFiles {
 public:
  /// Throws std::system_error.
  SummandFiles(const Region& p, const Region& q);
  SummandFiles(const SummandFiles&) = delete;
  SummandFiles& operator=(const SummandFiles&) = delete;
  ~SummandFiles();

  std::string p() const { return folder_ + "/p.wkt"; }
  std::string q() const { return folder_ + "/q.wkt"; }

 private:
  std::string folder_;
};

}  // namespace oplus
