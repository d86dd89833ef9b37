// Holds documents that Burl read and wrote again to the documents themselves, by MaterialX's own shaders:
//   node materialx_round.mjs MODULES CHROMIUM BURL SCRATCH DOCUMENT.mtlx [PATTERN]
// Each material of DOCUMENT whose base colour is an output of a graph (and whose name matches PATTERN) must have, as
// `burl show DOCUMENT.mtlx#MATERIAL --materialx` writes it, that output's values at 200 points within 1e-4 (5e-4 where SwiftShader has a rough sine),
// but for two points at a jump.
import {execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

const [modules, chromium, burl, scratch, source, pattern] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url)), text = readFileSync(source, 'utf8');
const position = Array.from({length: 200}, (_, k) => [k * 7919, k * 104729, k * 1299709].map((n) => (n % 4096) / 1024 - 2 + 1 / 2048));
const points = {position, texcoord: position.map(([x, y]) => [x / 4 + 0.5, y / 4 + 0.5]), normal: position.map(() => [0, 0, 1])};

rmSync(scratch, {recursive: true, force: true});
mkdirSync(scratch, {recursive: true});
const jobs = [], names = [], refused = [];
for (const [, name, body] of text.matchAll(/<surfacematerial name="(\w+)"[^>]*>([^]*?)<\/surfacematerial>/g)) {
    const shader = body.match(/nodename="(\w+)"/)?.[1];
    const color = text.match(new RegExp(`name="${shader}"[^>]*>[^]*?"base_color"[^>]*nodegraph="(\\w+)"[^>]*output="(\\w+)"`));
    if (!color || (pattern && !new RegExp(pattern).test(name))) continue;
    const document = join(scratch, `${name}.mtlx`);
    try {
        writeFileSync(document, execFileSync(burl, ['show', `${source}#${name}`, '--materialx'], {encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe']}));
    } catch (error) {
        refused.push(error.stderr.trim());
        continue;
    }
    names.push(name);
    jobs.push({document: resolve(source), output: `${color[1]}/${color[2]}`, points});
    jobs.push({document, output: `${readFileSync(document, 'utf8').match(/<nodegraph name="(\w+)"/)[1]}/base_color`, points});
}
writeFileSync(join(scratch, 'jobs.json'), JSON.stringify(jobs));
let answer;
try {
    answer = execFileSync('node', [join(here, 'materialx_values.mjs'), modules, chromium, '--list', join(scratch, 'jobs.json')], {encoding: 'utf8', maxBuffer: 1 << 28});
} catch (error) {
    answer = error.stdout;
}
const results = JSON.parse(answer);
let bad = 0;
for (const [i, name] of names.entries()) {
    const [was, is] = results.slice(2 * i, 2 * i + 2), failure = was.error ?? is.error;
    const rough = /\b(sin|cos|tan|asin|acos|rotate2d|rotate3d|hsvadjust)\b/.test(readFileSync(jobs[2 * i + 1].document, 'utf8')) ? 5e-4 : 1e-4;
    const off = failure ? [] : was.values.map((v, k) => Math.max(...v.map((one, c) => Math.abs(one - is.values[k][c]) / Math.max(1, Math.abs(one)))));
    const far = off.filter((one) => !(one <= rough)).length, fails = failure || !is.valid || far > 2;
    bad += fails ? 1 : 0;
    console.log(`${name}: ${failure ?? `${far} of 200 points beyond ${rough}, usually ${off.toSorted((a, b) => a - b)[197].toExponential(1)}`}${fails ? '  BAD' : ''}`);
}
for (const sentence of refused) console.log(`refused: ${sentence}`);
console.log(`${bad} of ${names.length} differ, ${refused.length} refused`);
process.exit(bad ? 1 : 0);
