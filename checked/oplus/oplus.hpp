// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <optional>
#include <ranges>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "checked/statistics.hpp"
#include "checked/verify/verdict.hpp"
#include "reference/definitions/values.hpp"
#include "reference/io/invalid_input.hpp"

/// @file
/// Exact Minkowski sums of polygons with holes.
///
/// Threads: any function may be called on any thread at any time; objects that are not changed may
/// be shared between threads. Nothing here writes to a stream or keeps state between calls.
///
/// Exceptions: bad input throws InvalidInput, whose what() is one line; nothing else does, but for
/// std::bad_alloc and what a function names. After an exception all arguments are as before.
///
/// Cost is given for n and m vertices of the two regions, in operations on coordinates.
namespace oplus {

/// A coordinate as input: any integer, floating-point number, rational or text, taken for exactly
/// what it is. 0.1 is the double next to one tenth; "0.1" is one tenth, and "1/3" a third.
class Number {
 public:
  /// Throws InvalidInput for an infinity and for what is not a number.
  template <std::floating_point T>
  requires(sizeof(T) <= sizeof(double)) Number(T value) : Number(from_double(value)) {}

  /// Signed or unsigned, of at most 64 bits.
  template <std::integral T>
  Number(T value) : Number(from_integer(value < 0, static_cast<std::uint64_t>(value))) {
    static_assert(sizeof(T) <= sizeof(std::uint64_t));
  }

  /// Whatever GMP's mpq_class can be made from: itself, mpz_class, and what they are computed with.
  /// Brought into lowest terms. Throws InvalidInput where the denominator is zero.
  template <typename T>
  requires(!std::is_arithmetic_v<T> && std::convertible_to<T, Rational>) Number(const T& value)
      : Number(from_rational(value)) {}

  /// An integer, a decimal, with or without an exponent, or a fraction. Throws InvalidInput.
  Number(const char* text) : Number(from_text(text)) {}
  Number(std::nullptr_t) = delete;
  Number(std::string_view text) : Number(from_text(text)) {}    ///< The same.
  Number(const std::string& text) : Number(from_text(text)) {}  ///< The same.

  const Rational& value() const { return value_; }  ///< Returns the number, in lowest terms.

 private:
  struct Exact {
    Rational value;
  };

  explicit Number(Exact exact) : value_(std::move(exact.value)) {}
  static Exact from_double(double value);
  static Exact from_integer(bool is_negative, std::uint64_t bits);
  static Exact from_rational(Rational value);
  static Exact from_text(std::string_view text);

  Rational value_;
};

/// A point as input: {x, y}, or whatever has two coordinates: members x and y, or two elements such
/// as those of std::array and std::pair.
class Coordinates {
 public:
  /// The point {x, y}.
  Coordinates(const Number& x, const Number& y) : point_{x.value(), y.value()} {}

  /// A point with members x and y.
  template <typename T>
  requires requires(const T& p) {
    { p.x } -> std::convertible_to<Number>;
    { p.y } -> std::convertible_to<Number>;
  }
  Coordinates(const T& p) : Coordinates(Number(p.x), Number(p.y)) {}

  /// A point with two elements.
  template <typename T>
  requires(std::tuple_size<T>::value == 2) Coordinates(const T& p)
      : Coordinates(Number(std::get<0>(p)), Number(std::get<1>(p))) {}

  const Point& point() const { return point_; }  ///< Returns the point, exactly.

 private:
  Point point_;
};

/// A region that was found valid: simple chains, outer ones counterclockwise, holes clockwise, that
/// may touch each other in points, but neither cross nor overlap; each hole in its outer chain.
/// Whatever computes takes one of these, so input is checked once, whether from a file or from code.
class ValidRegion {
 public:
  /// The empty set.
  ValidRegion() = default;

  /// Chains may be turned either way; the first vertex stays the first. Cost: n log n, but n² where
  /// very many edges overlap in x. Throws InvalidInput, which names chains, edges and vertices,
  /// counted from one.
  explicit ValidRegion(Region region);

  /// Returns the components, in the order of the input.
  const std::vector<Component>& components() const& { return region_.components; }
  std::vector<Component> components() && { return std::move(region_.components); }  ///< The same.

