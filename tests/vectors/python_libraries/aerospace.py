"""Libraries of aerospace, and small ones."""

import math

from .register import array, library, plain


@library("navpy")
def navpy():
    import navpy as nav

    def flat(pair):
        scalar, vector = pair
        return [float(array(scalar).reshape(-1)[0]), *array(vector).reshape(-1)]

    return {
        "make": lambda w, x, y, z: [w, x, y, z],
        "parts": list,
        "product": lambda a, b: flat(nav.qmult(a[0], array(a[1:]), b[0], array(b[1:]))),
        "matrix": lambda q: nav.quat2dcm(q[0], array(q[1:])),
        "from_matrix": lambda m: flat(nav.dcm2quat(array(m))),
        "euler": {
            "angle2quat(.3,.5,.7) default ZYX": lambda *e: flat(nav.angle2quat(*e)),
            "angle2dcm(.3,.5,.7) default ZYX": nav.angle2dcm,
        },
    }


@library("spiceypy")
def spiceypy():
    import spiceypy as spice

    return {
        **plain("wxyz"),
        "product": spice.qxq,
        "matrix": lambda q: spice.q2m(array(q)),
        "from_matrix": lambda m: spice.m2q(array(m)),
        "axis_z": lambda t: spice.m2q(spice.axisar([0, 0, 1], t)),
        "euler": {
            "eul2m(.3,.5,.7, 3,2,1)": lambda *e: spice.eul2m(*e, 3, 2, 1),
            "eul2m(.3,.5,.7, 1,2,3)": lambda *e: spice.eul2m(*e, 1, 2, 3),
            "eul2m(.3,.5,.7, 3,1,3)": lambda *e: spice.eul2m(*e, 3, 1, 3),
        },
    }


@library("pymavlink")
def pymavlink():
    from pymavlink.quaternion import QuaternionBase

    def normalize(q):
        q = QuaternionBase(q)
        q.normalize()
        return q

    return {
        "make": lambda *p: QuaternionBase(list(p)),
        "parts": lambda q: q.q,
        "given": QuaternionBase,
        "array": lambda q: q.q,
        "product": lambda a, b: a * b,
        "matrix": lambda q: q.dcm,
        "rotate": lambda q, v: q.transform(array(v)),
        "from_matrix": lambda m: QuaternionBase(array(m)),
        "inverse": lambda q: q.inversed,
        "normalize": normalize,
        "euler": {"QuaternionBase([roll=.3,pitch=.5,yaw=.7])": lambda *e: QuaternionBase(list(e)).q},
    }


@library("anise")
def anise():
    from anise.rotation import DCM, Quaternion

    def parts(q):
        return [q.w, q.x, q.y, q.z]

    # Frames have numbers: the left factor leads from 1 to 2, the right one from 0 to 1.
    return {
        "make": lambda *p: Quaternion(*p, 1, 1),
        "parts": parts,
        "given": lambda p: Quaternion(*p, 1, 1),
        "product": lambda a, b: Quaternion(*parts(a), 1, 2) * Quaternion(*parts(b), 0, 1),
        "matrix": lambda q: q.to_dcm().rot_mat,
    }


@library("euclid3")
def euclid3():
    from euclid3 import Quaternion, Vector3

    def parts(q):
        return [q.w, q.x, q.y, q.z]

    def rows(m):
        return [[m.a, m.b, m.c], [m.e, m.f, m.g], [m.i, m.j, m.k]]

    def rotate(q, v):
        r = q * Vector3(*v)
        return [r.x, r.y, r.z]

    return {
        "make": Quaternion,
        "parts": parts,
        "given": lambda p: Quaternion(*p),
        "product": lambda a, b: a * b,
        "matrix": lambda q: rows(q.get_matrix()),
        "rotate": rotate,
        "axis_z": lambda t: Quaternion.new_rotate_axis(t, Vector3(0, 0, 1)),
        "slerp": lambda a, b: Quaternion.new_interpolate(a, b, 0.5),
        "normalize": lambda q: q.normalized(),
        "euler": {
            "Quaternion.new_rotate_euler(heading=.3,attitude=.5,bank=.7)": lambda *e: parts(
                Quaternion.new_rotate_euler(*e)
            )
        },
    }


@library("basilisk")
def basilisk():
    from Basilisk.utilities import RigidBodyKinematics as rbk

    names = ["euler3212C", "euler1232C", "euler3132C"]
    euler = {f"{n}([.3,.5,.7])": lambda *e, n=n: getattr(rbk, n)(array(e)) for n in names}
    euler["euler3212EP"] = lambda *e: rbk.euler3212EP(array(e))
    return {
        **plain("wxyz"),
        "product": lambda a, b: rbk.addEP(array(a), array(b)),
        "matrix": lambda q: rbk.EP2C(array(q)),
        "from_matrix": lambda m: rbk.C2EP(array(m)),
        "axis_z": lambda t: rbk.PRV2EP(array([0, 0, t])),
        "euler": euler,
    }


@library("unityquaternionpy")
def unityquaternionpy():
    from UnityQuaternion import Quaternion

    def parts(q):
        return [q.w, q.x, q.y, q.z]

    return {
        "make": lambda w, x, y, z: Quaternion(x, y, z, w),
        "parts": parts,
        "given": lambda p: Quaternion(*p),
        "product": lambda a, b: a * b,
        "euler": {
            "Quaternion.Euler(x,y,z)": lambda *e: parts(Quaternion.Euler(*(math.degrees(angle) for angle in e)))
        },
    }


@library("yostlabs-math")
def yostlabs_math():
    from yostlabs.math import quaternion as yost

    return {
        **plain("xyzw"),
        "product": yost.quat_mul,
        "rotate": yost.quat_rotate_vec,
        "from_matrix": lambda m: yost.quaternion_from_3x3_rotation_matrix(array(m).reshape(9)),
        "axis_z": lambda t: yost.quat_from_axis_angle([0, 0, 1], t),
    }


@library("pspincalc")
def pspincalc():
    import PSpincalc as ps

    def first(rows):
        return array(rows).reshape(-1)[:4]

    return {
        **plain("wxyz"),
        "matrix": lambda q: array(ps.Q2DCM(array(q))).reshape(-1)[:9].reshape(3, 3),
        "from_matrix": lambda m: first(ps.DCM2Q(array(m))),
        "euler": {
            "EA2DCM([.3,.5,.7],'zyx')": lambda *e: array(ps.EA2DCM(array(e), "zyx")).reshape(-1)[:9].reshape(3, 3),
            "EA2Q([.3,.5,.7],'xyz')": lambda *e: first(ps.EA2Q(array(e), "xyz")),
        },
    }
