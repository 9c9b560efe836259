#!/usr/bin/env python3
"""Writes facs_map.json: what FACS action units and ARKit blendshapes move, as FAP values at full strength.

Input: facs_map.csv, a collection of public facts: the values that six character libraries give action units, values derived from the
Candide-3 model, and the signs of ARKit's blendshapes. Usage: make_facs_map.py facs_map.csv > facs_map.json

Rules (doc/decisions.md):
- A value is the median of those libraries that agree with the first library's sign, without it of the majority; where libraries
  contradict each other, or the Candide model alone knows a value, the entry is weak.
- A pair of FAPs on the left and right gets the mean of both, if they agree in direction; the sources differ by slips only.
- Blendshapes have the sign of the collection and the size of the action unit it names; OWN fills in what no source sizes.
- A blendshape of one side has half of what is on the midline, so that both together are the whole.
- CORNERS: inner mouth corners that one library alone moves go as far as the outer ones, or are left out where those go the other way.
- Derived rows of a ONE_SIDED unit turn to the side of its value rows: Candide pushes the jaw to the left, the libraries to the right.
- LIP_SIDES: where libraries contradict each other in the sides of a lip and the rest takes them further than its middle, they keep to the
  middle as in the Candide model.
- LEFT_OUT: rows that would move the lips when the head nods; one library alone has them.
"""
import csv
import json
import statistics
import sys

LIBRARIES = ["greta_default", "greta_autodesk", "greta_obadiah", "greta_poppy", "greta_prudence", "greta_spike"]
CANDIDE = {"AU13/15": ["AU15"], "AU23/24": ["AU23", "AU24"], "AU26/27": ["AU27"], "AU42-45": ["AU43"]}
SAME = {"AU45": "AU43", "AU46": "AU43"}  # a blink and a wink are lids that close
PAIRS = [(6, 7), (8, 9), (10, 11), (12, 13), (19, 20), (21, 22), (23, 24), (25, 26), (27, 28), (29, 30), (31, 32), (33, 34), (35, 36),
         (37, 38), (39, 40), (41, 42), (53, 54), (55, 56), (57, 58), (59, 60), (61, 62), (65, 66), (67, 68)]
PAIRED = {fap for pair in PAIRS for fap in pair}
ONE_SIDED = {"AU30", "AU32", "AU61", "AU62"}
SLIPS = {("AU15", 54): -20}  # outward is positive on both sides; the source has +20 beside -20
CORNERS = {6: 53, 7: 54}  # one library alone moves the inner corners by up to the width of the mouth; the outer ones are the measure
LIP_SIDES = {10: 5, 11: 5, 57: 52, 58: 52}
LEFT_OUT = {"AU58": "one library moves the lips with the head", "AU59": "one library moves the lips with the head"}
ARKIT_UNITS = {"AU43/45": ["AU43"], "AU10 or AU17": ["AU17"], "AU23 or AU24": ["AU24"], "AU26/27": ["AU27"], "AU28 (lower)": ["AU28"],
               "AU28 (upper)": ["AU28"], "AU34 (AD)": ["AU34"], "AU29 (AD)": ["AU29"], "AU30 (AD)": ["AU30"]}
# Sizes that no source has, chosen beside the others: FAP units, all weak.
OWN_UNITS = {"AU19": ("Tongue show", {45: 400}), "AU28": ("Lip suck", {16: -300, 17: -300, 51: 150, 52: 150})}
OWN = {"noseSneer": {61: 80, 62: 80, 63: 60}, "mouthShrugUpper": {51: 120, 17: 60}, "mouth": 150, "mouthClose": {4: 100, 5: 1000, 51: 100, 52: 500}, "tongueOut": {45: 400}}
# mouthClose takes back what jawOpen does to the lips: it closes them while the jaw hangs.
CLOSED_LIPS = [5, 10, 11, 52, 57, 58]
SHIFTS = ("jawLeft", "jawRight", "mouthLeft", "mouthRight")
ROTATIONS = [
    ("HeadYaw", 49, 1, "Live Link Face, rad, positive to the subject's left"),
    ("HeadPitch", 48, -1, "Live Link Face, rad, positive up; weak: some exports turn it round"),
    ("HeadRoll", 50, -1, "Live Link Face, rad, positive to the subject's left; weak: some exports turn it round"),
    ("pose_Rx", 48, 1, "OpenFace, rad, camera axes x right, y down, z away: positive down"),
    ("pose_Ry", 49, -1, "OpenFace, rad: positive to the subject's right"),
    ("pose_Rz", 50, -1, "OpenFace, rad: positive to the subject's left"),
]
# Live Link Face repeats in these what the eyeLook shapes say; they are read where those are missing or stay 0. No FAP rolls an eye.
EYES = [("LeftEyeYaw", 23, 1), ("LeftEyePitch", 25, -1), ("LeftEyeRoll", 0, 0), ("RightEyeYaw", 24, 1), ("RightEyePitch", 26, -1),
        ("RightEyeRoll", 0, 0)]
