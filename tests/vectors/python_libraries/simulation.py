"""Libraries of simulation, robotics and graphics."""

import math

from .register import array, last_first, library, plain, SINGLE


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
