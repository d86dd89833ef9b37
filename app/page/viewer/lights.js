// The environments of `burl render` for three.js: a sky of Radiance's RGBE pixels, and its sun as a light of its own.
import * as THREE from 'three';
import {inflated, keptBytes} from './data.js';

// The sky's light as half floats, rows from above.
function skyTexture(rgbe, width, height) {
    const halves = new Uint16Array(4 * width * height), one = THREE.DataUtils.toHalfFloat(1);
    for (let i = 0; i < width * height; ++i) {
        const scale = rgbe[4 * i + 3] === 0 ? 0 : 2 ** (rgbe[4 * i + 3] - 136);
        const row = height - 1 - Math.floor(i / width), to = 4 * (row * width + i % width); // textures begin below
        for (let c = 0; c < 3; ++c) halves[to + c] = THREE.DataUtils.toHalfFloat(Math.min((rgbe[4 * i + c] + 0.5) * scale, 65504));
        halves[to + 3] = one;
    }
    const texture = new THREE.DataTexture(halves, width, height, THREE.RGBAFormat, THREE.HalfFloatType);
    texture.mapping = THREE.EquirectangularReflectionMapping;
    texture.minFilter = texture.magFilter = THREE.LinearFilter;
    texture.needsUpdate = true;
    return texture;
}

const made = new Map();

// The light of an entry of the page's contents: {map, sun}. Made once.
export async function lightOf(renderer, entry) {
    if (!made.has(entry.name)) {
        const pixels = await inflated(await keptBytes(entry.file));
        const sky = skyTexture(pixels, entry.width, entry.height), generator = new THREE.PMREMGenerator(renderer);
        const map = generator.fromEquirectangular(sky).texture;
        sky.dispose();
        generator.dispose();
        let sun = null;
        if (entry.sun) {
            sun = new THREE.DirectionalLight(new THREE.Color(...entry.sun.light), 1);
            sun.position.set(...entry.sun.direction);
        }
        made.set(entry.name, {map, sun});
    }
    return made.get(entry.name);
}