# Written with a column for each side.
SIDED = {"AU1", "AU2", "AU4", "AU5", "AU6", "AU7", "AU9", "AU10", "AU12", "AU14", "AU15", "AU20", "AU43", "AU45", "AU46"}
# The order of the columns of Live Link Face.
EYE_ORDER = ["eyeBlink", "eyeLookDown", "eyeLookIn", "eyeLookOut", "eyeLookUp", "eyeSquint", "eyeWide"]
MOUTH_ORDER = ["mouthSmile", "mouthFrown", "mouthDimple", "mouthStretch"]
LIP_ORDER = ["mouthPress", "mouthLowerDown", "mouthUpperUp", "browDown"]


def both(names):
    return [name + side for name in names for side in ("Left", "Right")]


ORDER = ([name + "Left" for name in EYE_ORDER] + [name + "Right" for name in EYE_ORDER] +
         ["jawForward", "jawRight", "jawLeft", "jawOpen", "mouthClose", "mouthFunnel", "mouthPucker", "mouthRight", "mouthLeft"] +
         both(MOUTH_ORDER) + ["mouthRollLower", "mouthRollUpper", "mouthShrugLower", "mouthShrugUpper"] + both(LIP_ORDER) +
         ["browInnerUp"] + both(["browOuterUp"]) + ["cheekPuff"] + both(["cheekSquint", "noseSneer"]) + ["tongueOut"])


def sign(value):
    return (value > 0) - (value < 0)


def choose(values):
    """The value of libraries (name, value) and whether it is weak; None where as many say yes as no."""
    first = dict(values).get("greta_default")
    total = sum(sign(value) for _, value in values)
    if first is None and total == 0:
        return None
    chosen = sign(first) if first is not None else sign(total)
    agreeing = [value for _, value in values if sign(value) == chosen]
    return statistics.median(agreeing), len(agreeing) < len(values) or (first is None and len(agreeing) == 1)


def round_value(value):
    return int(value) if abs(value) >= 10000 else round(value)


def symmetric(name, faps):
    for left, right in PAIRS:
        if name in ONE_SIDED or left not in faps or right not in faps:
            continue
        (a, weak_a), (b, weak_b) = faps[left], faps[right]
        if sign(a) == sign(b):
            faps[left] = faps[right] = ((a + b) / 2, weak_a or weak_b)


def candide_faps(rows, name):
    return {int(row["fap"]): float(row["candide_or_sign"]) for row in rows
            if row["row_type"] == "AU_to_FAP_derived" and name in CANDIDE.get(row["code"], [row["code"]])}


def round_lip(faps, model):
    for side, middle in LIP_SIDES.items():
        if side not in faps or middle not in faps or side not in model or middle not in model:
            continue
        (value, weak), centre = faps[side], faps[middle][0]
        if weak and value * centre > 0 and abs(value) > abs(centre):
            faps[side] = centre * model[side] / model[middle], True


def turned_units(rows, units):
    """One-sided units whose derived rows go to the other side than their value rows: where both know a FAP, it tells."""
    turned = set()
    for row in rows:
        name, fap = row["code"], int(row["fap"] or 0)
        if row["row_type"] == "AU_to_FAP_derived" and name in ONE_SIDED and fap in units[name][1]:
            if sign(units[name][1][fap][0]) != sign(float(row["candide_or_sign"])):
                turned.add(name)
    return turned


