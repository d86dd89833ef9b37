// Scale and bias of every channel: PixelTransfer.
uniform float scale, bias;
uniform bool wraps;
out vec4 color;

void main() {
    vec4 x = scale * numbers(first) + bias;
    if (wraps) x -= 256.0 * floor(x * 0.00390625);
    color = stored(x);
}
