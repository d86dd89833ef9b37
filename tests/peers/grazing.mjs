// Pictures along a surface, drawn by three.js with anisotropic filtering, and judged against the texture itself:
//   node grazing.mjs draw MODULES CHROMIUM AZIMUTH,ELEVATION,DISTANCE WIDTHxHEIGHT ANISOTROPY FILE.glb...
// writes FILE.three.png beside each, one lookup a pixel, over the grey of `burl render`.
//   node grazing.mjs psnr TRUTH.png PLACES.png PLACES_MEAN.png PICTURE.png...
// prints each picture's PSNR in dB by its codes, and how many pixels count: those of the object through which no edge goes.
// PLACES shows every pixel's middle, PLACES_MEAN its mean; where they differ, two places meet in a pixel.
import {readFileSync, writeFileSync} from 'node:fs';
import {basename, join, normalize} from 'node:path';
import {browse} from './chromium.mjs';
import {encoded, png, readPng} from './png.mjs';

const grey = 176;

async function draw(modules, chromium, view, picture, anisotropy, ...files) {
    const [azimuth, elevation, distance] = view.split(',').map(Number), [width, height] = picture.split('x').map(Number);
    const jobs = files.map((_, i) => ({url: `/file/${i}.glb`, time: null, azimuth, elevation, distance, width, height, supersample: 1,
        anisotropy: Number(anisotropy)}));
    const find = (url) => {
        if (url === '/jobs') return Buffer.from(JSON.stringify({environment: null, jobs}));
        const file = url.match(/^\/file\/(\d+)\.glb$/);
        if (file) return readFileSync(files[Number(file[1])]);
        return url.startsWith('/modules/') ? readFileSync(join(modules, 'node_modules', normalize(url.slice(9)))) : null;
    };
    await browse(chromium, 'page.html', find, (url, body) => {
        const samples = new Float32Array(body.buffer.slice(body.byteOffset, body.byteOffset + body.length));
        const data = Buffer.alloc(3 * width * height, grey);
        for (let y = 0; y < height; ++y) {
            for (let x = 0; x < width; ++x) {
                const at = 4 * ((height - 1 - y) * width + x); // rows from below
                if (samples[at + 3] > 0) data.set([...samples.subarray(at, at + 3)].map(encoded), 3 * (y * width + x));
            }
        }
        writeFileSync(files[Number(url.match(/(\d+)$/)[1])].replace(/\.glb$/, '.three.png'), png(data, width, height));
    });
}

// The numbers of the pixels that count, from pictures of their places: none within a pixel of an edge.
function inner(middles, means) {
    const {width, height} = middles, edge = new Uint8Array(width * height), result = [];
    for (let i = 0; i < width * height; ++i) {
        const codes = [0, 1, 2].map((c) => [middles.data[3 * i + c], means.data[3 * i + c]]);
        if (codes.every(([a, b]) => a === grey && b === grey) || codes.some(([a, b]) => Math.abs(a - b) > 2)) edge[i] = 1;
    }
    for (let y = 1; y < height - 1; ++y) {
        for (let x = 1; x < width - 1; ++x) {
            let sum = 0;
            for (let j = -1; j <= 1; ++j) for (let i = -1; i <= 1; ++i) sum += edge[(y + j) * width + x + i];
            if (sum === 0) result.push(y * width + x);
        }
    }
    return result;
}

function psnr(truth, places, mean, ...pictures) {
    const read = (file) => readPng(readFileSync(file)), pixels = inner(read(places), read(mean)), wanted = read(truth).data;
    for (const file of pictures) {
        const {data} = read(file);
        let squares = 0;
        for (const i of pixels) for (let c = 0; c < 3; ++c) squares += (data[3 * i + c] - wanted[3 * i + c]) ** 2;
        console.log(basename(file, '.png'), (10 * Math.log10(255 ** 2 * 3 * pixels.length / squares)).toFixed(2), pixels.length);
    }
}

const [verb, ...rest] = process.argv.slice(2);
try {
    await {draw, psnr}[verb](...rest);
    process.exit(0);
} catch (error) {
    console.log(error.message);
    process.exit(1);
}
