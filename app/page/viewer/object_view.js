// A carved object under a light: the camera of `burl render` (azimuth, elevation, distance in radii of the object's sphere).
import * as THREE from 'three';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';
import {channelMaterial, texturesOf} from './channels.js';
import {edgesOf, linesOn} from './lines.js';

const degrees = Math.PI / 180;

// The sphere round all drawn points: its centre is the middle of their box.
function sphereOf(scene) {
    scene.updateMatrixWorld(true);
    const box = new THREE.Box3(), point = new THREE.Vector3(), place = new THREE.Matrix4(), meshes = [];
    const forPoints = (mesh, use) => {
        for (let copy = 0; copy < (mesh.count ?? 1); ++copy) {
            if (mesh.isInstancedMesh) mesh.getMatrixAt(copy, place);
            place.premultiply(mesh.matrixWorld);
            for (let i = 0; i < mesh.geometry.attributes.position.count; ++i) use(mesh.getVertexPosition(i, point).applyMatrix4(place));
            place.identity();
        }
    };
    scene.traverse((mesh) => mesh.isMesh && meshes.push(mesh));
    for (const mesh of meshes) forPoints(mesh, (p) => box.expandByPoint(p));
    const centre = box.getCenter(new THREE.Vector3());
    let radius = 0;
    for (const mesh of meshes) forPoints(mesh, (p) => { radius = Math.max(radius, p.distanceTo(centre)); });
    return {centre, radius: radius || 1};
}

export class ObjectView {
    constructor(renderer) {
        this.renderer = renderer;
        this.scene = new THREE.Scene();
        this.camera = new THREE.PerspectiveCamera(35, 1, 0.1, 10);
        this.meshes = [];
        this.sun = null;
    }

    // Takes a .glb's bytes in place of the object before. Fails where three.js cannot read them.
    async take(bytes) {
        const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
        const {scene, animations} = await new GLTFLoader().parseAsync(buffer, '');
        this.drop();
        this.object = scene;
        this.scene.add(scene);
        scene.traverse((mesh) => {
            if (!mesh.isMesh) return;
            mesh.frustumCulled = false;
            mesh.material.side = THREE.DoubleSide;
            this.meshes.push({mesh, material: mesh.material});
        });
        this.sphere = sphereOf(scene);
        this.mixer = animations.length ? new THREE.AnimationMixer(scene) : null;
        if (this.mixer) this.mixer.clipAction(animations[0]).play();
        this.playing = this.mixer !== null;
    }

    drop() {
        for (const {mesh, material} of this.meshes) {
            mesh.geometry.dispose();
            mesh.material.dispose();
            for (const texture of texturesOf(material)) texture.dispose();
            material.dispose();
        }
        if (this.object) this.scene.remove(this.object);
        this.meshes = [];
        this.lines = [];
    }

    get materials() { return [...new Set(this.meshes.map(({material}) => material))]; }
    get textures() { return [...new Set(this.materials.flatMap(texturesOf))]; }
    get triangles() {
        const of = (g) => (g.index ? g.index.count : g.attributes.position.count) / 3;
        return this.meshes.reduce((sum, {mesh}) => sum + of(mesh.geometry) * (mesh.count ?? 1), 0);
    }

    setChannel(channel) {
        for (const entry of this.meshes) {
            if (entry.mesh.material !== entry.material) entry.mesh.material.dispose();
            entry.mesh.material = channel.name === 'material' ? entry.material : channelMaterial(entry.material, channel);
        }
    }

    setLines(which) {
        for (const lines of this.lines ?? []) {
            lines.geometry.dispose();
            lines.removeFromParent();
        }
        this.lines = [];
        if (which === 'none') return;
        for (const {mesh} of this.meshes) {
            if (mesh.isSkinnedMesh || mesh.isInstancedMesh || mesh.morphTargetInfluences) continue; // lines have no pose
            const lines = linesOn(mesh.geometry, edgesOf(mesh.geometry, which));
            mesh.add(lines);
            this.lines.push(lines);
        }
    }

    // `light` is {map, sun}; `turn` in degrees about +y, as --light-turn has it.
    setLight(light, turn, behind) {
        if (this.sun) this.scene.remove(this.sun);
        this.sun = light.sun;
        this.scene.environment = light.map;
        this.scene.environmentRotation.set(0, turn * degrees, 0);
        this.scene.background = behind === 'light' ? light.map : null;
        this.scene.backgroundRotation.copy(this.scene.environmentRotation);
        this.scene.backgroundBlurriness = 0.15;
        if (!this.sun) return;
        this.sun.userData.direction ??= this.sun.position.clone();
        this.sun.position.copy(this.sun.userData.direction).applyAxisAngle(new THREE.Vector3(0, 1, 0), turn * degrees);
        this.scene.add(this.sun);
    }

    draw([azimuth, elevation, distance], width, height) {
        const {centre, radius} = this.sphere, a = azimuth * degrees, e = elevation * degrees, far = distance * radius;
        const camera = this.camera;
        camera.aspect = width / height;
        camera.near = Math.max(far - 1.01 * radius, far * 1e-3);
        camera.far = far + 1.01 * radius;
        camera.position.set(Math.cos(e) * Math.sin(a), Math.sin(e), Math.cos(e) * Math.cos(a)).multiplyScalar(far).add(centre);
        camera.lookAt(centre);
        camera.updateProjectionMatrix();
        this.renderer.render(this.scene, camera);
    }
}
