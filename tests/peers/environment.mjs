// Writes an environment to light a comparison with, as Radiance .hdr:
//   node environment.mjs OUT.hdr boxes|sun
// boxes: a sky from the horizon to the zenith, a darker ground, a warm and a cool soft box: light whose parts no program's
// filter loses, since nothing of it is smaller than five degrees. sun: one sun, five degrees wide, in a constant sky.
import {writeFileSync} from 'node:fs';

const width = 256, height = 128;

// Smooth 1 to 0 from `inner` to `outer` radians off the direction to azimuth and elevation (degrees).
function soft(direction, azimuth, elevation, inner, outer) {
    const a = azimuth * Math.PI / 180, e = elevation * Math.PI / 180;
    const to = [Math.cos(e) * Math.cos(a), Math.sin(e), Math.cos(e) * Math.sin(a)];
    const cosine = direction[0] * to[0] + direction[1] * to[1] + direction[2] * to[2];
    const t = Math.min(Math.max((Math.acos(Math.min(cosine, 1)) - inner) / (outer - inner), 0), 1);
    return 1 - t * t * (3 - 2 * t);
}

function sun(direction) {
    const disc = soft(direction, 60, 45, 0.03, 0.06);
    return [0.5 + 200 * disc, 0.5 + 190 * disc, 0.5 + 175 * disc];
}

function boxes(direction) {
    const up = direction[1];
    const sky = up > 0 ? [0.55 - 0.3 * up, 0.65 - 0.25 * up, 0.8 - 0.1 * up] : [0.25 + 0.1 * up, 0.22 + 0.1 * up, 0.2 + 0.1 * up];
    const warm = soft(direction, 70, 40, 0.25, 0.45), cool = soft(direction, 200, 20, 0.15, 0.4);
    return [sky[0] + 6 * warm + 1.2 * cool, sky[1] + 5 * warm + 1.6 * cool, sky[2] + 3.8 * warm + 2.2 * cool];
}

// Linear light of a direction, y up.
const radiance = {boxes, sun}[process.argv[3]];
const pixels = Buffer.alloc(width * height * 4);
for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
        const azimuth = 2 * Math.PI * ((x + 0.5) / width - 0.5), elevation = Math.PI * (0.5 - (y + 0.5) / height);
        const c = radiance([Math.cos(elevation) * Math.cos(azimuth), Math.sin(elevation), Math.cos(elevation) * Math.sin(azimuth)]);
        const exponent = Math.floor(Math.log2(Math.max(...c))) + 1;
        const scale = 256 / 2 ** exponent;
        pixels.set([...c.map((v) => Math.min(Math.floor(v * scale), 255)), exponent + 128], 4 * (y * width + x));
    }
}
const head = `#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ${height} +X ${width}\n`;
// Rows of 8 to 32767 pixels begin with 2, 2, width and are run-length coded by component, here as literals alone.
const rows = [];
for (let y = 0; y < height; ++y) {
    rows.push(Buffer.from([2, 2, width >> 8, width & 255]));
    for (let c = 0; c < 4; ++c) {
        for (let x = 0; x < width; x += 128) {
            const run = Math.min(128, width - x), bytes = Buffer.alloc(run + 1);
            bytes[0] = run;
            for (let i = 0; i < run; ++i) bytes[i + 1] = pixels[4 * (y * width + x + i) + c];
            rows.push(bytes);
        }
    }
}
writeFileSync(process.argv[2], Buffer.concat([Buffer.from(head, 'latin1'), ...rows]));
