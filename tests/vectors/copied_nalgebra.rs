[
("hamilton", {
// q: Hamilton (ij = k), body to world; Quaternion::new takes w x y z
let q = UnitQuaternion::from_quaternion(Quaternion::new(0.888819441731559, 0.1, -0.2, 0.4));
q.to_rotation_matrix().into_inner()
}, [[0.6000000000000001_f64,-0.7510555533852471_f64,-0.27552777669262357_f64],[0.671055553385247_f64,0.66_f64,-0.3377638883463117_f64],[0.43552777669262355_f64,0.017763888346311794_f64,0.9_f64]]),
("jpl", {
// q: JPL (ij = -k), world to body; Quaternion::new takes w x y z
// the numbers as they are: nalgebra multiplies ij = k, so to_rotation_matrix() of them is R(q) = C(q)^T, body to world
let q = UnitQuaternion::from_quaternion(Quaternion::new(0.888819441731559, 0.1, -0.2, 0.4));
q.to_rotation_matrix().into_inner()
}, [[0.6000000000000001_f64,-0.7510555533852471_f64,-0.27552777669262357_f64],[0.671055553385247_f64,0.66_f64,-0.3377638883463117_f64],[0.43552777669262355_f64,0.017763888346311794_f64,0.9_f64]]),
("hamilton-conjugate", {
// q*: Hamilton (ij = k), world to body; Quaternion::new takes w x y z
let q = UnitQuaternion::from_quaternion(Quaternion::new(0.888819441731559, -0.1, 0.2, -0.4));
q.to_rotation_matrix().into_inner()
}, [[0.6000000000000001_f64,0.671055553385247_f64,0.43552777669262355_f64],[-0.7510555533852471_f64,0.66_f64,0.017763888346311794_f64],[-0.27552777669262357_f64,-0.3377638883463117_f64,0.9_f64]]),
("jpl-conjugate", {
// q*: JPL (ij = -k), body to world; Quaternion::new takes w x y z
// the numbers as they are: nalgebra multiplies ij = k, so to_rotation_matrix() of them is R(q) = C(q)^T, world to body
let q = UnitQuaternion::from_quaternion(Quaternion::new(0.888819441731559, -0.1, 0.2, -0.4));
q.to_rotation_matrix().into_inner()
}, [[0.6000000000000001_f64,0.671055553385247_f64,0.43552777669262355_f64],[-0.7510555533852471_f64,0.66_f64,0.017763888346311794_f64],[-0.27552777669262357_f64,-0.3377638883463117_f64,0.9_f64]]),
("opposite", {
// -q: Hamilton (ij = k), body to world; Quaternion::new takes w x y z
let q = UnitQuaternion::from_quaternion(Quaternion::new(-0.888819441731559, -0.1, 0.2, -0.4));
q.to_rotation_matrix().into_inner()
}, [[0.6000000000000001_f64,-0.7510555533852471_f64,-0.27552777669262357_f64],[0.671055553385247_f64,0.66_f64,-0.3377638883463117_f64],[0.43552777669262355_f64,0.017763888346311794_f64,0.9_f64]]),
("yoosefian", {
// q: JPL (ij = -k), body to world; Quaternion::new takes w x y z
// the numbers as they are: nalgebra multiplies ij = k, so to_rotation_matrix() of them is R(q) = C(q)^T, world to body
let q = UnitQuaternion::from_quaternion(Quaternion::new(0.888819441731559, 0.1, -0.2, 0.4));
q.to_rotation_matrix().into_inner()
}, [[0.6000000000000001_f64,-0.7510555533852471_f64,-0.27552777669262357_f64],[0.671055553385247_f64,0.66_f64,-0.3377638883463117_f64],[0.43552777669262355_f64,0.017763888346311794_f64,0.9_f64]]),
("active", {
// q: Hamilton (ij = k), active, body to world; Quaternion::new takes w x y z
// to_rotation_matrix() of them is R(q), for coordinates world to body
let q = UnitQuaternion::from_quaternion(Quaternion::new(0.1, -0.2, 0.4, 0.888819441731559));
q.to_rotation_matrix().into_inner()
}, [[-0.9_f64,-0.3377638883463117_f64,-0.27552777669262357_f64],[0.017763888346311794_f64,-0.66_f64,0.7510555533852471_f64],[-0.43552777669262355_f64,0.671055553385247_f64,0.6000000000000001_f64]]),
("norm-2", {
// q: Hamilton (ij = k), body to world; Quaternion::new takes w x y z
// its norm is 2, not 1
let q = Quaternion::new(2.0, 0.0, 0.0, 0.0);
UnitQuaternion::from_quaternion(q).to_rotation_matrix().into_inner()
}, [[1_f64,0_f64,0_f64],[0_f64,1_f64,0_f64],[0_f64,0_f64,1_f64]]),
("jpl-norm", {
// q: JPL (ij = -k), world to body; Quaternion::new takes w x y z
// the numbers as they are: nalgebra multiplies ij = k, so to_rotation_matrix() of them, normalized, is R(q) = C(q)^T, body to world
// its norm is 0.9219544457292888, not 1
let q = Quaternion::new(0.8, 0.2, -0.1, 0.4);
UnitQuaternion::from_quaternion(q).to_rotation_matrix().into_inner()
}, [[0.6_f64,-0.8_f64,0_f64],[0.7058823529411765_f64,0.5294117647058824_f64,-0.47058823529411764_f64],[0.3764705882352941_f64,0.2823529411764706_f64,0.8823529411764706_f64]]),
("tiny-part", {
// q: Hamilton (ij = k), body to world; Quaternion::new takes w x y z
let q = UnitQuaternion::from_quaternion(Quaternion::new(1.0, 1e-9, -2.5e-12, 0.0));
q.to_rotation_matrix().into_inner()
}, [[1_f64,-5e-21_f64,-5e-12_f64],[-5e-21_f64,1_f64,-2e-9_f64],[5e-12_f64,2e-9_f64,1_f64]]),
("matrix", {
// R(q): body to world, multiplies columns
let m = Matrix3::new(
    0.6000000000000001, -0.7510555533852471, -0.27552777669262357,
    0.671055553385247, 0.66, -0.3377638883463117,
    0.43552777669262355, 0.017763888346311794, 0.9,
);
m
}, [[0.6000000000000001_f64,-0.7510555533852471_f64,-0.27552777669262357_f64],[0.671055553385247_f64,0.66_f64,-0.3377638883463117_f64],[0.43552777669262355_f64,0.017763888346311794_f64,0.9_f64]]),
("jpl-matrix", {
// C(q): world to body, multiplies columns
let m = Matrix3::new(
    0.6000000000000001, 0.671055553385247, 0.43552777669262355,
    -0.7510555533852471, 0.66, 0.017763888346311794,
    -0.27552777669262357, -0.3377638883463117, 0.9,
);
m
}, [[0.6000000000000001_f64,0.671055553385247_f64,0.43552777669262355_f64],[-0.7510555533852471_f64,0.66_f64,0.017763888346311794_f64],[-0.27552777669262357_f64,-0.3377638883463117_f64,0.9_f64]]),
("jpl-inverse-matrix", {
// C(q)^T: body to world, multiplies columns
let m = Matrix3::new(
    0.6000000000000001, -0.7510555533852471, -0.27552777669262357,
    0.671055553385247, 0.66, -0.3377638883463117,
    0.43552777669262355, 0.017763888346311794, 0.9,
);
m
}, [[0.6000000000000001_f64,-0.7510555533852471_f64,-0.27552777669262357_f64],[0.671055553385247_f64,0.66_f64,-0.3377638883463117_f64],[0.43552777669262355_f64,0.017763888346311794_f64,0.9_f64]]),
("row-matrix", {
// M: as DirectXMath prints it; it multiplies rows, v M
let m = Matrix3::new(
    0.6000000000000001, 0.671055553385247, 0.43552777669262355,
    -0.7510555533852471, 0.66, 0.017763888346311794,
    -0.27552777669262357, -0.3377638883463117, 0.9,
);
m
}, [[0.6000000000000001_f64,0.671055553385247_f64,0.43552777669262355_f64],[-0.7510555533852471_f64,0.66_f64,0.017763888346311794_f64],[-0.27552777669262357_f64,-0.3377638883463117_f64,0.9_f64]]),
("half-turn", {
// R(q): body to world, multiplies columns
let m = Matrix3::new(
    -0.2800000000000001, 0.0, 0.96,
    0.0, -1.0, 0.0,
    0.96, 0.0, 0.2800000000000001,
);
m
}, [[-0.2800000000000001_f64,0_f64,0.96_f64],[0_f64,-1_f64,0_f64],[0.96_f64,0_f64,0.2800000000000001_f64]]),
("axis-angle", {
// axis and angle in radians: the turn carries the world axes onto the body axes; its matrix is R(q), body to world
let q = UnitQuaternion::from_axis_angle(&Unit::new_normalize(Vector3::new(0.2182178902359924, -0.4364357804719848, 0.8728715609439696)), 0.9520676361226456);
q.to_rotation_matrix().into_inner()
}, [[0.6000000000000001_f64,-0.7510555533852471_f64,-0.27552777669262357_f64],[0.671055553385247_f64,0.66_f64,-0.3377638883463117_f64],[0.43552777669262355_f64,0.017763888346311794_f64,0.9_f64]]),
("rotation-vector", {
// rotation vector (angle times axis) in radians: the turn carries the world axes onto the body axes; its matrix is R(q), body to world
let q = UnitQuaternion::from_scaled_axis(Vector3::new(0.20775819091665218, -0.41551638183330436, 0.8310327636666087));
q.to_rotation_matrix().into_inner()
}, [[0.6000000000000001_f64,-0.7510555533852471_f64,-0.27552777669262357_f64],[0.671055553385247_f64,0.66_f64,-0.3377638883463117_f64],[0.43552777669262355_f64,0.017763888346311794_f64,0.9_f64]]),
("ZYX", {
// Euler angles ZYX in radians, about the moving axes (intrinsic): the turn carries the world axes onto the body axes; its matrix is R(q), body to world
let q = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 0.8412428293409866)
    * UnitQuaternion::from_axis_angle(&Vector3::y_axis(), -0.4506244980235586)
    * UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 0.019735091218422263);
q.to_rotation_matrix().into_inner()
}, [[0.6000000000000001_f64,-0.7510555533852471_f64,-0.27552777669262357_f64],[0.671055553385247_f64,0.66_f64,-0.3377638883463117_f64],[0.43552777669262355_f64,0.017763888346311794_f64,0.9_f64]]),
("xyz", {
// Euler angles xyz in radians, about the fixed axes (extrinsic): the turn carries the world axes onto the body axes; its matrix is R(q), body to world
let q = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 0.8412428293409866)
    * UnitQuaternion::from_axis_angle(&Vector3::y_axis(), -0.4506244980235586)
    * UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 0.019735091218422263);