  const Region& region() const& { return region_; }  ///< Returns the same as a plain value.
  Region region() && { return std::move(region_); }  ///< The same.

  friend bool operator==(const ValidRegion&, const ValidRegion&) = default;

 private:
  friend class Sum;
  friend ValidRegion read_wkt(const std::string& text);
  friend ValidRegion read_geojson(const std::string& text);
  friend ValidRegion read_file(const std::string& path);
  friend ValidRegion operator-(const ValidRegion& region);
  friend ValidRegion polygon(const std::vector<Coordinates>& outer,
                             const std::vector<std::vector<Coordinates>>& holes);
  static ValidRegion found_valid(Region region);
  static ValidRegion checked(Region region);  ///< Requires: in lowest terms.

  Region region_;
};

/// Returns the polygon with these vertices and holes. The closing vertex must not be repeated.
/// Throws as ValidRegion's constructor does.
///
/// Example: polygon({{0, 0}, {1, 0}, {0.5, "1/3"}}).
ValidRegion polygon(const std::vector<Coordinates>& outer,
                    const std::vector<std::vector<Coordinates>>& holes = {});

/// The same of a range of points of any type that Coordinates takes.
template <std::ranges::input_range Range>
requires std::convertible_to<std::ranges::range_reference_t<const Range&>, Coordinates> ValidRegion
polygon(const Range& outer) {
  return polygon(std::vector<Coordinates>(std::ranges::begin(outer), std::ranges::end(outer)));
}

/// Reads POLYGON, MULTIPOLYGON or EMPTY. Coordinates are decimals or fractions p/q, taken exactly.
/// Throws InvalidInput with line and column, also where the region is not valid.
ValidRegion read_wkt(const std::string& text);

/// Reads a GeoJSON Polygon or MultiPolygon. Throws as read_wkt does.
ValidRegion read_geojson(const std::string& text);

/// Reads WKT, GeoJSON or .dat (README, Files), told apart by the first character; "-" is standard
/// input. Throws as read_wkt does, and where the file cannot be read.
ValidRegion read_file(const std::string& path);

/// Returns -R, turned by π about the origin. The robot R at x meets an obstacle P iff x is in P ⊕ -R.
/// Cost: n.
ValidRegion operator-(const ValidRegion& region);

struct Engine;

/// How to compute a sum. The sum depends on `boundary` only.
struct SumOptions {
  Boundary boundary = Boundary::closed;  ///< DEFAULT: the regularized sum of the closed regions
  const Engine* engine = nullptr;        ///< DEFAULT: slide. Others: <oplus/engines.hpp>
  unsigned threads = 1;                  ///< 0: as many as there are cores
  bool with_origins = false;             ///< whether the result has origins()
};

/// A Minkowski sum, exact. Copies share what they hold, which never changes. References into it are
/// valid as long as one of them exists. A sum without a name returns copies instead, so that a loop
/// over minkowski_sum(p, q).components() is right too.
class Sum {
 public:
  /// The empty sum.
  Sum() : Sum(MinkowskiSum{}, Boundary::closed, {}, {}) {}

  Boundary boundary() const;  ///< Returns what was asked for: closed or open.

  /// Returns the regularized sum: simple outer chains, each with the holes in it. Computed when first
  /// asked for, once, on whichever thread asks.
  const std::vector<Component>& components() const&;
  std::vector<Component> components() && {
    return std::as_const(*this).components();
  }  ///< The same.

  /// Returns the same as a region, to be summed again.
  const ValidRegion& region() const&;
  ValidRegion region() && { return std::as_const(*this).region(); }  ///< The same.

  /// Returns where one summand just fits into the other and can be moved: edges of an open sum's
  /// complement that bound no face of it. None for Boundary::closed.
  const std::vector<Segment>& dangling_edges() const&;
  std::vector<Segment> dangling_edges() && {
    return std::as_const(*this).dangling_edges();
  }  ///< The same.

