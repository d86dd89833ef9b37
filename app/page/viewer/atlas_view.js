// A texture of the object as it lies in its file, texel by texel, with the charts' borders.
import * as THREE from 'three';
import {levelText, shownText, textureOf, uniformsOf} from './channels.js';
import {edgesOf, linesInAtlas} from './lines.js';

const vertexText = `
out vec2 place;
void main() {
    place = vec2(position.x, 1.0 - position.y);
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

// A texel that covers more than a pixel is drawn as a square; smaller ones are filtered.
const fragmentText = `
uniform sampler2D image;
uniform int imageLevel; // -1: by the pixel
in vec2 place;
${shownText}${levelText}
void main() {
    int level = max(imageLevel, 0);
    vec2 size = vec2(textureSize(image, level)), across = fwidth(place) * size;
    ivec2 at = ivec2(clamp(floor(place * size), vec2(0.0), size - 1.0));
    bool large = max(across.x, across.y) < 1.0;
    vec4 texel = large ? texelFetch(image, at, level) : imageLevel < 0 ? texture(image, place) : textureLod(image, place, float(level));
    gl_FragColor = vec4(burlOnScreen(burlShown(texel, float(level))), 1.0);
}`;

export class AtlasView {
    constructor(renderer) {
        this.renderer = renderer;
        this.scene = new THREE.Scene();
        this.camera = new THREE.OrthographicCamera(0, 1, 1, 0, -1, 1);
        this.lines = [];
        this.reset();
    }

    reset() {
        this.centre = [0.5, 0.5];
        this.zoom = 1;
    }

    // The materials that have a texture for the channel.
    candidates(object, channel) {
        return object.materials.filter((material) => textureOf(material, channel));
    }

    show(object, material, channel, level) {
        this.quad?.removeFromParent();
        this.quad?.material.dispose();
        this.quad?.geometry.dispose();
        this.quad = null;
        const texture = material && textureOf(material, channel);
        if (!texture) return;
        const shown = channel.texture ? channel : {name: 'base', component: null, factor: (m) => m.color};
        this.quad = new THREE.Mesh(new THREE.PlaneGeometry(1, 1).translate(0.5, 0.5, 0), new THREE.ShaderMaterial({
            vertexShader: vertexText, fragmentShader: fragmentText, toneMapped: false, glslVersion: null, depthTest: false,
            uniforms: {image: {value: texture}, imageLevel: {value: level === 'auto' ? -1 : level}, ...uniformsOf(material, shown)},
        }));
        this.scene.add(this.quad);
    }

    setLines(object, material, channel, which) {
        for (const lines of this.lines) {
            lines.removeFromParent();
            lines.geometry.dispose();
        }
        this.lines = [];
        const texture = material && textureOf(material, channel);
        if (which === 'none' || !texture) return;
        for (const {mesh, material: own} of object.meshes) {
            const uv = mesh.geometry.getAttribute(texture.channel === 0 ? 'uv' : `uv${texture.channel}`);
            if (own !== material || !uv) continue;
            const lines = linesInAtlas(uv, edgesOf(mesh.geometry, which));
            lines.renderOrder = 1;
            this.scene.add(lines);
            this.lines.push(lines);
        }
    }

    // Moves the picture by pixels of a view of that size.
    pan(dx, dy, width, height) {
        const side = this.zoom * 0.94 * Math.min(width, height);
        this.centre = [this.centre[0] - dx / side, this.centre[1] + dy / side].map((v) => Math.min(Math.max(v, 0), 1));
    }

    scaleBy(factor) { this.zoom = Math.min(Math.max(this.zoom * factor, 0.5), 512); }

    draw(width, height) {
        const side = this.zoom * 0.94 * Math.min(width, height), w = width / side / 2, h = height / side / 2;
        const [x, y] = this.centre;
        Object.assign(this.camera, {left: x - w, right: x + w, top: y + h, bottom: y - h});
        this.camera.updateProjectionMatrix();
        this.renderer.render(this.scene, this.camera);
    }
}
