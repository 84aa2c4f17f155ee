"""Writes accuracy.json: conversions of doubles, each result to 50 significant digits.

The tests measure errors in units of 2^-53, so a reference must be exact where a double is not:
every result starts from the exact binary value of the input, is computed twice, with 900 and with
1100 digits, and both must give the same 50. (So many, because an input may hold 1 beside 5e-324.)
Every result is checked by a second route: fractions, complex matrices, q x q^-1, the polar factor,
power series, or the way back. It takes some minutes.

    pip install mpmath && python3 tests/vectors/make_accuracy.py

The random numbers use no function of the C library, so every machine writes the same file.
"""

import fractions
import itertools
import json
import math
import pathlib
import random
import struct

import mpmath as mp

SEED = 20261
DIGITS = (900, 1100)
LARGEST, SMALLEST = 1.7976931348623157e308, 5e-324
PROVENANCE = (
    "Made by tests/vectors/make_accuracy.py (Python 3 and mpmath; run it to make the file again, bit for bit; "
    f"seed {SEED}). Inputs are doubles in the shortest form that reads back exactly; outputs are correct to 50 "
    f"significant digits, computed from the exact binary values with {DIGITS[0]} and again with {DIGITS[1]} working "
    "digits, and checked by a second route. Quaternions are Hamilton [w,x,y,z] of any norm; matrices are 9 numbers "
    "row by row; angles are in radians. R(q) = [(w^2-v.v)I + 2w[v]x + 2vv^T]/|q|^2, so +90 degrees about z takes x "
    "to y. normalize: q -> q/|q|. matrix: q -> R(q). product: p, q -> p q. rotate: q, x -> R(q)x. "
    "quaternion_from_matrix: unit eigenvector of the largest eigenvalue of Davenport's 4x4 matrix, which is the "
    "rotation nearest to M in the Frobenius norm, its component of largest magnitude positive (of equal ones the "
    "first). rotation_vector_from_matrix: rotation vector of the same rotation, angle in [0, pi]; in the group 'half "
    "turn' the angle is exactly pi and the axis has the sign of that quaternion, so compare up to sign. "
    "rotation_vector_from_quaternion: 2 atan2(|v|,w)/|v| v, of -q if w < 0; with w = 0 the sign of v is kept. "
    "quaternion_from_rotation_vector: [cos(|v|/2), sin(|v|/2) v/|v|], never negated. quaternion_from_euler: angles "
    "a,b,c about the axes i,j,k of 'sequence'; intrinsic q_i(a) q_j(b) q_k(c), extrinsic q_k(c) q_j(b) q_i(a), with "
    "q_n(t) = [cos(t/2), sin(t/2) e_n], never negated. euler_from_quaternion: the inverse for R(q); first and third "
    "in (-pi, pi], second in [-pi/2, pi/2] for three different axes, else [0, pi]; no input is at gimbal lock. "
    "slerp and slerp_beyond: a, b, t -> unit quaternion at t on the short way from a/|a|; b is negated if a.b < 0. angle_between: "
    "a, b -> 2 atan2(|Im(conj(a) b)|, |Re(conj(a) b)|). Results too small for a double are still given in full."
)

rng = random.Random(SEED)


# Arithmetic -------------------------------------------------------------------------------------

def numbers(values):
    result = [mp.mpf(v) for v in values]
    # Exact, subnormals too: the reference belongs to this double and no other.
    assert all(m == 0 or fractions.Fraction(v) == fractions.Fraction(int(m.man)) * fractions.Fraction(2) ** m.exp
               * (-1 if v < 0 and m.man > 0 else 1) for m, v in zip(result, values))
    return result


def dot(a, b):
    return sum(x * y for x, y in zip(a, b, strict=True))


def size(a):
    return mp.sqrt(dot(a, a))


def times(factor, a):
    return [factor * c for c in a]


def plus(a, b):
    return [x + y for x, y in zip(a, b, strict=True)]


def unit(a):
    return times(1 / size(a), a)


def conjugate(q):
    return [q[0], -q[1], -q[2], -q[3]]


def hamilton(p, q):
    """p q = [p0 q0 - p.q, p0 q + q0 p + p x q]."""
    p0, p1, p2, p3 = p
    q0, q1, q2, q3 = q
    return [
        p0 * q0 - p1 * q1 - p2 * q2 - p3 * q3,
        p0 * q1 + p1 * q0 + p2 * q3 - p3 * q2,
        p0 * q2 + p2 * q0 + p3 * q1 - p1 * q3,
        p0 * q3 + p3 * q0 + p1 * q2 - p2 * q1,
    ]


def transposed(m):
    return [list(column) for column in zip(*m)]


def matrix_product(a, b):
    return [[dot(row, column) for column in transposed(b)] for row in a]


def matrix_times(m, x):
    return [dot(row, x) for row in m]


def rows(flat):
    return [list(flat[n:n + 3]) for n in (0, 3, 6)]


def flat(m):
    return [c for row in m for c in row]


def rotation(q):
    w, v = q[0], q[1:]
    x, y, z = v
    cross = [[0, -z, y], [z, 0, -x], [-y, x, 0]]
    square = dot(q, q)
    return [[((w * w - dot(v, v)) * (r == c) + 2 * w * cross[r][c] + 2 * v[r] * v[c]) / square
             for c in range(3)] for r in range(3)]


def half_turn_of(axis, angle):
    """The quaternion of a turn by `angle` about a unit axis: it holds the half angle."""
    return [mp.cos(angle / 2)] + times(mp.sin(angle / 2), axis)


