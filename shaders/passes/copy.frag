// An image copied in the channels that the colour mask lets pass.
out vec4 color;

void main() {
    color = stored(numbers(first));
}
