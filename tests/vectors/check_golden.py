"""Recomputes the golden cases with 60 digits, from definitions alone, and compares.

Nothing here uses a formula of quatlas: a turn is the exponential of a matrix, a product is the
multiplication table of i, j, k, a quaternion turns a vector by q x q^-1, and a rate is a derivative
(of numbers with 60 digits).

    pip install mpmath && python3 tests/vectors/check_golden.py
"""

import json
import pathlib

import mpmath as mp

mp.mp.dps = 60
# i*j etc. in the Hamilton product: (first, second) -> (sign, result), with 0 = 1, 1 = i, 2 = j, 3 = k.
TABLE = {(1, 2): (1, 3), (2, 3): (1, 1), (3, 1): (1, 2), (2, 1): (-1, 3), (3, 2): (-1, 1), (1, 3): (-1, 2)}


def hamilton(p, q):
    result = [mp.mpf(0)] * 4
    for a in range(4):
        for b in range(4):
            if a == 0 or b == 0:
                sign, place = 1, a + b
            elif a == b:
                sign, place = -1, 0
            else:
                sign, place = TABLE[a, b]
            result[place] += sign * p[a] * q[b]
    return result


def jpl(p, q):
    return hamilton(q, p)


def conjugate(q):
    return [q[0], -q[1], -q[2], -q[3]]


def inverse(q):
    square = sum(c * c for c in q)
    return [c / square for c in conjugate(q)]


def numbers(values):
    return [mp.mpf(v) for v in values]


def exponential_matrix(v):
    """The matrix of the right-handed turn about v by |v| radians."""
    x, y, z = v
    return mp.expm(mp.matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]]), method="taylor")


def half_exponential(v):
    """The Hamilton quaternion of the same turn: the exponential of v/2 in the quaternions."""
    term, total = [mp.mpf(1), 0, 0, 0], [mp.mpf(1), 0, 0, 0]
    half = [mp.mpf(0)] + [c / 2 for c in v]
    for n in range(1, 200):
        term = [c / n for c in hamilton(term, half)]
        total = [a + b for a, b in zip(total, term)]
    return total


def turned(q, x, product):
    return product(product(q, [mp.mpf(0)] + list(x)), inverse(q))[1:]


def matrix_of(q, product):
    columns = [turned(q, e, product) for e in ([1, 0, 0], [0, 1, 0], [0, 0, 1])]
    return [[columns[c][r] for c in range(3)] for r in range(3)]


def flat(value):
    if isinstance(value, mp.matrix):
        value = value.tolist()
    if isinstance(value, list):
        return [n for member in value for n in flat(member)]
    return [mp.mpf(value)]


compared = 0


def check(case, name, got):
    agree(case, name, got, case["output"][name])


def agree(case, name, got, expected):
    global compared
    for value, wanted in zip(flat(got), flat(expected), strict=True):
        allowed = max(mp.mpf(case["tol"]), mp.mpf(2) ** -53) * max(1, abs(wanted))
        assert abs(value - wanted) <= allowed, (case["id"], name, value, wanted)
        compared += 1


def elementary(axis, angle):
    """The right-handed turn about the axis 1, 2 or 3, as a rotation vector."""
    return [angle if place == axis - 1 else mp.mpf(0) for place in range(3)]


def product_of(factors, times):
    first, *others = factors
    for factor in others:
        first = times(first, factor)
    return first


def skew(v):
    x, y, z = v
    return mp.matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def vector_of(skew_matrix):
    return [skew_matrix[2, 1], skew_matrix[0, 2], skew_matrix[1, 0]]


def slope(function, count):
    """The derivative at time 0 of a function with `count` numbers."""
    return [mp.diff(lambda time, place=place: function(time)[place], 0) for place in range(count)]