def vector_of(q):
    """The rotation vector of a quaternion with w >= 0."""
    length = size(q[1:])
    return times(2 * mp.atan2(length, q[0]) / length, q[1:]) if length else [mp.mpf(0)] * 3


# Second routes ----------------------------------------------------------------------------------

def agree(values, others, scale=1):
    """To 60 digits in each component; where one is zero, to what the working digits leave of the largest."""
    largest = max([abs(v) for v in values] + [mp.mpf(scale)])
    for a, b in zip(values, others, strict=True):
        allowed = max(mp.mpf(10) ** -60 * abs(a), mp.mpf(10) ** (120 - mp.mp.dps) * largest)
        assert abs(a - b) <= allowed, (mp.nstr(a, 60), mp.nstr(b, 60))


def turned(q, x):
    """q x q^-1, with the table of i, j, k alone."""
    return times(1 / dot(q, q), hamilton(hamilton(q, [mp.mpf(0)] + list(x)), conjugate(q)))[1:]


def series(one, step, product):
    """exp(step): Taylor series of step / 2^n, then n squarings. For quaternions and for matrices."""
    halvings = max(0, int(mp.ceil(mp.log(max(size(step), mp.mpf(1)), 2))) + 4)
    step = times(mp.mpf(2) ** -halvings, step)
    # What is added up is exp - 1, as 1 beside it would swallow a tiny vector part; so squaring is 2e + e e.
    term, total, n = step, step, 1
    while any(abs(c) > mp.mpf(10) ** (-mp.mp.dps - 400) for c in term):
        n += 1
        term = times(mp.mpf(1) / n, product(term, step))
        total = plus(total, term)
    for _ in range(halvings):
        total = plus(times(2, total), product(total, total))
    return plus(one, total)


def quaternion_exponential(v):
    return series([1, 0, 0, 0], [mp.mpf(0)] + times(mp.mpf(1) / 2, v), hamilton)


def matrix_exponential(v):
    x, y, z = v
    product = lambda a, b: flat(matrix_product(rows(a), rows(b)))
    return series([1, 0, 0, 0, 1, 0, 0, 0, 1], [mp.mpf(0), -z, y, z, mp.mpf(0), -x, -y, x, mp.mpf(0)], product)


def cofactors(m):
    # Indices that go round carry the sign of the cofactor with them.
    return [[m[(r + 1) % 3][(c + 1) % 3] * m[(r + 2) % 3][(c + 2) % 3]
             - m[(r + 1) % 3][(c + 2) % 3] * m[(r + 2) % 3][(c + 1) % 3] for c in range(3)] for r in range(3)]


def polar_factor(m):
    """The orthogonal matrix nearest to m: Newton's iteration X <- (X + X^-T)/2."""
    x = rows(times(1 / size(flat(m)), flat(m)))
    while True:
        inverse = cofactors(x)
        determinant = dot(x[0], inverse[0])
        assert determinant > 0, "nearest orthogonal matrix is not a rotation"
        following = times(mp.mpf(1) / 2, plus(flat(x), times(1 / determinant, flat(inverse))))
        change = size(plus(following, times(-1, flat(x))))
        x = rows(following)
        if change < mp.mpf(10) ** (10 - mp.mp.dps):
            return x


def same_rotation(m, other):
    """Compares the antisymmetric parts by themselves too: they alone hold a tiny angle."""
    agree(flat(m), flat(other))
    vee = lambda m: [m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]]
    agree(vee(m), vee(other))


# Operations: the exact input -> the exact output ------------------------------------------------

def normalize(q):
    result = unit(q)
    exact = [fractions.Fraction(int(mp.sign(c) * c.man)) * fractions.Fraction(2) ** c.exp for c in q]
    for c, x in zip(exact, result):
        square = c * c / sum(c * c for c in exact)
        agree([x * x], [mp.mpf(square.numerator) / square.denominator], 0)
        assert mp.sign(x) == mp.sign(c.numerator)
    return result


def matrix(q):
    result = rotation(q)
    agree(flat(result), flat(transposed([turned(q, e) for e in ([1, 0, 0], [0, 1, 0], [0, 0, 1])])))
    return flat(result)


def product(values):
    p, q = values[:4], values[4:]
    # As 2x2 complex matrices [[w+ix, y+iz], [-y+iz, w-ix]], in pairs (real, imaginary).
    times_complex = lambda a, b: (a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0])
    first = [times_complex((p[0], p[1]), (q[0], q[1])), times_complex((p[2], p[3]), (-q[2], q[3]))]
    second = [times_complex((p[0], p[1]), (q[2], q[3])), times_complex((p[2], p[3]), (q[0], -q[1]))]
    result = hamilton(p, q)
    # Products of doubles fit into the working digits, so this is equality.
    assert result == plus(*first) + plus(*second)
    return result


def rotate(values):
    q, x = values[:4], values[4:]
    result = matrix_times(rotation(q), x)
    agree(result, turned(q, x), 0)
    return result


def nearest_quaternion(m):
    trace = m[0][0] + m[1][1] + m[2][2]
    vee = [m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]]
    davenport = [[trace] + vee] + [
        [vee[r]] + [m[r][c] + m[c][r] - trace * (r == c) for c in range(3)] for r in range(3)]
    values, vectors = mp.eigsy(mp.matrix(davenport))
    top = max(range(4), key=lambda n: values[n])
    # What the working digits leave of a zero is no component.
    q = [c if abs(c) > mp.mpf(10) ** (60 - mp.mp.dps) else mp.mpf(0) for c in vectors[:, top]]
    q = unit(q)
    largest = max(abs(c) for c in q)
    leading = next(c for c in q if abs(c) > largest * (1 - mp.mpf(10) ** -60))
    q = times(mp.sign(leading), q)
    same_rotation(rotation(q), polar_factor(m))
    return q


