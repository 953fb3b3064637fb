// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
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

#include "checked/distance/nearest_points.hpp"
#include "checked/operations/affine_map.hpp"
#include "checked/operations/disc_side.hpp"
#include "checked/oplus/version.hpp"
#include "checked/repair/mend.hpp"
#include "checked/rounding/side.hpp"
#include "checked/statistics.hpp"
#include "checked/verify/verdict.hpp"
#include "reference/definitions/values.hpp"
#include "reference/io/invalid_input.hpp"
#include "reference/io/overlaps.hpp"

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

struct Repaired;

/// A region that was found valid: simple chains, outer ones counterclockwise, holes clockwise, that
/// may touch each other in points, but neither cross nor overlap; each hole in its outer chain.
/// One from complement() or a .dat file may be unbounded: the outer chain of one component is then empty, and
/// the component is the plane without its holes. Whatever computes takes one of these, so input is checked
/// once, whether from a file or from code.
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

  /// Whether two are the same set, whatever the order of chains and their first vertices. Cost: n log n.
  friend bool operator==(const ValidRegion& a, const ValidRegion& b);

 private:
  friend class ValidSet;
  friend ValidRegion read_wkt(const std::string& text, Overlaps overlaps);
  friend ValidRegion read_geojson(const std::string& text, Overlaps overlaps);
  friend ValidRegion read_text(const std::string& text, Overlaps overlaps);
  friend ValidRegion read_file(const std::string& path, Overlaps overlaps);
  friend Repaired repaired(Region region, std::optional<FillRule> fill);
  friend Repaired repaired_text(const std::string& text, std::optional<FillRule> fill);
  friend Repaired repaired_file(const std::string& path, std::optional<FillRule> fill);
  friend ValidRegion operator-(const ValidRegion& region);
  friend ValidRegion transformed(const ValidRegion& region, const AffineMap& map);
  friend ValidRegion disc(const Number& radius, DiscSide side, const Number& error);
  friend ValidRegion complement(const ValidRegion& region);
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

/// Reads POLYGON, MULTIPOLYGON, a GEOMETRYCOLLECTION of these or EMPTY; several of them, one a line, are
/// one region; `SRID=4326;` may stand before each. Of vertices with Z or M, x and y are read. Coordinates
/// are decimals or fractions p/q, taken exactly. Throws InvalidInput with line and column, also where the
/// region is not valid; with Overlaps::allowed each component by itself must be, and the result is the
/// union of all. Cost: n log n; of a union, (n + k) log n for k pairs of edges that meet.
ValidRegion read_wkt(const std::string& text, Overlaps overlaps = Overlaps::refused);

/// Reads a GeoJSON Polygon, MultiPolygon, GeometryCollection of these, Feature or FeatureCollection; or
/// coordinates alone: [[x, y], ...], an array of these (the outer chain and holes), or an array of such
/// arrays. Throws as read_wkt does.
ValidRegion read_geojson(const std::string& text, Overlaps overlaps = Overlaps::refused);

/// Reads any of the formats of docs/files.md, told apart by what the text starts with: these, WKB, .dat, and
/// SVG path data (M, L, H, V, Z). Throws as read_wkt does.
ValidRegion read_text(const std::string& text, Overlaps overlaps = Overlaps::refused);

/// The same of a file; "-" is standard input. Throws also where the file cannot be read.
ValidRegion read_file(const std::string& path, Overlaps overlaps = Overlaps::refused);

/// A region, and what was done to make it valid.
struct Repaired {
  ValidRegion region;       ///< the valid one
  std::vector<Mend> mends;  ///< none: it was valid, and its chains turned the right way
};

/// Leaves out repeated vertices, the tips of spikes, and chains that enclose nothing; makes outer chains of
/// holes that are outside all, and the like; turns chains; says each of these. A region whose chains still
/// cross or overlap becomes what they enclose by `fill` (docs/files.md); without it, throws InvalidInput.
/// Cost: n log n; with `fill`, (n + k) log n for k pairs of edges that meet.
Repaired repaired(Region region, std::optional<FillRule> fill = std::nullopt);

/// The same of a text in any format that read_text reads, whose rings may be open. Throws also where the
/// syntax is wrong.
Repaired repaired_text(const std::string& text, std::optional<FillRule> fill = std::nullopt);

/// The same of a file; "-" is standard input. Throws also where the file cannot be read.
Repaired repaired_file(const std::string& path, std::optional<FillRule> fill = std::nullopt);

