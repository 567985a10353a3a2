"""Compares the firmware's output on each target with the host's checksums."""
import re
from collections import defaultdict
from pathlib import Path

LAYOUTS = ["frame", "bands", "prepared"]
# Pictures that are drawn in other ways, too, on lines that begin with `same`.
WAYS = {(scene, "newton", f"rows-{rows}{order}{source}")
        for scene, orders in {"cube": ["", "-reversed"], "default": [""]}.items() for order in orders
        for rows in ["240", "1", "7", "16", "240-again", "240-over"] for source in ["", "-prepared"]}
ROW = "{:28} {:7} {:12} {:>7}" + " {:>14}" * 6


def compare(folder, host, targets):
    """Prints a table, and returns what is wrong: every target must have printed every scene in every mode and layout,
    with the host's checksum (by scene and mode) and the same number of pixels, and every other way to draw it. The
    folder has the output of each target, in a file with the target's name."""
    wrong = [] if len(host) == 20 else [f"the host printed {len(host)} checksums"]
    pixels = {}  # of each scene, from the output of the first target
    costs = [f"{what} {layout}" for what in ["M", "stack"] for layout in LAYOUTS]
    print(ROW.format("target", "mode", "scene", "pixels", *costs), " (M: million instructions)")
    for target in targets:
        printed = Path(folder, target).read_text()
        figures, same = defaultdict(dict), {}
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
        checksums = same | {case: found.get("crc") for case, found in figures.items()}
        for (scene, mode, way), crc in checksums.items():
            if crc != host.get((scene, mode)):
                wrong.append(f"{target}: {scene} in mode {mode}, {way}, is {crc}, not {host.get((scene, mode))}")
        for (scene, mode, layout), found in figures.items():
            if found["pixels"] != pixels.setdefault(scene, found["pixels"]):
                wrong.append(f"{target}: {scene} in mode {mode}, {layout}, has {found['pixels']} pixels, not "
                             f"{pixels[scene]}")
        for scene, mode in host:
            cells = [figures[scene, mode, layout] for layout in LAYOUTS]
            millions = [f"{int(cell['ticks']) * int(unit[1]) / 1e6:.2f}" for cell in cells]
            stacks = [cell["stack"] for cell in cells]
            print(ROW.format(target, mode, scene, cells[0]["pixels"], *millions, *stacks))
    return wrong