def read_units(rows):
    """AU -> (description, FAP -> (value, weak)), and what was left out."""
    units, raw, left_out = {}, {}, []
    for row in rows:
        if row["row_type"] != "AU_to_FAP_value":
            continue
        name, fap = row["code"], int(row["fap"])
        values = [(library, float(row[library])) for library in LIBRARIES if row[library]]
        raw.setdefault(name, {})[fap] = values
        if name in LEFT_OUT and not row["greta_default"]:
            left_out.append({"name": name, "fap": fap, "why": LEFT_OUT[name]})
            continue
        chosen = choose(values)
        if chosen is None:
            left_out.append({"name": name, "fap": fap, "why": "as many sources say one direction as the other"})
            continue
        if (name, fap) in SLIPS:
            chosen = SLIPS[name, fap], True
        if fap in CORNERS and len(values) == 1:
            outer = choose([(library, float(other[library])) for other in rows for library in LIBRARIES
                            if other["code"] == name and other["fap"] == str(CORNERS[fap]) and other[library]] or [("", 0.0)])
            if not outer or sign(outer[0]) != sign(chosen[0]):
                left_out.append({"name": name, "fap": fap, "why": "one library alone, against the outer corner"})
                continue
            chosen = sign(chosen[0]) * min(abs(chosen[0]), abs(outer[0])), True
        units.setdefault(name, (row["name_or_au"], {}))[1][fap] = chosen
    turned = turned_units(rows, units)
    for row in rows:
        if row["row_type"] != "AU_to_FAP_derived":
            continue
        fap, value = int(row["fap"]), float(row["candide_or_sign"])
        if row["code"] in turned:
            value = -value
        for name in CANDIDE.get(row["code"], [row["code"]]):
            faps = units.setdefault(name, (row["name_or_au"], {}))[1]
            if fap not in faps:
                faps[fap] = value, True
            elif sign(faps[fap][0]) != sign(value):
                faps[fap] = faps[fap][0], True
    for name, (_, faps) in units.items():
        symmetric(name, faps)
        round_lip(faps, candide_faps(rows, name))
    units["AU9"][1].update({fap: (OWN["noseSneer"][fap], True) for fap in (61, 62, 63)})
    for name, (description, faps) in OWN_UNITS.items():
        units[name] = description, {fap: (value, True) for fap, value in faps.items()}
    for name, other in SAME.items():
        units[name] = ("Blink" if name == "AU45" else "Wink"), dict(units[other][1])
    return units, raw, left_out


def size_of(row, units, raw, fap, wanted):
    name = row["code"].replace("Left", "").replace("Right", "")
    own = OWN.get(name, OWN.get(row["code"], {}))
    if not isinstance(own, dict) or fap in own:
        return (own[fap] if isinstance(own, dict) else own), True
    if name == "jaw":  # one action unit for both sides
        wanted = sign(units["AU30"][1][fap][0])
    for unit in ARKIT_UNITS.get(row["name_or_au"], [row["name_or_au"]]):
        faps = units.get(unit, ("", {}))[1]
        if fap in faps and sign(faps[fap][0]) == wanted:
            return abs(faps[fap][0]), faps[fap][1]
        agreeing = [abs(value) for _, value in raw.get(unit, {}).get(fap, []) if sign(value) == wanted]
        if agreeing:
            return statistics.median(agreeing), True
    raise ValueError(f"{row['code']}, FAP {fap}: no source gives a size")


def read_shapes(rows, units, raw):
    shapes = {}
    for row in rows:
        if row["row_type"] != "ARKit_to_FAP_sign":
            continue
        name, fap = row["code"], int(row["fap"])
        wanted = 1 if row["candide_or_sign"] == "+" else -1
        size, weak = size_of(row, units, raw, fap, wanted)
        if name.endswith(("Left", "Right")) and name not in SHIFTS and fap not in PAIRED:
            size /= 2
        doubtful = any(word in row["notes"] for word in ("weak", "disagree", "1/2", "no source", "name;"))
        shapes.setdefault(name, {})[fap] = wanted * size, weak or doubtful
    upper = shapes["mouthClose"][4][0]
    for fap in CLOSED_LIPS:
        shapes["mouthClose"][fap] = -shapes["jawOpen"][fap][0] - (upper if fap in (5, 10, 11) else 0), True
    return shapes


def entry(name, faps, description=None):
    item = {"name": name}
    if description:
        item["description"] = description
    item["faps"] = {str(fap): round_value(faps[fap][0]) for fap in sorted(faps) if round_value(faps[fap][0])}
    weak = [fap for fap in sorted(faps) if faps[fap][1]]
    if weak:
        item["weak"] = weak
    if name in SIDED:
        item["sided"] = True
    return item


def lines(items):
    return "[\n" + ",\n".join("    " + json.dumps(item) for item in items) + "\n  ]"


def main():
    with open(sys.argv[1], newline="") as file:
        rows = list(csv.DictReader(file))
    units, raw, left_out = read_units(rows)
    shapes = read_shapes(rows, units, raw)
    rotations = [{"name": name, "description": note, "faps": {str(fap): direction * 100000}} for name, fap, direction, note in ROTATIONS]
    rotations += [{"name": name, "faps": {str(fap): direction * 100000} if fap else {}, "stands_in": True} for name, fap, direction in EYES]
    order = sorted(units, key=lambda name: int(name[2:]))
    print('{\n  "format": "mien facial action map",\n  "version": 1,')
    print('  "action_units": ' + lines([entry(name, units[name][1], units[name][0]) for name in order]) + ",")
    print('  "blendshapes": ' + lines([entry(name, shapes[name]) for name in ORDER]) + ",")
    print('  "rotations": ' + lines(rotations) + ",")
    reasons = {}
    for item in left_out:
        reasons.setdefault((item["name"], item["why"]), []).append(item["fap"])
    print('  "left_out": ' + lines([{"name": name, "faps": faps, "why": why} for (name, why), faps in reasons.items()]) + "\n}")


main()
