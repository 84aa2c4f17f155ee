"""Runs the Python libraries of src/libraries.json again and compares with src/observations.json.

    python3 tests/vectors/run_python.py [id ...]

A library that is not installed is listed and counts as nothing. Exit code 1 if a number differs.
README.md tells how to install the versions that are recorded.
"""

import json
import math
import pathlib
import sys
import warnings

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOUBLE, SINGLE = 1e-12, 2e-6
RUNS = {}


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


@library("scipy")
def scipy():
    from scipy.spatial.transform import Rotation, Slerp

    def slerp(a, b):
        return Slerp([0, 1], Rotation.concatenate([a, b]))(0.5)

    sequences = ["xyz", "XYZ", "zyx", "ZYX", "zxz", "ZXZ"]
    return {
        "make": lambda w, x, y, z: Rotation.from_quat([x, y, z, w]),
        "parts": lambda q: last_first(q.as_quat()),
        "given": Rotation.from_quat,
        "array": lambda q: q.as_quat(),
        "product": lambda a, b: a * b,
        "matrix": lambda q: q.as_matrix(),
        "rotate": lambda q, v: q.apply(v),
        "from_matrix": Rotation.from_matrix,
        "axis_z": lambda t: Rotation.from_rotvec([0, 0, t]),
        "slerp": slerp,
        "inverse": lambda q: q.inv(),
        "euler": {
            f"Rotation.from_euler('{s}',[.3,.5,.7])": lambda *e, s=s: Rotation.from_euler(s, e).as_matrix()
            for s in sequences
        },
    }


@library("scipy-scalar-first")
def scipy_scalar_first():
    from scipy.spatial.transform import Rotation

    calls = scipy()
    calls["make"] = lambda *p: Rotation.from_quat(p, scalar_first=True)
    calls["parts"] = calls["array"] = lambda q: q.as_quat(scalar_first=True)
    calls["given"] = lambda p: Rotation.from_quat(p, scalar_first=True)
    return calls


@library("numpy-quaternion")
def numpy_quaternion():
    import quaternion as nq

    return {
        "make": nq.quaternion,
        "parts": nq.as_float_array,
        "given": lambda p: nq.quaternion(*p),
        "array": nq.as_float_array,
        "product": lambda a, b: a * b,
        "matrix": nq.as_rotation_matrix,
        "rotate": lambda q, v: nq.rotate_vectors(q, [float(x) for x in v]),
        "from_matrix": lambda m: nq.from_rotation_matrix(array(m)),
        "axis_z": lambda t: nq.from_rotation_vector([0, 0, t]),
        "slerp": lambda a, b: nq.slerp_evaluate(a, b, 0.5),
        "inverse": lambda q: q.inverse(),
        "normalize": lambda q: q.normalized(),
        "euler": {"from_euler_angles(.3,.5,.7)": lambda *e: nq.as_float_array(nq.from_euler_angles(*e))},
    }


@library("pyquaternion")
def pyquaternion():
    from pyquaternion import Quaternion

    return {
        "make": Quaternion,
        "parts": lambda q: q.elements,
        "given": lambda p: Quaternion(*p),
        "array": lambda q: q.elements,
        "product": lambda a, b: a * b,
        "matrix": lambda q: Quaternion(q).rotation_matrix,
        "rotate": lambda q, v: Quaternion(q).rotate(v),
        "from_matrix": lambda m: Quaternion(matrix=array(m)),
        "axis_z": lambda t: Quaternion(axis=[0, 0, 1], angle=t),
        "slerp": lambda a, b: Quaternion.slerp(a, b, 0.5),
        "inverse": lambda q: q.inverse,
        "normalize": lambda q: q.normalised,
    }


@library("transforms3d")
def transforms3d():
    import transforms3d.euler as te
    import transforms3d.quaternions as tq

    sequences = ["sxyz", "rxyz", "szyx", "rzyx", "szxz", "rzxz"]
    euler = {f"euler2mat(.3,.5,.7,'{s}')": lambda *e, s=s: te.euler2mat(*e, s) for s in sequences}
    euler["euler2quat(.3,.5,.7) default sxyz"] = te.euler2quat
    return {
        **plain("wxyz"),
        "product": tq.qmult,
        "matrix": tq.quat2mat,
        "rotate": lambda q, v: tq.rotate_vector(v, q),
        "from_matrix": lambda m: tq.mat2quat(array(m)),
        "axis_z": lambda t: tq.axangle2quat([0, 0, 1], t),
        "inverse": lambda q: tq.qinverse(array(q)),
        "euler": euler,
    }


