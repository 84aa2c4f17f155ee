"""Writes alignment.json: attitudes from vectors, weighted means and powers, from outside of quatlas.

Every result is computed with mpmath from the exact binary values of the inputs, with 1500 digits, and
rounded once; SciPy has to agree as far as its doubles go.

    pip install mpmath scipy==1.17.1 && python3 tests/vectors/make_alignment.py
"""

import json
import math
import pathlib

import mpmath as mp
import numpy as np
from scipy.spatial.transform import Rotation

mp.mp.dps = 1500


def exactly(values):
    return [mp.mpf(value) for value in values]


def matrix_of(q):
    """R(q) of Hamilton's [w, x, y, z], of any norm."""
    w, x, y, z = q
    n = w * w + x * x + y * y + z * z
    return mp.matrix([
        [(w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n],
        [2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n],
        [2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n],
    ])


def unit(q):
    """Of norm 1, its largest component positive."""
    norm = mp.sqrt(mp.fsum(number * number for number in q))
    largest = max(q, key=abs)
    return [number / (norm if largest > 0 else -norm) for number in q]


def nearest(profile):
    """The singular values, the last with the sign of the determinant, and the nearest rotation as matrix and quaternion."""
    u, s, v = mp.svd_r(profile)
    sign = mp.sign(mp.det(u) * mp.det(v))
    rotation = u * mp.diag([1, 1, sign]) * v
    r = rotation
    # Four columns that are the quaternion times each of its components; the longest is taken.
    columns = [
        [1 + r[0, 0] + r[1, 1] + r[2, 2], r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]],
        [r[2, 1] - r[1, 2], 1 + r[0, 0] - r[1, 1] - r[2, 2], r[0, 1] + r[1, 0], r[0, 2] + r[2, 0]],
        [r[0, 2] - r[2, 0], r[0, 1] + r[1, 0], 1 - r[0, 0] + r[1, 1] - r[2, 2], r[1, 2] + r[2, 1]],
        [r[1, 0] - r[0, 1], r[0, 2] + r[2, 0], r[1, 2] + r[2, 1], 1 - r[0, 0] - r[1, 1] + r[2, 2]],
    ]
    at = max(range(4), key=lambda place: columns[place][place])
    q = unit(columns[at])
    assert mp.norm(matrix_of(q) - rotation) < mp.mpf(10) ** -700
    return [s[0], s[1], sign * s[2]], rotation, q


def doubles(values):
    """Rounded once; what is nothing but the rounding of 1500 digits is 0."""
    return [float(value) if abs(value) > mp.mpf(10) ** -700 else 0.0 for value in values]


def agrees(what, ours, theirs, tolerance):
    ours, theirs = np.array(ours, dtype=float), np.array(theirs, dtype=float)
    assert np.allclose(ours, theirs, rtol=tolerance, atol=tolerance), (what, ours, theirs)


def scipy_quaternion(rotation, q):
    """SciPy's [w, x, y, z], with the sign of q."""
    theirs = rotation.as_quat(scalar_first=True)
    return theirs if np.dot(theirs, q) > 0 else -theirs


def align(name, body, world, weights, tolerance=1e-14):
    profile = mp.zeros(3)
    used = exactly(weights or [1.0] * len(body))
    for b, a, w in zip(body, world, used):
        profile += w * mp.matrix(exactly(a)) * mp.matrix(exactly(b)).T
    (s1, s2, s3), rotation, q = nearest(profile)
    squares = mp.mpf(0)
    for b, a, w in zip(body, world, used):
        distance = mp.matrix(exactly(a)) - rotation * mp.matrix(exactly(b))
        squares += w * mp.norm(distance) ** 2
    rssd = mp.sqrt(squares)
    kappa = s1 * s2 + s2 * s3 + s3 * s1
    zeta = (s1 + s2) * (s2 + s3) * (s3 + s1)
    sensitivity = mp.fsum(used) / len(used) / zeta * (kappa * mp.eye(3) + profile * profile.T)
    case = {
        "name": name,
        "body": body,
        "world": world,
        "weights": weights,
        "quaternion": doubles(q),
        "rssd": doubles([rssd])[0],
        "sensitivity": doubles(sensitivity),
    }
    # Between sizes that SciPy's squares leave, and between directions that are nearly one, it has no digits.
    if tolerance is not None:
        theirs = Rotation.align_vectors(world, body, weights=weights, return_sensitivity=True)
        agrees(name, case["quaternion"], scipy_quaternion(theirs[0], case["quaternion"]), tolerance)
        agrees(name, case["rssd"], theirs[1], 1e-7)
        agrees(name, case["sensitivity"], theirs[2].flatten(), tolerance)
    return case


