//! Libraries that do not exist: each of the 256 behaviours, from the definitions alone.

use quatlas::nalgebra::{Matrix3, Vector3};
use quatlas::{
    Behaviour, ComponentOrder, ComponentSign, CosineMatrix, Handedness, IncrementSign,
    MatrixLayout, Perturbation, Probe, ProbeKind,
};

/// Four numbers by name: w, x, y, z.
pub(crate) type Named = [f64; 4];

/// What printing does to numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Noise {
    None,
    /// Single precision, after an error of a few units in its last place.
    Single,
    /// The same, printed with so many decimals.
    SingleInDecimals(usize),
    /// So many decimals.
    Rounded(usize),
}

pub(crate) struct Simulated {
    pub(crate) behaviour: Behaviour,
    pub(crate) noise: Noise,
    /// The state of a generator of pseudo-random numbers, from a fixed seed.
    seed: u64,
}

/// `i² = j² = k² = −1`, `ij = k`.
pub(crate) fn hamilton([aw, ax, ay, az]: Named, [bw, bx, by, bz]: Named) -> Named {
    [
        aw * bw - ax * bx - ay * by - az * bz,
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
    ]
}

fn conjugate([w, x, y, z]: Named) -> Named {
    [w, -x, -y, -z]
}

/// `R(q)`, column by column: what becomes of the unit vectors.
pub(crate) fn active_matrix(q: Named) -> Matrix3<f64> {
    let turned = |unit: [f64; 3]| {
        let [_, x, y, z] = hamilton(hamilton(q, [0.0, unit[0], unit[1], unit[2]]), conjugate(q));
        let norm: f64 = q.iter().map(|n| n * n).sum();
        Vector3::new(x, y, z) / norm
    };
    Matrix3::from_columns(&[
        turned([1.0, 0.0, 0.0]),
        turned([0.0, 1.0, 0.0]),
        turned([0.0, 0.0, 1.0]),
    ])
}

/// The unit quaternion of a matrix whose `R(q)` it is.
fn of_matrix(m: &Matrix3<f64>) -> Named {
    // The test matrices are of turns by less than 170°.
    let w = (1.0 + m.trace()).sqrt() / 2.0;
    let part = |one: (usize, usize), other: (usize, usize)| (m[one] - m[other]) / (4.0 * w);
    [
        w,
        part((2, 1), (1, 2)),
        part((0, 2), (2, 0)),
        part((1, 0), (0, 1)),
    ]
}

impl Simulated {
    pub(crate) fn new(behaviour: Behaviour, noise: Noise, seed: u64) -> Self {
        Self {
            behaviour,
            noise,
            seed: seed.wrapping_mul(6_364_136_223_846_793_005) + 1,
        }
    }