@library("transformations")
def transformations():
    import transformations as tf

    sequences = ["sxyz", "rxyz", "szyx", "rzyx", "rzxz"]
    euler = {f"euler_matrix(.3,.5,.7,'{s}')": lambda *e, s=s: top_left(tf.euler_matrix(*e, s)) for s in sequences}
    euler["quaternion_from_euler(.3,.5,.7) default"] = tf.quaternion_from_euler
    return {
        **plain("wxyz"),
        "product": tf.quaternion_multiply,
        "matrix": lambda q: top_left(tf.quaternion_matrix(q)),
        "from_matrix": lambda m: tf.quaternion_from_matrix(homogeneous(m)),
        "axis_z": lambda t: tf.quaternion_about_axis(t, [0, 0, 1]),
        "slerp": lambda a, b: tf.quaternion_slerp(a, b, 0.5),
        "inverse": tf.quaternion_inverse,
        "euler": euler,
    }


@library("pytransform3d")
def pytransform3d():
    import pytransform3d.rotations as pr

    def named(i, j, k, extrinsic):
        return lambda *e: pr.matrix_from_euler(e, i, j, k, extrinsic)

    return {
        **plain("wxyz"),
        "product": lambda a, b: pr.concatenate_quaternions(array(a), array(b)),
        "matrix": lambda q: pr.matrix_from_quaternion(array(q)),
        "rotate": lambda q, v: pr.q_prod_vector(array(q), array(v)),
        "from_matrix": lambda m: pr.quaternion_from_matrix(array(m)),
        "axis_z": lambda t: pr.quaternion_from_axis_angle(array([0, 0, 1, t])),
        "slerp": lambda a, b: pr.quaternion_slerp(array(a), array(b), 0.5),
        "euler": {
            "matrix_from_euler([.3,.5,.7],0,1,2,extrinsic=True)": named(0, 1, 2, True),
            "matrix_from_euler([.3,.5,.7],2,1,0,extrinsic=False)": named(2, 1, 0, False),
            "matrix_from_euler([.3,.5,.7],2,0,2,extrinsic=False)": named(2, 0, 2, False),
        },
    }


@library("spatialmath")
def spatialmath():
    from spatialmath import UnitQuaternion

    return {
        "make": lambda *p: UnitQuaternion(list(p)),
        "parts": lambda q: q.A,
        "given": UnitQuaternion,
        "array": lambda q: q.A,
        "product": lambda a, b: a * b,
        "matrix": lambda q: q.R,
        "rotate": lambda q, v: (q * array(v)).flatten(),
        "from_matrix": lambda m: UnitQuaternion(array(m)),
        "axis_z": UnitQuaternion.Rz,
        "slerp": lambda a, b: a.interp(b, 0.5),
        "inverse": lambda q: q.inv(),
        "euler": {
            "UnitQuaternion.RPY([.3,.5,.7]) default order zyx": lambda *e: UnitQuaternion.RPY(e).A,
            "UnitQuaternion.RPY(order='xyz')": lambda *e: UnitQuaternion.RPY(e, order="xyz").A,
            "UnitQuaternion.RPY(order='yxz')": lambda *e: UnitQuaternion.RPY(e, order="yxz").A,
            "UnitQuaternion.Eul([.3,.5,.7])": lambda *e: UnitQuaternion.Eul(e).A,
        },
    }


@library("ahrs")
def ahrs():
    from ahrs import DCM, Quaternion
    from ahrs.common import orientation

    return {
        "make": lambda *p: Quaternion(list(p)),
        "parts": lambda q: list(q),
        "given": Quaternion,
        "array": lambda q: q.to_array(),
        "product": lambda a, b: a * b,
        "matrix": lambda q: q.to_DCM(),
        "rotate": lambda q, v: q.rotate(array(v)),
        "from_matrix": lambda m: Quaternion(dcm=array(m)),
        "inverse": lambda q: q.inverse,
        "euler": {
            "Quaternion(rpy=[.3,.5,.7])": lambda *e: list(Quaternion(rpy=array(e))),
            "Quaternion(angles=[.3,.5,.7])": lambda *e: list(Quaternion(angles=array(e))),
            "DCM(rpy=[.3,.5,.7])": lambda *e: DCM(rpy=list(e)),
            "DCM(euler=('zyx',[.3,.5,.7]))": lambda *e: DCM(euler=("zyx", list(e))),
            "DCM(x=.3,y=.5,z=.7)": lambda *e: DCM(x=e[0], y=e[1], z=e[2]),
            "orientation.rpy2q(np.array)": lambda *e: orientation.rpy2q(array(e)),
        },
    }