def logarithm(matrix):
    """The rotation vector of a turn that is neither 0 nor half a turn: angle by the trace."""
    angle = mp.acos((matrix[0, 0] + matrix[1, 1] + matrix[2, 2] - 1) / 2)
    return [c * angle / mp.sin(angle) for c in vector_of((matrix - matrix.T) / 2)]


def left_matrix(q, product, order):
    """Columns: q times each basis array."""
    basis = {"first": [0, 1, 2, 3], "last": [1, 2, 3, 0]}[order]
    images = [product(q, [mp.mpf(i == place) for i in range(4)]) for place in basis]
    return [[image[place] for image in images] for place in basis]


def motion(case, is_canonical):
    """Increments and rates: what turns is the body, whatever the convention."""
    given = case["input"]
    attitude, delta, rate = (numbers(given[name]) for name in ("v_WB", "delta", "omega_B"))
    to_convention = (lambda q: q) if is_canonical else conjugate
    after = {
        "q_plus_local": (exponential_matrix(attitude) * exponential_matrix(delta), (attitude, delta)),
        "q_plus_global": (exponential_matrix(delta) * exponential_matrix(attitude), (delta, attitude)),
    }
    for name, (matrix, turns) in after.items():
        q = product_of([half_exponential(v) for v in turns], hamilton)
        agree(case, name + " as a matrix", matrix_of(q, hamilton), matrix)
        check(case, name, to_convention(q))
    check(case, "omega_W", exponential_matrix(attitude) * mp.matrix(rate))
    turning = lambda time: hamilton(half_exponential(attitude), half_exponential([c * time for c in rate]))
    check(case, "q_dot", to_convention(slope(turning, 4)))


def matrices(cases):
    for n in range(12, 16):
        case = cases[f"G{n}"]
        for name, product in (("right_same", hamilton), ("left_same", jpl)):
            q = numbers(case["output"][name])
            agree(case, name + " as a matrix", matrix_of(q, product), case["input"]["M"])

    for n in range(20, 23):
        case = cases[f"G{n}"]
        turns = [elementary(*turn) for turn in zip(case["input"]["seq"], numbers(case["input"]["angles"]))]
        for name, order in (("successive", turns), ("fixed", turns[::-1])):
            check(case, "R_" + name, product_of([exponential_matrix(v) for v in order], mp.matrix.__mul__))
            check(case, "q_" + name, product_of([half_exponential(v) for v in order], hamilton))

    case = cases["G23"]
    yaw, pitch, roll = numbers(case["output"]["angles"])
    turns = [elementary(3, yaw), elementary(2, pitch), elementary(1, roll)]
    matrix = product_of([exponential_matrix(v) for v in turns], mp.matrix.__mul__)
    check(case, "R", matrix)
    agree(case, "M", matrix, case["input"]["M"])
    agree(case, "pitch and roll", [pitch, roll], [mp.pi / 2, 0])

    case = cases["G33"]
    attitude = exponential_matrix(numbers(case["input"]["v_WB"]))
    turn = exponential_matrix(numbers(case["input"]["delta"]))
    for name, after in (("local", attitude * turn), ("global", turn * attitude)):
        check(case, "R_WB_" + name, after)
        check(case, "R_BW_" + name, after.T)