    fn random(&mut self) -> f64 {
        self.seed ^= self.seed << 13;
        self.seed ^= self.seed >> 7;
        self.seed ^= self.seed << 17;
        (self.seed >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn matrix_of(&self, form: CosineMatrix, q: Named) -> Matrix3<f64> {
        match form {
            CosineMatrix::Hamilton => active_matrix(q),
            CosineMatrix::Shuster => active_matrix(q).transpose(),
        }
    }

    fn given(&self, text: &str) -> Named {
        let [a, b, c, d] = four(text);
        match self.behaviour.constructor {
            ComponentOrder::ScalarFirst => [a, b, c, d],
            ComponentOrder::ScalarLast => [d, a, b, c],
        }
    }

    fn print(&mut self, numbers: &[f64]) -> String {
        let written: Vec<String> = numbers
            .iter()
            .map(|&number| match self.noise {
                Noise::None => format!("{number:?}"),
                Noise::Single | Noise::SingleInDecimals(_) => {
                    let error = 1.0 + (self.random() - 0.5) * 1e-6;
                    #[allow(clippy::cast_possible_truncation, reason = "that is the noise")]
                    let single = (number * error) as f32;
                    match self.noise {
                        Noise::SingleInDecimals(decimals) => format!("{single:.decimals$}"),
                        _ => format!("{single:?}"),
                    }
                }
                Noise::Rounded(decimals) => format!("{number:.decimals$}"),
            })
            .collect();
        written.join(", ")
    }

    /// Prints `q` or `−q`, as it comes.
    fn print_either(&mut self, q: Named) -> String {
        let sign = if self.random() < 0.5 { 1.0 } else { -1.0 };
        self.print_quaternion(q.map(|n| n * sign))
    }

    fn print_quaternion(&mut self, [w, x, y, z]: Named) -> String {
        match self.behaviour.array {
            ComponentOrder::ScalarFirst => self.print(&[w, x, y, z]),
            ComponentOrder::ScalarLast => self.print(&[x, y, z, w]),
        }
    }

    /// The probe with what this library prints.
    pub(crate) fn answer(&mut self, probe: &Probe) -> Probe {
        let behaviour = self.behaviour;
        match probe.clone() {
            Probe::Components { quaternion, .. } => {
                let q = self.given(&quaternion);
                let printed = self.print_either(q);
                Probe::Components {
                    quaternion,
                    printed,
                }
            }
            Probe::Product { a, b, .. } => {
                let (left, right) = (self.given(&a), self.given(&b));
                let product = match behaviour.handedness {
                    Handedness::Right => hamilton(left, right),
                    Handedness::Left => hamilton(right, left),
                };
                // Of i and j the sign is all that tells, so no library chooses it.
                let printed = self.print_quaternion(product);
                Probe::Product { a, b, printed }
            }
            Probe::Rotate {
                quaternion, vector, ..
            } => {
                let matrix = self.matrix_of(behaviour.rotate, self.given(&quaternion));
                let turned = matrix * three(&vector);
                let printed = self.print(turned.as_slice());
                Probe::Rotate {
                    quaternion,
                    vector,
                    printed,
                }
            }
            Probe::Matrix {
                quaternion, layout, ..
            } => {
                let matrix = self.matrix_of(behaviour.matrix, self.given(&quaternion));
                // as_slice is column by column.
                let printed = match layout {
                    MatrixLayout::Columns => self.print(matrix.as_slice()),
                    MatrixLayout::Rows | MatrixLayout::AsWritten | MatrixLayout::Unknown => {
                        let rows: Vec<String> = (0..3)
                            .map(|row| {
                                let row: Vec<f64> = matrix.row(row).iter().copied().collect();
                                self.print(&row)
                            })
                            .collect();
                        rows.join("\n")
                    }
                };
                Probe::Matrix {
                    quaternion,
                    printed,
                    layout,
                }
            }
            Probe::FromMatrix { matrix, layout, .. } => {
                let q = of_matrix(&nine(&matrix));
                let printed = self.print_either(match behaviour.matrix {
                    CosineMatrix::Hamilton => q,
                    CosineMatrix::Shuster => conjugate(q),
                });
                Probe::FromMatrix {
                    matrix,
                    layout,
                    printed,
                }
            }
            Probe::QuarterTurn { .. } => {
                let half = std::f64::consts::FRAC_1_SQRT_2;
                let q = self.as_used([half, 0.0, 0.0, half]);
                Probe::QuarterTurn {
                    printed: self.print_either(q),
                }
            }
            Probe::Perturb {
                quaternion,
                rotation_vector,
                ..
            } => {
                let turn = three(&rotation_vector);
                let half = turn.norm() / 2.0;
                let axis = turn.normalize() * half.sin();
                let exponential = [half.cos(), axis.x, axis.y, axis.z];
                let turn = match behaviour.increment_sign {
                    IncrementSign::Physical => exponential,
                    IncrementSign::Formal => conjugate(exponential),
                };
                let body_to_world = self.as_used(self.given(&quaternion));
                let turned = match behaviour.perturbation {
                    Perturbation::Local => hamilton(body_to_world, turn),
                    Perturbation::Global => hamilton(turn, body_to_world),
                };
                let printed = self.print_either(self.as_used(turned));
                Probe::Perturb {
                    quaternion,
                    rotation_vector,
                    printed,
                }
            }
        }
    }

    fn as_used(&self, q: Named) -> Named {
        match self.behaviour.attitude {
            ComponentSign::Canonical => q,
            ComponentSign::Conjugated => conjugate(q),
        }
    }
}

fn parts(text: &str) -> Vec<f64> {
    text.split([' ', ',', ';'])
        .filter(|part| !part.is_empty())
        .map(|part| part.parse().expect("a number"))
        .collect()
}

fn four(text: &str) -> [f64; 4] {
    parts(text).try_into().expect("four numbers")
}

fn three(text: &str) -> Vector3<f64> {
    Vector3::from_column_slice(&parts(text))
}

fn nine(text: &str) -> Matrix3<f64> {
    Matrix3::from_row_slice(&parts(text))
}

/// One probe of each kind, with numbers that hide nothing.
pub(crate) fn every_probe() -> Vec<Probe> {
    let printed = String::new;
    let q = || "0.1 0.7 -0.5 0.5".to_owned();
    let kinds = [
        ProbeKind::Components,
        ProbeKind::Product,
        ProbeKind::Rotate,
        ProbeKind::Matrix,
        ProbeKind::FromMatrix,
        ProbeKind::QuarterTurn,
        ProbeKind::Perturb,
    ];
    kinds
        .into_iter()
        .map(|kind| match kind {
            ProbeKind::Components => Probe::Components {
                quaternion: q(),
                printed: printed(),
            },
            ProbeKind::Product => Probe::Product {
                a: q(),
                b: "0.8 0.2 -0.4 0.4".to_owned(),
                printed: printed(),
            },
            ProbeKind::Rotate => Probe::Rotate {
                quaternion: q(),
                vector: "1 -2 0.5".to_owned(),
                printed: printed(),
            },
            ProbeKind::Matrix => Probe::Matrix {
                quaternion: q(),
                printed: printed(),
                layout: MatrixLayout::Rows,
            },
            ProbeKind::FromMatrix => Probe::FromMatrix {
                matrix: "0.36 -0.48 0.8, 0.8 0.6 0, -0.48 0.64 0.6".to_owned(),
                layout: MatrixLayout::Rows,
                printed: printed(),
            },
            ProbeKind::QuarterTurn => Probe::QuarterTurn { printed: printed() },
            ProbeKind::Perturb => Probe::Perturb {
                quaternion: q(),
                rotation_vector: "0.1 -0.2 0.15".to_owned(),
                printed: printed(),
            },
        })
        .collect()
}

impl Simulated {
    /// A whole number from 0, less than that many.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a small number that is not negative"
        )]
        let number = (self.random() * count as f64) as usize;
        number
    }

    /// So many numbers between −1 and 1.
    fn numbers(&mut self, count: usize) -> String {
        let written: Vec<String> = (0..count)
            .map(|_| format!("{:.6}", 2.0 * self.random() - 1.0))
            .collect();
        written.join(" ")
    }
}

