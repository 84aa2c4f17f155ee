// One object a library: its own calls, and nothing else. A quaternion stays the library's own
// between them; what is compared is named [w, x, y, z], and a matrix [row][column] as printed.
//
//   id          its name in src/library/libraries.json and src/library/observations.json
//   package     its name on npm
//   tolerance   of its numbers, absolute and scaled by max(1, |recorded|)
//   named       the library's quaternion with these four named components
//   construct   the library's quaternion from four numbers in the order in which it takes them
//   components  w, x, y, z of a quaternion, by name
//   array       the quaternion as the library writes it into an array
//   euler       by the call as it is recorded, with the recorded arguments
//   other       by what is recorded, with the inputs of all observations
//   notRerun    what is recorded and cannot be run again here, with the reason
import {
  Quaternion as BabylonQuaternion,
  Matrix,
  Vector3,
} from "@babylonjs/core/Maths/math.vector.js";
import Cartesian3 from "@cesium/engine/Source/Core/Cartesian3.js";
import HeadingPitchRoll from "@cesium/engine/Source/Core/HeadingPitchRoll.js";
import Matrix3 from "@cesium/engine/Source/Core/Matrix3.js";
import CesiumQuaternion from "@cesium/engine/Source/Core/Quaternion.js";
import * as glMatrix from "gl-matrix";
import Quaternion from "quaternion";
import * as THREE from "three";
import * as wgpu from "wgpu-matrix";

const FLOAT64 = 1e-14;
/** Of libraries that keep their numbers in a Float32Array. */
const FLOAT32 = 2e-7;

const byName = ({ w, x, y, z }) => [w, x, y, z];
const xyzwByName = ([x, y, z, w]) => [w, x, y, z];
const transposed = (rows) => rows[0].map((_, column) => rows.map((row) => row[column]));
/** The upper left nine of numbers in columns (or, for row vectors, rows) of a length. */
const threes = (numbers, length) =>
  [0, 1, 2].map((at) => Array.from(numbers.slice(length * at, length * at + 3)));
const fromColumns = (numbers, length) => transposed(threes(numbers, length));

const three = {
  id: "three",
  package: "three",
  tolerance: FLOAT64,
  named: (w, x, y, z) => new THREE.Quaternion(x, y, z, w),
  construct: (...four) => new THREE.Quaternion(...four),
  components: byName,
  array: (q) => q.toArray(),
  product: (a, b) => a.clone().multiply(b),
  matrix: (q) => fromColumns(new THREE.Matrix4().makeRotationFromQuaternion(q).elements, 4),
  rotate: (q, v) => new THREE.Vector3(...v).applyQuaternion(q).toArray(),
  norm: (q) => q.length(),
  aboutZ: (angle) => new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(0, 0, 1), angle),
  fromMatrix: (rows) => {
    const matrix = new THREE.Matrix4().setFromMatrix3(new THREE.Matrix3(...rows.flat()));
    return new THREE.Quaternion().setFromRotationMatrix(matrix);
  },
  slerp: (a, b, t) => a.clone().slerp(b, t),
  inverse: (q) => q.clone().invert(),
  normalize: (q) => q.clone().normalize(),
  euler: Object.fromEntries(
    ["XYZ", "ZYX", "YXZ"].map((order) => [
      `new Euler(.3,.5,.7,'${order}')`,
      (...angles) => {
        const matrix = new THREE.Matrix4().makeRotationFromEuler(new THREE.Euler(...angles, order));
        return fromColumns(matrix.elements, 4);
      },
    ]),
  ),
  other: {
    "premultiply(b) = b*a": ({ a, b }) => byName(three.named(...a).premultiply(three.named(...b))),
    "Vector3.applyEuler default order": () => new THREE.Euler().order,
  },
};

const { mat3, quat, vec3 } = glMatrix;

