// The page of three_js.mjs: draws the files that /jobs names with three.js under an environment map and posts their linear
// colours back. Camera and samples are those of `burl render` (docs/reference/rendering.md).
import * as THREE from 'three';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';
import {HDRLoader} from 'three/addons/loaders/HDRLoader.js';

const degrees = Math.PI / 180;

// The sphere round all drawn points: its centre is the middle of their box.
function sphereOf(scene) {
    scene.updateMatrixWorld(true);
    const points = [];
    scene.traverse((mesh) => {
        if (!mesh.isMesh) return;
        const position = mesh.geometry.attributes.position;
        for (let i = 0; i < position.count; ++i) { // as targets and skin move it
            points.push(mesh.getVertexPosition(i, new THREE.Vector3()).applyMatrix4(mesh.matrixWorld));
        }
    });
    const centre = new THREE.Box3().setFromPoints(points).getCenter(new THREE.Vector3());
    return {centre, radius: Math.max(...points.map((p) => p.distanceTo(centre)))};
}

function cameraOf({centre, radius}, {azimuth, elevation, distance, width, height}) {
    const a = azimuth * degrees, e = elevation * degrees, far = distance * radius;
    const camera = new THREE.PerspectiveCamera(35, width / height, far - 1.01 * radius, far + 1.01 * radius);
    camera.position.set(Math.cos(e) * Math.sin(a), Math.sin(e), Math.cos(e) * Math.cos(a)).multiplyScalar(far).add(centre);
    camera.lookAt(centre);
    return camera;
}

function filterAnisotropically(map, anisotropy) {
    Object.assign(map, {anisotropy, minFilter: THREE.LinearMipmapLinearFilter, generateMipmaps: true, needsUpdate: true});
}

async function draw(renderer, environment, job) {
    const {scene: object, animations} = await new GLTFLoader().loadAsync(job.url);
    const scene = new THREE.Scene();
    scene.add(object);
    scene.environment = environment;
    object.traverse((mesh) => {
        if (!mesh.isMesh) return;
        if (!environment) mesh.material = new THREE.MeshBasicMaterial({map: mesh.material.map});
        mesh.material.side = THREE.DoubleSide;
        if (job.anisotropy) filterAnisotropically(mesh.material.map, job.anisotropy);
        mesh.frustumCulled = false;
    });
    if (job.time !== null) {
        const mixer = new THREE.AnimationMixer(object);
        mixer.clipAction(animations[0]).play();
        mixer.setTime(Number(job.time));
        object.updateMatrixWorld(true);
    }
    const n = job.supersample, width = n * job.width, height = n * job.height;
    const target = new THREE.WebGLRenderTarget(width, height, {type: THREE.FloatType, depthBuffer: true});
    renderer.setRenderTarget(target);
    renderer.setClearColor(0x000000, 0);
    renderer.clear();
    renderer.render(scene, cameraOf(sphereOf(object), job));
    const pixels = new Float32Array(4 * width * height);
    renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
    target.dispose();
    return pixels;
}

async function environmentOf(renderer, url) {
    const map = await new HDRLoader().setDataType(THREE.FloatType).loadAsync(url);
    map.mapping = THREE.EquirectangularReflectionMapping;
    return new THREE.PMREMGenerator(renderer).fromEquirectangular(map).texture;
}

async function post(path, body) {
    await fetch(path, {method: 'POST', body});
}

try {
    const {environment: url, jobs} = await (await fetch('/jobs')).json();
    const renderer = new THREE.WebGLRenderer({antialias: false, alpha: true});
    const environment = url ? await environmentOf(renderer, url) : null;
    for (const [number, job] of jobs.entries()) {
        await post(`/picture/${number}`, (await draw(renderer, environment, job)).buffer);
    }
    await post('/done', '');
} catch (error) {
    await post('/failed', String(error.stack ?? error));
}
