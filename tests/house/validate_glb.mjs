// Runs the Khronos glTF validator over files and fails on any error or warning:
//   node validate_glb.mjs MODULES FILE...
// MODULES is the folder whose node_modules holds gltf-validator. Exit 77: it is not there.
import {createRequire} from 'node:module';
import {readFileSync} from 'node:fs';
import {basename, dirname, join, resolve} from 'node:path';

const [modules, ...files] = process.argv.slice(2);
let validator;
try {
    validator = createRequire(resolve(modules, 'x.js'))('gltf-validator');
} catch {
    console.log(`SKIPPED: no gltf-validator in ${modules}/node_modules`);
    process.exit(77);
}

async function validate(path) {
    const report = await validator.validateBytes(new Uint8Array(readFileSync(path)), {
        uri: basename(path),
        externalResourceFunction: async (uri) =>
            new Uint8Array(readFileSync(join(dirname(path), decodeURIComponent(uri)))),
    });
    const {numErrors, numWarnings, messages} = report.issues;
    const infos = [...new Set(messages.filter((m) => m.severity > 1).map((m) => m.code))];
    console.log(`${numErrors} errors, ${numWarnings} warnings  ${path}  ${infos.join(' ')}`);
    for (const m of messages.filter((m) => m.severity < 2)) {
        console.log(`    ${m.code} ${m.pointer ?? ''}: ${m.message}`);
    }
    return numErrors + numWarnings === 0 && report.info.version === '2.0';
}

let good = 0;
for (const file of files) {
    good += await validate(file).catch((e) => (console.log(`${file}: ${e}`), false));
}
console.log(`${good} of ${files.length} files without error or warning (validator ${validator.version()})`);
process.exit(files.length > 0 && good === files.length ? 0 : 1);
