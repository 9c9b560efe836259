#!/usr/bin/env python3
"""Writes demo.fap, Mien's own demonstration animation: 301 frames at 25 fps of the 22 FAPs of the paper.

Neutral, a blink, brows up and down, a speech-like mouth, then each of the six expressions of expressions.json with
smooth ease in and out, and neutral again. Usage: make_demo.py > demo.fap
"""
import json
import math
import pathlib

VERSION = 1
FRAMES, RATE = 301, 25
FAPS = [19, 20, 31, 32, 33, 34, 35, 36, 39, 40, 41, 42, 51, 52, 53, 54, 59, 60, 61, 62, 63, 64]
BLINK = {19: 1024, 20: 1024}
BROWS_UP = {fap: 260 for fap in range(31, 37)}
BROWS_DOWN = {31: -130, 32: -130, 33: -110, 34: -110, 35: -60, 36: -60}
# Syllables of speech: first frame, length, how far the mouth opens, how far its corners go out.
SYLLABLES = [(84, 9, 330, 20), (91, 8, 160, 70), (97, 10, 420, -30), (105, 8, 220, 50), (111, 9, 120, -60), (118, 10, 300, 40)]
FIRST_EXPRESSION, EXPRESSION_LENGTH, EASE = 130, 28, 9


def smooth(t):
    t = min(max(t, 0.0), 1.0)
    return t * t * t * (10.0 - 15.0 * t + 6.0 * t * t)


def held(frame, first, length, ease):
    """0 before and after, 1 between, with smooth ends."""
    return smooth((frame - first) / ease) * smooth((first + length - frame) / ease)


def speech(frame):
    values = {}
    for first, length, opening, width in SYLLABLES:
        inside = min(max((frame - first) / length, 0.0), 1.0)
        share = math.sin(math.pi * inside) ** 2
        for fap, value in ((51, -0.15 * opening), (52, -opening), (53, width), (54, width)):
            values[fap] = values.get(fap, 0.0) + share * value
    return values


def values_at(frame, expressions):
    layers = [(held(frame, 22, 10, 4), BLINK), (held(frame, 40, 22, 8), BROWS_UP), (held(frame, 58, 22, 8), BROWS_DOWN),
              (1.0, speech(frame))]
    for number, expression in enumerate(expressions):
        first = FIRST_EXPRESSION + number * EXPRESSION_LENGTH
        actions = expression.get("actions", [expression])
        faps = {int(fap): value for action in actions for fap, value in action["faps"].items() if int(fap) in FAPS}
        layers.append((held(frame, first, EXPRESSION_LENGTH, EASE), faps))
    total = dict.fromkeys(FAPS, 0.0)
    for share, faps in layers:
        for fap, value in faps.items():
            total[fap] += share * value
    return [round(total[fap]) for fap in FAPS]


def main():
    folder = pathlib.Path(__file__).resolve().parent
    expressions = json.loads((folder / "expressions.json").read_text())["expressions"]
    mask = " ".join("1" if fap in FAPS else "0" for fap in range(1, 69))
    print(f"# Mien demonstration animation, version {VERSION}, written by make_demo.py")
    print(f"2.1 Mien_demonstration {RATE} {FRAMES}")
    for frame in range(FRAMES):
        print(mask)
        print(frame, *values_at(frame, expressions))


if __name__ == "__main__":
    main()