/// A probe of any kind with any numbers.
pub(crate) fn random_probe(source: &mut Simulated) -> Probe {
    let kinds = every_probe();
    let kind = source.below(kinds.len());
    let mut probe = kinds[kind].clone();
    match &mut probe {
        Probe::Components { quaternion, .. } | Probe::Matrix { quaternion, .. } => {
            *quaternion = source.numbers(4);
        }
        Probe::Product { a, b, .. } => {
            *a = source.numbers(4);
            *b = source.numbers(4);
        }
        Probe::Rotate {
            quaternion, vector, ..
        } => {
            *quaternion = source.numbers(4);
            *vector = source.numbers(3);
        }
        Probe::FromMatrix { matrix, .. } => {
            // Of a turn by less than 126°, all of whose digits are written.
            let [x, y, z] = three(&source.numbers(3)).into();
            let entries = active_matrix([1.0, x, y, z]).transpose();
            let written: Vec<String> = entries.iter().map(|entry| format!("{entry:?}")).collect();
            *matrix = written.join(" ");
        }
        Probe::QuarterTurn { .. } => {}
        Probe::Perturb {
            quaternion,
            rotation_vector,
            ..
        } => {
            *quaternion = source.numbers(4);
            *rotation_vector = source.numbers(3);
        }
    }
    probe
}

/// Whether two libraries printed the same; q and −q are.
pub(crate) fn prints_the_same(one: &Probe, other: &Probe) -> bool {
    let printed = |probe: &Probe| parts(&probe.printed().replace('\n', " "));
    let (one, other) = (printed(one), printed(other));
    let differs_by = |sign: f64| {
        let pairs = one.iter().zip(&other);
        pairs.fold(0.0, |most: f64, (a, b)| most.max((a - sign * b).abs()))
    };
    let sign_may_differ = one.len() == 4;
    differs_by(1.0) < 1e-9 || sign_may_differ && differs_by(-1.0) < 1e-9
}
