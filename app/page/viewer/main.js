// The page that `burl page` writes: carved objects under Burl's lights, their channels, MIP levels and atlases.
import * as THREE from 'three';
import {AtlasView} from './atlas_view.js';
import {channelsOf, textureOf} from './channels.js';
import {Controls, element, galleryOf} from './controls.js';
import {bytesOfFile} from './data.js';
import {lightOf} from './lights.js';
import {ObjectView} from './object_view.js';
import {hashOf, next, start, stateOf} from './state.js';
import style from './page.css';

const contents = JSON.parse(document.getElementById('burl-contents').textContent);
const root = document.documentElement;
let state = stateOf(location.hash), drawn = {}, channels = [], asked = false, lastTime = 0, opening = '', telling = 0, told = '';

document.head.append(element('style', {}, style));
const controls = new Controls(contents, ask);
const canvas = element('canvas', {id: 'view', tabindex: 0, role: 'application', 'aria-label': 'Object; arrow keys turn it'});
const stage = element('main', {id: 'stage'}, controls.bar, canvas, controls.facts, controls.legend);
const gallery = galleryOf(contents, (name) => ask({asset: name}));
document.body.append(gallery, stage, controls.status, controls.help);

let renderer, object, atlas, size = [0, 0]; // size: the canvas in pixels of the screen

function startDrawing() {
    renderer = new THREE.WebGLRenderer({canvas, antialias: true});
    renderer.toneMapping = THREE.NeutralToneMapping;
    renderer.setScissorTest(true);
    object = new ObjectView(renderer);
    atlas = new AtlasView(renderer);
    const observer = new ResizeObserver(([{devicePixelContentBoxSize: exact}]) => {
        const scale = devicePixelRatio, [box] = exact ?? [{inlineSize: canvas.clientWidth * scale, blockSize: canvas.clientHeight * scale}];
        size = [Math.round(box.inlineSize), Math.round(box.blockSize)];
        redraw();
    });
    try {
        observer.observe(canvas, {box: 'device-pixel-content-box'});
    } catch { // browsers without it round
        observer.observe(canvas);
    }
}

function tell() {
    told = hashOf(state);
    location.replace(told);
}

// Takes what a visitor asked for into the state.
function ask(changes) {
    const other = changes.asset !== undefined && changes.asset !== state.asset;
    state = {...state, ...(other ? {material: 0} : {}), ...changes};
    clearTimeout(telling);
    telling = setTimeout(tell, 200); // browsers refuse more of them while somebody drags
    follow();
}

const channel = () => channels.find(({name}) => name === state.channel) ?? channels[0];
const shownMaterials = () => atlas.candidates(object, channel());

// The number of levels that lookups can take.
function levels() {
    const usable = object.textures.filter((texture) => texture.generateMipmaps || texture.mipmaps?.length > 1);
    const side = Math.max(1, ...usable.map((texture) => Math.max(texture.image?.width ?? 1, texture.image?.height ?? 1)));
    return 1 + Math.floor(Math.log2(side));
}

// Lets every lookup read one level alone, by the sampler's own bounds.
function holdLevel() {
    const gl = renderer.getContext(), [low, high] = state.level === 'auto' ? [-1000, 1000] : [state.level, state.level];
    for (const texture of object.textures) {
        renderer.initTexture(texture);
        renderer.state.bindTexture(gl.TEXTURE_2D, renderer.properties.get(texture).__webglTexture);
        gl.texParameterf(gl.TEXTURE_2D, gl.TEXTURE_MIN_LOD, low);
        gl.texParameterf(gl.TEXTURE_2D, gl.TEXTURE_MAX_LOD, high);
    }
    renderer.state.unbindTexture();
}

function factsOf(asset) {
    const count = (n) => n.toLocaleString('en');
    const sizes = new Set(object.textures.map((t) => `${t.image.width} x ${t.image.height}`));
    const parts = [`${count(object.triangles)} triangles`, `${count(asset.bytes)} bytes`];
    if (sizes.size > 0) parts.splice(1, 0, `${object.textures.length} textures of ${[...sizes].join(', ')}`);
    return parts.join(' · ');
}

