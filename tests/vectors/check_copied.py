"""Runs the copied Python of copied.json and compares each rotation with that of the page.

Needs NumPy and SciPy; prints how many agreed, and exits with 1 if any did not.
"""

import json
import pathlib
import sys

import numpy as np
from scipy.spatial.transform import Rotation

cases = json.loads(pathlib.Path(__file__).with_name("copied.json").read_text())
failed = 0
agreed = 0
for case in cases:
    if case["format"] not in ("scipy", "numpy"):
        continue
    names = {"np": np, "Rotation": Rotation}
    exec(case["text"], names)
    made = names.get("r", names.get("q"))
    if not isinstance(made, Rotation):
        numbers = [value for name, value in names.items() if name in ("q_wxyz", "q_xyzw", "M", "v", "axis", "angles")]
        if len(numbers) != 1 or numbers[0].dtype != float:
            failed += 1
            print(case["value"], "is no array of floats:", case["text"])
        continue
    error = abs(made.as_matrix() - np.array(case["rotation"])).max()
    if error < 1e-14:
        agreed += 1
    else:
        failed += 1
        print(case["value"], "differs by", error)
print(f"{agreed} rotations agreed, {failed} failed")
sys.exit(failed > 0)