@library("squaternion")
def squaternion():
    from squaternion import Quaternion

    return {
        "make": Quaternion,
        "parts": lambda q: [q.w, q.x, q.y, q.z],
        "given": lambda p: Quaternion(*p),
        "array": lambda q: [q.w, q.x, q.y, q.z],
        "product": lambda a, b: a * b,
        "matrix": lambda q: q.to_rot(),
        "normalize": lambda q: q.normalize,
        "euler": {
            "Quaternion.from_euler(roll=.3,pitch=.5,yaw=.7)": lambda *e: list(Quaternion.from_euler(*e).to_tuple())
        },
    }


@library("sympy")
def sympy():
    from sympy import Matrix
    from sympy.algebras.quaternion import Quaternion

    def floats(p):
        return [float(x) for x in p]

    sequences = ["xyz", "XYZ", "zyx", "ZYX", "zxz", "ZXZ"]
    return {
        "make": Quaternion,
        "parts": lambda q: floats([q.a, q.b, q.c, q.d]),
        "given": lambda p: Quaternion(*p),
        "array": lambda q: floats(q.args),
        "product": lambda a, b: a * b,
        "matrix": lambda q: [floats(row) for row in q.to_rotation_matrix().tolist()],
        "rotate": lambda q, v: floats(Quaternion.rotate_point(tuple(v), q)),
        "from_matrix": lambda m: Quaternion.from_rotation_matrix(Matrix(m)),
        "axis_z": lambda t: Quaternion.from_axis_angle((0, 0, 1), t),
        "inverse": lambda q: q.inverse(),
        "normalize": lambda q: q.normalize(),
        "euler": {
            f"Quaternion.from_euler([.3,.5,.7],'{s}')": lambda *e, s=s: floats(Quaternion.from_euler(e, s).args)
            for s in sequences
        },
    }


@library("mujoco")
def mujoco():
    import mujoco as mj

    def filled(size, function, *arguments):
        out = array([0.0] * size)
        function(out, *arguments)
        return out

    def matrix(q):
        return filled(9, mj.mju_quat2Mat, array(q)).reshape(3, 3)

    def normalize(q):
        out = array(q)
        mj.mju_normalize4(out)
        return out

    return {
        **plain("wxyz"),
        "product": lambda a, b: filled(4, mj.mju_mulQuat, array(a), array(b)),
        "matrix": matrix,
        "rotate": lambda q, v: filled(3, mj.mju_rotVecQuat, array(v), array(q)),
        "from_matrix": lambda m: filled(4, mj.mju_mat2Quat, array(m).reshape(9)),
        "axis_z": lambda t: filled(4, mj.mju_axisAngle2Quat, array([0.0, 0.0, 1.0]), t),
        "normalize": normalize,
        "euler": {
            f"mju_euler2Quat([.3,.5,.7],'{s}')": lambda *e, s=s: filled(4, mj.mju_euler2Quat, array(e), s)
            for s in ["xyz", "XYZ", "zyx", "ZYX"]
        },
    }


@library("pybullet")
def pybullet():
    import pybullet as p

    none = [0, 0, 0]
    return {
        **plain("xyzw"),
        "product": lambda a, b: p.multiplyTransforms(none, a, none, b)[1],
        "matrix": lambda q: array(p.getMatrixFromQuaternion(q)).reshape(3, 3),
        "rotate": lambda q, v: p.rotateVector(q, v),
        "axis_z": lambda t: p.getQuaternionFromAxisAngle([0, 0, 1], t),
        "slerp": lambda a, b: p.getQuaternionSlerp(a, b, 0.5),
        "inverse": lambda q: p.invertTransform(none, q)[1],
        "euler": {
            "getQuaternionFromEuler([.3,.5,.7])": lambda *e: last_first(p.getQuaternionFromEuler(e)),
        },
    }


