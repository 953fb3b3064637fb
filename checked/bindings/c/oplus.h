// SPDX-License-Identifier: MIT
#ifndef OPLUS_H
#define OPLUS_H

/// @file
/// Exact Minkowski sums of polygons with holes, for C (C99) and for what calls C: docs/c.md.
///
/// Sets are handles. All functions compute exactly, and none changes a set that it is given. What a function
/// returns through a pointer is made by it: a set is freed by oplus_free, a text by oplus_free_text, each once.
///
/// Errors: functions that can fail return a code. Unless it is OPLUS_OK, nothing is put through pointers, and
/// oplus_message says in a line what is wrong. NULL is an error wherever it is not said to be allowed. No exception
/// of C++ leaves a function. Where GMP, by which all is computed, finds no memory, it ends the program.
///
/// Threads: any function may be called on any thread at any time, also with a set that other threads use; only
/// oplus_free must be the last that is called with a set. A message is that of the calling thread.
///
/// Numbers as text are integers, decimals or fractions "p/q", taken exactly. Doubles are taken for exactly what
/// they are: 0.1 is not one tenth, "0.1" is. Texts are UTF-8 and end with a zero.

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define OPLUS_PUBLIC __attribute__((visibility("default")))
#else
#define OPLUS_PUBLIC  ///< What the library exports.
#endif

typedef struct oplus_set
    oplus_set;  ///< A set in the plane: a region, segments and points together.

/// What functions return. The values stay.
typedef enum oplus_code {
  OPLUS_OK = 0,             ///< all is well
  OPLUS_INVALID_INPUT = 1,  ///< what was given is wrong: the message says what
  OPLUS_NO_MEMORY = 2,      ///< there is too little memory
  OPLUS_FAILED = 3          ///< anything else: a fault of oplus
} oplus_code;

/// Kinds of boundary. An open sum, that of interiors, keeps in which places one summand just fits.
enum { OPLUS_CLOSED = 0, OPLUS_OPEN = 1 };

/// What a chain of vertices is. Holes are those of the outer chain before them. An outer chain without vertices is
/// that of an unbounded component. Lines are polylines, of a result segments; they and points are what bounds no face.
enum { OPLUS_OUTER = 0, OPLUS_HOLE = 1, OPLUS_LINE = 2, OPLUS_POINT = 3 };

/// Which set on a grid, or which polygon for a disc: of rounding and of discs.
enum { OPLUS_NEAREST = 0, OPLUS_CONTAIN = 1, OPLUS_CONTAINED = 2 };

/// Where a point is.
enum { OPLUS_OUTSIDE = 0, OPLUS_ON_BOUNDARY = 1, OPLUS_INSIDE = 2 };

OPLUS_PUBLIC const char* oplus_version(void);  ///< Returns "1.0.0" or what is linked.

/// Returns what was wrong in the last call on this thread that failed, in a line; "" before. It is valid until the
/// next such call on this thread.
OPLUS_PUBLIC const char* oplus_message(void);

OPLUS_PUBLIC void oplus_free(oplus_set* set);   ///< Frees a set. NULL is allowed.
OPLUS_PUBLIC void oplus_free_text(char* text);  ///< Frees a text. NULL is allowed.

// Sets from elsewhere.

/// Reads a region: WKT, GeoJSON, arrays of coordinates, WKB in hexadecimal digits, .dat, or SVG path data, told apart
/// by how the text starts (docs/files.md). Chains may be turned either way, and may neither cross nor overlap.
OPLUS_PUBLIC oplus_code oplus_read(const char* text, oplus_set** set);

/// Reads the same but SVG path data, and also points, line strings, and collections of all these.
OPLUS_PUBLIC oplus_code oplus_read_set(const char* text, oplus_set** set);