  /// Returns where one summand just fits into the other and cannot be moved: points of an open sum's
  /// complement that bound no face or edge of it. None for Boundary::closed.
  const std::vector<Point>& isolated_vertices() const&;
  std::vector<Point> isolated_vertices() && {
    return std::as_const(*this).isolated_vertices();
  }  ///< The same.

  /// Returns all of it in canonical form, chains cut at no touching point.
  const MinkowskiSum& value() const&;
  MinkowskiSum value() && { return std::as_const(*this).value(); }  ///< The same.

  /// Returns for each edge of value() where it came from. Empty unless asked for.
  const Origins& origins() const&;
  Origins origins() && { return std::as_const(*this).origins(); }  ///< The same.

  /// Returns what it took: counts and times, which differ from engine to engine.
  const Statistics& statistics() const&;
  Statistics statistics() && { return std::as_const(*this).statistics(); }  ///< The same.

  /// Whether two sums are the same set. Cost: their size.
  friend bool operator==(const Sum& a, const Sum& b) { return a.value() == b.value(); }

 private:
  friend Sum minkowski_sum(const ValidRegion& p, const ValidRegion& q, const SumOptions& options);
  Sum(MinkowskiSum value, Boundary boundary, Origins origins, Statistics statistics);

  struct State;
  std::shared_ptr<const State> state_;
};

/// Returns P ⊕ Q, all p + q (docs/slide.md). Cost: that of the reduced convolution, at most nm
/// segments, times about log(n + m) for each that is looked at; memory grows with the convolution
/// and the result. Throws nothing for valid regions but std::bad_alloc.
Sum minkowski_sum(const ValidRegion& p, const ValidRegion& q, const SumOptions& options = {});

/// Returns the area, holes not counted. Cost: the size.
Rational area(const ValidRegion& region);

/// Returns the same of a sum.
Rational area(const Sum& sum);

/// Returns whether a point is inside, outside, or on the boundary. Cost: the size.
Location locate(const Coordinates& point, const ValidRegion& region);

/// Returns the same of a sum. An open sum's dangling edges and isolated vertices belong to its
/// boundary.
Location locate(const Coordinates& point, const Sum& sum);

/// Whether a point belongs to the region; its boundary does. Cost: the size.
bool contains(const ValidRegion& region, const Coordinates& point);

/// Whether a point belongs to the sum; its boundary does iff the sum is closed. Cost: the size.
bool contains(const Sum& sum, const Coordinates& point);

/// Decides whether a sum from anywhere is P ⊕ Q, by the definitions and by no engine
/// (docs/verify.md). Returns reasons with a point each, or none. Nothing is required of the given
/// sum but denominators that are not zero: else throws InvalidInput. Cost: at least that of all
/// convolution segments against each other near by.
Verdict verify(const ValidRegion& p, const ValidRegion& q, const GivenSum& given,
               Boundary boundary = Boundary::closed);

/// The same of a sum from here, with its own boundary().
Verdict verify(const ValidRegion& p, const ValidRegion& q, const Sum& sum);

/// Returns the region as WKT, without the end of the line. Exactly: decimals where they end, fractions
/// p/q elsewhere, which few other readers take. With `digits`, rounded to that many decimals, half away
/// from zero: it may then be invalid. Cost: the size. Throws std::invalid_argument unless
/// 0 <= digits <= 4096.
std::string to_wkt(const ValidRegion& region, std::optional<int> digits = std::nullopt);

/// Returns the same of a sum's region(), in a GEOMETRYCOLLECTION with its dangling edges as line
/// strings and its isolated vertices as points, where it has such.
std::string to_wkt(const Sum& sum, std::optional<int> digits = std::nullopt);

/// Returns the region as a GeoJSON geometry, as to_wkt does. Fractions p/q are strings, which is
/// GeoJSON to no other reader.
std::string to_geojson(const ValidRegion& region, std::optional<int> digits = std::nullopt);

/// Returns the same of a sum, as to_wkt does.
std::string to_geojson(const Sum& sum, std::optional<int> digits = std::nullopt);

/// Returns the double nearest to a number, ties to even; an infinity beyond the largest.
double to_double(const Rational& value);

/// Returns {x, y}, each as above.
std::array<double, 2> to_double(const Point& point);

}  // namespace oplus