@library("gtsam")
def gtsam():
    from gtsam import Rot3

    return {
        "make": Rot3.Quaternion,
        "parts": lambda q: last_first(q.toQuaternion().coeffs()),
        "given": lambda p: Rot3.Quaternion(*p),
        "array": lambda q: q.toQuaternion().coeffs(),
        "product": lambda a, b: a * b,
        "matrix": lambda q: q.matrix(),
        "rotate": lambda q, v: q.rotate(array(v)),
        "from_matrix": lambda m: Rot3(array(m)),
        "axis_z": Rot3.Rz,
        "slerp": lambda a, b: a.slerp(0.5, b),
        "inverse": lambda q: q.inverse(),
        "euler": {
            "Rot3.Ypr(.3,.5,.7)": lambda *e: Rot3.Ypr(*e).matrix(),
            "Rot3.RzRyRx(.3,.5,.7)": lambda *e: Rot3.RzRyRx(*e).matrix(),
        },
    }


@library("pinocchio")
def pinocchio():
    import pinocchio as pin

    def normalize(q):
        q = pin.Quaternion(q)
        q.normalize()
        return q

    return {
        "make": lambda *p: pin.Quaternion(*(float(x) for x in p)),
        "parts": lambda q: last_first(q.coeffs()),
        "given": lambda p: pin.Quaternion(*p),
        "array": lambda q: q.coeffs(),
        "product": lambda a, b: a * b,
        "matrix": lambda q: q.toRotationMatrix(),
        "rotate": lambda q, v: q * array(v),
        "from_matrix": lambda m: pin.Quaternion(array(m)),
        "axis_z": lambda t: pin.Quaternion(pin.AngleAxis(t, array([0.0, 0.0, 1.0]))),
        "slerp": lambda a, b: a.slerp(0.5, b),
        "inverse": lambda q: q.inverse(),
        "normalize": normalize,
        "euler": {"pinocchio.rpy.rpyToMatrix(.3,.5,.7)": pin.rpy.rpyToMatrix},
    }


@library("drake")
def drake():
    from pydrake.common.eigen_geometry import AngleAxis, Quaternion
    from pydrake.math import RollPitchYaw, RotationMatrix

    return {
        "make": Quaternion,
        "parts": lambda q: q.wxyz(),
        "given": lambda p: Quaternion(*p),
        "array": lambda q: q.wxyz(),
        "product": lambda a, b: a.multiply(b),
        "matrix": lambda q: q.rotation(),
        "rotate": lambda q, v: q.multiply(array(v)),
        "from_matrix": lambda m: RotationMatrix(array(m)).ToQuaternion(),
        "axis_z": lambda t: AngleAxis(t, array([0.0, 0.0, 1.0])).quaternion(),
        "slerp": lambda a, b: a.slerp(0.5, b),
        "inverse": lambda q: q.inverse(),
        "euler": {
            "RollPitchYaw(.3,.5,.7).ToRotationMatrix()": lambda *e: RollPitchYaw(*e).ToRotationMatrix().matrix()
        },
    }


@library("pyglm")
def pyglm():
    from pyglm import glm

    def parts(q):
        return [q.w, q.x, q.y, q.z]

    def rows(m):
        return [[m[j][i] for j in range(3)] for i in range(3)]

    def columns(m):
        return glm.dmat3(*(m[i][j] for j in range(3) for i in range(3)))

    return {
        "make": glm.dquat,
        "parts": parts,
        "given": lambda p: glm.dquat(*p),
        "array": list,
        "product": lambda a, b: a * b,
        "matrix": lambda q: rows(glm.mat3_cast(q)),
        "rotate": lambda q, v: list(q * glm.dvec3(*v)),
        "from_matrix": lambda m: glm.quat_cast(columns(m)),
        "axis_z": lambda t: glm.angleAxis(t, glm.dvec3(0, 0, 1)),
        "slerp": lambda a, b: glm.slerp(a, b, 0.5),
        "inverse": glm.inverse,
        "normalize": glm.normalize,
        "euler": {"glm.quat(vec3(.3,.5,.7))  pitch,yaw,roll": lambda *e: parts(glm.dquat(glm.dvec3(*e)))},
    }


@library("panda3d")
def panda3d():
    from panda3d.core import LMatrix3d, LQuaterniond, LVecBase3d

    def matrix(q):
        m = LMatrix3d()
        q.extract_to_matrix(m)
        return [[m.get_cell(i, j) for j in range(3)] for i in range(3)]

    def from_matrix(m):
        q = LQuaterniond()
        q.set_from_matrix(LMatrix3d(*(x for row in m for x in row)))
        return q

    def normalize(q):
        q = LQuaterniond(q)
        q.normalize()
        return q

    def axis_z(t):
        q = LQuaterniond()
        q.set_from_axis_angle_rad(t, LVecBase3d(0, 0, 1))
        return q

    def hpr(*angles):
        q = LQuaterniond()
        q.set_hpr(LVecBase3d(*(math.degrees(angle) for angle in angles)))
        return list(q)

    def inverse(q):
        inverted = LQuaterniond()
        inverted.invert_from(q)
        return inverted

    return {
        "make": LQuaterniond,
        "parts": list,
        "given": lambda p: LQuaterniond(*p),
        "array": list,
        "product": lambda a, b: a * b,
        "matrix": matrix,
        "rotate": lambda q, v: list(q.xform(LVecBase3d(*v))),
        "from_matrix": from_matrix,
        "axis_z": axis_z,
        "inverse": inverse,
        "normalize": normalize,
        "euler": {"set_hpr((h,p,r) degrees)": hpr},
    }