def quaternion_from_matrix(m):
    return nearest_quaternion(rows(m))


def rotation_vector_from_matrix(m):
    q = nearest_quaternion(rows(m))
    result = vector_of(times(-1, q) if q[0] < 0 else q)
    same_rotation(rotation(q), rows(matrix_exponential(result)))
    return result


def rotation_vector_from_quaternion(q):
    result = vector_of(times(-1, q) if q[0] < 0 else q)
    agree(unit(times(-1, q) if q[0] < 0 else q), quaternion_exponential(result))
    return result


def quaternion_from_rotation_vector(v):
    result = half_turn_of(unit(v), size(v)) if any(v) else [mp.mpf(1), 0, 0, 0]
    agree(result, quaternion_exponential(v))
    return result


AXES = {"X": [1, 0, 0], "Y": [0, 1, 0], "Z": [0, 0, 1]}


def quaternion_from_euler(angles, sequence, frame):
    parts = [half_turn_of(AXES[letter], angle) for letter, angle in zip(sequence, angles)]
    powers = [quaternion_exponential(times(angle, AXES[letter])) for letter, angle in zip(sequence, angles)]
    if frame == "extrinsic":
        parts, powers = parts[::-1], powers[::-1]
    result = hamilton(hamilton(parts[0], parts[1]), parts[2])
    agree(result, hamilton(powers[0], hamilton(powers[1], powers[2])))
    return result


def axis_numbers(sequence, frame):
    """From the left of the product to its right: extrinsic turns are the intrinsic ones in reverse."""
    return ["XYZ".index(letter) for letter in (sequence if frame == "intrinsic" else sequence[::-1])]


def about(n, angle):
    """The matrix of a turn about one axis, from the picture: the next axis goes towards the one after."""
    m = [[mp.mpf(r == c) for c in range(3)] for r in range(3)]
    a, b = (n + 1) % 3, (n + 2) % 3
    m[a][a] = m[b][b] = mp.cos(angle)
    m[b][a], m[a][b] = mp.sin(angle), -mp.sin(angle)
    return m


def euler_from_quaternion(q, sequence, frame):
    m = rotation(q)
    i, j, k = axis_numbers(sequence, frame)
    sign = 1 if j == (i + 1) % 3 else -1
    # At the lock both arguments of an outer angle vanish; the working digits carry any distance from it.
    if i == k:
        k = 3 - i - j
        assert m[i][j] != 0 or m[i][k] != 0
        result = [mp.atan2(m[j][i], -sign * m[k][i]), mp.atan2(mp.hypot(m[i][j], m[i][k]), m[i][i]),
                  mp.atan2(m[i][j], sign * m[i][k])]
        assert 0 < result[1] < mp.pi
    else:
        assert m[i][i] != 0 or m[i][j] != 0
        result = [mp.atan2(-sign * m[j][k], m[k][k]), mp.atan2(sign * m[i][k], mp.hypot(m[i][i], m[i][j])),
                  mp.atan2(-sign * m[i][j], m[i][i])]
        assert abs(result[1]) < mp.pi / 2
    assert all(-mp.pi < result[n] <= mp.pi for n in (0, 2))
    back = [about(axis, angle) for axis, angle in zip(axis_numbers(sequence, frame), result)]
    same_rotation(matrix_product(matrix_product(back[0], back[1]), back[2]), m)
    return result if frame == "intrinsic" else result[::-1]


def slerp(values):
    a, b, t = unit(values[:4]), unit(values[4:8]), values[8]
    cosine = dot(a, b)
    assert cosine != 0, "no short way"
    if cosine < 0:
        b = times(-1, b)
    relative = hamilton(conjugate(a), b)
    theta = mp.atan2(size(relative[1:]), relative[0])
    # Equal rotations leave rounding noise of the working digits only.
    if theta < mp.mpf(10) ** (20 - mp.mp.dps):
        return a
    result = plus(times(mp.sin((1 - t) * theta) / mp.sin(theta), a), times(mp.sin(t * theta) / mp.sin(theta), b))
    agree(result, hamilton(a, quaternion_exponential(times(t, vector_of(relative)))))
    return result


def angle_between(values):
    a, b = values[:4], values[4:]
    relative = hamilton(conjugate(a), b)
    result = 2 * mp.atan2(size(relative[1:]), abs(relative[0]))
    m = matrix_product(transposed(rotation(a)), rotation(b))
    vee = [m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]]
    agree([result], [mp.atan2(size(vee), m[0][0] + m[1][1] + m[2][2] - 1)])
    return [result]


# Inputs -----------------------------------------------------------------------------------------

def doubles(values):
    # + 0.0, as -0.0 would promise a meaning that these operations don't give it.
    return [float(v) + 0.0 for v in values]


def direction(n):
    while True:
        v = [mp.mpf(rng.uniform(-1, 1)) for _ in range(n)]
        if 0.1 < size(v) < 1:
            return unit(v)


def power(low, high):
    """Log-uniform between 10^low and 10^high."""
    return mp.mpf(10) ** mp.mpf(rng.uniform(low, high))


def signs(values):
    return [v * rng.choice((-1, 1)) for v in values]


