// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

// For bindings, which include <oplus/oplus.hpp>: nothing of ours is included here, since that has it too.

namespace oplus {

class ValidRegion;
class ValidSet;
struct SumOptions;

/// The name of an operation, and a line of help that follows "Compute" or "Returns".
struct NamedOperation {
  std::string name;
  std::string what;
};

/// Those of the table (checked/operations/operations.hpp): nfp, ifp, erode, open, close.
std::vector<NamedOperation> named_operations();

/// Computes one of them. The options' boundary does not count. Throws std::invalid_argument for another name.
ValidSet value_of(const std::string& operation, const ValidRegion& p, const ValidRegion& q,
                  const SumOptions& options);

}  // namespace oplus