@library("usd")
def usd():
    from pxr import Gf

    def rows(m):
        return [[m[i][j] for j in range(3)] for i in range(3)]

    return {
        "make": Gf.Quatd,
        "parts": lambda q: [q.GetReal(), *q.GetImaginary()],
        "given": lambda p: Gf.Quatd(*p),
        "product": lambda a, b: a * b,
        "matrix": lambda q: rows(Gf.Matrix3d(q)),
        "rotate": lambda q, v: list(q.Transform(Gf.Vec3d(*v))),
        "from_matrix": lambda m: Gf.Matrix3d(*(x for row in m for x in row)).ExtractRotation().GetQuat(),
        "axis_z": lambda t: Gf.Rotation(Gf.Vec3d(0, 0, 1), math.degrees(t)).GetQuat(),
        "slerp": lambda a, b: Gf.Slerp(0.5, a, b),
        "inverse": lambda q: q.GetInverse(),
        "normalize": lambda q: q.GetNormalized(),
    }


@library("mathutils", SINGLE)
def mathutils():
    from mathutils import Euler, Matrix, Quaternion, Vector

    return {
        "make": lambda *p: Quaternion(p),
        "parts": list,
        "given": Quaternion,
        "array": list,
        "product": lambda a, b: a @ b,
        "matrix": lambda q: [list(row) for row in q.to_matrix()],
        "rotate": lambda q, v: list(q @ Vector(v)),
        "from_matrix": lambda m: Matrix(m).to_quaternion(),
        "axis_z": lambda t: Quaternion((0, 0, 1), t),
        "slerp": lambda a, b: a.slerp(b, 0.5),
        "inverse": lambda q: q.inverted(),
        "normalize": lambda q: q.normalized(),
        "euler": {
            "Euler((.3,.5,.7)).to_matrix()  default XYZ": lambda *e: [list(row) for row in Euler(e).to_matrix()],
            "Quaternion from Euler((.3,.5,.7)).to_quaternion()": lambda *e: list(Euler(e).to_quaternion()),
        },
    }


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


def array(values):
    import numpy

    return numpy.array(values, dtype=float)


def homogeneous(m):
    return [[*m[0], 0], [*m[1], 0], [*m[2], 0], [0, 0, 0, 1]]


class Refused(str):
    """What an error said."""


def attempt(function, *arguments):
    try:
        return function(*arguments)
    except BaseException as error:  # an abort in Rust is no Exception
        if isinstance(error, (KeyboardInterrupt, SystemExit)):
            raise
        return Refused(f"{type(error).__name__}: {error}")


def flat(value):
    """The numbers of a value in order; an error stays an error."""
    if isinstance(value, str):
        return [math.nan] if value == "NaN" else [Refused(value)]
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, (list, tuple)):
        return [number for item in value for number in flat(item)]
    return [float(value)]