def two_vectors(name, body, world, tolerance=1e-14):
    b, w = exactly(body), exactly(world)
    product = mp.sqrt(mp.fsum(x * x for x in b)) * mp.sqrt(mp.fsum(x * x for x in w))
    cross = [b[1] * w[2] - b[2] * w[1], b[2] * w[0] - b[0] * w[2], b[0] * w[1] - b[1] * w[0]]
    q = unit([product + mp.fsum(x * y for x, y in zip(b, w)), *cross])
    case = {"name": name, "body": body, "world": world, "quaternion": doubles(q)}
    if tolerance is not None:
        theirs = Rotation.align_vectors(world, body)[0]
        agrees(name, case["quaternion"], scipy_quaternion(theirs, case["quaternion"]), tolerance)
    return case


def mean(name, quaternions, weights):
    profile = mp.zeros(3)
    for q, w in zip(quaternions, exactly(weights)):
        profile += w * matrix_of(exactly(q))
    q = doubles(nearest(profile)[2])
    theirs = Rotation.from_quat(quaternions, scalar_first=True).mean(weights=weights)
    agrees(name, q, scipy_quaternion(theirs, q), 1e-14)
    return {"name": name, "quaternions": quaternions, "weights": weights, "quaternion": q}


def power(name, quaternion, t, tolerance=1e-14):
    w, *vector = exactly(quaternion)
    if w < 0:
        w, vector = -w, [-number for number in vector]
    length = mp.sqrt(mp.fsum(number * number for number in vector))
    half = mp.atan2(length, w) * mp.mpf(t)
    q = doubles([mp.cos(half), *(mp.sin(half) * number / length for number in vector)])
    if tolerance is not None:
        theirs = Rotation.from_quat(quaternion, scalar_first=True) ** t
        agrees(name, q, scipy_quaternion(theirs, q), tolerance)
    return {"name": name, "input": quaternion, "t": t, "quaternion": q}


def random_attitude(seed):
    """SplitMix64 and xoshiro256++ by their C code (prng.di.unimi.it), and Shoemake's subgroups."""
    mask = 2**64 - 1
    state, counter = [], seed
    for _ in range(4):
        counter = (counter + 0x9E3779B97F4A7C15) & mask
        z = ((counter ^ (counter >> 30)) * 0xBF58476D1CE4E5B9) & mask
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & mask
        state.append(z ^ (z >> 31))

    def left(number, bits):
        return ((number << bits) | (number >> (64 - bits))) & mask

    parts = []
    for _ in range(3):
        drawn = (left((state[0] + state[3]) & mask, 23) + state[0]) & mask
        t = (state[1] << 17) & mask
        state[2] ^= state[0]
        state[3] ^= state[1]
        state[1] ^= state[2]
        state[0] ^= state[3]
        state[2] ^= t
        state[3] = left(state[3], 45)
        parts.append(mp.mpf(drawn >> 11) / 2**53)
    a, b, c = parts
    small, large, b, c = mp.sqrt(1 - a), mp.sqrt(a), 2 * mp.pi * b, 2 * mp.pi * c
    q = doubles([large * mp.cos(c), small * mp.sin(b), small * mp.cos(b), large * mp.sin(c)])
    return {"name": f"seed {seed}", "seed": str(seed), "quaternion": q}


def turned(angles, vectors):
    """World coordinates to some digits, of an attitude of yaw, pitch and roll: so the fit is not perfect."""
    return Rotation.from_euler("ZYX", angles, degrees=True).apply(vectors).round(4).tolist()


BODY = [[1.0, 0.2, -0.4], [0.3, 1.5, 0.6], [-0.7, 0.4, 2.0], [0.9, -1.1, 0.8]]
# A direction, and others so far from it about another axis.
AHEAD = [math.cos(0.3), math.sin(0.3), 0.0]