def unit_double(n=4):
    return doubles(direction(n))


def any_norm(low=-307, high=308):
    return doubles(times(power(low, high), direction(4)))


def nudged(values, place):
    """The same with one component moved to a neighbouring double."""
    values = list(values)
    values[place] = math.nextafter(values[place], rng.choice((-math.inf, math.inf)))
    return values


def turn(angle, axis=None):
    return half_turn_of(axis or direction(3), mp.mpf(angle))


def subnormals(n):
    return [float(rng.randrange(-2 ** rng.randrange(1, 52), 2 ** rng.randrange(1, 52))) * SMALLEST for _ in range(n)]


def normalize_inputs():
    yield "rounded unit", [unit_double() for _ in range(30)]
    yield "any norm", [any_norm() for _ in range(40)]
    yield "subnormal", [[SMALLEST, 0, 0, 0], [SMALLEST] * 4, [0, SMALLEST, -SMALLEST, 0], [0, 0, 0, -SMALLEST],
                        [SMALLEST, 2 * SMALLEST, -3 * SMALLEST, 0], [2.225073858507201e-308] * 4,
                        [2.2250738585072014e-308, SMALLEST, 0, 0]] + [subnormals(4) for _ in range(18)]
    yield "largest", [[LARGEST] * 4, [LARGEST, 0, 0, 0], [0, -LARGEST, LARGEST, 0], [LARGEST, SMALLEST, 0, 1]] + [
        [rng.uniform(-1, 1) * LARGEST for _ in range(4)] for _ in range(18)]
    yield "wide", [doubles(signs(power(-323, 308) for _ in range(4))) for _ in range(15)]
    yield "wide", [doubles(signs(power(-20, 0) for _ in range(4))) for _ in range(15)]
    yield "exact", [[0.5, 0.5, 0.5, 0.5], [0.5, -0.5, 0.5, -0.5], [1, 0, 0, 0], [0, 0, -1, 0], [0, 3, 4, 0],
                    [1, 2, 3, 4], [1, 1, 0, 0], [1, 1, 1, 0], [2, 4, 5, 6], [1, 2, 4, 10]]
    yield "exact", [[rng.randrange(-99, 100) for _ in range(3)] + [1] for _ in range(10)]


def matrix_inputs():
    yield "unit", [unit_double() for _ in range(35)]
    yield "unit", [[0.5, 0.5, 0.5, 0.5], [0.5, -0.5, 0.5, 0.5], [1, 0, 0, 0], [0.6, 0, 0.8, 0]]
    yield "any norm", [any_norm() for _ in range(30)] + [[1, 2, 3, 4], [4, -3, 2, 1], [1, 1, 0, 0]]
    yield "half turn", [[0] + unit_double(3) for _ in range(14)]
    yield "half turn", [[0, 1, 0, 0], [0, 1, 1, 0], [0, 1, -1, 1], [0, 3, 4, 0]]
    yield "near half turn", [doubles(turn(mp.pi + rng.choice((-1, 1)) * power(-20, -1))) for _ in range(20)]
    yield "tiny angle", [doubles(turn(power(-20, -1))) for _ in range(12)]
    yield "tiny angle", [doubles(turn(power(-323, -20))) for _ in range(10)]
    yield "subnormal", [[SMALLEST, 0, 0, 0], [SMALLEST] * 4, [SMALLEST, 2 * SMALLEST, -3 * SMALLEST, 0]]
    yield "subnormal", [subnormals(4) for _ in range(10)]
    yield "largest", [[LARGEST] * 4, [0, -LARGEST, LARGEST, 0]]
    yield "largest", [[rng.uniform(-1, 1) * LARGEST for _ in range(4)] for _ in range(10)]


def product_inputs():
    moderate = lambda: [rng.uniform(-10, 10) for _ in range(4)]
    yield "moderate", [unit_double() + unit_double() for _ in range(35)]
    yield "moderate", [moderate() + moderate() for _ in range(35)]
    cases = []
    for _ in range(20):
        q = unit_double()
        cases.append(q + conjugate(q))
        cases.append(nudged(q, rng.randrange(4)) + conjugate(q))
        q = moderate()
        cases.append(q + doubles(times(1 / dot(numbers(q), q), conjugate(numbers(q)))))
    yield "cancellation", cases
    # w of p q is zero but for the rounding of one component.
    cases = []
    for _ in range(10):
        p, q = moderate(), moderate()
        q[0] = float(dot(numbers(p[1:]), numbers(q[1:])) / p[0])
        cases.append(p + q)
    yield "cancellation", cases
    yield "integers", [[rng.randrange(-9, 10) for _ in range(8)] for _ in range(12)]
    yield "integers", [[float(rng.randrange(2 ** 52, 2 ** 53)) * rng.choice((-1, 1)) for _ in range(8)]
                       for _ in range(12)]
    yield "mixed sizes", [doubles(signs(power(-20, 20) for _ in range(8))) for _ in range(15)]
    yield "mixed sizes", [doubles(signs(power(-100, 100) for _ in range(8))) for _ in range(15)]


