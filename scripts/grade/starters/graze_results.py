"""Reads cases of Graze, lets your intersect answer them, and writes a file of results.

    python3 graze_results.py cases.json results.json

`npm run grade -- --cases cases.json` writes the cases, as does the page Check. Fill in intersect.
"""

import json
import math
import sys


def intersect(shape, origin, direction):
    """All t at which the line origin + t direction meets the shape: ascending, a tangent once.

    shape is a dict: kind, and its numbers, as in {"kind": "sphere", "center": [x, y, z],
    "radius": r}. Raise ValueError for what is no shape or no ray.
    """
    return []


def numbers(value):
    """The value with NaN and infinities, which stand as texts in the file."""
    if isinstance(value, dict):
        return {key: numbers(one) if key != "kind" else one for key, one in value.items()}
    if isinstance(value, list):
        return [numbers(one) for one in value]
    if value in ("NaN", "Infinity", "-Infinity"):
        return float(value.replace("Infinity", "inf"))
    return value


def answer(case):
    ray = numbers(case["ray"])
    try:
        t = intersect(numbers(case["shape"]), ray["origin"], ray["direction"])
        return {"id": case["id"], "t": [float(x) for x in t]}
    except Exception as error:  # whatever is raised is the answer
        return {"id": case["id"], "error": f"{type(error).__name__}: {error}"}


def main():
    with open(sys.argv[1], encoding="utf-8") as source:
        cases = json.load(source)["cases"]
    results = [answer(case) for case in cases]
    for one in results:
        one["t"] = [x if math.isfinite(x) else str(x) for x in one.get("t", [])]
    with open(sys.argv[2], "w", encoding="utf-8") as out:
        json.dump({"graze": "check-results", "results": results}, out)


if __name__ == "__main__":
    main()