/// Returns -R, turned by π about the origin. The robot R at x meets an obstacle P iff x is in P ⊕ -R.
/// Cost: n.
ValidRegion operator-(const ValidRegion& region);

class ValidSet;
struct SumOptions;

/// A region that is summed with many others: what the engine slide computes of one region alone, integers
/// and trees of boxes, is computed for the first sum and kept. It is kept anew for each common denominator
/// with another region, up to eight times. Copies share it, also on several threads. Cost: that of the sums
/// without preparing this region, and as much memory as one of them.
///
/// Example: PreparedRegion bin(read_file("bin.wkt")); then minkowski_sum(bin, -part) for each part.
class PreparedRegion {
 public:
  PreparedRegion(ValidRegion region);  ///< Prepares nothing yet.

  const ValidRegion& region() const;  ///< Returns the region.

 private:
  friend ValidSet minkowski_sum(const PreparedRegion& p, const PreparedRegion& q,
                                const SumOptions& options);
  struct State;
  std::shared_ptr<const State> state_;
};

struct Engine;
struct Rounded;

/// How to compute a sum. The sum depends on `boundary` only.
struct SumOptions {
  Boundary boundary = Boundary::closed;  ///< DEFAULT: the regularized sum of the closed regions
  const Engine* engine = nullptr;        ///< DEFAULT: slide. Others: <oplus/engines.hpp>
  unsigned threads = 1;                  ///< 0: as many as there are cores
  bool with_origins = false;             ///< whether the result has origins()

  /// Called now and then while segments are searched, on any of the threads: how many are done. What it throws
  /// ends the computation, and is thrown by it. DEFAULT: nobody is told.
  std::function<void(std::size_t done, std::size_t total)> progress = {};
};

/// A set in the plane: a region, dangling edges and isolated vertices together; bounded or not; closed, when these
/// belong to it, or open, when they belong to its complement. What is read, summed, returned and written: whatever
/// is made here was found valid, or computed, and is in canonical form. Copies share what they hold, which never
/// changes. References into it are valid as long as one of them exists. A set without a name returns copies
/// instead, so that a loop over minkowski_sum(p, q).components() is right too.
class ValidSet {
 public:
  /// The empty set, closed.
  ValidSet() : ValidSet(PlanarSet{}, Boundary::closed, {}, {}) {}

  ValidSet(const ValidRegion& region);  ///< The region, closed. Cost: n log n.

  /// The union of a region, of polylines and of points, closed. A polyline is the segments between its vertices,
  /// which may repeat each other; one of a single vertex is a point, one without any is empty. Cost: n log n,
  /// and the number of crossings.
  ///
  /// Example: ValidSet({}, {{{0, 0}, {4, 0}, {4, 3}}}) is one polyline of two segments.
  ValidSet(const ValidRegion& region, const std::vector<std::vector<Coordinates>>& polylines,
           const std::vector<Coordinates>& points = {});

  Boundary boundary() const;  ///< Returns whether it is closed or open.

  /// Returns the regularized set: simple outer chains, each with the holes in it. Computed when first
  /// asked for, once, on whichever thread asks.
  const std::vector<Component>& components() const&;
  std::vector<Component> components() && {
    return std::as_const(*this).components();
  }  ///< The same.

  /// Returns the same as a region, to be summed again.
  const ValidRegion& region() const&;
  ValidRegion region() && { return std::as_const(*this).region(); }  ///< The same.

  /// Returns the segments that bound no face of its complement. Of an open sum: where one summand just fits into
  /// the other and can be moved. Of a closed set: its segments outside its region, such as those of polylines.
  const std::vector<Segment>& dangling_edges() const&;
  std::vector<Segment> dangling_edges() && {
    return std::as_const(*this).dangling_edges();
  }  ///< The same.

  /// Returns the points that bound no face or segment. Of an open sum: where one summand just fits into the other
  /// and cannot be moved. Of a closed set: its points outside its region and segments.
  const std::vector<Point>& isolated_vertices() const&;
  std::vector<Point> isolated_vertices() && {
    return std::as_const(*this).isolated_vertices();
  }  ///< The same.

  /// Returns all of it in canonical form, chains cut at no touching point.
  const PlanarSet& value() const&;
  PlanarSet value() && { return std::as_const(*this).value(); }  ///< The same.

  /// Returns for each edge of value() where it came from. Empty unless a sum was asked for with them.
  const Origins& origins() const&;
  Origins origins() && { return std::as_const(*this).origins(); }  ///< The same.

  /// Returns what a sum took: counts and times, which differ from engine to engine.
  const Statistics& statistics() const&;
  Statistics statistics() && { return std::as_const(*this).statistics(); }  ///< The same.