operations = {
    "align_vectors": [
        align("the example of SciPy's documentation",
              [[1.0, 0.0, 0.0], [1.0, 1.1, 0.0], [1.0, 0.9, 0.0]],
              [[0.0, 1.0, 0.0], [0.0, 1.0, 1.0], [0.0, 1.0, 1.0]], None),
        align("four pairs", BODY, turned([65, 20, -35], BODY), None),
        align("four pairs with weights", BODY, turned([65, 20, -35], BODY), [0.5, 3.0, 1.25, 0.0078125]),
        align("two pairs at different angles", [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0]],
              [[0.0, 1.0, 0.5], [0.25, 0.0, 1.0]], [1.0, 4.0]),
        align("a rough fit", BODY, [[0.1, 1.4, 0.3], [-1.0, 0.5, 1.2], [0.9, -0.2, 1.7], [1.3, 0.4, -0.6]], None),
        align("a mirror image", BODY, [[x, y, -z] for x, y, z in BODY], None),
        align("nearly half a turn", BODY, turned([179.9, 0, 0.2], BODY), None),
        align("nearly no turn", [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
              [[1.0, 3e-9, -2e-9], [-3e-9, 1.0, 1e-12], [2e-9, -1e-12, 1.0]], None),
        *(align(f"directions {apart} apart", [[1.0, 0.0, 0.0], [1.0, apart, 0.0]], [AHEAD, [*AHEAD[:2], 0.9 * apart]],
                None, tolerance=None) for apart in (1e-3, 1e-5, 2e-6)),
        align("weights apart", BODY[:2], turned([-100, 50, 10], BODY[:2]), [1e-7, 1e3], tolerance=1e-6),
        align("sizes apart", [[1e200, 2e199, 0.0], [0.0, 1e199, 3e200]], [[0.0, 1e-150, 2e-151], [3e-150, 0.0, 0.0]],
              [1e-300, 2e-300], tolerance=None),
    ],
    "from_two_vectors": [
        two_vectors("an acute angle", [1.0, 2.0, 3.0], [-0.5, 4.0, 1.0]),
        two_vectors("an obtuse angle", [1.0, 2.0, 3.0], [0.5, -4.0, 1.0]),
        two_vectors("a right angle", [0.0, 3.0, 0.0], [0.0, 0.0, 0.25]),
        two_vectors("nearly the same", [1.0, 2.0, 3.0], [1.0, 2.0, 3.0000001]),
        two_vectors("the last digit of the same", [1.0, 2.0, 3.0], [1.0, 2.0000000000000004, 3.0]),
        two_vectors("nearly opposite", [1.0, 2.0, 3.0], [-1.0, -2.0, -3.0000001], tolerance=1e-7),
        two_vectors("the last digit of opposite", [1.0, 2.0, 3.0], [-1.0, -2.0000000000000004, -3.0], tolerance=None),
        two_vectors("small beside large", [1e300, 1e10, 2e5], [-1e-300, 1e-312, 3e-310], tolerance=None),
        two_vectors("far smaller than a digit", [1.0, 0.0, 0.0], [1.0, 2e-200, -3e-290], tolerance=None),
        two_vectors("the same, opposite", [1.0, 0.0, 0.0], [-1.0, 2e-200, -3e-290], tolerance=None),
    ],
    "mean_weighted": [
        mean("three", [[0.9, 0.1, -0.2, 0.3], [-0.7, -0.4, 0.1, -0.5], [0.5, 0.5, 0.4, 0.3]], [1.0, 2.5, 0.75]),
        mean("of any norm", [[3.0, 0.1, 4.0, 0.3], [7.0, -0.4, 9.0, 0.5]], [1e-3, 2e-4]),
        mean("one of weight 0", [[0.9, 0.1, -0.2, 0.3], [0.1, 0.9, 0.4, 0.5], [0.5, 0.5, 0.4, 0.3]], [3.0, 0.0, 5.0]),
        mean("near half a turn", [[1e-3, 0.6, 0.8, 0.0], [-2e-3, 0.6, 0.7, 0.1]], [1.0, 3.0]),
    ],
    "power": [
        power("a half", [0.5, 0.1, -0.7, 0.3], 0.5),
        power("beyond", [0.5, 0.1, -0.7, 0.3], 2.75),
        power("back", [0.5, 0.1, -0.7, 0.3], -0.8125),
        power("the shorter way", [-0.5, 0.1, -0.7, 0.3], 0.75),
        power("half a turn", [0.0, 0.48, -0.6, 0.64], 0.3),
        power("nearly half a turn", [1e-12, 0.48, -0.6, 0.64], 1.5),
        power("a small turn", [1.0, 1e-9, -2e-12, 3e-15], 0.7),
        power("a small turn many times", [1.0, 1e-9, -2e-9, 3e-9], 7e8, tolerance=1e-7),
        power("the smallest turn", [1.0, 1e-310, -2e-308, 3e-300], 0.37, tolerance=None),
        power("less than the smallest angle with digits", [1.0, 1e-320, -3e-321, 2e-322], 1e10, tolerance=None),
        power("a small part", [0.5, 0.1, -0.7, 0.3], 1e-13),
    ],
    "random": [random_attitude(seed) for seed in (0, 1, 2, 20261201, 2**64 - 1)],
}

PROVENANCE = (
    "Made by tests/vectors/make_alignment.py with mpmath, 1500 digits, and rounded once; SciPy 1.17.1 agrees. Quaternions "
    "are Hamilton [w, x, y, z], body to world. align_vectors(body, world, weights) is SciPy's with a = world and b = "
    "body; sensitivity is row by row. from_two_vectors, mean_weighted and align_vectors have the sign for which the "
    "largest component is positive; power is [cos(t h), sin(t h) u] with h up to a quarter turn; random is by xoshiro256++ "
    "and Shoemake's subgroups."
)
file = {"provenance": PROVENANCE, **operations}
lines = [f' "provenance": {json.dumps(PROVENANCE)}']
for operation, cases in operations.items():
    rows = ",\n  ".join(json.dumps(case) for case in cases)
    lines.append(f' "{operation}": [\n  {rows}\n ]')
path = pathlib.Path(__file__).with_name("alignment.json")
path.write_text("{\n" + ",\n".join(lines) + "\n}\n")
assert json.loads(path.read_text()) == file
