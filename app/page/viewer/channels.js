// The channels of a glTF material as pictures: a texture's red, green, blue or alpha times the material's factor, in a MeshBasic
// material that keeps skins and targets. Colours are shown encoded as sRGB; numbers and normals as they are stored.
import * as THREE from 'three';

const red = [1, 0, 0, 0], green = [0, 1, 0, 0], blue = [0, 0, 1, 0], alpha = [0, 0, 0, 1];
const white = new THREE.Color(1, 1, 1);

// Each: name, title, the material's texture, its component (null: a colour), and its factor.
const table = [
    ['base', 'Base colour', 'map', null, (m) => m.color],
    ['opacity', 'Opacity', 'map', alpha, (m) => m.opacity],
    ['metallic', 'Metallic', 'metalnessMap', blue, (m) => m.metalness],
    ['roughness', 'Roughness', 'roughnessMap', green, (m) => m.roughness],
    ['normal', 'Normals', 'normalMap', 'raw', () => 1],
    ['occlusion', 'Occlusion', 'aoMap', red, () => 1],
    ['emission', 'Emission', 'emissiveMap', null, (m) => m.emissive?.clone().multiplyScalar(m.emissiveIntensity)],
    ['coat', 'Coat', 'clearcoatMap', red, (m) => m.clearcoat],
    ['coat-roughness', 'Coat roughness', 'clearcoatRoughnessMap', green, (m) => m.clearcoatRoughness],
    ['coat-normal', 'Coat normals', 'clearcoatNormalMap', 'raw', () => 1],
    ['transmission', 'Transmission', 'transmissionMap', red, (m) => m.transmission],
    ['thickness', 'Thickness', 'thicknessMap', green, () => 1],
    ['sheen', 'Sheen', 'sheenColorMap', null, (m) => m.sheenColor],
    ['sheen-roughness', 'Sheen roughness', 'sheenRoughnessMap', alpha, (m) => m.sheenRoughness],
    ['specular', 'Specular', 'specularIntensityMap', alpha, (m) => m.specularIntensity],
    ['specular-color', 'Specular colour', 'specularColorMap', null, (m) => m.specularColor],
    ['iridescence', 'Iridescence', 'iridescenceMap', red, (m) => m.iridescence],
    ['film', 'Film thickness', 'iridescenceThicknessMap', green, () => 1],
    ['anisotropy', 'Anisotropy', 'anisotropyMap', 'raw', () => 1],
].map(([name, title, texture, component, factor]) => ({name, title, texture, component, factor}));

// The channels that any of the materials has a texture for, after the lit material, and the level that a lookup takes.
export function channelsOf(materials) {
    const there = table.filter((channel) => materials.some((m) => m[channel.texture] &&
        (channel.name !== 'opacity' || m.transparent || m.alphaTest > 0)));
    return [{name: 'material', title: 'Material, lit'}, ...there, {name: 'level', title: 'Level in use'}];
}

// The texture of a material that a channel shows; the lit material and the level show the first there is.
export function textureOf(material, channel) {
    if (channel.texture) return material[channel.texture] ?? null;
    return table.map((one) => material[one.texture]).find((texture) => texture) ?? null;
}

export function texturesOf(material) {
    return [...new Set(table.map((one) => material[one.texture]).filter((texture) => texture))];
}

export const levelColors = ['#f4f1ea', '#8fce7b', '#3fa7a0', '#3f78d8', '#8a56c9', '#d64c8d', '#e3693b', '#5b4636'];

// GLSL: what a channel shows of a texel; `level` is the MIP level that a lookup takes.
export const shownText = `
uniform vec4 burlComponent, burlFactor;
uniform int burlKind; // 0 a colour, 1 a number, 2 as it is stored, 3 the level
uniform vec3 burlLevels[${levelColors.length}];
vec3 burlShown(vec4 texel, float level) {
    if (burlKind == 0) return texel.rgb * burlFactor.rgb;
    if (burlKind == 1) return vec3(dot(texel, burlComponent) * burlFactor.x);
    if (burlKind == 2) return texel.rgb;
    float most = float(burlLevels.length() - 1);
    int low = int(min(floor(level), most)), high = int(min(floor(level) + 1.0, most));
    return mix(burlLevels[low], burlLevels[high], fract(level));
}
vec3 burlOnScreen(vec3 shown) {
    bool linear = burlKind == 0;
    vec3 encoded = mix(1.055 * pow(max(shown, 0.0031308), vec3(1.0 / 2.4)) - 0.055, 12.92 * shown, lessThan(shown, vec3(0.0031308)));
    return linear ? encoded : shown;
}`;

export const levelText = `
float burlLevel(sampler2D image, vec2 uv) {
    vec2 size = vec2(textureSize(image, 0)), dx = dFdx(uv) * size, dy = dFdy(uv) * size;
    return 0.5 * log2(max(max(dot(dx, dx), dot(dy, dy)), 1.0));
}`;

// The uniforms of shownText for a channel of a material.
export function uniformsOf(material, channel) {
    const component = Array.isArray(channel.component) ? channel.component : [0, 0, 0, 0];
    const kind = channel.name === 'level' ? 3 : channel.component === 'raw' ? 2 : channel.component ? 1 : 0;
    const factor = channel.factor?.(material) ?? white;
    const four = factor.isColor ? [factor.r, factor.g, factor.b, 1] : [factor, factor, factor, 1];
    return {
        burlComponent: {value: new THREE.Vector4(...component)},
        burlFactor: {value: new THREE.Vector4(...four)},
        burlKind: {value: kind},
        burlLevels: {value: levelColors.map((text) => new THREE.Color().setStyle(text, THREE.LinearSRGBColorSpace))},
    };
}

// A material that shows a channel of another one.
export function channelMaterial(material, channel) {
    const texture = textureOf(material, channel);
    const shown = new THREE.MeshBasicMaterial({map: texture, toneMapped: false, side: THREE.DoubleSide});
    const uniforms = uniformsOf(material, channel);
    shown.onBeforeCompile = (shader) => {
        Object.assign(shader.uniforms, uniforms);
        const read = texture ? 'texture2D(map, vMapUv)' : 'vec4(1.0)', level = texture ? 'burlLevel(map, vMapUv)' : '0.0';
        shader.fragmentShader = shader.fragmentShader
            .replace('void main() {', `${shownText}${levelText}\nvoid main() {`)
            .replace('#include <map_fragment>', `diffuseColor = vec4(burlShown(${read}, ${level}), 1.0);`)
            .replace('#include <color_fragment>', '')
            .replace('#include <colorspace_fragment>', 'gl_FragColor.rgb = burlOnScreen(gl_FragColor.rgb);');
    };
    shown.customProgramCacheKey = () => `burl ${texture ? 'texture' : 'plain'}`;
    return shown;
}