  /// Whether the points inside, the edges and the vertices are the same, so also of an open set and a closed one
  /// without edges and vertices of their own. Cost: their size.
  friend bool operator==(const ValidSet& a, const ValidSet& b) { return a.value() == b.value(); }

 private:
  friend ValidSet set_of(PlanarSet value, Boundary boundary, Origins origins,
                         Statistics statistics);
  friend Rounded rounded(const ValidSet& sum, const Number& step, Side side);
  friend Rounded rounded(const ValidRegion& region, const Number& step, Side side);
  static Rounded rounded_value(const PlanarSet& value, Boundary boundary, const Number& step,
                               Side side);
  ValidSet(PlanarSet value, Boundary boundary, Origins origins, Statistics statistics);

  struct State;
  std::shared_ptr<const State> state_;
};

/// Returns P ⊕ Q, all p + q (docs/slide.md). Cost: that of the reduced convolution, at most nm
/// segments, times about log(n + m) for each that is looked at; memory grows with the convolution
/// and the result. Throws nothing for valid regions but std::bad_alloc; InvalidInput for origins of the sum
/// of an unbounded one.
ValidSet minkowski_sum(const ValidRegion& p, const ValidRegion& q, const SumOptions& options = {});

/// The same of summands of many sums; either may be a ValidRegion. The result is the same, too.
ValidSet minkowski_sum(const PreparedRegion& p, const PreparedRegion& q,
                       const SumOptions& options = {});

/// Returns the same of sets (docs/polylines.md). Boundary::closed: all p + q, with dangling edges and
/// isolated vertices of its own. Boundary::open: P ⊕ int Q and int P ⊕ Q together, an open set; it is empty
/// where neither has inner points. Without origins. An open set counts as its region; throws InvalidInput where
/// it has dangling edges or isolated vertices. Cost: for sets with segments, that of an arrangement of at
/// most nm edges, less where they follow each other.
///
/// Example: minkowski_sum(ValidSet({}, {path}), tool) is what the tool covers on its path.
ValidSet minkowski_sum(const ValidSet& p, const ValidSet& q, const SumOptions& options = {});

/// Reads what read_text reads but SVG path data, and also points, line strings, and collections of them with
/// polygons, as a closed set. Throws as read_wkt does.
ValidSet read_set(const std::string& text);

/// The same of a file; "-" is standard input. Throws also where it cannot be read.
ValidSet read_set_file(const std::string& path);

/// Returns the set turned by π about the origin. Cost: the size times its logarithm.
ValidSet operator-(const ValidSet& set);

// Operations (docs/operations.md). Cost: that of the sums they are made of. They take all options but
// `boundary` and `with_origins`. Either region may be unbounded.

/// Returns the open set of all x where Q + x overlaps P, the no-fit polygon, P ⊕ -Q. On its boundary, with
/// dangling edges and isolated vertices, the two only touch.
ValidSet nfp(const ValidRegion& p, const ValidRegion& q, const SumOptions& options = {});

/// Returns the closed set of all x where Q + x is inside P, the inner-fit polygon. Where Q fits exactly,
/// dangling_edges() and isolated_vertices() are parts of it that belong to no component.
ValidSet ifp(const ValidRegion& p, const ValidRegion& q, const SumOptions& options = {});

/// Returns the erosion of P by Q: ifp without edges and points.
ValidSet erosion(const ValidRegion& p, const ValidRegion& q, const SumOptions& options = {});

/// Returns the union of all Q + x inside P.
ValidSet opening(const ValidRegion& p, const ValidRegion& q, const SumOptions& options = {});

/// Returns the erosion by Q of the closed sum of P and Q, which contains P.
ValidSet closing(const ValidRegion& p, const ValidRegion& q, const SumOptions& options = {});

/// Returns the closure of the complement. Cost: n log n.
ValidRegion complement(const ValidRegion& region);

/// Returns the complement, of an open set a closed one, and the reverse: with the same dangling edges and
/// isolated vertices. Cost: n log n.
ValidSet complement(const ValidSet& set);

// Transformations (docs/transform.md). Coordinates stay exact. Maps are combined by *, the right one first.

/// Returns the map that moves each point by a vector.
AffineMap translation(const Coordinates& by);

/// Returns the map that multiplies each x and each y by a factor, which may be negative: scaling(1, -1) is
/// the reflection in the x-axis. Throws InvalidInput if one is zero.
AffineMap scaling(const Number& of_x, const Number& of_y);
AffineMap scaling(const Number& of_both);  ///< The same with one factor.