def vectors(cases):
    case = cases["G24"]
    angles, rates = numbers(case["input"]["angles"]), numbers(case["input"]["rates"])

    def attitude(time):
        turns = [elementary(axis, a + rate * time) for axis, a, rate in zip((3, 2, 1), angles, rates)]
        return product_of([exponential_matrix(v) for v in turns], mp.matrix.__mul__)

    rows = slope(lambda time: flat(attitude(time)), 9)
    derivative = mp.matrix([rows[0:3], rows[3:6], rows[6:9]])
    check(case, "omega_B", vector_of(attitude(0).T * derivative))
    check(case, "omega_W", vector_of(derivative * attitude(0).T))

    case = cases["G25"]
    a, b = (exponential_matrix(numbers(case["input"][name])) for name in ("a", "b"))
    check(case, "R", a * b)
    check(case, "v", logarithm(a * b))

    # The mean of Exp(-s v) over s from 0 to 1: a block of the exponential of a larger matrix.
    case = cases["G26"]
    large = mp.zeros(6)
    large[0:3, 0:3] = -skew(numbers(case["input"]["v"]))
    large[0:3, 3:6] = mp.eye(3)
    jacobian = mp.expm(large, method="taylor")[0:3, 3:6]
    check(case, "Jr", jacobian)
    check(case, "Jr_inv", mp.inverse(jacobian))
    check(case, "v_dot", mp.lu_solve(jacobian, mp.matrix(numbers(case["input"]["omega_B"]))))

    case = cases["G27"]
    vectors = [numbers(case["input"][name]) for name in ("a", "b")]
    a, b = (exponential_matrix(v) for v in vectors)
    p, q = (mp.matrix(half_exponential(v)) for v in vectors)
    check(case, "geodesic", mp.norm(mp.matrix(logarithm(a.T * b))))
    check(case, "chordal", mp.norm(mp.matrix(flat(a - b))))
    check(case, "quaternion", mp.norm(p - q))
    check(case, "quaternion_second_negated", mp.norm(p + q))
    check(case, "quaternion_min", min(mp.norm(p - q), mp.norm(p + q)))

    case = cases["G29"]
    first, second, mounted = (exponential_matrix(numbers(case["input"]["v_" + name])) for name in ("GI1", "GI2", "IC"))
    p_1, p_2, lever = (mp.matrix(numbers(case["input"]["p_" + name])) for name in ("GI1", "GI2", "IC"))
    camera_1, camera_2 = first * mounted, second * mounted
    moved = camera_1.T * (p_2 + second * lever - p_1 - first * lever)
    check(case, "R_C2_C1", camera_2.T * camera_1)
    check(case, "p_C1_C2", moved)
    check(case, "p_GI2_corrected", p_2)
    check(case, "p_GI2_as_printed", p_1 + first * lever + camera_1 * moved - camera_2 * lever)

    case = cases["G31"]
    q, rate = numbers(case["input"]["q_wxyz"]), [mp.mpf(0)] + numbers(case["input"]["omega"])
    check(case, "OmegaH_q", hamilton(q, rate))
    left = jpl(rate, q)
    check(case, "OmegaJ_q_xyzw", left[1:] + left[:1])

    # The commutator of two skew matrices is the skew matrix of the cross product.
    case = cases["G34"]
    h, a, b = mp.mpf(case["input"]["h"]), *(skew(numbers(case["input"][name])) for name in ("omega_a", "omega_b"))
    theta = vector_of((a + b) * h / 2 + (a * b - b * a) * h**2 * mp.sqrt(3) / 12)
    check(case, "theta", theta)
    check(case, "q_step", half_exponential(theta))


