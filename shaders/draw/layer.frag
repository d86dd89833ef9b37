#version 330 core
// A layer of premultiplied colours as it is, to be blended with what the target holds.
uniform sampler2D layer;

out vec4 fragment;

void main() { fragment = texelFetch(layer, ivec2(gl_FragCoord.xy), 0); }
