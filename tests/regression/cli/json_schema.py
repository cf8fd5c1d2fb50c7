# SPDX-License-Identifier: BSD-3-Clause
"""The part of JSON Schema 2020-12 that `netloft schema` uses, for machines without python3-jsonschema.

An unknown keyword is an error, so that no part of the schema is left unchecked.
"""
import re

ANNOTATIONS = {"$schema", "$defs", "title", "description", "default", "then", "else"}
DEFINITIONS = {}  # of the schema that was asked last


def is_type(value, name):
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return {"object": isinstance(value, dict), "array": isinstance(value, list), "string": isinstance(value, str),
            "boolean": isinstance(value, bool), "number": is_number, "integer": is_number and value == int(value)}[name]


def faults(value, schema, path="scene"):
    """Sentences about what is wrong; none if the value is valid."""
    if isinstance(schema, bool):
        return [] if schema else [f"{path} is not allowed"]
    if "$defs" in schema:
        DEFINITIONS.update({f"#/$defs/{name}": one for name, one in schema["$defs"].items()})
    found = []
    for keyword, rule in schema.items():
        if keyword in ANNOTATIONS or keyword in ("properties", "additionalProperties"):
            continue
        if keyword not in CHECKS and keyword != "if":
            raise NotImplementedError(f"keyword {keyword}")
        found += check_branch(value, rule, schema, path) if keyword == "if" else CHECKS[keyword](value, rule, path)
    return found + check_members(value, schema, path)


def check_members(value, schema, path):
    if not isinstance(value, dict):
        return []
    known, others = schema.get("properties", {}), schema.get("additionalProperties", True)
    return [f for key, member in value.items() for f in faults(member, known.get(key, others), f"{path}.{key}")]


def unless(good, sentence):
    return [] if good else [sentence]


def applies(kind, rule):
    """A check that applies to values of one kind only."""
    return lambda value, limit, path: unless(not isinstance(value, kind) or isinstance(value, bool) or rule(value, limit),
                                             f"{path}: {value!r} against {limit!r}")


def check_branch(value, condition, branches, path):
    """`if` with the `then` and `else` beside it."""
    chosen = "else" if faults(value, condition, path) else "then"
    return faults(value, branches.get(chosen, True), path)


CHECKS = {
    "type": lambda v, r, p: unless(is_type(v, r), f"{p} is no {r}"),
    "const": lambda v, r, p: unless(v == r, f"{p} is not {r!r}"),
    "enum": lambda v, r, p: unless(v in r, f"{p} is none of {r}"),
    "required": lambda v, r, p: [f"{p}.{k} is missing" for k in r if isinstance(v, dict) and k not in v],
    "minProperties": applies(dict, lambda v, r: len(v) >= r),
    "minimum": applies((int, float), lambda v, r: v >= r),
    "maximum": applies((int, float), lambda v, r: v <= r),
    "exclusiveMinimum": applies((int, float), lambda v, r: v > r),
    "exclusiveMaximum": applies((int, float), lambda v, r: v < r),
    "minItems": applies(list, lambda v, r: len(v) >= r),
    "maxItems": applies(list, lambda v, r: len(v) <= r),
    "minLength": applies(str, lambda v, r: len(v) >= r),
    "pattern": applies(str, lambda v, r: re.search(r, v) is not None),
    "items": lambda v, r, p: [f for i, x in enumerate(v) for f in faults(x, r, f"{p}[{i}]")] if isinstance(v, list) else [],
    "$ref": lambda v, r, p: faults(v, DEFINITIONS[r], p),
    "allOf": lambda v, r, p: [f for s in r for f in faults(v, s, p)],
    "anyOf": lambda v, r, p: unless(any(not faults(v, s, p) for s in r), f"{p} fits none"),
    "oneOf": lambda v, r, p: unless(sum(not faults(v, s, p) for s in r) == 1, f"{p} fits not exactly one"),
}
