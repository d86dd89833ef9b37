// Bakes KTX2 files and reads them with three.js's parser, which knows nothing of Burl:
//   node read_ktx2.mjs MODULES BURL SCRATCH
// The texels of compressed levels must be those of stored ones. Exit 77: three is not there.
import {execFileSync} from 'node:child_process';
import {existsSync, mkdirSync, readFileSync, rmSync} from 'node:fs';
import {join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

const [modules, burl, scratch] = process.argv.slice(2);
const libraries = resolve(modules, 'node_modules/three/examples/jsm/libs');
if (!existsSync(join(libraries, 'ktx-parse.module.js'))) {
    console.log(`SKIPPED: no three in ${modules}/node_modules`);
    process.exit(77);
}
const library = (name) => import(pathToFileURL(join(libraries, name)));
const {read} = await library('ktx-parse.module.js');
const {ZSTDDecoder} = await library('zstddec.module.js');
const zstd = new ZSTDDecoder();
await zstd.init();

function expect(holds, what) {
    if (!holds) throw new Error(what);
}

/// The file's header and the texels of its levels.
function texture(path) {
    const file = read(new Uint8Array(readFileSync(path)));
    const packed = file.supercompressionScheme === 2;
    const levels = file.levels.map(({levelData, uncompressedByteLength}) =>
        Buffer.from(packed ? zstd.decode(levelData, uncompressedByteLength) : levelData));
    return {file, packed, levels};
}

rmSync(scratch, {recursive: true, force: true});
mkdirSync(scratch, {recursive: true});
const bake = (name, ...more) => execFileSync(burl, ['bake', 'sample:cube', '-o', join(scratch, name), '--recipe',
    'brushed-steel', '--size', '64', '--levels', 'all', '-q', ...more], {stdio: ['ignore', 'ignore', 'ignore']});
bake('packed.ktx2');
bake('stored.ktx2', '--picture-format', 'ktx2:0');

const srgb = 43, rgba = 37, red = 9;  // Vulkan's formats
for (const [end, format, texel] of [['', srgb, 4], ['_normal', rgba, 4], ['_roughness', red, 1]]) {
    const packed = texture(join(scratch, `packed${end}.ktx2`)), stored = texture(join(scratch, `stored${end}.ktx2`));
    expect(packed.packed && !stored.packed, `${end}: one is compressed`);
    for (const {file, levels} of [packed, stored]) {
        expect(file.vkFormat === format, `${end}: format ${file.vkFormat}`);
        expect(file.pixelWidth === 64 && file.pixelHeight === 64, `${end}: size`);
        expect(file.dataFormatDescriptor[0].transferFunction === (format === srgb ? 2 : 1), `${end}: transfer`);
        expect(file.dataFormatDescriptor[0].samples.length === texel, `${end}: samples`);
        expect(file.keyValue.KTXorientation === 'rd', `${end}: orientation`);
        expect(levels.length === 7, `${end}: ${levels.length} levels`);
        levels.forEach((level, l) => expect(level.length === texel * (64 >> l) ** 2, `${end}: level ${l}`));
    }
    packed.levels.forEach((level, l) => expect(level.equals(stored.levels[l]), `${end}: texels of level ${l}`));
    expect(new Set(packed.levels[0]).size > 8, `${end}: the texture is flat`);
}
console.log('KTX2 files are as three.js reads them');
