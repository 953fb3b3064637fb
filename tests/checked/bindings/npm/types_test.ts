// SPDX-License-Identifier: GPL-3.0-or-later
// What TypeScript takes and refuses of the module; compiled, not run.
import {Fraction, OplusError, PlanarSet, Shape, disc, ifp, minkowskiSum, nfp, rounded, verify, version} from "oplus";

const square = [[0, 0], ["1/2", 0], [1n, {n: 1n, d: 3n}]] as const;
const shapes: Shape[] = [square, [square, square], [[square], [square]], "POINT (1 2)",
  {type: "Polygon", coordinates: [[[0, 0], [1, 0], [0, 1], [0, 0]]]}, new PlanarSet("POLYGON EMPTY")];
const sum: PlanarSet = minkowskiSum(shapes[0], shapes[1], {open: true});
const numbers: [number, number][][][] = sum.coordinates().polygons;
const fractions: [Fraction, Fraction][] = sum.coordinates({exact: true}).points;
const third: bigint = rounded(sum, "1/3", {side: "contain"}).exactArea.d;
const where: "inside" | "boundary" | "outside" = nfp(sum, square).locate(["1/3", 2n]);
const verdict = verify(sum, square, "POLYGON EMPTY");
const reason: string = verdict.isSum ? version() : verdict.reason;
const {code}: {code: "invalid" | "memory" | "failed"} = new OplusError();
export const all = [numbers, fractions, third, where, reason, code, disc(1, "1/100"), ifp(sum, sum).area + 1];

// @ts-expect-error a boolean is no shape
minkowskiSum(true, square);
// @ts-expect-error a point has two coordinates
new PlanarSet([[0, 0, 0], [1, 0, 0], [0, 1, 0]]);
// @ts-expect-error no such side
rounded(sum, 1, {side: "above"});
// @ts-expect-error contains takes numbers
sum.contains(["1/3", 0]);
// @ts-expect-error the area is read
sum.area = 3;
// @ts-expect-error a reason is there only where it is no sum
verify(sum, square, sum).reason.length;