async function open(asset) {
    opening = asset.name;
    root.dataset.state = 'loading';
    controls.say(`${asset.name} is being read.`);
    try {
        const bytes = await bytesOfFile(asset.file);
        if (opening !== asset.name) return;
        await object.take(bytes);
        URL.revokeObjectURL(controls.save.href);
        controls.save.href = URL.createObjectURL(new Blob([bytes], {type: 'model/gltf-binary'}));
        controls.save.download = `${asset.name}.glb`;
        channels = channelsOf(object.materials);
        controls.facts.textContent = factsOf(asset);
        atlas.reset();
        drawn = {asset: asset.name};
        controls.say('');
        await follow();
    } catch (error) {
        controls.say(`${asset.name} cannot be shown: ${error.message}`, true);
        root.dataset.state = 'failed';
    }
}

// Brings what is drawn to the state; work is done for what differs alone.
async function follow() {
    const asset = contents.assets.find(({name}) => name === state.asset), chosen = document.activeElement?.closest('#gallery');
    gallery.hidden = !!asset;
    stage.hidden = !asset;
    if (asset && chosen) canvas.focus();
    document.title = asset ? `${asset.name} - ${contents.title}` : contents.title;
    if (!asset) {
        gallery.querySelector(`[data-name="${CSS.escape(drawn.asset ?? '')}"]`)?.focus();
        drawn = {};
        root.dataset.state = 'gallery';
        return;
    }
    if (drawn.asset !== asset.name) return opening === asset.name && root.dataset.state === 'loading' ? undefined : open(asset);
    const light = contents.lights.find(({name}) => name === state.light) ?? contents.lights[0];
    const made = await lightOf(renderer, light);
    if (drawn.asset !== state.asset) return;
    state.light = light.name;
    state.channel = channel().name;
    if (state.level !== 'auto') state.level = Math.min(state.level, levels() - 1);
    const differs = (...names) => names.some((name) => drawn[name] !== state[name]);
    if (differs('light', 'turn', 'behind')) object.setLight(made, state.turn, state.behind);
    if (differs('channel')) object.setChannel(channel());
    if (differs('lines')) object.setLines(state.lines);
    if (differs('level')) holdLevel();
    state.material %= Math.max(shownMaterials().length, 1);
    const inAtlas = shownMaterials()[state.material];
    if (differs('channel', 'level') || drawn.inAtlas !== inAtlas) atlas.show(object, inAtlas, channel(), state.level);
    if (differs('channel', 'lines') || drawn.inAtlas !== inAtlas) atlas.setLines(object, inAtlas, channel(), state.lines);
    drawn = {...state, inAtlas};
    controls.update(state, channels, levels());
    redraw();
    root.dataset.state = 'ready';
}

function redraw() {
    if (asked) return;
    asked = true;
    requestAnimationFrame(draw);
}

// The parts of the canvas in pixels of the screen: x, y from below, width, height.
function parts() {
    const [w, h] = size;
    if (state.show === 'object') return {object: [0, 0, w, h]};
    if (state.show === 'atlas') return {atlas: [0, 0, w, h]};
    const half = Math.floor(Math.max(w, h) / 2);
    if (w >= h) return {object: [0, 0, half, h], atlas: [half, 0, w - half, h]};
    return {object: [0, half, w, h - half], atlas: [0, 0, w, half]};
}

function draw(time) {
    asked = false;
    if (!drawn.light || stage.hidden || size[0] * size[1] === 0) return;
    if (canvas.width !== size[0] || canvas.height !== size[1]) renderer.setSize(...size, false);
    renderer.setClearColor(getComputedStyle(canvas).backgroundColor);
    for (const [name, [x, y, width, height]] of Object.entries(parts())) {
        renderer.setViewport(x, y, width, height);
        renderer.setScissor(x, y, width, height);
        if (name === 'object') object.draw(state.view, width, height);
        else atlas.draw(width, height);
    }
    root.dataset.frames = Number(root.dataset.frames ?? 0) + 1;
    if (!object.playing) return;
    object.mixer.update(Math.min((time - lastTime) / 1000, 0.1));
    lastTime = time;
    redraw();
}

// Turns the object by degrees.
function turn(right, up) {
    const [azimuth, elevation, distance] = state.view;
    const turned = ((azimuth + right) % 360 + 360) % 360;
    ask({view: [turned, Math.min(Math.max(elevation + up, -89), 89), distance]});
}

function scale(factor, inAtlas) {
    if (inAtlas) {
        atlas.scaleBy(1 / factor);
        return redraw();
    }
    const [azimuth, elevation, distance] = state.view;
    ask({view: [azimuth, elevation, Math.min(Math.max(distance * factor, 1.2), 100)]});
}