def rotate_inputs():
    vector = lambda: [rng.uniform(-10, 10) for _ in range(3)]
    yield "unit", [unit_double() + vector() for _ in range(50)]
    yield "any norm", [any_norm() + vector() for _ in range(40)]
    yield "any norm", [[SMALLEST] * 4 + vector(), [LARGEST] * 4 + vector(), subnormals(4) + vector()]
    yield "wide vector", [unit_double() + doubles(signs(power(-100, 100) for _ in range(3))) for _ in range(20)]
    cases = []
    # The turned vector lies along an axis, so two of its components are what rounding left.
    for _ in range(30):
        q, axis = unit_double(), rng.choice(list(AXES.values()))
        target = times(mp.mpf(rng.uniform(0.1, 10)), axis)
        cases.append(q + doubles(matrix_times(transposed(rotation(numbers(q))), target)))
    yield "cancellation", cases
    yield "cancellation", [[0.5, 0.5, 0.5, 0.5, 1, 2, 3], [1, 1, 0, 0, 0, 1, 1], [1, 2, 3, 4, 4, -2, 1],
                           [1, 2, 3, 4, 2, 3, 4], [0, 3, 4, 0, 3, 4, 0], [0, 3, 4, 0, 4, -3, 1e-17]]


def rounded_matrix(q, factor=1):
    return doubles(flat([times(mp.mpf(factor), row) for row in rotation(q)]))


def single(values):
    return list(struct.unpack("9f", struct.pack("9f", *values)))


def noisy(values, amount):
    return [v + amount * rng.uniform(-1, 1) for v in values]


def boundary_quaternions():
    """Where methods that choose by trace or diagonal change their mind."""
    for _ in range(6):
        yield turn(2 * mp.pi / 3)  # trace 0
    for axis in itertools.product((1, -1), repeat=3):
        yield turn(mp.mpf(rng.uniform(0.1, 3.1)), unit(numbers(axis)))  # equal diagonal entries
    for places in itertools.combinations(range(4), 2):  # two components equal in size
        q = direction(4)
        q[places[1]] = rng.choice((-1, 1)) * q[places[0]]
        yield q
    for place in range(4):  # three equal, and the fourth of about the same size
        q = [mp.mpf(c) for c in signs([1] * 4)]
        q[place] *= mp.mpf(rng.uniform(0.9, 1.1))
        yield q
    for _ in range(4):
        yield [mp.mpf(c) for c in signs([1] * 4)]
    for place in range(1, 4):
        yield [mp.mpf(n in (0, place)) for n in range(4)]
    for _ in range(3):  # two pairs
        a, b = rng.uniform(0.1, 1), rng.uniform(0.1, 1)
        yield [mp.mpf(c) for c in signs([a, a, b, b])]


def matrices():
    yield "rounded rotation", [rounded_matrix(direction(4)) for _ in range(30)]
    yield "rounded rotation", [[1, 0, 0, 0, 1, 0, 0, 0, 1]]
    half = [axis for axis in itertools.product((1, 0, -1), repeat=3) if axis > (0, 0, 0)]
    yield "half turn", [rounded_matrix([mp.mpf(c) for c in (0,) + axis]) for axis in half]
    yield "half turn", [rounded_matrix([mp.mpf(0)] + direction(3)) for _ in range(15)]
    yield "near half turn", [rounded_matrix(turn(mp.pi - power(-15, -1))) for _ in range(14)]
    yield "branch boundary", [rounded_matrix(q) for q in boundary_quaternions()]
    yield "float32", [single(rounded_matrix(direction(4))) for _ in range(14)]
    yield "float32", [single(rounded_matrix(turn(mp.pi - power(-7, -1)))) for _ in range(4)]
    yield "noise 1e-4", [noisy(rounded_matrix(direction(4)), 1e-4) for _ in range(16)]
    yield "noise 1e-2", [noisy(rounded_matrix(direction(4)), 1e-2) for _ in range(16)]
    # Half a turn has the smallest w, so noise decides which side it is on.
    yield "noise 1e-2", [noisy(rounded_matrix([mp.mpf(0)] + direction(3)), 1e-2) for _ in range(4)]
    yield "scaled", [rounded_matrix(direction(4), factor) for factor in
                     (1e-3, 7.0, 1e100, 1e-200, 2.0 ** 10, 2.0 ** -30, 2.0 ** 900, 2.0 ** -900) for _ in range(2)]
    yield "scaled", [noisy(rounded_matrix(direction(4), 1e3), 1.0) for _ in range(2)]
    yield "tiny angle", [rounded_matrix(turn(power(-16, -1))) for _ in range(8)]
    yield "tiny angle", [rounded_matrix(turn(mp.mpf(10) ** -n)) for n in (8, 12, 16, 20, 50, 100, 150, 200, 250, 300)]
    # Diagonal entries a little off one: the antisymmetric part alone still holds the angle.
    yield "tiny angle", [nudged(rounded_matrix(turn(power(-300, -20))), place) for place in (0, 4, 8)]


def tiny_matrices():
    tiny = SMALLEST
    yield "tiny angle", [[1, -tiny, 0, tiny, 1, 0, 0, 0, 1], [1, 0, -tiny, 0, 1, 0, tiny, 0, 1],
                         [1, 0, 0, 0, 1, tiny, 0, -tiny, 1], [1, -tiny, tiny, tiny, 1, -tiny, -tiny, tiny, 1],
                         [1, -2 * tiny, -tiny, 2 * tiny, 1, -3 * tiny, tiny, 3 * tiny, 1]]
    yield "tiny angle", [rounded_matrix(turn(power(-322, -300))) for _ in range(6)]
    # As near to half a turn as w can tell.
    yield "near half turn", [[1, 0, 0, 0, -1, -tiny, 0, tiny, -1], [-1, 0, 1e-300, 0, 1, 0, -1e-300, 0, -1]]


