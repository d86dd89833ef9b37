// Value noise, which is below what draws. After draw/mesh.frag.