/// Makes a set of coordinates: x and y of each vertex of the first chain, of the next one, and so on. `lengths` has the
/// number of vertices of each of `chains` chains; the first vertex is not repeated. `kinds` has a kind for each, lines
/// and points last; NULL is allowed: the first is an outer one, the others are holes in it. A point has one vertex.
OPLUS_PUBLIC oplus_code oplus_from_doubles(const double* xy, const size_t* lengths,
                                           const int* kinds, size_t chains, oplus_set** set);

/// Makes the same of integers.
OPLUS_PUBLIC oplus_code oplus_from_integers(const int64_t* xy, const size_t* lengths,
                                            const int* kinds, size_t chains, oplus_set** set);

/// Makes a convex polygon inside the disc about the origin (OPLUS_CONTAINED) or around it (OPLUS_CONTAIN), which
/// differs from it by at most `error`. A sum with it is an offset (docs/discs.md).
OPLUS_PUBLIC oplus_code oplus_disc(const char* radius, int side, const char* error,
                                   oplus_set** set);

/// Reads what oplus_read_set reads, with all vertices in their order: of a region whose chains cross, too. `chains` has a line
/// for each chain: its kind, x and y of each vertex, exactly, with blanks between; lines are segments. Where the set is
/// valid, chains are turned, and `notes` has a line for each that was, and on coordinates beyond x and y. Where it is
/// not, `fault` says why in a line; else it is "".
OPLUS_PUBLIC oplus_code oplus_as_written(const char* text, char** chains, char** notes,
                                         char** fault);

// Sets as they are written.

/// Writes WKT, exactly: with fractions p/q where decimals don't end. With `digits` from 0 to 4096, the set is first
/// rounded to that many; any negative number is for exactly.
OPLUS_PUBLIC oplus_code oplus_wkt(const oplus_set* set, int digits, char** text);

/// Writes a GeoJSON geometry likewise; fractions are strings.
OPLUS_PUBLIC oplus_code oplus_geojson(const oplus_set* set, int digits, char** text);

/// Returns how many chains a set has, and how many vertices all of them have: for what is below.
OPLUS_PUBLIC oplus_code oplus_sizes(const oplus_set* set, size_t* chains, size_t* vertices);

/// Fills arrays of the caller: `kinds` and `lengths` of each chain, `xy` with two coordinates for each vertex, rounded
/// to nearest. NULL is allowed for what is not wanted. Outer chains are counterclockwise, holes clockwise.
OPLUS_PUBLIC oplus_code oplus_to_doubles(const oplus_set* set, int* kinds, size_t* lengths,
                                         double* xy);

/// Writes the same coordinates exactly: integers and fractions p/q in lowest terms, with a blank between two.
OPLUS_PUBLIC oplus_code oplus_fractions(const oplus_set* set, char** text);

// Sums, and what is made of them (docs/operations.md). Where P and Q are regions, so is each closed sum. Q + x is Q
// moved by x.

/// Makes P ⊕ Q, all p + q. Of open sets that have lines or points there is no sum.
OPLUS_PUBLIC oplus_code oplus_sum(const oplus_set* p, const oplus_set* q, int boundary,
                                  oplus_set** sum);

/// Makes the no-fit polygon, the open set of all x where Q + x overlaps P. Its lines and points are exact fits.
OPLUS_PUBLIC oplus_code oplus_nfp(const oplus_set* p, const oplus_set* q, oplus_set** places);

/// Makes the inner-fit polygon, the closed set of all x where Q + x is inside P; P and Q are regions, here and below.
OPLUS_PUBLIC oplus_code oplus_ifp(const oplus_set* p, const oplus_set* q, oplus_set** places);

/// Makes the erosion of P by Q: the inner-fit polygon without lines and points.
OPLUS_PUBLIC oplus_code oplus_erosion(const oplus_set* p, const oplus_set* q, oplus_set** set);

/// Makes the opening: the union of all Q + x inside P.
OPLUS_PUBLIC oplus_code oplus_opening(const oplus_set* p, const oplus_set* q, oplus_set** set);