def rotation_vector_from_quaternion_inputs():
    negative = lambda q: [-abs(q[0])] + q[1:]
    yield "unit", [[abs(q[0])] + q[1:] for q in (unit_double() for _ in range(30))] + [[1, 0, 0, 0], [0.5] * 4]
    yield "negative w", [negative(unit_double()) for _ in range(22)] + [[-1, 0, 0, 0], [-0.5] * 4]
    yield "any norm", [any_norm() for _ in range(28)] + [[SMALLEST] * 4, [LARGEST] * 4, [1, 2, 3, 4]]
    yield "tiny angle", [doubles(times(rng.choice((-1, 1)), turn(power(-20, -1)))) for _ in range(15)]
    yield "tiny angle", [doubles(times(rng.choice((-1, 1)), turn(power(-322, -20)))) for _ in range(20)]
    yield "tiny angle", [[1, SMALLEST, 0, 0], [1, 0, -SMALLEST, 0], [-1, SMALLEST, SMALLEST, -SMALLEST],
                         [1, 3 * SMALLEST, 0, 1e-320], [2, 0, 0, 3e-308]]
    yield "near pi", [doubles(turn(mp.pi + rng.choice((-1, 1)) * power(-17, -1))) for _ in range(15)]
    yield "near pi", [doubles([rng.choice((-1, 1)) * power(-323, -17)] + direction(3)) for _ in range(10)]
    yield "exactly pi", [[0] + unit_double(3) for _ in range(10)] + [
        [0, 1, 0, 0], [0, 0, -1, 0], [0, -3, 4, 0], [0, SMALLEST, 0, 0], [0, 0, LARGEST, -LARGEST]]


def quaternion_from_rotation_vector_inputs():
    yield "up to pi", [doubles(times(mp.mpf(rng.uniform(0, math.pi)), direction(3))) for _ in range(40)]
    yield "up to pi", [[math.pi, 0, 0], [0, -math.pi, 0], [0, 0, math.pi / 2], [1, 1, 1]]
    yield "tiny", [doubles(times(power(-20, -1), direction(3))) for _ in range(15)]
    yield "tiny", [doubles(times(power(-307, -20), direction(3))) for _ in range(15)]
    yield "tiny", [[SMALLEST, 0, 0], [SMALLEST] * 3, [0, -2 * SMALLEST, 0], [0, 0, 0]] + [
        subnormals(3) for _ in range(6)]
    cases = []
    for k in (1, 2, 3, 4, 7, 22, 100, 355, 1000, 12345, 10 ** 6, 10 ** 9, 10 ** 12):
        length = 2 * mp.pi * k
        cases += [doubles(times(length, rng.choice(list(AXES.values())))),
                  doubles(times(length, unit(numbers([2, -1, 2])))), doubles(times(length, direction(3)))]
    yield "near multiples of 2 pi", cases
    yield "long", [doubles(times(power(1, 15), direction(3))) for _ in range(35)]
    # By themselves, as here even the length must be known to far more digits than two doubles hold. The last is
    # the known worst case: of all doubles, its half comes nearest to a multiple of pi/2.
    yield "beyond 1e15", [doubles(times(power(16, 300), direction(3))) for _ in range(5)]
    yield "beyond 1e15", [[1e22, 0, 0], [0, LARGEST, 0], [2 * 6381956970095103 * 2.0 ** 797, 0, 0]]
    yield "wide", [doubles(signs([power(-1, 1), power(-20, 0), power(-320, -20)])) for _ in range(10)]
    yield "wide", [doubles(signs(power(-100, 0.5) for _ in range(3))) for _ in range(10)]


SEQUENCES = [a + b + c for a in "XYZ" for b in "XYZ" for c in "XYZ" if a != b != c]
FRAMES = ("intrinsic", "extrinsic")
CONVENTIONS = list(itertools.product(SEQUENCES, FRAMES))


def quaternion_from_euler_inputs():
    angles = lambda limit: [rng.uniform(-limit, limit) for _ in range(3)]
    for convention in CONVENTIONS:
        yield "usual", [angles(math.pi) for _ in range(3)], *convention
        # As 30 degrees and the like come out in radians.
        yield "degrees", [[rng.randrange(-12, 13) * 15 * (math.pi / 180) for _ in range(3)]], *convention
        yield "small", [doubles(signs(power(-20, -1) for _ in range(3)))], *convention
        yield "large", [angles(1e3), angles(1e6)], *convention


def angles_near_lock(sequence, end, distance):
    """Random outer angles, and a middle one at `distance` from the lower or upper end of its range."""
    low, high = (0, mp.pi) if sequence[0] == sequence[2] else (-mp.pi / 2, mp.pi / 2)
    middle = low + mp.mpf(distance) if end == "lower" else high - mp.mpf(distance)
    return [mp.mpf(rng.uniform(-3.14, 3.14)), middle, mp.mpf(rng.uniform(-3.14, 3.14))]


def quaternion_of(angles, sequence, frame):
    parts = [half_turn_of(AXES[letter], angle) for letter, angle in zip(sequence, angles)]
    if frame == "extrinsic":
        parts = parts[::-1]
    return hamilton(hamilton(parts[0], parts[1]), parts[2])


def at_lock(q, sequence, frame):
    i, j, k = axis_numbers(sequence, frame)
    # Both entries are polynomials in doubles over |q|^2, so the working digits give an exact zero.
    m = rotation(numbers(q))
    return m[i][j] == 0 and m[i][3 - i - j if i == k else i] == 0


