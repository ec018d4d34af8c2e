"""What `taut export` says as CSV, read by pandas, and which shapes follow from it: the truth that other formats
are held against. It knows taut's sources only by their documentation (docs/exports.md)."""

import re
from pathlib import Path

import numpy as np
import pandas as pd


class Motion:
    """Tables of masses and links: masses.csv and links.csv in a folder."""

    def __init__(self, folder, cloths):
        masses = pd.read_csv(Path(folder) / "masses.csv", float_precision="round_trip")
        links = pd.read_csv(Path(folder) / "links.csv", float_precision="round_trip")
        self.frames = masses["frame"].unique()
        count = len(self.frames)
        self.names = list(masses["name"][masses["frame"] == self.frames[0]])
        self.times = masses["time"].to_numpy().reshape(count, -1)[:, 0]
        self.position = masses[["x", "y", "z"]].to_numpy().reshape(count, -1, 3)
        self.velocity = masses[["vx", "vy", "vz"]].to_numpy().reshape(count, -1, 3)
        first = links[links["frame"] == self.frames[0]]
        number = {name: i for i, name in enumerate(self.names)}
        self.ends = np.array([[number[a], number[b]] for a, b in zip(first["a"], first["b"])]).reshape(-1, 2)
        self.rest_length = first["rest_length"].to_numpy()
        self.tension = links["tension"].to_numpy().reshape(count, -1)
        self.strain = links["strain"].to_numpy().reshape(count, -1)
        self.broken_at = links["broken_at"].to_numpy().reshape(count, -1)
        self.broken = ~np.isnan(self.broken_at)
        self.cloths = cloths
        self._find_sheets()

    # Masses of sheets are named sheet.row.column; only those of several rows are none of a chain.
    def _find_sheets(self):
        self.places = {}
        for i, name in enumerate(self.names):
            match = re.fullmatch(r"(.+)\.(\d+)\.(\d+)", name)
            if match:
                self.places[i] = (match[1], int(match[2]), int(match[3]))
        self.mass_at = {place: i for i, place in self.places.items()}
        self.link_between = {frozenset(ends): i for i, ends in enumerate(self.ends.tolist())}

    def _is_whole(self, triangle, broken):
        edges = [frozenset((triangle[i], triangle[(i + 1) % 3])) for i in range(3)]
        return not any(edge in self.link_between and broken[self.link_between[edge]] for edge in edges)

    def _holds_shape(self, link):
        """Whether a link is there for a sheet's stiffness alone."""
        a, b = (self.places.get(int(end)) for end in self.ends[link])
        if a is None or b is None or a[0] != b[0]:
            return False
        return abs(a[1] - b[1]) + abs(a[2] - b[2]) != 1

    def shape(self, frame):
        """Faces by sheet, lines and points of a frame, as masses."""
        broken = self.broken[frame]
        faces = {name: [] for name in self.cloths}
        edges = set()
        for i, (sheet, row, column) in self.places.items():
            if sheet not in self.cloths:
                continue
            corners = [self.mass_at.get((sheet, row + r, column + c)) for r, c in ((0, 0), (1, 0), (1, 1), (0, 1))]
            if None in corners:
                continue
            top_left, bottom_left, bottom_right, top_right = corners
            upper, lower = (top_left, bottom_left, top_right), (top_right, bottom_left, bottom_right)
            whole = [t for t in (upper, lower) if self._is_whole(t, broken)]
            for triangle in whole:
                edges |= {frozenset((triangle[k], triangle[(k + 1) % 3])) for k in range(3)}
            faces[sheet] += [tuple(corners)] if len(whole) == 2 else whole
        lines = [tuple(ends) for link, ends in enumerate(self.ends.tolist())
                 if not broken[link] and not self._holds_shape(link) and frozenset(ends) not in edges]
        used = {mass for sheet in faces.values() for face in sheet for mass in face}
        used |= {mass for line in lines for mass in line}
        points = [i for i in range(len(self.names)) if i not in used]
        return faces, lines, points


def turned(face):
    """A face from its smallest corner on: the same for every way of writing it down in the same sense."""
    start = face.index(min(face))
    return tuple(face[start:] + face[:start])


def same_faces(got, wanted, what):
    assert sorted(turned(tuple(f)) for f in got) == sorted(turned(tuple(f)) for f in wanted), f"{what}: faces differ"


def same_lines(got, wanted, what):
    assert sorted(tuple(sorted(l)) for l in got) == sorted(tuple(sorted(l)) for l in wanted), f"{what}: lines differ"


def same_numbers(got, wanted, what):
    got, wanted = np.asarray(got), np.asarray(wanted)
    assert got.shape == wanted.shape, f"{what}: {got.shape} numbers, not {wanted.shape}"
    assert np.array_equal(got, wanted, equal_nan=wanted.dtype.kind == "f"), (
        f"{what}: differ by up to {np.nanmax(np.abs(got - wanted))}")
