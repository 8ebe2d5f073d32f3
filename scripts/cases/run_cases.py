"""Runs an intersect function of yours on hard cases with exact answers.

    python3 run_cases.py cases.json my_program:intersect [--junit FILE] [--report FILE]

`npm run cases` writes cases.json. The function gets the shape as a dict (kind and its numbers), and
origin and direction as lists of three floats; it returns every t of the whole line, ascending, a
tangent once. Where it does not know a kind, it raises NotImplementedError: the case is skipped.
A case fails if the number of roots is wrong, or a root is off by more than --ulps units in the last
place (2 ** 52 unless given). The exit code is 1 where a case failed.
"""

import argparse
import importlib
import json
import math
import sys
from fractions import Fraction
from xml.sax.saxutils import quoteattr

ROOTS = {"two": 2, "tangent": 1, "one": 1, "none": 0, "contained": 0}


def ulps_off(t, exact):
    """How far t is from the exact number, in units of the exact number's last place."""
    if not math.isfinite(t):
        return math.inf
    # Beyond the doubles there is no place to count in.
    size = abs(exact)
    if size > Fraction(sys.float_info.max):
        return math.inf
    return float(abs(Fraction(t) - exact) / Fraction(math.ulp(float(size))))


def judge(case, intersect, most):
    """(state, words, ulps): state is passed, failed or skipped."""
    ray = case["ray"]
    try:
        found = [float(t) for t in intersect(case["shape"], ray["origin"], ray["direction"])]
    except NotImplementedError:
        return "skipped", "", 0.0
    except Exception as error:  # whatever their program raises is its answer
        return "failed", f"{type(error).__name__}: {error}", math.inf
    wanted = ROOTS[case["class"]]
    if len(found) != wanted:
        words = f"{len(found)} roots, exactly {wanted} ({case['class']})"
        return "failed", words, math.inf
    off = [ulps_off(t, Fraction(hit["t"])) for t, hit in zip(found, case["hits"])]
    worst = max(off, default=0.0)
    if worst <= most:
        return "passed", "", worst
    return "failed", f"t = {found}, off by {worst:.3g} ulps", worst


def junit(file, results):
    failed = sum(state == "failed" for _, state, _, _ in results)
    skipped = sum(state == "skipped" for _, state, _, _ in results)
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<testsuite name="graze" tests="{len(results)}" failures="{failed}" skipped="{skipped}">',
    ]
    for case, state, words, _ in results:
        name = f'  <testcase classname={quoteattr(case["family"])} name={quoteattr(case["id"])}'
        if state == "passed":
            lines.append(name + "/>")
        elif state == "skipped":
            lines.append(name + "><skipped/></testcase>")
        else:
            lines.append(name + f"><failure message={quoteattr(words)}/></testcase>")
    write(file, lines + ["</testsuite>"])


def by_family(results):
    families = {}
    for result in results:
        families.setdefault(result[0]["family"], []).append(result)
    return families


def report(file, results):
    lines = [
        "| family | cases | wrong | skipped | ulps: worst of the right ones | first that is wrong |",
        "| --- | ---: | ---: | ---: | ---: | --- |",
    ]
    for family, own in by_family(results).items():
        wrong = [(case, words) for case, state, words, _ in own if state == "failed"]
        skipped = sum(state == "skipped" for _, state, _, _ in own)
        right = [ulps for _, state, _, ulps in own if state == "passed"]
        worst = f"{max(right):.3g}" if right else ""
        first = f"{wrong[0][0]['id']}: {wrong[0][1]}".replace("|", "/") if wrong else ""
        lines.append(f"| {family} | {len(own)} | {len(wrong)} | {skipped} | {worst} | {first} |")
    write(file, lines)


def write(file, lines):
    with open(file, "w", encoding="utf-8") as out:
        out.write("\n".join(lines) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("cases")
    parser.add_argument("function", help="module:function")
    parser.add_argument("--junit")
    parser.add_argument("--report")
    parser.add_argument("--ulps", type=float, default=2.0**52)
    args = parser.parse_args()
    with open(args.cases, encoding="utf-8") as source:
        given = json.load(source)
    if given.get("graze") != "hard-cases" or given.get("version") != 1:
        sys.exit(f"{args.cases} has no hard cases of version 1")
    module, _, name = args.function.partition(":")
    sys.path.insert(0, "")
    intersect = getattr(importlib.import_module(module), name or "intersect")
    results = [(case, *judge(case, intersect, args.ulps)) for case in given["cases"]]
    if args.junit:
        junit(args.junit, results)
    if args.report:
        report(args.report, results)
    counts = {state: sum(one[1] == state for one in results) for state in STATES}
    print(", ".join(f"{count} {state}" for state, count in counts.items()))
    sys.exit(1 if counts["failed"] else 0)


STATES = ("passed", "failed", "skipped")

if __name__ == "__main__":
    main()