def nearest_to_lock(sequence, end, frame):
    """Doubles exactly at the lock, then one of them moved to its neighbour."""
    q = doubles(quaternion_of(angles_near_lock(sequence, end, 0), sequence, frame))
    if sequence[0] == sequence[2]:
        # At the lock two components are zero; the working digits leave noise there.
        q = [c if abs(c) > 1e-200 else 0.0 for c in q]
        return nudged(q, rng.choice([n for n in range(4) if q[n] == 0]))
    # Two pairs are equal in size. Rounding keeps them so, as mpmath rounds both parts alike.
    return nudged(q, rng.randrange(4))


def euler_from_quaternion_inputs():
    for convention in CONVENTIONS:
        yield "random", [unit_double(), unit_double()], *convention
    for sequence in SEQUENCES:
        for n, distance in enumerate(("1e-1", "1e-4", "1e-7", "1e-8", "1e-10", "1e-13", "1e-15", "nearest")):
            for m, end in enumerate(("lower", "upper")):
                frame = FRAMES[(n + m) % 2]
                if distance == "nearest":
                    q = nearest_to_lock(sequence, end, frame)
                else:
                    exact = quaternion_of(angles_near_lock(sequence, end, distance), sequence, frame)
                    while at_lock(q := doubles(exact), sequence, frame):
                        exact = quaternion_of(angles_near_lock(sequence, end, distance), sequence, frame)
                yield f"gimbal lock {distance}", [q], sequence, frame
    for sequence, frame in CONVENTIONS:
        yield "any norm", [any_norm()], sequence, frame
    for sequence in SEQUENCES:
        angles = angles_near_lock(sequence, rng.choice(("lower", "upper")), power(-12, -1))
        q = quaternion_of(angles, sequence, FRAMES[0])
        yield "any norm", [doubles(times(power(-290, 300), q))], sequence, FRAMES[0]
    # Two components of one pair so small that their sum is far below the rounding of the others.
    a, b = 0.6000000000000001, 1e-200
    for q, sequence in (([a, b, a, -math.nextafter(b, 1)], "ZYX"), ([a, b, -a, -b + 1e-215], "ZYX"),
                        ([a, 3 * SMALLEST, a, -2 * SMALLEST], "XYZ"), ([a, SMALLEST, -a, 0], "XYZ")):
        for frame in FRAMES:
            yield "gimbal lock tiny", [q], sequence, frame


def slerp_inputs():
    between = lambda: rng.uniform(0, 1)
    near = lambda a, angle: doubles(hamilton(numbers(a), turn(angle)))
    opposite = lambda q: [-c + 0.0 for c in q]
    yield "wide", [unit_double() + unit_double() + [between()] for _ in range(35)]
    yield "wide", [[1, 0, 0, 0, 0.5, 0.5, 0.5, 0.5, t] for t in (0.25, 0.5, 1 / 3)]
    cases, far = [], []
    for n in range(3, 17):
        for _ in range(2):
            a = unit_double()
            cases.append(a + near(a, mp.mpf(10) ** -n) + [between()])
            a = unit_double()
            far.append(a + opposite(near(a, mp.mpf(10) ** -n)) + [between()])
    for place in range(4):
        a = unit_double()
        cases.append(a + nudged(a, place) + [between()])
        cases.append(a + a + [between()])
        far.append(a + opposite(a) + [between()])
    yield "small angle", cases + [[1, 0, 0, 0, 1, 1e-300, 0, 0, 0.5], [1, 0, 0, 0, 1, 0, SMALLEST, SMALLEST, 0.75]]
    yield "nearly antipodal", far
    cases = []
    for n in range(1, 16):
        for sign in (1, -1):
            a = unit_double()
            cases.append(a + doubles(hamilton(numbers(a), turn(mp.pi + sign * mp.mpf(10) ** -n))) + [between()])
    yield "half angle near 90 degrees", [c for c in cases if dot(numbers(c[:4]), numbers(c[4:8])) != 0]
    yield "ends", [unit_double() + unit_double() + [t] for t in
                   (0, 0, 0, 1, 1, 1, 1e-17, 1e-300, SMALLEST, math.nextafter(1, 0), math.nextafter(1, 0), 1e-8)]
    yield "ends", [a + near(a, mp.mpf("1e-10")) + [t] for a in [unit_double(), unit_double()] for t in (0, 1)]
    yield "any norm", [any_norm() + any_norm() + [between()] for _ in range(28)]
    yield "any norm", [[SMALLEST] * 4 + [LARGEST, 0, 0, LARGEST, 0.3], [LARGEST] * 4 + [1, 2, 3, 4, 0.7]]


def slerp_beyond(values):
    return slerp(values)


def slerp_beyond_inputs():
    opposite = lambda q: [-c + 0.0 for c in q]
    near = lambda a, angle: doubles(hamilton(numbers(a), turn(angle)))
    beyond = lambda reach: rng.choice((-1, 1)) * rng.uniform(0, 1) * reach + 0.5
    half = math.sqrt(0.5)
    # Not to t = 2, whose zeros would be noise of the working digits: that is in tests/rotation/gates.rs.
    yield "quarter turn", [[1, 0, 0, 0, half, 0, 0, half, t] for t in (-1, 1.5, 3, -2.5, 1e6 + 1)]
    yield "wide", [unit_double() + unit_double() + [beyond(4)] for _ in range(40)]
    yield "far", [unit_double() + unit_double() + [beyond(10**n)] for n in (1, 2, 3, 6, 9, 12) for _ in range(3)]
    cases = []
    for n in range(3, 17):
        a = unit_double()
        cases.append(a + near(a, mp.mpf(10) ** -n) + [beyond(10**n)])
        a = unit_double()
        cases.append(a + opposite(near(a, mp.mpf(10) ** -n)) + [beyond(10)])
    yield "small angle", cases + [[1, 0, 0, 0, 1, 1e-300, 0, 0, 1e299]]
    a = unit_double()
    yield "no turn", [a + a + [t] for t in (2, -1e20, LARGEST, -LARGEST)] + [a + opposite(a) + [1e20]]
    yield "ends", [unit_double() + unit_double() + [t] for t in
                   (-SMALLEST, -1e-17, math.nextafter(1, 2), math.nextafter(1, 2), 1 + 1e-8)]
    yield "any norm", [any_norm() + any_norm() + [beyond(4)] for _ in range(12)]


