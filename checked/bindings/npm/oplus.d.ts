// SPDX-License-Identifier: MIT

/** A fraction s · n / d, such as one of fraction.js. */
export interface Fraction {
  readonly n: bigint;
  readonly d: bigint;
  readonly s?: bigint;
}

/** A number for exactly what it is: 0.1 is a double, "0.1" is one tenth, "1/3" a third. */
export type Coordinate = number | string | bigint | Fraction;
export type Point = readonly [Coordinate, Coordinate];
/** A chain of vertices; the last one may be the first one again. */
export type Ring = readonly Point[];

/** Whatever has the form of a GeoJSON geometry, feature or collection. */
export interface GeoJSON {
  readonly type: string;
  readonly [member: string]: unknown;
}

/** What a set is made from: itself; text (WKT, GeoJSON, SVG path data and more); an object of GeoJSON; a ring; a
 * polygon, which is its outer ring and holes; or several polygons. */
export type Shape = PlanarSet | string | GeoJSON | Ring | readonly Ring[] | readonly (readonly Ring[])[];

/** What bounds a set. Polygons are outer rings, counterclockwise, and their holes, clockwise, without the first vertex
 * again. Lines and points are what bounds no face: exact fits. */
export interface Coordinates<Number> {
  polygons: [Number, Number][][][];
  lines: [Number, Number][][];
  points: [Number, Number][];
}

/** What is thrown: for bad input ("invalid"), which the message names in a line, too little memory, a fault of oplus. */
export class OplusError extends Error {
  readonly code: "invalid" | "memory" | "failed";
}

/** A set in the plane, exact, which never changes. */
export class PlanarSet {
  /** Throws OplusError where chains cross or overlap, and where a text is wrong. */
  constructor(shape: Shape);
  /** Frees the memory now; the garbage collector does, else. */
  free(): void;
  /** WKT, exactly, with fractions where decimals don't end; or rounded to so many digits. */
  toWKT(digits?: number): string;
  toString(): string;
  /** A GeoJSON geometry: its numbers are doubles, fractions p/q are strings. */
  toGeoJSON(digits?: number): GeoJSON;
  /** The same as text, exactly. */
  toGeoJSONText(digits?: number): string;
  coordinates(options: {exact: true}): Coordinates<Fraction>;
  coordinates(options?: {exact?: false}): Coordinates<number>;
  readonly area: number;
  readonly exactArea: Fraction;
  locate(point: Point): "inside" | "boundary" | "outside";
  /** Whether a point belongs to the set: of its boundary iff the set is closed. */
  contains(point: readonly [number, number]): boolean;
  equals(other: Shape): boolean;
}

/** P ⊕ Q, all p + q; open: of interiors, which keeps where one just fits. */
export function minkowskiSum(p: Shape, q: Shape, options?: {open?: boolean}): PlanarSet;
/** The no-fit polygon: all x where Q + x overlaps P, an open set. */
export function nfp(p: Shape, q: Shape): PlanarSet;
/** The inner-fit polygon: all x where Q + x is inside P, with exact fits. */
export function ifp(p: Shape, q: Shape): PlanarSet;
/** The same without lines and points. */
export function erosion(p: Shape, q: Shape): PlanarSet;
/** The union of all Q + x inside P. */
export function opening(p: Shape, q: Shape): PlanarSet;
/** The erosion by Q of P ⊕ Q. */
export function closing(p: Shape, q: Shape): PlanarSet;
/** −P. */
export function reflected(p: Shape): PlanarSet;
export function complement(p: Shape): PlanarSet;
/** A set on the grid of multiples of a step: nearest to P, containing it, or contained in it. */
export function rounded(p: Shape, step: Coordinate, options?: {side?: "nearest" | "contain" | "contained"}): PlanarSet;
/** A polygon around the disc about the origin, or contained in it, which differs from it by at most `error`. */
export function disc(radius: Coordinate, error: Coordinate, options?: {side?: "contain" | "contained"}): PlanarSet;
/** A shape as it is written, with all vertices in their order, of a region whose chains cross, too; lines are segments.
 * `fault` says why it is no valid shape; chains of a valid one are turned, and `notes` say which were. */
export function asWritten(shape: Shape): {
  chains: {kind: "outer" | "hole" | "line" | "point", vertices: [Fraction, Fraction][]}[];
  notes: string[];
  fault?: string;
};
/** A segment of the convolution: an edge, which leaves a vertex, and a vertex of the other region. Each is its chain and its
 * number there, from 0, in the order of asWritten. */
export interface ConvolutionSegment {
  edgeOf: "P" | "Q";
  edge: [number, number];
  vertex: [number, number];
  isReflex: boolean;
}
/** The cycles of the convolution of two regions. */
export function cycles(p: Shape, q: Shape): ConvolutionSegment[][];
/** The winding number of x with respect to the convolution, and the tangent count, which is equal: x is inside the sum iff
 * they are positive. Where x is on the convolution both are those of the ray to the right. */
export function windingNumber(p: Shape, q: Shape, x: Point): {winding: number; tangents: number; onConvolution: boolean};
/** A shortest move of Q + x after which it and P only touch, and where. */
export function wayOut(p: Shape, q: Shape, x?: Point):
  {move: [Fraction, Fraction]; squaredLength: Fraction; contact: [Fraction, Fraction]};
/** What shows the program oplus-certified that a sum is right, with the WKT of P and Q. Throws OplusError where it is wrong. */
export function certificate(p: Shape, q: Shape, claimed: Shape, options?: {open?: boolean}): string;
/** Whether what some program claims to be P ⊕ Q is that, by the definitions; else why not: a line with a reason,
 * one with a witness, a point, and more. */
export function verify(p: Shape, q: Shape, claimed: Shape, options?: {open?: boolean}):
  {isSum: true, reason?: undefined} | {isSum: false, reason: string};
/** The version of oplus, such as "1.0.0". */
export function version(): string;
