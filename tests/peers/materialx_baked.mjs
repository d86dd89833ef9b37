// Holds documents of `burl bake -o NAME.mtlx` to their pictures by MaterialX's own shaders:
//   node materialx_baked.mjs MODULES CHROMIUM DOCUMENT.mtlx...
// Documents must be valid, their materials compile, and each output of their graphs be at 2,000 centres of texels what the picture has
// there within 1e-5: colours in linear light, normals of a frame along the axes.
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {inflateSync} from 'node:zlib';

const [modules, chromium, ...documents] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));

// A PNG of 8 bits that is not interlaced: {width, height, channels, codes}.
function readPng(file) {
    const bytes = readFileSync(file), data = [];
    for (let at = 8; at < bytes.length; at += 12 + bytes.readUInt32BE(at))
        if (bytes.toString('latin1', at + 4, at + 8) === 'IDAT') data.push(bytes.subarray(at + 8, at + 8 + bytes.readUInt32BE(at)));
    const width = bytes.readUInt32BE(16), height = bytes.readUInt32BE(20), channels = {0: 1, 2: 3, 4: 2, 6: 4}[bytes[25]];
    if (bytes[24] !== 8 || !channels || bytes[28]) throw new Error(`${file} is no plain PNG of 8 bits.`);
    const raw = inflateSync(Buffer.concat(data)), row = width * channels, codes = Buffer.alloc(row * height);
    for (let y = 0; y < height; ++y)
        for (let i = 0; i < row; ++i) {
            const a = i >= channels ? codes[y * row + i - channels] : 0, b = y ? codes[(y - 1) * row + i] : 0;
            const c = i >= channels && y ? codes[(y - 1) * row + i - channels] : 0, p = a + b - c;
            const nearest = Math.abs(p - a) <= Math.abs(p - b) && Math.abs(p - a) <= Math.abs(p - c) ? a : Math.abs(p - b) <= Math.abs(p - c) ? b : c;
            codes[y * row + i] = raw[y * (row + 1) + 1 + i] + [0, a, b, (a + b) >> 1, nearest][raw[y * (row + 1)]];
        }
    return {width, height, channels, codes};
}

const linear = (code) => code <= 0.04045 * 255 ? code / 255 / 12.92 : ((code / 255 + 0.055) / 1.055) ** 2.4;
const unit = (v) => v.map((one) => one / Math.hypot(...v));
const expected = {
    base_color: (codes) => codes.slice(0, 3).map(linear),
    emissive: (codes) => codes.slice(0, 3).map(linear),
    sheen: (codes) => codes.slice(0, 3).map(linear),
    normal: (codes) => unit(codes.slice(0, 3).map((code) => 2 * code / 255 - 1)),
    opacity: (codes, cut) => Array(3).fill(cut ? Number(codes[3] >= 128) : codes[3] / 255),
};
const most = 1e-5;

const jobs = [], wanted = [];
for (const document of documents) {
    const text = readFileSync(document, 'utf8'), graph = text.match(/<nodegraph name="(\w+)"/)[1];
    const pictureOf = (channel) => join(dirname(document), text.match(new RegExp(`<image name="${channel}_image"[^]*?value="([^"]*)"`))[1]);
    for (const [, output] of text.matchAll(/<output name="(\w+)"/g)) {
        const {width, height, channels, codes} = readPng(pictureOf(output === 'opacity' ? 'base_color' : output));
        const texels = Array.from({length: 2000}, (_, k) => (k * 7919) % (width * height));
        const texcoord = texels.map((t) => [(t % width + 0.5) / width, 1 - (Math.floor(t / width) + 0.5) / height]);
        jobs.push({document, output: `${graph}/${output}`, points: {position: texcoord.map(() => [0, 0, 0]), texcoord}});
        const given = expected[output] ?? ((of) => [of[0] / 255]);
        wanted.push({name: `${document} ${output}`,
            values: texels.map((t) => given([...codes.subarray(t * channels, (t + 1) * channels)], text.includes('alpha_cut')))});
    }
    jobs.push({document, output: text.match(/<surfacematerial name="(\w+)"/)[1], points: {position: []}});
    wanted.push({name: `${document} compiled`, values: []});
}

const folder = mkdtempSync(join(tmpdir(), 'materialx-')), list = join(folder, 'jobs.json');
writeFileSync(list, JSON.stringify(jobs));
let answer;
try {
    answer = execFileSync('node', [join(here, 'materialx_values.mjs'), modules, chromium, '--list', list], {encoding: 'utf8', maxBuffer: 1 << 28});
} catch (error) {
    answer = error.stdout;
}
rmSync(folder, {recursive: true});
let bad = 0;
for (const [i, result] of JSON.parse(answer).entries()) {
    const {name, values} = wanted[i];
    const error = result.error ? NaN : Math.max(0, ...values.map((v, k) => Math.max(...v.map((one, c) => Math.abs(one - result.values[k][c])))));
    const fails = !result.valid || !(error <= most);
    bad += fails ? 1 : 0;
    console.log(`${name}: ${result.error ?? `off by at most ${error.toExponential(1)}`}${result.valid ? '' : ', not valid'}${fails ? '  BAD' : ''}`);
}
console.log(`${bad} of ${wanted.length} differ`);
process.exit(bad ? 1 : 0);