def angle_between_inputs():
    opposite = lambda q: [-c + 0.0 for c in q]
    near = lambda a, angle: doubles(hamilton(numbers(a), turn(angle)))
    yield "random", [unit_double() + unit_double() for _ in range(35)]
    cases, negated = [], []
    for n in range(1, 17):
        for _ in range(2):
            a = unit_double()
            cases.append(a + near(a, mp.mpf(10) ** -n))
            a = unit_double()
            negated.append(a + opposite(near(a, mp.mpf(10) ** -n)))
    for place in range(4):
        for _ in range(2):
            a = unit_double()
            cases.append(a + nudged(a, place))
            negated.append(a + opposite(nudged(a, place)))
    yield "near 0", cases + [[1, 0, 0, 0, 1, 1e-17, 0, 0], [1, 0, 0, 0, 1, 1e-300, -1e-300, 0],
                             [1, 0, 0, 0, 1, 0, 0, SMALLEST], [0.6, 0, 0.8, 0, 0.6, 1e-200, 0.8, 0]]
    yield "negated", negated
    equal = []
    for _ in range(3):
        a = unit_double()
        equal += [a + a, a + opposite(a), a + times(2.0, a), times(-3.0, [1.0, 2.0, 3.0, 4.0]) + [1, 2, 3, 4]]
    yield "equal", equal[:11] + [equal[-1]]
    cases = []
    for _ in range(28):
        a = unit_double()
        cases.append(a + near(a, mp.pi + rng.choice((-1, 1)) * power(-17, -1)))
    yield "near pi", cases + [[1, 0, 0, 0, 0, 1, 0, 0], [1, 0, 0, 0, 1e-300, 1, 0, 0], [0, 1, 0, 0, 0, 0, 1, 0]]
    yield "any norm", [any_norm() + any_norm() for _ in range(28)]
    yield "any norm", [[SMALLEST] * 4 + [LARGEST, 0, 0, LARGEST], [LARGEST] * 4 + [1, 2, 3, 4]]


OPERATIONS = [
    (normalize, normalize_inputs),
    (matrix, matrix_inputs),
    (product, product_inputs),
    (rotate, rotate_inputs),
    (quaternion_from_matrix, matrices),
    (rotation_vector_from_matrix, lambda: itertools.chain(matrices(), tiny_matrices())),
    (rotation_vector_from_quaternion, rotation_vector_from_quaternion_inputs),
    (quaternion_from_rotation_vector, quaternion_from_rotation_vector_inputs),
    (quaternion_from_euler, quaternion_from_euler_inputs),
    (euler_from_quaternion, euler_from_quaternion_inputs),
    (slerp, slerp_inputs),
    (angle_between, angle_between_inputs),
    (slerp_beyond, slerp_beyond_inputs),
]


def text(x):
    if x == 0:
        return "0"
    result = mp.nstr(x, 50, min_fixed=0, max_fixed=0)
    assert abs(mp.mpf(result) - x) <= abs(x) * mp.mpf("5.001e-50")
    return result


def reference(operation, given, convention):
    results = []
    for digits in DIGITS:
        with mp.workdps(digits):
            results.append([text(x) for x in operation(numbers(given), *convention)])
    assert results[0] == results[1], (operation.__name__, given, results)
    return results[0]


def main():
    mp.mp.dps = DIGITS[0]
    parts, counts = [], {}
    for operation, inputs in OPERATIONS:
        name, lines, seen = operation.__name__, [], {}
        for group, cases, *convention in inputs():
            for case in cases:
                case = doubles(case)
                assert all(math.isfinite(c) for c in case)
                output = reference(operation, case, convention)
                entry = {"group": group}
                if operation is rotation_vector_from_matrix and rows(case) == transposed(rows(case)):
                    # A symmetric matrix is half a turn, even where only rounding made it so, or none at all.
                    entry["group"] = "half turn" if any(c != "0" for c in output) else group
                if convention:
                    entry |= {"sequence": convention[0], "frame": convention[1]}
                entry |= {"input": case, "output": output}
                line = "   " + json.dumps(entry, separators=(",", ":"))
                if line in lines:
                    continue
                lines.append(line)
                seen[entry["group"]] = seen.get(entry["group"], 0) + 1
        parts.append(f'  "{name}": [\n' + ",\n".join(lines) + "\n  ]")
        print(f"{name}: {len(lines)} cases; " + ", ".join(f"{group} {n}" for group, n in seen.items()), flush=True)
    content = '{\n "provenance": ' + json.dumps(PROVENANCE) + ',\n "operations": {\n' + ",\n".join(parts) + "\n }\n}\n"
    json.loads(content)
    (pathlib.Path(__file__).parent / "accuracy.json").write_text(content)


main()
