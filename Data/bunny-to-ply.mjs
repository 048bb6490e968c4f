// SPDX-License-Identifier: BSD-3-Clause
// Converts the arrays of the npm package "bunny" to an ASCII PLY file.
//
//   node bunny-to-ply.mjs PACKAGE_DIR OUT.ply
//
// The package's y axis points up; the file's z axis does. The bunny then stands on z = 0, is centred
// in x and y and has height 1.

import { createRequire } from "node:module";
import { writeFileSync } from "node:fs";
import { resolve } from "node:path";

const [packageDir, outFile] = process.argv.slice(2);
if (!packageDir || !outFile) {
  console.error("usage: node bunny-to-ply.mjs PACKAGE_DIR OUT.ply");
  process.exit(2);
}

const { positions, cells } = createRequire(import.meta.url)(resolve(packageDir));

const points = positions.map(([x, y, z]) => [x, -z, y]);
const low = [0, 1, 2].map((axis) => Math.min(...points.map((p) => p[axis])));
const high = [0, 1, 2].map((axis) => Math.max(...points.map((p) => p[axis])));
const origin = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]];
const scale = 1 / (high[2] - low[2]);

const lines = [
  "ply",
  "format ascii 1.0",
  "comment Stanford bunny, public domain, from the npm package bunny",
  `element vertex ${points.length}`,
  "property float x",
  "property float y",
  "property float z",
  `element face ${cells.length}`,
  "property list uchar int vertex_indices",
  "end_header",
  ...points.map((p) => p.map((v, axis) => +((v - origin[axis]) * scale).toFixed(7)).join(" ")),
  ...cells.map((cell) => `${cell.length} ${cell.join(" ")}`),
];
writeFileSync(outFile, lines.join("\n") + "\n");
