"""Holds a usda file against the CSV: check_usda.py FOLDER CLOTH… Debian has no library for USD, so this reads it
by a strict grammar of its own: the part of the published one (OpenUSD, "USDA file format") that taut writes.
Whatever lies outside of that is an error."""

import re
import sys
from pathlib import Path

import numpy as np

from motion_of_csv import Motion, same_faces, same_lines, same_numbers

TOKEN = re.compile(r"""\s*(?:(?P<number>-?(?:\d+\.?\d*(?:e[-+]?\d+)?|inf)\b)|(?P<string>"(?:[^"\\\n]|\\.)*")"""
                   r"""|(?P<name>[A-Za-z_][A-Za-z0-9_:.\[\]]*)|(?P<sign>[][(){}=:,]))""")
TYPES = {"token", "token[]", "bool", "int[]", "float[]", "point3f[]", "float3[]", "color3f[]", "quatd"}


class Usda:
    def __init__(self, text):
        header = "#usda 1.0\n"
        assert text.startswith(header), "no header"
        self.tokens, at = [], len(header)
        text = text.rstrip()
        while at < len(text):
            match = TOKEN.match(text, at)
            assert match, f"no token: {text[at:at + 40]!r}"
            self.tokens.append((match.lastgroup, match[match.lastgroup]))
            at = match.end()
        self.at = 0
        self.metadata = self.parenthesised_metadata()
        self.root = self.prim()
        assert self.at == len(self.tokens), "more after the last prim"

    def peek(self):
        return self.tokens[self.at][1]

    def take(self, wanted=None):
        kind, value = self.tokens[self.at]
        assert wanted is None or value == wanted, f"{value!r} where {wanted!r} should be"
        self.at += 1
        return float(value) if kind == "number" else value[1:-1] if kind == "string" else value

    def parenthesised_metadata(self):
        self.take("(")
        entries = {}
        while self.peek() != ")":
            name = self.take()
            self.take("=")
            entries[name] = self.value()
        self.take(")")
        return entries

    def value(self):
        if self.peek() not in ("[", "("):
            return self.take()
        closing = {"[": "]", "(": ")"}[self.take()]
        values = []
        while self.peek() != closing:
            values.append(self.value())
            if self.peek() != closing:
                self.take(",")
        self.take(closing)
        return values if closing == "]" else tuple(values)

    def samples(self):
        self.take("{")
        samples = {}
        while self.peek() != "}":
            code = self.take()
            assert not samples or code > max(samples), "time codes must rise"
            self.take(":")
            samples[code] = self.value()
            self.take(",")
        self.take("}")
        return samples

    def prim(self):
        self.take("def")
        prim = {"schema": self.take(), "name": self.take(), "children": []}
        assert re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*", prim["name"]), prim["name"]
        self.take("{")
        while self.peek() != "}":
            if self.peek() == "def":
                prim["children"].append(self.prim())
                continue
            word = self.take()
            kind = self.take() if word == "uniform" else word
            assert kind in TYPES, f"no type of ours: {kind}"
            name = self.take()
            self.take("=")
            prim[name] = self.samples() if name.endswith(".timeSamples") else self.value()
            if self.peek() == "(":
                self.parenthesised_metadata()
        self.take("}")
        return prim


def held(samples, code):
    return samples[max(each for each in samples if each <= code)]


folder, cloths = Path(sys.argv[1]), sys.argv[2:]
motion = Motion(folder, cloths)
usda = Usda((folder / "motion.usda").read_text())
assert usda.metadata["upAxis"] == "Y" and usda.metadata["metersPerUnit"] == 1
assert usda.root["name"] == usda.metadata["defaultPrim"] and usda.root["schema"] == "Xform"
per_second = usda.metadata["timeCodesPerSecond"]
prims = {prim["name"]: prim for prim in usda.root["children"]}
single = motion.position.astype("<f4").astype(float)


def as_points(points):
    return np.array(points, dtype="<f4").reshape(-1, 3).astype(float)


codes = sorted(next(iter(prims.values()))["points.timeSamples"])
same_numbers(np.round(np.array(codes) / per_second, 12), np.round(motion.times, 12), "times")
assert (usda.metadata["startTimeCode"], usda.metadata["endTimeCode"]) == (codes[0], codes[-1])
for number, code in enumerate(codes):
    faces, lines, points = motion.shape(number)
    for sheet in cloths:
        prim = prims[sheet]
        assert prim["schema"] == "Mesh" and prim["subdivisionScheme"] == "none"
        masses = [i for i, place in motion.places.items() if place[0] == sheet]
        places = prim["points.timeSamples"][code]
        same_numbers(as_points(places), single[number][masses], sheet)
        extent = as_points(prim["extent.timeSamples"][code])
        same_numbers(extent, [single[number][masses].min(0), single[number][masses].max(0)], f"extent of {sheet}")
        counts = [int(n) for n in held(prim["faceVertexCounts.timeSamples"], code)]
        corners = [masses[int(n)] for n in held(prim["faceVertexIndices.timeSamples"], code)]
        ends = np.cumsum([0, *counts])
        assert ends[-1] == len(corners)
        same_faces([corners[a:b] for a, b in zip(ends, ends[1:])], faces[sheet], sheet)
    curves = prims.get("links")  # what never has a point isn't there
    assert curves or not lines, "no links"
    if curves:
        counts = held(curves["curveVertexCounts.timeSamples"], code)
        assert curves["schema"] == "BasisCurves" and curves["type"] == "linear" and counts == [2.0] * len(lines)
        places = as_points(curves["points.timeSamples"][code])
        same_numbers(places, single[number][np.array(lines, dtype=int).ravel()], "links")
    assert "masses" in prims or not points, "no masses"
    if "masses" in prims:
        same_numbers(as_points(prims["masses"]["points.timeSamples"][code]), single[number][points], "masses")
print(f"usda: {len(codes)} samples of {', '.join(prims)} are as the CSV says, in single precision")