q.to_rotation_matrix().into_inner()
}, [[0.6000000000000001_f64,-0.7510555533852471_f64,-0.27552777669262357_f64],[0.671055553385247_f64,0.66_f64,-0.3377638883463117_f64],[0.43552777669262355_f64,0.017763888346311794_f64,0.9_f64]]),
("YXZ", {
// Euler angles YXZ in radians, about the moving axes (intrinsic): the turn carries the world axes onto the body axes; its matrix is R(q), body to world
let q = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), -0.2970820644221166)
    * UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 0.3445401504122536)
    * UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 0.7937038266261864);
q.to_rotation_matrix().into_inner()
}, [[0.6000000000000001_f64,-0.7510555533852471_f64,-0.27552777669262357_f64],[0.671055553385247_f64,0.66_f64,-0.3377638883463117_f64],[0.43552777669262355_f64,0.017763888346311794_f64,0.9_f64]]),
("ZXZ", {
// Euler angles ZXZ in radians, about the moving axes (intrinsic): the turn carries the world axes onto the body axes; its matrix is R(q), body to world
let q = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), -0.6842655526526049)
    * UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 0.4510268117962624)
    * UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 1.530031882935576);
q.to_rotation_matrix().into_inner()
}, [[0.6000000000000001_f64,-0.7510555533852471_f64,-0.27552777669262357_f64],[0.671055553385247_f64,0.66_f64,-0.3377638883463117_f64],[0.43552777669262355_f64,0.017763888346311794_f64,0.9_f64]]),
("yxy", {
// Euler angles yxy in radians, about the fixed axes (extrinsic): the turn carries the world axes onto the body axes; its matrix is R(q), body to world
let q = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), -1.5471488390261892)
    * UnitQuaternion::from_axis_angle(&Vector3::x_axis(), 0.8499775659248069)
    * UnitQuaternion::from_axis_angle(&Vector3::y_axis(), 1.104486488309876);
q.to_rotation_matrix().into_inner()
}, [[0.6000000000000001_f64,-0.7510555533852471_f64,-0.27552777669262357_f64],[0.671055553385247_f64,0.66_f64,-0.3377638883463117_f64],[0.43552777669262355_f64,0.017763888346311794_f64,0.9_f64]]),
]
