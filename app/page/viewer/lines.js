// The borders of charts, or all triangles, as lines: over an object, and over its atlas.
import * as THREE from 'three';

const found = new WeakMap(); // by geometry: the object and its atlas show the same edges

// Pairs of vertex numbers: the edges of one triangle alone, which bound charts, or all edges, each once.
export function edgesOf(geometry, which) {
    const known = found.get(geometry) ?? {};
    known[which] ??= findEdges(geometry, which);
    found.set(geometry, known);
    return known[which];
}

function findEdges(geometry, which) {
    const count = geometry.index ? geometry.index.count : geometry.attributes.position.count;
    const at = geometry.index ? (i) => geometry.index.getX(i) : (i) => i;
    const vertices = geometry.attributes.position.count, times = new Map();
    for (let first = 0; first + 2 < count; first += 3) {
        for (let k = 0; k < 3; ++k) {
            const a = at(first + k), b = at(first + (k + 1) % 3), key = Math.min(a, b) * vertices + Math.max(a, b);
            times.set(key, (times.get(key) ?? 0) + 1);
        }
    }
    const edges = [];
    for (const [key, n] of times) if (which === 'triangles' || n === 1) edges.push(Math.floor(key / vertices), key % vertices);
    return edges;
}

export const lineMaterial = new THREE.LineBasicMaterial({color: 0x00d5ff, toneMapped: false});

export function linesOn(geometry, edges) {
    const lines = new THREE.BufferGeometry();
    lines.setAttribute('position', geometry.attributes.position);
    lines.setIndex(edges);
    return new THREE.LineSegments(lines, lineMaterial);
}

// In the plane of the atlas: x is u, y is 1 - v.
export function linesInAtlas(uv, edges) {
    const points = new Float32Array(3 * edges.length);
    edges.forEach((vertex, i) => points.set([uv.getX(vertex), 1 - uv.getY(vertex), 0], 3 * i));
    const lines = new THREE.BufferGeometry();
    lines.setAttribute('position', new THREE.BufferAttribute(points, 3));
    return new THREE.LineSegments(lines, lineMaterial);
}
