#!/usr/bin/env python3
"""Compares the firmware's output on each target with the host's checksums, and prints a table.

Arguments: a folder with the output of each target, in a file with the target's name, and the file `host` (lines of
scene, mode and checksum); then the targets. Fails unless every target printed every scene in every mode and layout, all
with the host's checksum and the same number of pixels. Lines that begin with `same` are for pictures drawn in other
ways: every way must be there, and must also have the host's checksum."""
import re
import sys
from collections import defaultdict
from pathlib import Path

LAYOUTS = ["frame", "bands", "prepared"]
DRAWN = [f"rows-{rows}" for rows in ["240", "1", "7", "16", "240-again", "240-over"]]
ORDERS = {"cube": ["", "-reversed"], "default": [""]}
WAYS = {
    (scene, "newton", drawn + order + source)
    for scene, orders in ORDERS.items()
    for order in orders
    for drawn in DRAWN
    for source in ["", "-prepared"]
}
folder, *targets = sys.argv[1:]
lines = [line.split() for line in Path(folder, "host").read_text().splitlines()]
host = {(scene, mode): crc for scene, mode, crc in lines}
wrong = [] if len(host) == 20 else [f"the host printed {len(host)} checksums"]
pixels = {}  # of each scene, from the output of the first target
rows = []
for target in targets:
    printed = Path(folder, target).read_text()
    figures = defaultdict(dict)
    same = {}
    for line in printed.splitlines():
        fields = dict(re.findall(r"(\S+)=(\S+)", line))
        if line.startswith("same "):
            same[fields["scene"], fields["mode"], fields["way"]] = fields["crc"]
        elif fields.get("layout") in LAYOUTS:
            figures[fields["scene"], fields["mode"], fields["layout"]].update(fields)
    unit = re.search(r"^tick=(\d+) instructions$", printed, re.M)
    cases = {(*drawn, layout) for drawn in host for layout in LAYOUTS}
    if not unit or cases - figures.keys() or WAYS - same.keys() or "failed" in printed:
        wrong.append(f"{target} did not finish:\n{printed}")
        continue
    for (scene, mode, way), crc in same.items():
        if crc != host.get((scene, mode)):
            wrong.append(f"{target}: {scene} in mode {mode}, {way}, is {crc}, not {host.get((scene, mode))}")
    for (scene, mode, layout), found in figures.items():
        case, wanted = f"{target}: {scene} in mode {mode}, {layout},", host.get((scene, mode))
        if found.get("crc") != wanted:
            wrong.append(f"{case} is {found.get('crc')}, not {wanted}")
        if found["pixels"] != pixels.setdefault(scene, found["pixels"]):
            wrong.append(f"{case} has {found['pixels']} pixels, not {pixels[scene]}")
    for scene, mode in host:
        cells = [figures[scene, mode, layout] for layout in LAYOUTS]
        rows.append(
            [target, mode, scene, cells[0]["pixels"]]
            + [f"{int(cell['ticks']) * int(unit[1]) / 1e6:.2f}" for cell in cells]
            + [cell["stack"] for cell in cells]
        )
print(*wrong, sep="\n", end="\n" if wrong else "")
head = ["target", "mode", "scene", "pixels"]
head += [f"M instructions, {layout}" for layout in LAYOUTS]
head += [f"stack, {layout}" for layout in LAYOUTS]
widths = [max(len(row[column]) for row in [head, *rows]) for column in range(len(head))]
for row in [head, *rows]:
    texts = [cell.ljust(width) for cell, width in zip(row[:3], widths)]
    numbers = [cell.rjust(width) for cell, width in zip(row[3:], widths[3:])]
    print("  ".join(texts + numbers))
sys.exit(bool(wrong))
