// The size of a level, computed from level 0: software OpenGL gives neighbouring pixels that ask
// for different levels the size of one of them.
ivec2 level_size(sampler2D image, int level) {
    return max(textureSize(image, 0) >> level, 1);
}
