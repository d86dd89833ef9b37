// The shaders that MaterialX's own generator (npm @needle-tools/materialx, WebAssembly) writes for outputs of documents.
import {createRequire} from 'node:module';
import {readFileSync} from 'node:fs';
import {dirname, join, resolve} from 'node:path';

// The library's module, its ESSL generator and the standard node definitions; `modules` is the folder whose node_modules holds it.
export async function loadMaterialX(modules) {
    const bin = resolve(modules, 'node_modules/@needle-tools/materialx/bin');
    globalThis.require = createRequire(import.meta.url);  // the module is written for CommonJS
    globalThis.__dirname = bin;
    globalThis.__filename = join(bin, 'JsMaterialXGenShader.js');
    const {default: create} = await import(globalThis.__filename);
    const data = join(bin, 'JsMaterialXGenShader.data.txt');
    const mx = await create({locateFile: (name) => name.endsWith('.data') ? data : join(bin, name)});
    const generator = mx.EsslShaderGenerator.create();
    const context = new mx.GenContext(generator);
    const library = mx.loadStandardLibraries(context);
    const options = context.getOptions();
    options.shaderInterfaceType = mx.ShaderInterfaceType.SHADER_INTERFACE_COMPLETE;
    options.hwSrgbEncodeOutput = false;
    options.hwSpecularEnvironmentMethod = mx.HwSpecularEnvironmentMethod.SPECULAR_ENVIRONMENT_FIS;
    return {mx, generator, context, library};
}

// Exceptions of C++ arrive as numbers.
function said(mx, error) {
    return typeof error === 'number' ? String(mx.getExceptionMessage(error)) : String(error.message ?? error);
}

function readDocument({mx, library}, file, text) {
    const document = mx.createDocument();
    return mx.readFromXmlString(document, text, dirname(resolve(file))).then(() => {
        document.setDataLibrary(library);
        return document;
    });
}

// The generator draws a boolean black: such an output goes through a node that makes a number of it.
function asNumber(document, element) {
    const graph = element.getParent();
    const convert = graph.addChildOfCategory('convert', 'burl_number');
    convert.setAttribute('type', 'float');
    const input = convert.addInput('in', 'boolean');
    for (const key of ['nodename', 'output', 'interfacename', 'nodegraph']) {
        if (element.hasAttribute(key)) input.setAttribute(key, element.getAttribute(key));
    }
    if (element.getCategory() !== 'output') input.setAttribute('nodename', element.getName());
    const output = graph.addOutput('burl_number_out', 'float');
    output.setAttribute('nodename', 'burl_number');
    return output;
}

function plain(value) {
    const data = value?.getData();
    if (data === undefined || data === null || typeof data === 'number' || typeof data === 'string') return data ?? null;
    if (typeof data === 'boolean') return Number(data);
    if (data.numRows) {
        const items = [];
        for (let i = 0; i < data.numRows(); ++i) for (let k = 0; k < data.numColumns(); ++k) items.push(data.getItem(i, k));
        return items;
    }
    return data.data ? [...data.data()] : [...data];
}

function uniformsOf(shader) {
    const found = [];
    for (const stage of ['vertex', 'pixel']) {
        for (const block of Object.values(shader.getStage(stage).getUniformBlocks())) {
            for (let i = 0; i < block.size(); ++i) {
                const port = block.get(i);
                const type = port.getType().getName?.() ?? String(port.getType());
                found.push({name: port.getVariable(), type, value: plain(port.getValue())});
            }
        }
    }
    return found;
}

// The shader of the output, node or material at `path` in the document `file`:
// {valid, type, vertex, pixel, uniforms: [{name, type, value}]}, or {valid, error}.
export async function shaderOf(library, file, path) {
    const {mx, generator, context} = library;
    let valid = null;
    try {
        const document = await readDocument(library, file, readFileSync(file, 'utf8'));
        valid = document.validate();
        const element = document.getDescendant(path);
        if (!element) return {valid, error: `${file} has no element '${path}'.`};
        const type = element.getType();
        const target = type === 'boolean' ? asNumber(document, element) : element;
        const shader = generator.generate('shader', target, context);
        return {valid, type, vertex: shader.getSourceCode('vertex'), pixel: shader.getSourceCode('pixel'), uniforms: uniformsOf(shader)};
    } catch (error) {
        return {valid, error: `${file} ${path}: ${said(mx, error)}`};
    }
}
