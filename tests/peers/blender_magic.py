# How the turns of Blender's Magic texture were found (procedural/blender/patterns.h): each depth changes one coordinate, to a sine or a
# cosine of the three with some signs, and a search over all of them finds which.
#   blender --background --factory-startup --python-exit-code 1 --python blender_magic.py
import itertools
import os
import sys

import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.argv += ["--", "", ""]
import blender_points

distortion = 1.3
points = numpy.random.default_rng(1).uniform(-1, 1, (400, 3)).astype(numpy.float32)


def magic(depth):
    inputs = {"Scale": 1, "Distortion": distortion}
    return blender_points.evaluate("TexMagic", {"turbulence_depth": depth}, inputs, "Color", points).astype(float)


x, y, z = points.astype(float).T
state = numpy.stack([numpy.sin(5 * (x + y + z)), numpy.cos(5 * (x - y + z)), -numpy.cos(5 * (x + y - z))], 1)
print("begin: largest difference", numpy.abs(0.5 - state / (2 * distortion) - magic(0)).max())
state *= distortion
for depth in range(1, 11):
    target = magic(depth)
    (axis,) = [a for a in range(3) if numpy.abs(target[:, a] - 0.5 + state[:, a] / (2 * distortion)).max() > 1e-4]
    for signs, function, sign in itertools.product(itertools.product([1, -1], repeat=3), (numpy.sin, numpy.cos), (1, -1)):
        turned = sign * function(state @ numpy.array(signs, float))
        if numpy.abs(turned - (0.5 - target[:, axis]) * 2).max() < 1e-4:
            print(depth, "xyz"[axis], sign, function.__name__, signs)
            found = turned
    state[:, axis] = found * distortion