/// Makes the closing: the erosion by Q of P ⊕ Q.
OPLUS_PUBLIC oplus_code oplus_closing(const oplus_set* p, const oplus_set* q, oplus_set** set);

/// Makes -P, which is P turned by π about the origin.
OPLUS_PUBLIC oplus_code oplus_reflected(const oplus_set* p, oplus_set** set);

/// Makes the complement, of an open set a closed one, and the reverse.
OPLUS_PUBLIC oplus_code oplus_complement(const oplus_set* p, oplus_set** set);

/// Makes a set whose coordinates are multiples of a number above 0: nearest to the given one, containing it, or
/// contained in it (docs/rounding.md).
OPLUS_PUBLIC oplus_code oplus_rounded(const oplus_set* p, const char* step, int side,
                                      oplus_set** set);

// What is asked of a set.

/// Returns the area: the nearest double, and the exact number as a text; NULL is allowed for either.
OPLUS_PUBLIC oplus_code oplus_area(const oplus_set* p, double* nearest, char** exact);

/// Returns whether a point belongs to a set, 1 or 0. Its boundary does iff the set is closed.
OPLUS_PUBLIC oplus_code oplus_contains(const oplus_set* p, double x, double y, int* contains);

/// Returns where a point is. The boundary of a set has its lines and points.
OPLUS_PUBLIC oplus_code oplus_locate(const oplus_set* p, const char* x, const char* y,
                                     int* location);

/// Returns whether two sets have the same inner points, edges and vertices, 1 or 0.
OPLUS_PUBLIC oplus_code oplus_equal(const oplus_set* a, const oplus_set* b, int* equal);

/// Returns whether what some program claims to be P ⊕ Q is that, 1 or 0, decided by the definitions and by no algorithm
/// for sums (docs/verify.md). The claim is a text as it was written, by WKT, GeoJSON or .dat, and may be invalid as a
/// region. `reason` is why not, or "": its first line is a reason, the second "witness: (x, y)" and more; NULL is allowed.
/// P and Q are bounded regions.
OPLUS_PUBLIC oplus_code oplus_verify(const oplus_set* p, const oplus_set* q, const char* claimed,
                                     int boundary, int* is_sum, char** reason);

/// Writes a certificate that what is claimed is P ⊕ Q: the program oplus-certified checks it, with P and Q as oplus_wkt
/// writes them and the claim as it was written (docs/certificates.md). What is not the sum is invalid input.
OPLUS_PUBLIC oplus_code oplus_certify(const oplus_set* p, const oplus_set* q, const char* claimed,
                                      int boundary, char** certificate);

// The convolution of two bounded regions (docs/cycles.md), and places of Q.

/// Writes the convolution's cycles, one a line, of each segment six numbers with blanks between: 0 for an edge of P, 1 for
/// one of Q; its chain and the vertex that it leaves; chain and vertex of the other region, which it is added to; and
/// whether that is reflex, 1 or 0. All count from 0, and vertices as the texts of P and Q do, turned as
/// oplus_as_written turns them.
OPLUS_PUBLIC oplus_code oplus_cycles(const char* p, const char* q, char** cycles);

/// Returns the winding number of a point with respect to the convolution, and the tangent count in the direction (1, 0),
/// which is equal (docs/winding.md), both on the ray from the point to the right; and whether the point is on the
/// convolution, 1 or 0.
OPLUS_PUBLIC oplus_code oplus_winding(const oplus_set* p, const oplus_set* q, const char* x,
                                      const char* y, int* winding, int* tangents,
                                      int* on_convolution);

/// Writes a shortest move of Q + x after which it and P only touch: x and y of the move, the square of its length, x and y
/// of a point where they touch; five numbers, with blanks between. Where P or Q is empty, that is invalid input.
OPLUS_PUBLIC oplus_code oplus_way_out(const oplus_set* p, const oplus_set* q, const char* x,
                                      const char* y, char** way);

#ifdef __cplusplus
}
#endif

#endif
