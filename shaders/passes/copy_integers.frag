// A corner's integers copied in the channels that the colour mask lets pass.
out uvec4 integers;

void main() {
    integers = texelFetch(first_integers, texel(), 0);
}