const glMatrixLibrary = {
  id: "gl-matrix",
  package: "gl-matrix",
  tolerance: FLOAT32,
  named: (w, x, y, z) => quat.fromValues(x, y, z, w),
  construct: (...four) => quat.fromValues(...four),
  components: xyzwByName,
  array: (q) => Array.from(q),
  product: (a, b) => quat.multiply(quat.create(), a, b),
  matrix: (q) => fromColumns(mat3.fromQuat(mat3.create(), q), 3),
  rotate: (q, v) => Array.from(vec3.transformQuat(vec3.create(), vec3.fromValues(...v), q)),
  norm: (q) => quat.length(q),
  aboutZ: (angle) => quat.setAxisAngle(quat.create(), [0, 0, 1], angle),
  fromMatrix: (rows) => quat.fromMat3(quat.create(), mat3.fromValues(...transposed(rows).flat())),
  slerp: (a, b, t) => quat.slerp(quat.create(), a, b, t),
  inverse: (q) => quat.invert(quat.create(), q),
  normalize: (q) => quat.normalize(quat.create(), q),
  euler: Object.fromEntries(
    [
      ["quat.fromEuler(out,x,y,z degrees)"],
      ["quat.fromEuler(out,x,y,z degrees,'xyz')", "xyz"],
      ["quat.fromEuler(out,x,y,z degrees,'zyx')", "zyx"],
    ].map(([call, ...order]) => [
      call,
      (...radians) => {
        const degrees = radians.map((angle) => (angle * 180) / Math.PI);
        return xyzwByName(quat.fromEuler(quat.create(), ...degrees, ...order));
      },
    ]),
  ),
};

const quaternionJs = {
  id: "quaternion-js",
  package: "quaternion",
  tolerance: FLOAT64,
  // Not from an object { w, x, y, z }: that reads NaN as 0.
  named: (w, x, y, z) => new Quaternion(w, x, y, z),
  construct: (...four) => new Quaternion(...four),
  components: byName,
  array: (q) => q.toVector(),
  product: (a, b) => a.mul(b),
  matrix: (q) => q.toMatrix(true),
  rotate: (q, v) => q.rotateVector(v),
  norm: (q) => q.norm(),
  aboutZ: (angle) => Quaternion.fromAxisAngle([0, 0, 1], angle),
  fromMatrix: (rows) => Quaternion.fromMatrix(rows),
  slerp: (a, b, t) => a.slerp(b)(t),
  inverse: (q) => q.inverse(),
  normalize: (q) => q.normalize(),
  euler: {
    "Quaternion.fromEuler(.3,.5,.7) default": (...angles) =>
      byName(Quaternion.fromEuler(...angles)),
    ...Object.fromEntries(
      ["ZXY", "XYZ", "RPY", "YPR", "ZYX"].map((order) => [
        `Quaternion.fromEuler(.3,.5,.7,'${order}')`,
        (...angles) => byName(Quaternion.fromEuler(...angles, order)),
      ]),
    ),
    "Quaternion.fromEulerLogical(.3,.5,.7)": (...angles) =>
      byName(Quaternion.fromEulerLogical(...angles)),
  },
  other: {
    "new Quaternion(2a) rotateVector assumption": ({ a }) =>
      new Quaternion(a.map((component) => 2 * component)).norm(),
    "Quaternion() zero-arg": () => new Quaternion().w,
  },
};

const babylon = {
  id: "babylon",
  package: "@babylonjs/core",
  tolerance: FLOAT64,
  named: (w, x, y, z) => new BabylonQuaternion(x, y, z, w),
  construct: (...four) => new BabylonQuaternion(...four),
  components: byName,
  array: (q) => q.asArray(),
  product: (a, b) => a.multiply(b),
  matrix: (q) => threes(q.toRotationMatrix(new Matrix()).m, 4),
  rotate: (q, v) => new Vector3(...v).applyRotationQuaternion(q).asArray(),
  norm: (q) => q.length(),
  aboutZ: (angle) => BabylonQuaternion.RotationAxis(new Vector3(0, 0, 1), angle),
  fromMatrix: (rows) =>
    BabylonQuaternion.FromRotationMatrix(
      Matrix.FromValues(...rows.flatMap((row) => [...row, 0]), 0, 0, 0, 1),
    ),
  slerp: (a, b, t) => BabylonQuaternion.Slerp(a, b, t),
  inverse: (q) => BabylonQuaternion.Inverse(q),
  normalize: (q) => BabylonQuaternion.Normalize(q),
  euler: {
    "Quaternion.RotationYawPitchRoll(yaw=.3,pitch=.5,roll=.7)": (...angles) =>
      byName(BabylonQuaternion.RotationYawPitchRoll(...angles)),
    "Quaternion.FromEulerAngles(.3,.5,.7)": (...angles) =>
      byName(BabylonQuaternion.FromEulerAngles(...angles)),
    "Quaternion.RotationAlphaBetaGamma(.3,.5,.7)": (...angles) =>
      byName(BabylonQuaternion.RotationAlphaBetaGamma(...angles)),
  },
  other: {
    "Vector3.TransformCoordinates(v,M(q))": ({ a, v }) => {
      const matrix = babylon.named(...a).toRotationMatrix(new Matrix());
      return Vector3.TransformCoordinates(new Vector3(...v), matrix).asArray();
    },
    "Matrix.RotationZ(.3) m[1]": ({ axisAngle }) => Matrix.RotationZ(axisAngle).m[1],
  },
  notRerun: { "other note": "words about it, not what it printed" },
};

