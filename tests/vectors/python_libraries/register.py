"""What every adapter of a library gives, and a few orders of numbers."""

RUNS = {}
DOUBLE, SINGLE = 1e-12, 2e-6


def library(identifier, tolerance=DOUBLE):
    """Registers a function that imports a library and returns what to call, by these names:

    make(w, x, y, z): a quaternion, of named components     parts(q): its [w, x, y, z]
    given(p): what the constructor makes of four numbers    array(q): its own order
    product, matrix, rotate, from_matrix, axis_z(angle), slerp(a, b), inverse, normalize
    euler: {call as recorded: function of a, b, c that gives a quaternion's parts or a matrix}
    """

    def register(function):
        RUNS[identifier] = (function, tolerance)
        return function

    return register


def plain(order):
    """The calls of a library whose quaternion is a list of four numbers."""
    if order == "wxyz":
        return {"make": lambda w, x, y, z: [w, x, y, z], "parts": list, "given": list, "array": list}
    return {
        "make": lambda w, x, y, z: [x, y, z, w],
        "parts": lambda q: [q[3], q[0], q[1], q[2]],
        "given": list,
        "array": list,
    }


def last_first(q):
    return [q[3], q[0], q[1], q[2]]


def top_left(m):
    return [[m[i][j] for j in range(3)] for i in range(3)]


def array(values):
    import numpy

    return numpy.array(values, dtype=float)


def homogeneous(m):
    return [[*m[0], 0], [*m[1], 0], [*m[2], 0], [0, 0, 0, 1]]