// Moves by steps: the atlas where it stands alone, else the object.
function move(right, up, fine) {
    const step = fine ? 2 : 10;
    if (state.show !== 'atlas') return turn(-right * step, up * step);
    atlas.pan(-right * 4 * step, up * 4 * step, ...size);
    redraw();
}

function reset() {
    atlas.reset();
    ask({view: start.view, turn: start.turn});
}

function cycle(key, names, by) {
    ask({[key]: next(names, state[key], by)});
}

const cycles = {
    c: (by) => cycle('channel', channels.map(({name}) => name), by),
    e: (by) => cycle('light', contents.lights.map(({name}) => name), by),
    l: (by) => cycle('level', ['auto', ...Array(levels()).keys()], by),
    a: (by) => cycle('show', ['object', 'both', 'atlas'], by),
    w: (by) => cycle('lines', ['none', 'charts', 'triangles'], by),
    b: (by) => cycle('behind', ['grey', 'light'], by),
    n: (by) => cycle('asset', contents.assets.map(({name}) => name), by),
    m: (by) => ask({material: state.material + by + shownMaterials().length}),
    g: () => contents.assets.length > 1 && ask({asset: ''}),
};

const moves = {ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};

// Does what a key is for; whether it is for anything.
function pressed({key, shiftKey}) {
    if (moves[key]) move(...moves[key], shiftKey);
    else if (key === '+' || key === '=') scale(1 / 1.15, state.show === 'atlas');
    else if (key === '-') scale(1.15, state.show === 'atlas');
    else if (key === '0' || key === 'Home') reset();
    else if (key === '[' || key === ']') ask({turn: (state.turn + (key === ']' ? 15 : 345)) % 360});
    else if (key === '?') controls.help.showModal();
    else if (key === ' ' && object.mixer) {
        object.playing = !object.playing;
        lastTime = performance.now();
        redraw();
    } else if (cycles[key.toLowerCase()]) cycles[key.toLowerCase()](shiftKey ? -1 : 1);
    else return false;
    return true;
}

document.addEventListener('keydown', (event) => {
    if (stage.hidden || controls.help.open || event.ctrlKey || event.altKey || event.metaKey) return;
    if (root.dataset.state !== 'ready' && !/^[gnGN]$/.test(event.key)) return;
    const inList = event.target.tagName === 'SELECT', ofLists = moves[event.key] || event.key === 'Home' || event.key === ' ';
    if ((inList || event.target.tagName === 'BUTTON' || event.target.tagName === 'A') && ofLists) return;
    if (pressed(event)) event.preventDefault();
});

function isInAtlas(event) {
    const {left, bottom} = canvas.getBoundingClientRect(), [x, y, w, h] = parts().atlas ?? [0, 0, 0, 0];
    const px = (event.clientX - left) * devicePixelRatio, py = (bottom - event.clientY) * devicePixelRatio;
    return px >= x && px < x + w && py >= y && py < y + h;
}

const held = new Map(); // pointers that are down

canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    held.set(event.pointerId, {x: event.clientX, y: event.clientY, inAtlas: isInAtlas(event)});
});
canvas.addEventListener('pointermove', (event) => {
    const last = held.get(event.pointerId);
    if (!last) return;
    const dx = event.clientX - last.x, dy = event.clientY - last.y, others = [...held].filter(([id]) => id !== event.pointerId);
    if (others.length === 1) { // two fingers
        const [, {x, y}] = others[0];
        scale(Math.hypot(last.x - x, last.y - y) / Math.max(Math.hypot(event.clientX - x, event.clientY - y), 1), last.inAtlas);
    } else if (last.inAtlas) {
        const [, , w, h] = parts().atlas ?? [0, 0, 1, 1];
        atlas.pan(dx * devicePixelRatio, dy * devicePixelRatio, w, h);
        redraw();
    } else {
        turn(-dx * 0.4, dy * 0.4);
    }
    Object.assign(last, {x: event.clientX, y: event.clientY});
});
for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, (event) => held.delete(event.pointerId));
canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    scale(Math.exp(event.deltaY * 0.001), isInAtlas(event));
}, {passive: false});
canvas.addEventListener('dblclick', reset);
window.addEventListener('hashchange', () => {
    if (location.hash === told || location.hash === hashOf(state)) return; // the page's own, perhaps overtaken
    state = stateOf(location.hash);
    follow();
});

try {
    startDrawing();
    if (state.asset === '' && contents.assets.length === 1) state.asset = contents.assets[0].name;
    follow();
} catch (error) {
    controls.say(`This browser cannot draw the objects: ${error.message}`, true);
    root.dataset.state = 'failed';
}