/// Returns a rotation about the origin, counterclockwise, by an angle that differs from `degrees` by at most
/// `error`: by a multiple of 90 exactly, else by the one whose sine and cosine, members c and a of the map,
/// have the smallest denominator. Cost: as that of numbers with as many bits as the error has, and 64 more.
/// Throws InvalidInput unless the error is positive.
AffineMap rotation(const Number& degrees, const Number& error = Rational(1, 1000));

/// Returns the rotation about the origin with this cosine and sine: that takes (1, 0) to a point of the unit
/// circle, such as {"3/5", "4/5"}. Throws InvalidInput if the squares don't add up to 1.
AffineMap rotation_to(const Coordinates& cosine_and_sine);

/// Returns the image of a region. Each chain keeps its first vertex, and the interior is to the left of each
/// edge. Cost: n. Throws InvalidInput if the map's determinant is zero.
ValidRegion transformed(const ValidRegion& region, const AffineMap& map);

/// Returns the image of a sum or another set; without origins. Cost: n log n. Throws likewise.
ValidSet transformed(const ValidSet& set, const AffineMap& map);

/// Returns a convex polygon inside or around the disc about the origin, each point of the larger one of the
/// two at most `error` away from the smaller one, which is decided exactly (docs/discs.md). It has at most a
/// tenth more vertices than necessary, and up to 8; that is about π / √(2 error / radius). Coordinates are
/// multiples of 1, 2 or 5 times a power of ten, so they are short decimals.
///
/// Offsets: p ⊕ disc contains only points at most `radius` away from p, with DiscSide::inside, and all of
/// them with DiscSide::outside.
///
/// Cost: about twenty times the number of vertices. Throws InvalidInput unless both numbers are positive,
/// and where a million vertices are too few.
ValidRegion disc(const Number& radius, DiscSide side, const Number& error);

/// Whether all points far enough away belong to the region.
bool is_unbounded(const ValidRegion& region);

/// Returns the area, holes not counted; of an unbounded region, minus that of its complement. Cost: the size.
Rational area(const ValidRegion& region);

/// Returns the same of a sum.
Rational area(const ValidSet& sum);

/// Returns whether a point is inside, outside, or on the boundary. Cost: the size.
Location locate(const Coordinates& point, const ValidRegion& region);

/// Returns the same of a sum. An open sum's dangling edges and isolated vertices belong to its
/// boundary.
Location locate(const Coordinates& point, const ValidSet& sum);

/// Whether a point belongs to the region; its boundary does. Cost: the size.
bool contains(const ValidRegion& region, const Coordinates& point);

/// Whether a point belongs to the sum; its boundary does iff the sum is closed. Cost: the size.
bool contains(const ValidSet& sum, const Coordinates& point);

// Distances (docs/distance.md). Either region may be unbounded. All is exact.

/// Returns the squared distance of two regions, and a pair of points that are as near as that. Throws
/// InvalidInput where one of them is empty. Cost: n log n + m log m, by experience; nm at worst.
NearestPoints distance(const ValidRegion& p, const ValidRegion& q);

/// Returns a shortest move of Q after which it overlaps P no longer, exact fits included; none where it does not
/// overlap P. Throws InvalidInput where it overlaps P wherever it is. Cost: at most that of nfp(p, q).
std::optional<Overlap> depth(const ValidRegion& p, const ValidRegion& q);

/// A pair of regions for many places of Q: their no-fit polygon is computed once. Copies share it. Q + x is Q moved
/// by x. Cost, for k edges of the no-fit polygon: k log k, and as much memory, beside that of nfp(p, q).
///
/// Example: Placements at(bin, part); then at.locate({x, y}) == Location::inside says that they overlap.
class Placements {
 public:
  /// Options as for nfp. Throws InvalidInput where one of the regions is empty.
  Placements(const ValidRegion& p, const ValidRegion& q, const SumOptions& options = {});

  const ValidSet& no_fit() const;  ///< Returns nfp(p, q).

  /// Returns inside where Q + x overlaps P, boundary where the two only touch, outside where they are apart.
  /// Cost: log k.
  Location locate(const Coordinates& x) const;

  /// Returns depth of P and Q + x. Cost: log k, by experience.
  std::optional<Overlap> depth(const Coordinates& x) const;

