// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "checked/layouts/layout.hpp"
#include "checked/operations/affine_map.hpp"
#include "reference/io/input_text.hpp"
#include "reference/io/placed_geometry.hpp"

namespace oplus::layouts {

/// A place in a text that starts at another one; column 0 stays.
inline Position shifted(Position at, const Position& start) {
  if (at.line == 1 && at.column != 0) at.column += start.column - 1;
  at.line += start.line - 1;
  return at;
}

/// Calls `read`; an InvalidInput that it throws names `what`, unless that is empty. Its place is one in a text that
/// starts at `start`.
template <typename Read>
decltype(auto) naming(const std::string& what, const Read& read, const Position& start = {}) {
  try {
    return read();
  } catch (const InvalidInput& error) {
    const Place& here = error.where();
    const Position at = here.line == 0 ? Position{0, 0} : shifted({here.line, here.column}, start);
    throw InvalidInput({here.file, at.line, at.column},
                       (what.empty() ? "" : what + ": ") + error.wrong(), error.expected());
  }
}

/// A layout while it is read: what all formats need.
class Builder {
 public:
  Builder(const InputText& text, std::filesystem::path its_folder, Rational angle_error)
      : input(text), folder(std::move(its_folder)), angle_error_(std::move(angle_error)) {}

  /// A valid region of these chains. Throws InvalidInput.
  Region region(PlacedGeometry geometry);

  /// The rotation by so many degrees, counterclockwise where y points upwards.
  AffineMap rotation(const Rational& degrees);

  /// Places a part on the last sheet: `shape` under a map. Where it is placed more than once, `original` is the same
  /// each time, and for no other shape; else it may be null.
  void place(std::string name, std::size_t line, const void* original, Region shape,
             const AffineMap& map, std::optional<int> least_quality = {});

  /// The layout, with notes.
  Layout finish();

  const InputText& input;
  const std::filesystem::path folder;
  Layout layout{{Sheet{}}, {}};

 private:
  using Turn = std::array<Rational, 4>;

  Rational angle_error_;
  std::size_t turned_chains_ = 0, beyond_the_plane_ = 0, near_rotations_ = 0;
  std::map<Rational, AffineMap> rotations_;
  std::map<std::pair<const void*, Turn>, std::shared_ptr<const Region>> shapes_;
};

// The formats. Each adds to a builder and throws InvalidInput.

void read_polygons(Builder& builder, const std::string& text);
void read_svg(Builder& builder);
class JsonFields;
void read_placements(Builder& builder, const JsonFields& root);
void read_jagua(Builder& builder, const JsonFields& root);
void read_packingsolver(Builder& builder, const JsonFields& root);

}  // namespace oplus::layouts
