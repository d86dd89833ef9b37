// Values of MaterialX documents as MaterialX's own shaders give them, drawn in a headless Chromium in float32:
//   node materialx_values.mjs MODULES CHROMIUM DOCUMENT.mtlx OUTPUT POINTS.json >VALUES.json
//   node materialx_values.mjs MODULES CHROMIUM --list JOBS.json >VALUES.json
// OUTPUT is a path such as graph/out, or the name of a node or material. POINTS.json is {"position": [[x, y, z], ...]}, which may also
// give normal, tangent, bitangent, texcoord (two numbers) and color (four). JOBS.json is a list of {"document", "output", "points"}, with
// points as a file's name or the object itself. The answer, or of a list each in turn, is {"valid", "type", "values": [[...], ...]} with as
// many numbers a point as the type has ("NaN", "Infinity" and "-Infinity" as words), or {"valid", "error"}; a material's shader is compiled
// and has no values. MODULES is the folder whose node_modules holds @needle-tools/materialx. Pictures: 8 bits, linear or closest, no MIPs.
import {existsSync, readFileSync} from 'node:fs';
import {dirname, resolve} from 'node:path';
import {browse} from './chromium.mjs';
import {loadMaterialX, shaderOf} from './materialx_shader.mjs';

const [modules, chromium, ...asked] = process.argv.slice(2);
const widths = {float: 1, integer: 1, boolean: 1, vector2: 2, vector3: 3, color3: 3, vector4: 4, color4: 4};
const one = asked[0] !== '--list';
const readJson = (file) => JSON.parse(readFileSync(file, 'utf8'));
const wanted = one ? [{document: asked[0], output: asked[1], points: asked[2]}] : readJson(asked[1]);

const cache = new Map();
function pointsOf(points) {
    if (typeof points !== 'string') return points;
    if (!cache.has(points)) cache.set(points, readJson(points));
    return cache.get(points);
}

const begun = performance.now();
const word = (v) => Number.isFinite(v) ? v : String(v);
const library = await loadMaterialX(modules);
const results = [], jobs = [], pictures = [];

// The pictures that the shader samples, by number.
function texturesOf(file, uniforms) {
    return uniforms.filter(({type, value}) => type === 'filename' && value).map(({name, value}) => {
        const path = resolve(dirname(file), value);
        if (!existsSync(path)) throw new Error(`${file} names a picture that is not there: ${value}`);
        return {name, url: `/picture/${pictures.push(path) - 1}`};
    });
}

for (const [number, {document, output, points}] of wanted.entries()) {
    const {vertex, pixel, uniforms, ...rest} = await shaderOf(library, document, output);
    results[number] = rest;
    if (rest.error) continue;
    try {
        const at = widths[rest.type] ? pointsOf(points) : {position: []};
        jobs.push({number, vertex, pixel, uniforms, textures: texturesOf(document, uniforms), points: at});
    } catch (error) {
        results[number] = {valid: rest.valid, error: error.message};
    }
}

function find(url) {
    if (url === '/jobs') return Buffer.from(JSON.stringify(jobs));
    const picture = url.match(/^\/picture\/(\d+)$/);
    return picture ? readFileSync(pictures[Number(picture[1])]) : null;
}

function receive(url, body) {
    if (process.env.PEER_TIMES) console.error(((performance.now() - begun) / 1000).toFixed(2), url, wanted[url.match(/\d+/)[0]].output);
    const [, kind, number] = url.match(/^\/(values|error)\/(\d+)$/), result = results[Number(number)];
    if (kind === 'error') {
        result.error = body.toString();
        return;
    }
    const numbers = new Float32Array(body.buffer.slice(body.byteOffset, body.byteOffset + body.length)), width = widths[result.type] ?? 0;
    result.values = Array.from({length: numbers.length / 4}, (_, k) => Array.from(numbers.slice(4 * k, 4 * k + width), word));
}

try {
    if (jobs.length) await browse(chromium, 'materialx_page.html', find, receive);
    console.log(JSON.stringify(one ? results[0] : results));
    process.exitCode = results.some(({error}) => error) ? 1 : 0;
} catch (error) {
    console.error(error.message);
    process.exitCode = 2;
}
