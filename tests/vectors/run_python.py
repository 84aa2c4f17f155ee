"""Runs the Python libraries of src/library/libraries.json again and compares with src/library/observations.json.

    python3 tests/vectors/run_python.py [id ...]

A library that is not installed is listed and counts as nothing. Exit code 1 if a number differs.
README.md tells how to install the versions that are recorded.
"""

import json
import math
import pathlib
import sys
import warnings

from python_libraries import aerospace, mathematics, simulation
from python_libraries.register import RUNS

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Importing them has registered them.
assert aerospace and mathematics and simulation


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
    document = json.loads((ROOT / "src/library/observations.json").read_text())
    records = {record["id"]: record for record in json.loads((ROOT / "src/library/libraries.json").read_text())}
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
