// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "properties/experiments/fit.hpp"
#include "properties/experiments/plot.hpp"

namespace oplus {

/// The plots of chapter 6 from a table NAME.csv whose rows are from measured_engines. None where
/// nothing was measured.
struct EnginePlots {
  std::string csv;
  const Table& table;

  /// Times of both engines.
  std::optional<Plot> times(const std::string& name, const std::string& title,
                            const std::string& x_column, const std::string& x_label,
                            const std::optional<Fit>& of_rca,
                            const std::optional<Fit>& of_winding) const;

  /// Peak memory of both, against m.
  std::optional<Plot> memory(const std::string& name, const std::string& title) const;

  /// The stages of one, against m.
  std::optional<Plot> stages(const std::string& name, const std::string& title,
                             const std::string& engine) const;

  /// The ratio of the engines' times, with and without the output, against m.
  std::optional<Plot> ratio(const std::string& name, const std::string& title) const;
};

}  // namespace oplus
