// The named conventions: constants, which are there before the core is.
import type { Convention } from "../../pkg/quatlas.js";
import { namedConventions } from "../../pkg/values.js";

/** Hamilton: `[w, x, y, z]`, ij = k, passive, body to world, local perturbation. */
export const HAMILTON: Convention = Object.freeze(namedConventions.hamilton);

/** JPL (Shuster): `[x, y, z, w]`, ij = −k, passive, world to body, local perturbation. */
export const JPL: Convention = Object.freeze(namedConventions.jpl);

/**
 * “My Lab” of the field guide: `[w, x, y, z]`, ij = k, active, world to body, local perturbation. The
 * numbers are Hamilton's; the guide pairs them with the passive matrix world to body.
 *
 * @example
 * // A quarter turn about z: R_W^B is C(q), which takes the world's x axis to the body's −y.
 * const { paired } = analyze({
 *   view: "read",
 *   quaternion: "√½ 0 0 √½",
 *   vector: "1 0 0",
 *   convention: MY_LAB,
 *   matrix: { function: "passive", direction: "world-to-body" },
 * });
 * paired.form; // "C"
 * paired.rows[1][0]; // -1
 */
export const MY_LAB: Convention = Object.freeze(namedConventions.myLab);

/** JPL as in Yoosefian 2021, eq. 18: body to world, so the numbers are the conjugate of Hamilton's. */
export const JPL_BODY_TO_WORLD: Convention = Object.freeze(namedConventions.jplBodyToWorld);

/** Hamilton with the scalar last, `[x, y, z, w]`, as Eigen and ROS store it. */
export const HAMILTON_SCALAR_LAST: Convention = Object.freeze(namedConventions.hamiltonScalarLast);
