// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "properties/runner/temporary_folder.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

/// A pair in two files of a folder of its own, all of which goes with it. Their names need no quotes in
/// a shell.
class SummandFiles {
 public:
  /// Throws std::system_error.
  SummandFiles(const Region& p, const Region& q);

  std::string p() const { return folder_.path() / "p.wkt"; }
  std::string q() const { return folder_.path() / "q.wkt"; }

 private:
  TemporaryFolder folder_;
};

}  // namespace oplus
