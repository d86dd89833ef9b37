// The page of materialx_values.mjs: runs the shaders that /jobs lists at their points, one pixel a point in float32, and posts the values.
const side = 1024;  // pixels of a row of the target
const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const gl = new OffscreenCanvas(4, 4).getContext('webgl2');
if (!gl?.getExtension('EXT_color_buffer_float')) throw new Error('There is no WebGL 2 with float targets.');
gl.getExtension('OES_texture_float_linear');

async function post(path, body) {
    await fetch(path, {method: 'POST', body});
}

function compiled(kind, source) {
    const shader = kept('Shader', gl.createShader(kind));
    gl.shaderSource(shader, source.replaceAll('precision mediump float', 'precision highp float').replaceAll('uniform sampler2D', 'uniform highp sampler2D'));
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    return shader;
}

// The vertex shader passes its varyings on as it likes; only where the point is drawn becomes ours.
function placed(vertex) {
    const end = vertex.lastIndexOf('}');
    return vertex.replace('void main()', 'in vec2 burl_pixel;\nvoid main()').slice(0, end + 'in vec2 burl_pixel;\n'.length) +
        '    gl_Position = vec4(burl_pixel, 0.0, 1.0);\n    gl_PointSize = 1.0;\n}\n';
}

const shadersOf = ({vertex, pixel}) => [compiled(gl.VERTEX_SHADER, placed(vertex)), compiled(gl.FRAGMENT_SHADER, pixel)];

function programOf(shaders) {
    const program = kept('Program', gl.createProgram());
    for (const shader of shaders) gl.attachShader(program, shader);
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    return program;
}

function wrapOf(job, name, axis) {
    const key = `${name.replace(/_[^_]*$/, '')}_${axis}addressmode`;
    const mode = job.uniforms.find((uniform) => uniform.name === key)?.value ?? 2;
    return [gl.CLAMP_TO_EDGE, gl.CLAMP_TO_EDGE, gl.REPEAT, gl.MIRRORED_REPEAT][mode] ?? gl.REPEAT;
}

async function bindTexture(job, {name, url}, unit) {
    const picture = await (await fetch(url)).blob();
    const bitmap = await createImageBitmap(picture, {imageOrientation: 'flipY', premultiplyAlpha: 'none', colorSpaceConversion: 'none'});
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, kept('Texture', gl.createTexture()));
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
    const filter = job.uniforms.find((uniform) => uniform.name === `${name.replace(/_[^_]*$/, '')}_filtertype`)?.value;
    const kind = filter === 0 ? gl.NEAREST : gl.LINEAR;
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, kind);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, kind);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, wrapOf(job, name, 'u'));
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, wrapOf(job, name, 'v'));
}

const setters = {
    [WebGL2RenderingContext.FLOAT]: (at, v) => gl.uniform1f(at, v),
    [WebGL2RenderingContext.INT]: (at, v) => gl.uniform1i(at, v),
    [WebGL2RenderingContext.BOOL]: (at, v) => gl.uniform1i(at, v),
    [WebGL2RenderingContext.FLOAT_VEC2]: (at, v) => gl.uniform2fv(at, v),
    [WebGL2RenderingContext.FLOAT_VEC3]: (at, v) => gl.uniform3fv(at, v),
    [WebGL2RenderingContext.FLOAT_VEC4]: (at, v) => gl.uniform4fv(at, v),
    [WebGL2RenderingContext.FLOAT_MAT3]: (at, v) => gl.uniformMatrix3fv(at, false, v),
    [WebGL2RenderingContext.FLOAT_MAT4]: (at, v) => gl.uniformMatrix4fv(at, false, v),
};

