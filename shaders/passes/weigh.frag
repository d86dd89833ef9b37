// A corner's random number times its weight along one axis, or times the weight's complement.
out vec4 color;

void main() {
    float weight = numbers(second)[axis];
    color = stored(product(numbers(first), vec4(upper ? weight : one - weight)));
}