def main():
    file = json.loads((pathlib.Path(__file__).parent / "golden.json").read_text())
    cases = {case["id"]: case for case in file["cases"]}
    for n in range(1, 9):
        case = cases[f"G{n:02d}"]
        convention, given = case["convention"], case["input"]
        product = hamilton if convention["handedness"] == "Right" else jpl
        body_to_world = exponential_matrix(numbers(given["v_WB"]))
        passive_b2w = convention["function"] == "Passive", convention["direction"] == "B2W"
        operator = body_to_world if passive_b2w[0] == passive_b2w[1] else body_to_world.T
        check(case, "S", operator)
        check(case, "S_x", operator * mp.matrix(numbers(given["x"])))
        # Of q and its conjugate, the components are those that act as the operator.
        def in_convention(v):
            q, turn = half_exponential(numbers(v)), exponential_matrix(numbers(v))
            wanted = turn if passive_b2w[0] == passive_b2w[1] else turn.T
            acts = mp.matrix(matrix_of(q, product))
            return q if mp.norm(acts - wanted) < mp.mpf(10) ** -40 else conjugate(q)
        q_wb, q_bc = in_convention(given["v_WB"]), in_convention(given["v_BC"])
        check(case, "q_WB_wxyz", q_wb)
        check(case, "q_WB_xyzw", q_wb[1:] + q_wb[:1])
        check(case, "q_BC_wxyz", q_bc)
        # R_WC = R_WB R_BC: find the order of the product that acts so.
        chain = body_to_world * exponential_matrix(numbers(given["v_BC"]))
        chain = chain if passive_b2w[0] == passive_b2w[1] else chain.T
        candidates = [product(q_wb, q_bc), product(q_bc, q_wb)]
        [q_wc] = [q for q in candidates if mp.norm(mp.matrix(matrix_of(q, product)) - chain) < mp.mpf(10) ** -40]
        check(case, "q_WC_wxyz", q_wc)
        motion(case, q_wb == half_exponential(numbers(given["v_WB"])))

    case = cases["G09"]
    p, q = numbers(case["input"]["p"]), numbers(case["input"]["q"])
    check(case, "hamilton", hamilton(p, q))
    check(case, "jpl", jpl(p, q))

    case = cases["G10"]
    q = numbers(case["input"]["q"])
    for hand, product in (("Right", hamilton), ("Left", jpl)):
        for order in ("first", "last"):
            swapped = lambda a, b, product=product: product(b, a)
            check(case, f"{hand}_w{order}_L", left_matrix(q, product, order))
            check(case, f"{hand}_w{order}_R", left_matrix(q, swapped, order))

    for name in ("G11", "G30"):
        check(cases[name], "R", matrix_of(numbers(cases[name]["input"]["q"]), hamilton))

    # Without the division by the square of the norm: q x q*.
    q = numbers(cases["G11"]["input"]["q"])
    scaled = mp.matrix(matrix_of(q, hamilton)) * sum(c * c for c in q)
    check(cases["G11"], "M", scaled)

    case = cases["G16"]
    axis = [mp.mpf(2) / 3, -mp.mpf(1) / 3, mp.mpf(2) / 3]
    check(case, "q", [mp.mpf(0)] + axis)
    check(case, "log_plus", [mp.pi * c for c in axis])

    case = cases["G17"]
    w, *vector = numbers(case["input"]["q"])
    size = mp.norm(mp.matrix(vector))
    check(case, "v", [2 * mp.atan2(size, w) / size * c for c in vector])

    for name in ("G18", "G19"):
        v = numbers(cases[name]["input"]["v"])
        check(cases[name], "q", half_exponential(v))
        check(cases[name], "R", exponential_matrix(v))
    size = mp.norm(mp.matrix(v))
    check(cases["G19"], "wrapped", [c * (size - 2 * mp.pi) / size for c in v])

    case = cases["G28"]
    q, point = half_exponential(numbers(case["input"]["v"])), numbers(case["input"]["p_a"])
    check(case, "Q_ab", q)
    check(case, "Q_P_Qinv", turned(q, point, hamilton))
    check(case, "p_b", turned(conjugate(q), point, hamilton))

    case = cases["G32"]
    q = half_exponential(numbers(case["input"]["v_WB"]))
    last = lambda q: q[1:] + q[:1]
    check(case, "hamilton_B2W_wxyz", q)
    check(case, "eigen_ros_B2W_xyzw", last(q))
    check(case, "jpl_W2B_xyzw", last(q))
    check(case, "jpl_B2W_xyzw", last(conjugate(q)))
    check(case, "hamilton_W2B_wxyz", conjugate(q))
    check(case, "mylab_active_W2B_wxyz", q)
    check(case, "mylab_matrix_R_WtoB", mp.matrix(matrix_of(q, hamilton)).T)

    matrices(cases)
    vectors(cases)
    print(f"{compared} numbers agree")


main()
