// Holds the errors of sampled views (`burl metrics --levels`) to those of three.js's own samplers, which look up the same places
// with the same steps from pixel to pixel in a headless Chromium:
//   node samplers.mjs MODULES CHROMIUM FOLDER NAME...
// FOLDER has what view_samples wrote. A row of views must agree to 3 % with trilinear filtering, and to 15 % with 16x anisotropic
// filtering at 75 and 85 degrees. In rows that look less along the surface browsers differ from the extension's example: they round
// the number of probes where it goes up to the next one, which looks up a finer level.
import {readFileSync} from 'node:fs';
import {join, normalize} from 'node:path';
import {browse} from './chromium.mjs';

const [modules, chromium, folder, ...names] = process.argv.slice(2);
const anisotropies = [1, 16], values = new Map();

function find(url) {
    if (url === '/jobs') return Buffer.from(JSON.stringify({names, anisotropies}));
    if (url.startsWith('/file/')) return readFileSync(join(folder, normalize(url.slice(6))));
    if (url.startsWith('/modules/')) return readFileSync(join(modules, 'node_modules', normalize(url.slice(9))));
    return null;
}

const floats = (bytes) => new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));

function receive(url, body) {
    values.set(url, floats(body));
}

// The number of rows that do not agree.
function compare(name, anisotropy) {
    const {points, rows} = JSON.parse(readFileSync(join(folder, `${name}.json`)));
    const means = floats(readFileSync(join(folder, `${name}.means`))), theirs = values.get(`/values/${name}/${anisotropy}`);
    let bad = 0, worst = 1;
    rows.forEach((row, r) => {
        let squares = 0;
        for (let i = r * points; i < (r + 1) * points; ++i) {
            for (let c = 0; c < 3; ++c) squares += (theirs[4 * i + c] - means[3 * i + c]) ** 2 / 3;
        }
        const ratio = Math.sqrt(squares / points) / row.errors[anisotropy];
        if (anisotropy === 1 || row.tilt >= 75) {
            if (Math.abs(Math.log(ratio)) > Math.abs(Math.log(worst))) worst = ratio;
            if (!(Math.abs(Math.log(ratio)) < Math.log(anisotropy === 1 ? 1.03 : 1.15))) ++bad;
        }
        if (process.env.PEER_LOG) console.log(name, anisotropy, row.minification, row.tilt, row.errors[anisotropy].toFixed(5), ratio.toFixed(3));
    });
    console.log(`${name}, anisotropy ${anisotropy}: ${bad} rows off, errors by three.js over ours in the worst ${worst.toFixed(3)}`);
    return bad;
}

try {
    await browse(chromium, 'samplers.html', find, receive);
    let bad = 0;
    for (const name of names) for (const anisotropy of anisotropies) bad += compare(name, anisotropy);
    process.exit(bad === 0 ? 0 : 1);
} catch (error) {
    console.log(error.message);
    process.exit(1);
}