  /// Returns distance of P and Q + x. Cost: log k, by experience; where they overlap, that of distance.
  NearestPoints distance(const Coordinates& x) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

/// Decides whether a sum from anywhere is P ⊕ Q, by the definitions and by no engine
/// (docs/verify.md). Returns reasons with a point each, or none. Nothing is required of the given
/// sum but denominators that are not zero: else throws InvalidInput; likewise where P or Q is unbounded.
/// Cost: at least that of all convolution segments against each other near by.
Verdict verify(const ValidRegion& p, const ValidRegion& q, const ClaimedSum& given,
               Boundary boundary = Boundary::closed);

/// Reads what is claimed to be a sum from WKT, GeoJSON or .dat, chains as they are: only the syntax is checked.
/// Throws as read_wkt does.
ClaimedSum read_claimed_sum(const std::string& text);

/// The same of a sum from here, with its own boundary().
Verdict verify(const ValidRegion& p, const ValidRegion& q, const ValidSet& sum);

/// Returns the text of a certificate that a given set is the sum of P and Q, closed or open, which the program
/// oplus-certified checks (docs/certificates.md). Its vertices are numbered in the order of the regions, so the
/// three are to be written with their chains and vertices in this order, as to_wkt does. Throws InvalidInput,
/// with the first reason of verify, where it is not the sum; where a vertex of it equals the next one;
/// and as verify does. Cost: that of verify, and of cutting all three into convex pieces.
///
/// Example: certify(p, q, {sum.region().region(), {}, {}}).
std::string certify(const ValidRegion& p, const ValidRegion& q, const ClaimedSum& given,
                    Boundary boundary = Boundary::closed);

/// What rounding returns.
struct Rounded {
  ValidSet sum;             ///< the set on the grid; of a region, a closed sum
  TopologyChanges changes;  ///< what happened to components and holes
  bool is_exact;            ///< whether nothing had to be rounded
  Rational
      bound;  ///< how far boundaries are from each other at most, in x and in y; √2 times that in distance
};

/// Rounds a sum to the points (i step, j step), i and j integers (docs/rounding.md): a valid set, each of whose points in
/// which it differs from the sum is at most `bound` from the sum's boundary, and so is its own boundary. With
/// Side::contain it contains the sum, with Side::contained it is contained in it. A sum on the grid is returned as
/// it is. Cost: near-linear in the size, by experience; for the sides other than nearest that of a sum with a square. Throws
/// InvalidInput unless step > 0.
///
/// Example: to_wkt(rounded(sum, "0.01").sum), which all programs read.
Rounded rounded(const ValidSet& sum, const Number& step, Side side = Side::nearest);

/// The same of a region.
Rounded rounded(const ValidRegion& region, const Number& step, Side side = Side::nearest);

/// Returns the region as WKT, without the end of the line. Exactly: decimals where they end, fractions
/// p/q elsewhere, which few other readers take. With `digits`, rounded(region, 10^-digits) instead. Cost: the
/// size, or that of rounding. Throws std::invalid_argument unless 0 <= digits <= 4096, and where the
/// region is unbounded.
std::string to_wkt(const ValidRegion& region, std::optional<int> digits = std::nullopt);

/// Returns the same of a sum's region(), in a GEOMETRYCOLLECTION with its dangling edges as line
/// strings and its isolated vertices as points, where it has such.
std::string to_wkt(const ValidSet& sum, std::optional<int> digits = std::nullopt);

/// Returns the region as a GeoJSON geometry, as to_wkt does. Fractions p/q are strings, which is
/// GeoJSON to no other reader.
std::string to_geojson(const ValidRegion& region, std::optional<int> digits = std::nullopt);

/// Returns the same of a sum, as to_wkt does.
std::string to_geojson(const ValidSet& sum, std::optional<int> digits = std::nullopt);

/// Returns the region as WKB, in hexadecimal digits, as PostGIS writes it and GEOS reads it. Throws
/// InvalidInput where a coordinate is not exactly a double: rounded(region, 0x1p-20) has such. Cost: the size.
std::string to_wkb(const ValidRegion& region);

/// Returns the same of a sum, as to_wkt does.
std::string to_wkb(const ValidSet& sum);

/// Returns the region as .dat (docs/files.md), which holds unbounded regions, too. Exact.
std::string to_dat(const ValidRegion& region);

/// Returns the same of a set. Throws std::invalid_argument where it has dangling edges or isolated vertices.
std::string to_dat(const ValidSet& set);

/// Returns the double nearest to a number, ties to even; an infinity beyond the largest.
double to_double(const Rational& value);

/// Returns {x, y}, each as above.
std::array<double, 2> to_double(const Point& point);

}  // namespace oplus
