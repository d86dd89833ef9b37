// Unwraps an OBJ with xatlas, for comparisons: node unwrap.mjs MODULES FILE.obj OUT.obj PADDING
// MODULES is the folder whose node_modules holds xatlas-wasm, which no test installs. xatlas gets the mesh scaled to a half diagonal
// of 1, a texture of 1024 and a padding in texels; UVs are divided by the width and height that it chose.
import {readFileSync, writeFileSync} from 'node:fs';
import {resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

const [modules, source, out, padding] = process.argv.slice(2);
const createXAtlas = (await import(pathToFileURL(resolve(modules, 'node_modules/xatlas-wasm/dist/index.mjs')))).default;
const points = [], triangles = [];
for (const line of readFileSync(source, 'utf8').split('\n')) {
    const words = line.trim().split(/\s+/);
    if (words[0] === 'v') points.push(words.slice(1, 4).map(Number));
    if (words[0] !== 'f') continue;
    const corners = words.slice(1).map((word) => parseInt(word) - 1);
    for (let i = 1; i + 1 < corners.length; ++i) triangles.push([corners[0], corners[i], corners[i + 1]]);
}
const bounds = [0, 1, 2].map((k) => points.reduce(([low, high], p) => [Math.min(low, p[k]), Math.max(high, p[k])], [Infinity, -Infinity]));
const half = 0.5 * Math.hypot(...bounds.map(([low, high]) => high - low));
const positions = points.flatMap((p) => p.map((x, k) => (x - 0.5 * (bounds[k][0] + bounds[k][1])) / half));
const atlas = (await createXAtlas()).createAtlas();
atlas.addMesh({positions: new Float32Array(positions), indices: new Uint32Array(triangles.flat())});
atlas.generate({}, {resolution: 1024, padding: Number(padding)});
const {vertices, indices} = atlas.getMesh(0), lines = points.map((p) => `v ${p.join(' ')}`);
for (const {uv} of vertices) lines.push(`vt ${uv[0] / atlas.width} ${uv[1] / atlas.height}`);
for (let i = 0; i < indices.length; i += 3) {
    lines.push(`f ${[0, 1, 2].map((k) => `${vertices[indices[i + k]].xref + 1}/${indices[i + k] + 1}`).join(' ')}`);
}
writeFileSync(out, `${lines.join('\n')}\n`);
process.exit(0);
