// The page of samplers.mjs: three.js's own samplers look up what /file/NAME.lookups asks for; every lookup is a square of two by
// two pixels, in whose lower left one it lies at its place, and the others a step away.
import * as THREE from 'three';

const across = 128; // lookups in a row of the target

const floats = async (path) => new Float32Array(await (await fetch(path)).arrayBuffer());

async function textureOf(name, sides) {
    const texels = await floats(`/file/${name}.levels`), levels = [];
    let from = 0;
    for (const side of sides) {
        levels.push({data: texels.subarray(from, from + 4 * side * side), width: side, height: side});
        from += 4 * side * side;
    }
    const texture = new THREE.DataTexture(levels[0].data, sides[0], sides[0], THREE.RGBAFormat, THREE.FloatType);
    texture.mipmaps = levels;
    texture.generateMipmaps = false;
    texture.minFilter = THREE.LinearMipmapLinearFilter;
    texture.magFilter = THREE.LinearFilter;
    return texture;
}

function placesOf(lookups) {
    const rows = Math.ceil(lookups.length / (8 * across)), data = new Float32Array(8 * across * rows);
    data.set(lookups);
    const places = new THREE.DataTexture(data, 2 * across, rows, THREE.RGBAFormat, THREE.FloatType);
    places.needsUpdate = true;
    return {places, rows};
}

const vertexShader = 'in vec3 position; void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }';
const fragmentShader = `
    precision highp float;
    uniform highp sampler2D map;
    uniform highp sampler2D places;
    out vec4 color;
    void main() {
        ivec2 pixel = ivec2(gl_FragCoord.xy);
        vec4 a = texelFetch(places, ivec2(2 * (pixel.x / 2), pixel.y / 2), 0);
        vec4 b = texelFetch(places, ivec2(2 * (pixel.x / 2) + 1, pixel.y / 2), 0);
        color = texture(map, a.xy + float(pixel.x % 2) * a.zw + float(pixel.y % 2) * b.xy);
    }`;

async function lookUp(renderer, name, anisotropy) {
    const {sides, points, rows: views} = await (await fetch(`/file/${name}.json`)).json();
    const map = await textureOf(name, sides), {places, rows} = placesOf(await floats(`/file/${name}.lookups`));
    map.anisotropy = anisotropy;
    map.needsUpdate = true;
    const material = new THREE.RawShaderMaterial(
        {glslVersion: THREE.GLSL3, vertexShader, fragmentShader, uniforms: {map: {value: map}, places: {value: places}}});
    const scene = new THREE.Scene();
    scene.add(new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material));
    scene.children[0].frustumCulled = false;
    const width = 2 * across, height = 2 * rows;
    const target = new THREE.WebGLRenderTarget(width, height, {type: THREE.FloatType, depthBuffer: false});
    renderer.setRenderTarget(target);
    renderer.render(scene, new THREE.Camera());
    const pixels = new Float32Array(4 * width * height), values = new Float32Array(4 * points * views.length);
    renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
    for (let i = 0; i < points * views.length; ++i) {
        const at = 4 * (2 * Math.floor(i / across) * width + 2 * (i % across));
        values.set(pixels.subarray(at, at + 4), 4 * i);
    }
    return values;
}

try {
    const {names, anisotropies} = await (await fetch('/jobs')).json();
    const renderer = new THREE.WebGLRenderer({antialias: false});
    if (renderer.capabilities.getMaxAnisotropy() < Math.max(...anisotropies)) throw new Error('no anisotropic filtering');
    for (const name of names) {
        for (const anisotropy of anisotropies) {
            await fetch(`/values/${name}/${anisotropy}`, {method: 'POST', body: (await lookUp(renderer, name, anisotropy)).buffer});
        }
    }
    await fetch('/done', {method: 'POST', body: ''});
} catch (error) {
    await fetch('/failed', {method: 'POST', body: String(error.stack ?? error)});
}
