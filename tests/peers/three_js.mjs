// Draws .glb files with three.js in a headless Chromium, as another program shows what we export:
//   node three_js.mjs MODULES CHROMIUM ENVIRONMENT.hdr|unlit AZIMUTH,ELEVATION,DISTANCE SIDE FILE.glb[@SECONDS]...
// writes FILE.three.png beside each, with SECONDS FILE@SECONDS.three.png of that moment of its first animation; unlit, the base
// colour as it is, else averaged in linear light, through the tone curve of Khronos PBR Neutral, encoded to sRGB,
// over the grey of `burl render`. MODULES is the folder whose node_modules holds three.
import {readFileSync, writeFileSync} from 'node:fs';
import {join, normalize} from 'node:path';
import {browse} from './chromium.mjs';
import {encoded, png} from './png.mjs';

const [modules, chromium, environment, view, side, ...asked] = process.argv.slice(2);
const files = asked.map((name) => name.split('@')[0]), times = asked.map((name) => name.split('@')[1] ?? null);
const unlit = environment === 'unlit';
const [azimuth, elevation, distance] = view.split(',').map(Number);
const size = Number(side), supersample = 2, grey = 176;

// Khronos PBR Neutral, from its specification.
function toneMapped(c) {
    const start = 0.8 - 0.04, desaturation = 0.15;
    const low = Math.min(...c), offset = low < 0.08 ? low - 6.25 * low * low : 0.04;
    c = c.map((v) => v - offset);
    const peak = Math.max(...c);
    if (peak < start) return c;
    const d = 1 - start, newPeak = 1 - d * d / (peak + d - start);
    const g = 1 - 1 / (desaturation * (peak - newPeak) + 1);
    return c.map((v) => v * newPeak / peak * (1 - g) + newPeak * g);
}

const toned = (c) => unlit ? c : toneMapped(c);

// The 8-bit picture of linear samples with alpha multiplied in, rows from below.
function developed(samples) {
    const picture = Buffer.alloc(3 * size * size), n = supersample;
    for (let y = 0; y < size; ++y) {
        for (let x = 0; x < size; ++x) {
            const sum = [0, 0, 0, 0];
            for (let j = 0; j < n; ++j) {
                for (let i = 0; i < n; ++i) {
                    const at = 4 * ((n * size - 1 - n * y - j) * n * size + n * x + i);
                    for (let c = 0; c < 4; ++c) sum[c] += samples[at + c] / (n * n);
                }
            }
            const codes = sum[3] > 0 ? toned(sum.slice(0, 3).map((v) => v / sum[3])).map(encoded) : [grey, grey, grey];
            picture.set(sum[3] < 1 ? [grey, grey, grey] : codes, 3 * (y * size + x));
        }
    }
    return picture;
}

const jobs = files.map((_, i) => ({url: `/file/${i}.glb`, time: times[i], azimuth, elevation, distance, width: size, height: size, supersample}));

function find(url) {
    if (url === '/jobs') return Buffer.from(JSON.stringify({environment: unlit ? null : '/environment.hdr', jobs}));
    if (url === '/environment.hdr') return readFileSync(environment);
    const file = url.match(/^\/file\/(\d+)\.glb$/);
    if (file) return readFileSync(files[Number(file[1])]);
    if (url.startsWith('/modules/')) return readFileSync(join(modules, 'node_modules', normalize(url.slice(9))));
    return null;
}

function receive(url, body) {
    const samples = new Float32Array(body.buffer.slice(body.byteOffset, body.byteOffset + body.length));
    const i = Number(url.match(/^\/picture\/(\d+)$/)[1]), moment = times[i] === null ? '' : `@${times[i]}`;
    writeFileSync(files[i].replace(/\.glb$/, `${moment}.three.png`), png(developed(samples), size, size));
}

try {
    await browse(chromium, 'page.html', find, receive);
    process.exit(0);
} catch (error) {
    console.log(error.message);
    process.exit(1);
}
