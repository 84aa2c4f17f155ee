"""Libraries of mathematics and attitude estimation."""

from .register import array, homogeneous, last_first, library, plain, top_left


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