const cesium = {
  id: "cesium",
  package: "@cesium/engine",
  tolerance: FLOAT64,
  named: (w, x, y, z) => new CesiumQuaternion(x, y, z, w),
  construct: (...four) => new CesiumQuaternion(...four),
  components: byName,
  array: (q) => CesiumQuaternion.pack(q, []),
  product: (a, b) => CesiumQuaternion.multiply(a, b, new CesiumQuaternion()),
  matrix: (q) => fromColumns(Matrix3.toArray(Matrix3.fromQuaternion(q)), 3),
  // It has no call that rotates a vector by a quaternion.
  rotate: (q, v) => {
    const rotated = new Cartesian3();
    Matrix3.multiplyByVector(Matrix3.fromQuaternion(q), new Cartesian3(...v), rotated);
    return Cartesian3.pack(rotated, []);
  },
  norm: (q) => CesiumQuaternion.magnitude(q),
  aboutZ: (angle) => CesiumQuaternion.fromAxisAngle(new Cartesian3(0, 0, 1), angle),
  fromMatrix: (rows) => CesiumQuaternion.fromRotationMatrix(new Matrix3(...rows.flat())),
  slerp: (a, b, t) => CesiumQuaternion.slerp(a, b, t, new CesiumQuaternion()),
  inverse: (q) => CesiumQuaternion.inverse(q, new CesiumQuaternion()),
  normalize: (q) => CesiumQuaternion.normalize(q, new CesiumQuaternion()),
  euler: {
    "Quaternion.fromHeadingPitchRoll(h=.3,p=.5,r=.7)": (...angles) =>
      byName(CesiumQuaternion.fromHeadingPitchRoll(new HeadingPitchRoll(...angles))),
    "Matrix3.fromHeadingPitchRoll(h=.3,p=.5,r=.7)": (...angles) =>
      fromColumns(
        Matrix3.toArray(Matrix3.fromHeadingPitchRoll(new HeadingPitchRoll(...angles))),
        3,
      ),
  },
  other: {
    "Matrix3.fromRotationZ(.3) as rows": ({ axisAngle }) =>
      fromColumns(Matrix3.toArray(Matrix3.fromRotationZ(axisAngle)), 3),
  },
};

const wgpuMatrix = {
  id: "wgpu-matrix",
  package: "wgpu-matrix",
  tolerance: FLOAT32,
  named: (w, x, y, z) => wgpu.quat.create(x, y, z, w),
  construct: (...four) => wgpu.quat.create(...four),
  components: xyzwByName,
  array: (q) => Array.from(q),
  product: (a, b) => wgpu.quat.multiply(a, b),
  // Its matrix of three columns has one number of padding under each.
  matrix: (q) => fromColumns(wgpu.mat3.fromQuat(q), 4),
  rotate: (q, v) => Array.from(wgpu.vec3.transformQuat(wgpu.vec3.create(...v), q)),
  norm: (q) => wgpu.quat.length(q),
  aboutZ: (angle) => wgpu.quat.fromAxisAngle([0, 0, 1], angle),
  fromMatrix: (rows) => wgpu.quat.fromMat(wgpu.mat3.create(...transposed(rows).flat())),
  slerp: (a, b, t) => wgpu.quat.slerp(a, b, t),
  inverse: (q) => wgpu.quat.inverse(q),
  normalize: (q) => wgpu.quat.normalize(q),
  euler: Object.fromEntries(
    ["xyz", "zyx"].map((order) => [
      `quat.fromEuler(.3,.5,.7,'${order}')`,
      (...angles) => xyzwByName(wgpu.quat.fromEuler(...angles, order)),
    ]),
  ),
};

export const libraries = [three, glMatrixLibrary, quaternionJs, babylon, cesium, wgpuMatrix];
