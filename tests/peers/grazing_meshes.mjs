// Writes meshes that are seen along their surface: node grazing_meshes.mjs FOLDER
// floor.obj, eight by eight tiles with grooves between them and a carved rosette in each, plain.obj, the floor before it was carved,
// and hull.obj, an open boat whose sides run back from its bow. Beside each NAME-places.obj, whose vertices have their places for
// colours: where a pixel shows two places, an edge goes through it.
import {writeFileSync} from 'node:fs';
import {join} from 'node:path';

const folder = process.argv[2];

// A mesh of (columns + 1) x (rows + 1) points, point(u, v) for u and v from 0 to 1.
function grid(columns, rows, point) {
    const points = [], triangles = [];
    for (let j = 0; j <= rows; ++j) for (let i = 0; i <= columns; ++i) points.push(point(i / columns, j / rows));
    for (let j = 0; j < rows; ++j) {
        for (let i = 0; i < columns; ++i) {
            const a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1, d = c + 1;
            triangles.push([a, c, b], [b, c, d]);
        }
    }
    return {points, triangles};
}

function carved(u, v) {
    const s = 2 * (8 * u - Math.min(7, Math.floor(8 * u))) - 1, t = 2 * (8 * v - Math.min(7, Math.floor(8 * v))) - 1;
    const groove = Math.max(0, 1 - (1 - Math.max(Math.abs(s), Math.abs(t))) / 0.25);
    const radius = Math.min(1, Math.hypot(s, t) / 0.7), bell = (1 - radius * radius) ** 2;
    const height = 0.01 * radius * bell * Math.cos(6 * Math.atan2(t, s)) - 0.01 * groove;
    return [2 * u - 1, height, 2 * v - 1];
}

// u runs from bow to stern, v round a frame from one gunwale to the other; the sides stand at ten degrees to the keel.
function hull(u, v) {
    const side = 2 * v - 1, turn = Math.abs(side), bottom = 0.4, beam = 0.57 * u * (1 - 0.12 * u), depth = 0.62 - 0.1 * u;
    const out = Math.sign(side) * (turn < bottom ? 0.85 * (turn / bottom) ** 0.9 : 0.85 + 0.15 * (turn - bottom) / (1 - bottom));
    const height = turn < bottom ? 0.22 * (turn / bottom) ** 2 : 0.22 + 0.78 * (turn - bottom) / (1 - bottom);
    return [beam * out, depth * (height - 1), 1.6 - 3.2 * u + 0.12 * height * (1 - u) ** 4];
}

function write(name, {points, triangles}) {
    const low = [0, 1, 2].map((k) => Math.min(...points.map((p) => p[k]))), high = [0, 1, 2].map((k) => Math.max(...points.map((p) => p[k])));
    const side = Math.max(...high.map((h, k) => h - low[k]));
    const faces = triangles.map((t) => `f ${t.map((i) => i + 1).join(' ')}\n`).join('');
    writeFileSync(join(folder, `${name}.obj`), points.map((p) => `v ${p.join(' ')}\n`).join('') + faces);
    const colored = points.map((p) => `v ${p.join(' ')} ${p.map((x, k) => (x - low[k]) / side).join(' ')}\n`);
    writeFileSync(join(folder, `${name}-places.obj`), colored.join('') + faces);
}

write('floor', grid(128, 128, carved));
write('plain', grid(128, 128, (u, v) => [2 * u - 1, 0, 2 * v - 1]));
write('hull', grid(96, 48, hull));
