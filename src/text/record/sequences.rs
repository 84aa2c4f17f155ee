//! Sequences of Euler angles in names.

use crate::character::{is_alphabetic, is_capital, parts_words};
use crate::convention::euler_sequence::{EulerFrame, EulerSequence};

/// The sequence of Euler angles in a name: `rpy`, `Yaw-Pitch-Roll`, `euler_zyx`, `intrinsic XYZ`.
pub(crate) fn sequence_of(key: &str, words: &[String]) -> Option<EulerSequence> {
    let joined = words.join("");
    for (name, sequence) in [
        ("rollpitchyaw", EulerSequence::ROLL_PITCH_YAW),
        ("rpy", EulerSequence::ROLL_PITCH_YAW),
        ("yawpitchroll", EulerSequence::AEROSPACE),
        ("ypr", EulerSequence::AEROSPACE),
    ] {
        if joined.contains(name) {
            return Some(sequence);
        }
    }
    if let Some(sequence) = primed(key) {
        return Some(sequence);
    }
    let frame = words.iter().find_map(|word| match word.as_str() {
        "intrinsic" | "moving" | "rotating" => Some(EulerFrame::Intrinsic),
        "extrinsic" | "fixed" | "static" => Some(EulerFrame::Extrinsic),
        _ => None,
    });
    // `as_euler('zyx')`, `quat2eul(q, 'ZYZ')`, `mat2euler(M, 'rzxz')`: the letters are those of the library.
    let quoted = key
        .split(['\'', '"'])
        .skip(1)
        .step_by(2)
        .find_map(quoted_sequence);
    if quoted.is_some() {
        return quoted;
    }
    let is_euler = words.iter().any(|word| word.starts_with("eul"));
    let letters = key
        .split(parts_words)
        .find(|word| word.len() == 3 && word.parse::<EulerSequence>().is_ok())?;
    let sequence: EulerSequence = letters.parse().ok()?;
    match frame {
        Some(frame) => Some(EulerSequence { frame, ..sequence }),
        // Capitals in a name are moving axes; small letters there may be only the style of names.
        None if is_euler && letters.starts_with(is_capital) => Some(sequence),
        None => None,
    }
}

/// The sequence of letters that are quoted: of three, or of `transforms3d` with s or r before them.
fn quoted_sequence(letters: &str) -> Option<EulerSequence> {
    let (frame, axes) = match letters.split_at_checked(1)? {
        ("s", axes) if axes.len() == 3 => (Some(EulerFrame::Extrinsic), axes),
        ("r", axes) if axes.len() == 3 => (Some(EulerFrame::Intrinsic), axes),
        _ => (None, letters),
    };
    let sequence: EulerSequence = axes.parse().ok()?;
    Some(EulerSequence {
        frame: frame.unwrap_or(sequence.frame),
        ..sequence
    })
}

/// Axes that move by their primes: `Z-Y'-X''`, `[X,Y',Z'']`.
fn primed(key: &str) -> Option<EulerSequence> {
    const PRIMES: [char; 4] = ['\'', '′', '’', '″'];
    // Each axis with the count of its primes.
    let mut axes: Vec<(char, usize)> = Vec::new();
    for mark in key.chars() {
        match axes.last_mut() {
            Some((_, count)) if PRIMES.contains(&mark) => {
                *count += if mark == '″' { 2 } else { 1 }
            }
            _ if is_alphabetic(mark) => axes.push((mark, 0)),
            _ => {}
        }
    }
    axes.windows(3).find_map(|axes| match axes {
        &[(first, 0), (second, 1), (third, 2)] => {
            let letters: String = [first, second, third].iter().collect();
            letters.to_ascii_uppercase().parse().ok()
        }
        _ => None,
    })
}
