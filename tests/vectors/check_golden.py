"""Recomputes the golden cases with 60 digits, from definitions alone, and compares.

Nothing here uses a formula of quatlas: a turn is the exponential of a matrix, a product is the
multiplication table of i, j, k, and a quaternion turns a vector by q x q^-1.

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
    global compared
    for value, wanted in zip(flat(got), flat(case["output"][name]), strict=True):
        allowed = max(mp.mpf(case["tol"]), mp.mpf(2) ** -53) * max(1, abs(wanted))
        assert abs(value - wanted) <= allowed, (case["id"], name, value, wanted)
        compared += 1


def left_matrix(q, product, order):
    """Columns: q times each basis array."""
    basis = {"first": [0, 1, 2, 3], "last": [1, 2, 3, 0]}[order]
    images = [product(q, [mp.mpf(i == place) for i in range(4)]) for place in basis]
    return [[image[place] for image in images] for place in basis]


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
    print(f"{compared} numbers agree")


main()