async function setUniforms(program, job) {
    let unit = 0;
    for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); ++i) {
        const {name, type} = gl.getActiveUniform(program, i);
        const at = gl.getUniformLocation(program, name);
        const given = job.uniforms.find((uniform) => uniform.name === name);
        const texture = job.textures.find((one) => one.name === name);
        if (texture) {
            await bindTexture(job, texture, unit);
            gl.uniform1i(at, unit++);
        } else if (type === gl.FLOAT_MAT4) {
            gl.uniformMatrix4fv(at, false, given?.value ?? identity);
        } else if (given?.value !== null && given?.value !== undefined && setters[type]) {
            setters[type](at, given.value);
        }
    }
}

// Attributes by the names that the generator gives them, with what a point has that gives none.
const attributes = [
    [/^i_position$/, 'position', 3, [0, 0, 0]], [/^i_normal$/, 'normal', 3, [0, 0, 1]], [/^i_tangent$/, 'tangent', 3, [1, 0, 0]],
    [/^i_bitangent$/, 'bitangent', 3, [0, 1, 0]], [/^i_texcoord_\d+$/, 'texcoord', 2, [0, 0]], [/^i_color_\d+$/, 'color', 4, [1, 1, 1, 1]],
];

function give(program, name, numbers, width) {
    const at = gl.getAttribLocation(program, name);
    gl.bindBuffer(gl.ARRAY_BUFFER, kept('Buffer', gl.createBuffer()));
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(numbers), gl.STATIC_DRAW);
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, width, gl.FLOAT, false, 0, 0);
}

function giveAttributes(program, points, count, height) {
    for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_ATTRIBUTES); ++i) {
        const {name} = gl.getActiveAttrib(program, i);
        const known = attributes.find(([pattern]) => pattern.test(name));
        if (name === 'burl_pixel') {
            const centre = (k) => [2 * (k % side + 0.5) / side - 1, 2 * (Math.floor(k / side) + 0.5) / height - 1];
            give(program, name, Array.from({length: count}, (_, k) => centre(k)).flat(), 2);
        } else if (known) {
            const [, key, width, usual] = known;
            give(program, name, points[key]?.flat() ?? Array.from({length: count}, () => usual).flat(), width);
        } else {
            throw new Error(`The shader wants '${name}' of its points.`);
        }
    }
}

function targetOf(height) {
    const texture = kept('Texture', gl.createTexture());
    gl.activeTexture(gl.TEXTURE0 + 15);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, side, height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, kept('Framebuffer', gl.createFramebuffer()));
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    gl.viewport(0, 0, side, height);
}

// Frees what the jobs before made, which Chromium would keep: gigabytes of a long list.
const made = [];
function kept(kind, object) {
    made.push([kind, object]);
    return object;
}
function forget() {
    for (const [kind, object] of made.splice(0)) gl[`delete${kind}`](object);
}

// Four numbers a point.
async function valuesOf(job) {
    const count = job.points.position.length, height = Math.ceil(count / side), shaders = shadersOf(job);
    if (!count) return new Float32Array(0);
    const program = programOf(shaders);
    gl.useProgram(program);
    targetOf(height);
    gl.bindVertexArray(kept('VertexArray', gl.createVertexArray()));
    await setUniforms(program, job);
    giveAttributes(program, job.points, count, height);
    gl.clearColor(NaN, NaN, NaN, NaN);
    gl.disable(gl.BLEND);
    gl.drawArrays(gl.POINTS, 0, count);
    const pixels = new Float32Array(4 * side * height);
    gl.readPixels(0, 0, side, height, gl.RGBA, gl.FLOAT, pixels);
    if (gl.getError()) throw new Error('WebGL reports an error.');
    return pixels.slice(0, 4 * count);
}

try {
    for (const job of await (await fetch('/jobs')).json()) {
        try {
            await post(`/values/${job.number}`, (await valuesOf(job)).buffer);
        } catch (error) {
            await post(`/error/${job.number}`, String(error.message ?? error));
        }
        forget();
    }
    await post('/done', '');
} catch (error) {
    await post('/failed', String(error.stack ?? error));
}