def compute(calls, recorded, inputs):
    """(key, recorded, printed) of everything that both the record and this script have."""
    make, parts = calls["make"], calls["parts"]
    a, b, v = inputs["a"], inputs["b"], inputs["v"]
    twice, zero = [2 * x for x in a], [0.0] * 4
    qa, qb, q0 = lambda: make(*a), lambda: make(*b), lambda: make(*zero)

    def named(function, *arguments):
        return lambda: parts(function(*(x() for x in arguments)))

    tries = {
        "norm2A": lambda: math.hypot(*(float(x) for x in parts(make(*twice)))),
        "constructed0": lambda: parts(q0()),
    }
    if "array" in calls:
        tries["arrayOfA"] = lambda: calls["array"](qa())
    if "given" in calls:
        tries["constructed1234"] = lambda: parts(calls["given"]([0.1, 0.2, 0.3, 0.4]))
    if product := calls.get("product"):
        # A product may be a bare array; `parts` reads that too.
        tries["productAB"] = lambda: components(calls, product(qa(), qb()))
        tries["productIJ"] = lambda: components(calls, product(make(0.0, 1.0, 0.0, 0.0), make(0.0, 0.0, 1.0, 0.0)))
    if matrix := calls.get("matrix"):
        tries["matrixA"] = lambda: matrix(qa())
        tries["matrixB"] = lambda: matrix(qb())
        tries["matrix2A"] = lambda: matrix(make(*twice))
        tries["matrix0"] = lambda: matrix(q0())
        if product:
            tries["matrixAB"] = lambda: matrix(product(qa(), qb()))
    if rotate := calls.get("rotate"):
        tries["rotateAV"] = lambda: rotate(qa(), v)
        tries["rotate2AV"] = lambda: rotate(make(*twice), v)
        tries["rotate0V"] = lambda: rotate(q0(), v)
        tries["rotateBThenA"] = lambda: rotate(qa(), flat(rotate(qb(), v)))
        tries["rotateAThenB"] = lambda: rotate(qb(), flat(rotate(qa(), v)))
        if product:
            tries["rotateABV"] = lambda: rotate(product(qa(), qb()), v)
    if "axis_z" in calls:
        tries["axisAngleZ"] = lambda: parts(calls["axis_z"](inputs["axisAngle"]))
    if slerp := calls.get("slerp"):
        tries["slerpPositive"] = lambda: parts(slerp(qa(), qb()))
        tries["slerpNegative"] = lambda: parts(slerp(qa(), make(*(-x for x in b))))
    if "inverse" in calls:
        tries["inverse0"] = named(calls["inverse"], q0)
    if "normalize" in calls:
        tries["normalize0"] = named(calls["normalize"], q0)

    for key, function in tries.items():
        if key in recorded:
            yield key, recorded[key], attempt(function)
    if "from_matrix" in calls and "fromMatrix" in recorded:
        for number, (m, was) in enumerate(zip(inputs["fromMatrix"], recorded["fromMatrix"], strict=True)):
            yield f"fromMatrix[{number}]", was, attempt(lambda m=m: parts(calls["from_matrix"](m)))
    for entry in recorded.get("euler", []):
        if function := calls.get("euler", {}).get(entry["call"]):
            yield entry["call"], entry["out"], attempt(function, *entry["args"])


def components(calls, product):
    return product if type(product).__module__ == "numpy" and product.shape == (4,) else calls["parts"](product)


def same(recorded, printed, tolerance):
    if len(recorded) != len(printed):
        return any(isinstance(x, Refused) for x in recorded) and any(isinstance(x, Refused) for x in printed)
    for was, now in zip(recorded, printed, strict=True):
        if isinstance(was, Refused) or isinstance(now, Refused):
            if not (isinstance(was, Refused) and isinstance(now, Refused)):
                return False
        elif math.isnan(was) or math.isnan(now):
            if not (math.isnan(was) and math.isnan(now)):
                return False
        elif abs(was - now) > tolerance * max(1.0, abs(was)):
            return False
    return True


def main(wanted):
    warnings.simplefilter("ignore")
    document = json.loads((ROOT / "src/observations.json").read_text())
    records = {record["id"]: record for record in json.loads((ROOT / "src/libraries.json").read_text())}
    recorded = {observation["id"]: observation for observation in document["observations"]}
    if unknown := set(wanted) - set(RUNS):
        sys.exit(f"no such id: {', '.join(sorted(unknown))}; there are: {', '.join(RUNS)}")
    agreed, differing, missing = [], [], []
    for identifier, (load, tolerance) in RUNS.items():
        if wanted and identifier not in wanted:
            continue
        version = records[identifier]["version"]
        try:
            calls = load()
        except ImportError as error:
            missing.append(identifier)
            print(f"{identifier} {version}: not installed ({error})")
            continue
        count, wrong = 0, []
        for key, was, now in compute(calls, recorded[identifier], document["inputs"]):
            count += 1
            was, now = flat(was), flat(now)
            if not same(was, now, tolerance):
                wrong.append(f"  {key}\n    recorded {was}\n    printed  {now}")
        (differing if wrong else agreed).append(identifier)
        print(f"{identifier} {version}: {f'{len(wrong)} of {count} differ' if wrong else f'agreed, {count} results'}")
        print("\n".join(wrong), end="\n" if wrong else "")
    print(f"agreed: {len(agreed)}, differing: {len(differing)}, not installed: {len(missing)}")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
