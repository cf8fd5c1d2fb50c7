#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Lists every number that influences what the strategy `auto` does, as found in the sources.

    steering.py SOURCE_FOLDER [--lines] [--write] [--check]

Prints Markdown tables: numbers in option tables, constants with a name, numbers without a name, with file, value and reason. A value that one
strategy gives to an option of another takes the place of its default.

Numbers that nobody can choose are not counted. Separate tables list them, with the reasons given below: what rounding, formulas or the machine
determine, and limits that no scene reaches. A number without a name is the coefficient of a formula if a comment on its line cites the
equation by its number, such as (3a): such a formula is derived in a header, and is wrong with any other coefficient. Limits of the range of an
option are not counted either: they refuse a value that a user gives, and no default is refused.

`--write` writes the tables to tests/bench/steering.md, `--check` compares them with that page and prints the rows that differ.

The script reads the strategies that `auto` calls, the solvers that these use, the assessment of an equilibrium and the choice among several.
It does not read the search for winch settings, branches of studies, motions, and methods that `auto` does not use.
"""
import argparse
import re
import sys
from pathlib import Path

READ = """io/scenes/reading/keys.cpp solvers/strategies/auto/* solvers/strategies/coarse-to-fine/* solvers/strategies/direct/*
solvers/strategies/stiffness-steps/* solvers/strategies/pseudo-time/* solvers/strategies/relaxed/* solvers/strategies/tension/* solvers/methods/newton/*
solvers/methods/ptc/* solvers/adapters/common/round_off.hpp solvers/methods/relaxation/* framework/balance/convergence.*
framework/judging/assessment.* framework/judging/correction.* framework/judging/growth.* framework/judging/arnoldi.*
framework/judging/cayley.* framework/judging/linear_motion.* framework/balance/static_problem.* framework/balance/limits.*
framework/balance/work.*
framework/search/running_search.* framework/search/search_host.*
framework/search/known_stages.* framework/search/shapes.* framework/include/netloft/strategy.hpp
framework/include/netloft/imbalance.hpp framework/include/netloft/scatter.hpp""".split()
# For each file, the options that do not influence the strategy `auto`. In a file that ONLY lists, only the
# options listed there influence `auto`.
NOT_ITS_OWN = {
    "io/scenes/reading/keys.cpp": None,
}
ONLY = {"io/scenes/reading/keys.cpp": {"tolerance", "max_iterations", "work"}}
# Files with formulas of geometry only.
GEOMETRY = {"solvers/strategies/tension/second_order_cone.hpp", "solvers/strategies/tension/members.hpp"}
INDEX = re.compile(r"\[|std::size_t|axis|std::array|sizeof|char |squared\(|reserve\(")

# Fragments of lines, and the reason why their numbers are no parameters.
EXPLAINED = {  # names of constants, fragments of lines
    "rounding": {
        "epsilon()": "multiples of the rounding of a double",
        "kEnergyRoundOff": "rounding of a sum of many terms",
        "kLeastRemainder": "orthogonalised twice is enough (Parlett)",
        "1e-14": "eigenvalues of a small tridiagonal matrix, to rounding",
        "high = low * (1 + 1e-12)": "eigenvalues of a small tridiagonal matrix, to rounding",
        **dict.fromkeys(("kLightest", "kSolved"), "half of the digits of a double"),
        "kShortest": "half of the digits of a double",
        **dict.fromkeys(("kShortestStep", "kLongestStep"), "half of the digits of a double, and all of them"),
        "kDifference": "a quarter of the digits of a double",
        "kRoundingOfMatrix": "rounding error of a matrix that is assembled from many elements",
        "kNeutral": "rounding error of a matrix that is assembled from many elements",
        "kRounding": "rounding error of a matrix that is assembled from many elements",
        "round < 3": "inverse iteration next to an eigenvalue converges at once",
    },
    "formula": {
        **dict.fromkeys(("kGolden", "kSilver"), "fractional parts of its multiples, which break every symmetry"),
        "2 * (multiple": "a fraction in [−1, 1]",
        **dict.fromkeys(("kLargestRate", "kWantedRate"), "stability limit of central differences, and half of it"),
        "0.5 * std::max(m, least)": "Gershgorin's bound",
        "0.5 * sum": "kinetic energy",
        "v_[i] = -0.5": "half a step",
        "2 * peak": "vertex of a parabola",
        "kGrowth": "the least of g²/(g − 1)",
        "2 * kinetic_": "twice a kinetic energy",
        "0.5 * t": "trapezoidal rule, and Taylor's second term",
        "2 * rise": "vertex of a parabola",
        "0.5 * (low + high)": "bisection",
        "rise > 0 ?": "bisection",
        "double middle": "bisection",
        "high += 2": "Gershgorin's bound",
        "kMostGrowth": "(3) of ptc.hpp: the curvature beyond which Euler's step leads onto what the motion leaves, halved",
        "-0.5 * std::inner_product": "energy of a quadratic model",
        "? 2 : 0.5": "halving and doubling",
        "convex_fraction_": "halving and doubling",
        "0.5 * least_": "halving",
        "delta_ /= 2": "halving and doubling",
        "2 * kSteps": "as many again",
        "2 * corrections": "half of them",
        "sigma > kLeastSigma / 2": "between two steps",
        "kOtherSigma": "any other number would do: it hits an eigenvalue only by chance",
        "rhs_ *= 2": "Cayley transform",
        "Vector z(2": "positions and velocities",
        "0.5 * (A[": "symmetric part",
        **dict.fromkeys(("2 * rows)", "are_three ?"), "three columns of a node"),
        "kMatricesOfMotion": "matrices of one linearisation",
        "2 * u[i] - step.u": "extrapolation",
        "side < 2": "a line has two",
        "? 1 : 2": "a rank",
        "i < 2": "orthogonalised twice is enough (Parlett)",
        "time < 2": "orthogonalised twice is enough (Parlett)",
        "(1 - reached)": "Mehrotra's exponent, 3",
    },
    "limit": {
        "kAsManyAsItTakes": "the budget of work ends the search first",
        "kDeepestCall": "ends endless recursion: two calls for each coarser mesh, and no scene has thirty",
        "kLeastGrowth": "range of an option",
        "double least = ": "range of an option",
    },
    "cost of the machine": {
        **dict.fromkeys(("kPerEntry", "kPerResidual", "kPerMatrix"), "measured by tests/bench/work_model.cpp"),
        "829.0": "nested dissection of a square grid (George 1973)",
        "31.0": "nested dissection of a square grid (George 1973)",
        "pattern.size / 3.0": "nested dissection of a square grid (George 1973)",
        "kMostKept": "memory: answers follow soon after the stage that found them",
    },
}
TOKEN = re.compile(
    r"//[^\n]*|\"(?:\\.|[^\"\\])*\"|'(?:\\.|[^'\\])*'"
    r"|(?<![\w.])(?:0x[0-9a-fA-F.]+p?[-+]?\d*|\d+\.?\d*(?:e[-+]?\d+)?|\.\d+)u?(?!\w)", re.S)
EQUATION = re.compile(r"//.*(\(\d+[a-z]?\))")
# Options that a strategy gives to another one, in the words of the option `strategy`.
GIVEN = re.compile(r"[:,](\w+)=([-\d.e]+)")
CALL = re.compile(r"(?:\.(real|integer)|\b(add))\(")


class Number:
    def __init__(self, kind, file, line, name, value, reason):
        self.kind, self.file, self.line, self.name, self.value, self.reason = kind, file, line, name, value, reason

    def row(self, lines):
        where = f"{self.file}:{self.line}" if lines else self.file
        return f"| `{where}` | {self.name} | {self.value} | {self.reason} |"


def end_of_call(text, at):
    depth = 0
    for token in re.finditer(TOKEN.pattern + r"|[(){}]", text[at:], re.S):
        depth += token.group() in "({"
        depth -= token.group() in ")}"
        if depth == 0:
            return at + token.end()
    return len(text)


def options(file, text):
    """Returns the numbers of an option table, and the ranges of text that they occupy."""
    found, taken = [], []
    for call in CALL.finditer(text):
        end = end_of_call(text, call.end() - 1)
        words = text[call.end():end]
        tokens = [t.group() for t in TOKEN.finditer(words) if not t.group().startswith("//")]
        texts = ["".join(m) for m in re.findall(r'"((?:\\.|[^"\\])*)"', words)]
        fallback = re.search(r"\.fallback = ([-\w.+]+)", words)
        numbers = [t for t in tokens if t[0] not in "\"'"]
        taken.append((call.start(), end))
        if not texts or texts[0] in (NOT_ITS_OWN.get(file) or ()) or (file in ONLY and texts[0] not in ONLY[file]):
            continue
        last = words.rstrip(" );\n").rsplit(",", 1)[-1].strip()
        value = fallback.group(1) if fallback else numbers[0] if call.group(2) and numbers else last
        if value is None or not re.match(r"[-\d.]", value):
            continue
        doc = "".join(t for t in texts[1:] if " " in t)
        found.append(Number("option", file, text.count("\n", 0, call.start()) + 1, f"`{texts[0]}`", value, doc))
    return found, taken


def comment_at(lines, at):
    """Returns the comment of a line, or the comment that ends above the line."""
    if "//" in lines[at]:
        return lines[at].split("//", 1)[1].strip(" /")
    above = []
    while at > 0 and lines[at - 1].lstrip().startswith("//"):
        at -= 1
        above.insert(0, lines[at].strip(" /"))
    return " ".join(above)


def explained(line, name):
    for kind, fragments in EXPLAINED.items():
        for fragment, reason in fragments.items():
            if fragment == name or (fragment in line and not fragment.startswith("k")):
                return kind, reason
    return None


def numbers_of(file, text):
    found, taken = options(file, text)
    if file in ONLY:
        return found
    lines = text.split("\n")
    for token in TOKEN.finditer(text):
        value, at = token.group(), text.count("\n", 0, token.start())
        line = lines[at]
        is_none = value[0] in "/\"'" or value in ("0", "1", "0u", "1u", "1.0", "0.0") or line.startswith("#")
        if is_none or any(begin <= token.start() < end for begin, end in taken):
            continue
        before = text[text.rfind("\n", 0, token.start()) + 1:token.start()]
        named = re.findall(r"\b(k[A-Z]\w*) = [^,;]*$", before)
        member = re.findall(r"^  (?:static constexpr |constexpr )?(?:double|int|std::\w+) (?:.*, )?(\w+) = $", before)
        if reason := explained(line, named[0] if named else None):
            found.append(Number(*reason[:1], file, at + 1, f"`{named[0]}`" if named else "", value, reason[1]))
        elif named:
            found.append(Number("constant", file, at + 1, f"`{named[0]}`", value, comment_at(lines, at)))
        elif member:
            found.append(Number("constant", file, at + 1, f"`{member[0]}`", value, comment_at(lines, at)))
        elif equation := EQUATION.search(line):
            found.append(Number("formula", file, at + 1, "", value, f"coefficient of {equation[1]}"))
        elif not (value.isdigit() and INDEX.search(line)):
            found.append(Number("bare", file, at + 1, "", value, f"`{line.strip().replace('|', chr(92) + '|')}`"))
    return found


def all_numbers(root):
    files = sorted({f for pattern in READ for f in root.glob(pattern) if f.suffix in (".hpp", ".cpp")})
    found, given = [], {}
    for path in files:
        file, text = str(path.relative_to(root)), path.read_text()
        if file not in GEOMETRY:
            found += numbers_of(file, text)
        for words in re.findall(r'"(\w[\w=,:./-]*)"', text):
            given |= {f"`{name}`": value for name, value in GIVEN.findall(words) if value not in ("0", "1")}
    for number in found:
        if number.kind == "option" and number.value in ("0", "1") and number.name in given:
            number.value = given[number.name]
    return found


def page(numbers, lines):
    count = {kind: sum(n.kind == kind for n in numbers) for kind in ("option", "constant", "bare")}
    steer = sum(count.values())
    text = ["# Numbers that steer `auto`", "",
            f"{steer}: {count['option']} in option tables, {count['constant']} constants with a name, {count['bare']} without one. "
            "`tests/bench/steering.py SOURCE_FOLDER --write` makes this page,",
            "with `--lines` it prints the lines, too; its head says what is read and what is not."]
    heads = {"option": ("In option tables: `netloft describe auto`", "option"),
             "constant": ("Constants", "name"), "bare": ("Without a name", ""),
             "rounding": ("Not counted: rounding", "name"), "formula": ("Not counted: formulas", "name"),
             "limit": ("Not counted: limits that no scene reaches, and ranges of options", "name"),
             "cost of the machine": ("Not counted: what operations cost, and memory", "name")}
    for kind, (head, name) in heads.items():
        rows = list(dict.fromkeys(n.row(lines) for n in numbers if n.kind == kind))
        if rows:
            text += ["", f"## {head}", "", f"| file | {name} | value | reason |", "|---|---|---|---|", *rows]
    return "\n".join(text) + "\n"


def main(arguments):
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("source", type=Path)
    p.add_argument("--lines", action="store_true", help="print the lines, too")
    p.add_argument("--write", action="store_true")
    p.add_argument("--check", action="store_true", help="exit 1 where tests/bench/steering.md says something else")
    words = p.parse_args(arguments)
    text, kept = page(all_numbers(words.source), words.lines), words.source / "tests/bench/steering.md"
    if words.write:
        kept.write_text(text)
    elif not words.check:
        print(text, end="")
    elif kept.read_text() != text:
        old, new = kept.read_text().split("\n"), text.split("\n")
        print("\n".join([f"-{line}" for line in old if line not in new] + [f"+{line}" for line in new if line not in old]))
        print("a number that steers auto has come, gone or changed: say so by steering.py SOURCE_FOLDER --write")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
