// Holds recipes written as MaterialX documents to what MaterialX's own shaders make of them:
//   node materialx_recipes.mjs MODULES CHROMIUM BURL SCRATCH
// At 1,000 points each output of `burl show RECIPE --materialx` must be that of `burl eval` within 2e-5 (the shaders' float32), or 5e-4
// where it has sines, of which Chromium's have an error of 1.4e-4, but for two points at a jump; documents must be valid and their
// materials compile. Exit 1 where that does not hold.
import {execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const [modules, chromium, burl, scratch] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const x = {node: 'coordinate'}, y = {node: 'coordinate', direction: [0, 1, 0]}, z = {node: 'coordinate', direction: [0, 0.5, 1], offset: 0.25};
const map = (stops, rest) => ({node: 'color_map', stops, ...rest});
const stops = [[0, '#102030'], [0.2, '#f0a040'], [0.2, '#20c040'], [0.65, '#8040ff'], [1, '#ffffff']];

// One or more recipes of each operation that a value program has.
const recipes = {
    wood: {texture: {node: 'wood_grain', a: '#402010', b: '#e0c080', profile: 'ramp', twist: 1.5}},
    mixed: {texture: {node: 'mix', a: '#ff8040', b: {node: 'stripes', a: '#204060', b: '#e0e0ff', period: 0.7},
        amount: {node: 'smoothstep', low: 0.2, high: 0.7, input: {node: 'fract', input: z}}}},
    arithmetic: {texture: {node: 'combine', red: {node: 'divide', a: x, b: {node: 'abs', input: y}},
        green: {node: 'min', a: {node: 'power', input: y, exponent: 3}, b: {node: 'max', a: x, b: z}},
        blue: {node: 'power', input: {node: 'abs', input: {node: 'sin', input: z}}, exponent: 1.7}}},
    ranges: {texture: {node: 'combine', red: {node: 'clamp', input: x, low: -0.5, high: 0.75}, green: {node: 'remap', input: y, in_low: -1, in_high: 2},
        blue: {node: 'subtract', a: {node: 'floor', input: z}, b: {node: 'length', x, y}}}},
    map: {texture: map(stops, {input: x, wrap: 'repeat'})},
    clamped_map: {texture: map(stops, {input: {node: 'multiply', a: 0.5, b: y}, wrap: 'clamp'})},
    checks: {texture: {node: 'transform', scale: [2, 2, 2], rotate: [10, 20, 30], input: {node: 'checkerboard_3d', a: '#f2ede2', b: '#23303f'}}},
    round: {texture: {node: 'map_spherical', input: {node: 'uv'}}, solid: {scale: 2, rotate: [0, 30, 0], translate: [0.5, 0, 0.25]}},
    rings: {texture: {node: 'rings', a: '#000000', b: '#ff0000'}},
    bricks: {texture: {node: 'bricks', a: '#b0b0a0', b: '#803020'}},
    hexagons: {texture: {node: 'hexagons', a: '#b0b0a0', b: '#803020', gives: 'edge'}},
    hsv: {texture: {node: 'hsv', input: map(stops, {input: x, wrap: 'repeat'}), hue: 0.2, saturation: 0.8, value: 0.9}},
    glass: {texture: {node: 'layer_over', top: '#ff000080', opacity: {node: 'fract', input: x}, base: '#00ff0000'}},
    quadric: {texture: map(stops, {input: {node: 'field', quadric: {A: 1, E: 2, H: -0.5, J: 0.25, B: 0.3}}, wrap: 'repeat'})},
    picture: {texture: {node: 'image', file: 'picture.png', wrap: 'repeat'}},
    shares: {texture: {node: 'ramp', a: '#102030', b: '#f0e0d0', direction: [1, 0.25, 0]}, material: {alpha: 'mask', opacity: {node: 'fract', input: y}}},
    material: {texture: {node: 'ramp', a: '#202020', b: '#e0e0e0'},
        material: {roughness: {node: 'fract', input: y}, emissive: {node: 'scale', a: '#ff8000', b: {node: 'fract', input: x}}}},
};
Object.assign(recipes.material.material, {clearcoat: 0.5, sheen: '#404080', transmission: {node: 'clamp', input: z}, emissive_strength: 3});

// MaterialX's own functions: each noise but three sums of octaves, whose shader takes SwiftShader minutes to compile, and three operations a recipe, where they are defined.
for (const name of ['noise', 'fractal', 'cellnoise', 'worley'])
    for (const suffix of name === 'fractal' ? [''] : ['', '_color'])
        for (const dimensions of ['2', '3'])
            for (const style of name === 'worley' ? ['distance', 'solid'] : [null]) {
                const node = {node: `materialx_${name}${suffix}`, dimensions, ...style && {style, jitter: 0.8}, ...name === 'fractal' && {octaves: 4, diminish: 0.6}};
                recipes[[name, suffix.slice(1), dimensions, style].filter(Boolean).join('_')] = {texture: node, solid: {scale: 3}};
            }
const above = {node: 'add', a: {node: 'abs', input: x}, b: 0.125}, low = {node: 'multiply', a: 0.25, b: y}, share = {node: 'fract', input: z};
const vector = {node: 'combine', red: x, green: y, blue: above}, other = {node: 'combine', red: share, green: above, blue: 0.5};
const operations = 'add subtract multiply divide modulo power safepower absval sign floor ceil round fract sqrt ln exp atan2 min max clamp smoothstep mix ' +
    'trianglewave burn dodge screen overlay difference plus minus';
const math = (operation, a, b, c) => ({node: 'materialx_math', operation, a, b, c});
const trio = (words, ...inputs) => ({texture: {node: 'combine', red: math(words[0], ...inputs), green: math(words[1], ...inputs), blue: math(words[2], ...inputs)}});
const signed = 'add subtract multiply divide modulo safepower absval sign floor ceil round fract clamp smoothstep mix trianglewave ifgreater ifgreatereq'.split(' ');
for (let i = 0; i < signed.length; i += 3) recipes[`signed_${i / 3 + 1}`] = trio(signed.slice(i, i + 3), x, above, {node: 'add', a: 2.5, b: share});
const shares = 'power sqrt ln exp atan2 min max burn dodge screen overlay difference plus minus ifequal'.split(' ');
for (let i = 0; i < shares.length; i += 3) recipes[`shares_${i / 3 + 1}`] = trio(shares.slice(i, i + 3), above, share, share);
recipes.sines_1 = trio(['sin', 'cos', 'tan'], low, 0, 0);
recipes.sines_2 = trio(['asin', 'acos', 'exp'], low, 0, 0);
for (const operation of [...operations.split(' ').filter((word) => !['power', 'sqrt', 'ln'].includes(word)),
    'dotproduct', 'crossproduct', 'normalize', 'magnitude', 'distance', 'reflect', 'refract', 'luminance'])
    recipes[`vector_${operation}`] = {texture: {node: 'materialx_vector_math', operation, a: vector, b: other, c: share}};
for (const operation of ['rgbtohsv', 'hsvtorgb']) recipes[`vector_${operation}`] = {texture: {node: 'materialx_vector_math', operation, a: other}};
recipes.vector_rotate3d = {texture: {node: 'materialx_vector_math', operation: 'rotate3d', a: vector, b: other, c: {node: 'multiply', a: 90, b: y}}};

const numbers = (() => {  // numbers of 10 bits after the point, which every float holds
    let state = 1;
    return () => (state = (state * 48271) % 2147483647) / 2147483647;
})();
const position = Array.from({length: 1000}, () => [0, 1, 2].map(() => Math.round((4 * numbers() - 2) * 1024 + 0.5) / 1024 + 1 / 4096));
const with_sines = ['wood', 'arithmetic', 'sines_1', 'sines_2', 'vector_rotate3d'];
// Centres of a picture's texels: between them a shader mixes codes of sRGB, and Burl light.
const texels = Array.from({length: 1000}, (_, k) => [(k % 37 - 8.5) / 16, (Math.floor(k / 37) - 5.5) / 16, 0]);
const pointsOf = (name) => name === 'picture' ? texels : position;
const channels = {base_color: ['base_color', 3], roughness: ['roughness', 1], emissive: ['emissive', 3], transmission: ['transmission', 1]};

rmSync(scratch, {recursive: true, force: true});
mkdirSync(scratch, {recursive: true});
const run = (...words) => execFileSync(burl, words, {encoding: 'utf8', maxBuffer: 1 << 26, stdio: ['ignore', 'pipe', 'pipe']});
run('bake', 'sample:cube', '-o', join(scratch, 'picture.png'), '--recipe', 'marble', '--size', '16', '--quiet');

function evaluated(recipe, points, channel, width) {
    const [head, ...rows] = run('eval', recipe, '--points', points, '--channel', channel).trim().split('\n').map((row) => row.split(','));
    const columns = (width === 3 ? ['red', 'green', 'blue'] : ['value']).map((name) => head.indexOf(name));
    return rows.map((row) => columns.map((column) => Number(row[column])));
}

// A mask cuts the opacity.
function opacity(file, points, material) {
    const cut = (alpha) => material?.alpha === 'mask' ? Number(alpha >= 0.5) : alpha;
    return evaluated(file, points, 'alpha', 1).map(([alpha]) => Array(3).fill(cut(alpha)));
}

// Colours of `burl eval` have the base colour's own alpha as a factor.
function unmultiplied(colors, alphas) {
    return colors.map((color, k) => color.map((c) => alphas[k][0] > 0 ? c / alphas[k][0] : 0));
}

const jobs = [], wanted = [];
for (const [name, recipe] of Object.entries(recipes)) {
    const file = join(scratch, `${name}.json`), document = join(scratch, `${name}.mtlx`);
    const points = join(scratch, `${name}.csv`);
    writeFileSync(points, pointsOf(name).map((p) => p.join(',')).join('\n') + '\n');
    writeFileSync(file, JSON.stringify({name, ...recipe}));
    writeFileSync(document, run('show', file, '--materialx'));
    if (run('show', file, '--materialx') !== readFileSync(document, 'utf8')) throw new Error(`${name}: the bytes differ from run to run`);
    const outputs = [...readFileSync(document, 'utf8').matchAll(/<output name="(\w+)"/g)].map(([, output]) => output);
    for (const output of outputs) {
        jobs.push({document, output: `NG_${name}/${output}`, points: {position: pointsOf(name)}});
        const values = output === 'opacity' ? opacity(file, points, recipe.material) : evaluated(file, points, ...channels[output]);
        const over = output === 'base_color' && outputs.includes('opacity') && !recipe.material?.opacity ? unmultiplied(values, evaluated(file, points, 'alpha', 1)) : values;
        wanted.push({name: `${name} ${output}`, values: over, most: with_sines.includes(name) ? 5e-4 : 2e-5});
    }
    jobs.push({document, output: name, points: {position: []}});
    wanted.push({name: `${name} compiled`, values: [], most: 0});
}
writeFileSync(join(scratch, 'jobs.json'), JSON.stringify(jobs));
let answer;
try {
    answer = execFileSync('node', [join(here, 'materialx_values.mjs'), modules, chromium, '--list', join(scratch, 'jobs.json')], {encoding: 'utf8', maxBuffer: 1 << 28});
} catch (error) {
    answer = error.stdout;
}
let bad = 0;
for (const [i, result] of JSON.parse(answer).entries()) {
    const {name, values, most} = wanted[i];
    const errors = result.error ? [] : values.map((v, k) => Math.max(...v.map((one, c) => Math.abs(one - result.values[k][c]) / Math.max(1, Math.abs(one)))));
    const far = errors.filter((error) => !(error <= most)).length;
    const usual = errors.toSorted((a, b) => a - b)[Math.max(errors.length - 3, 0)] ?? 0;
    const fails = result.error || !result.valid || far > 2;
    bad += fails ? 1 : 0;
    console.log(`${name}: ${result.error ?? `${far} of ${values.length} points beyond ${most}, else at most ${usual.toExponential(1)}`}${result.valid ? '' : ', not valid'}${fails ? '  BAD' : ''}`);
}
console.log(`${bad} of ${wanted.length} outputs differ`);
process.exit(bad ? 1 : 0);
