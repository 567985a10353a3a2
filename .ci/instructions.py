"""Compares the instructions of programs on each target with tests/instructions.csv, or writes them to this file. Its
first line has the compiler's release for all counts. Counts of another release are compared, too: if one has grown, the
message names both releases."""
import csv
import re
from pathlib import Path

from cross import PINNED

MOST = 1.02
FILE = Path("tests/instructions.csv")
# The ending of the name of a target's output, by opt-level; "plain" is without link-time optimization.
OUTPUTS = {"3": "", "s": ".size", "3 plain": ".plain", "s plain": ".plain-size"}
COUNTED = 1000  # costs of kernels are kept for this many pixels or triangles


def measured(folder, target):
    """Returns instructions by optimization, mode, the thing drawn, and unit."""
    found = {}
    for optimization, end in OUTPUTS.items():
        path = Path(folder, target + end)
        for case, instructions in (counts(path.read_text()) if path.exists() else {}).items():
            found[optimization, *case] = instructions
    return found


def counts(text):
    """Returns instructions by mode, the thing drawn, and unit."""
    unit = re.search(r"^tick=(\d+) instructions$", text, re.M)
    found = {}
    for line in text.splitlines() if unit else []:
        fields = dict(re.findall(r"(\S+)=(\S+)", line))
        if "ticks" not in fields:
            continue
        instructions = int(fields["ticks"]) * int(unit[1])
        if "scene" in fields:
            found[fields["mode"], fields["scene"], fields["layout"]] = round(instructions / int(fields.get("frames", 1)))
        else:
            per = f"{COUNTED} {fields['unit']}s".replace("vertexs", "vertices")
            found["kernel", fields["kernel"], per] = round(instructions * COUNTED / int(fields["units"]))
    return found


def read():
    """Returns instructions by target and case."""
    kept = {}
    for target, *case, instructions in list(csv.reader(FILE.read_text().splitlines()))[2:]:
        kept.setdefault(target, {})[tuple(case)] = int(instructions)
    return kept


def renew(folder, targets, release):
    """Rewrites the targets' part of the file."""
    kept = read()
    if release != PINNED and kept.keys() - set(targets):
        return [f"{FILE} has counts of rustc {PINNED}: renew those of all targets with {release}"]
    for target in targets:
        kept[target] = measured(folder, target)
        print(f"{target}: {len(kept[target])} counts written to {FILE}")
    with FILE.open("w", newline="") as file:
        file.write(f"# rustc {release}\n")
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["target", "optimization", "mode", "what", "per", "instructions"])
        for target in sorted(kept):
            out.writerows([target, *case, count] for case, count in kept[target].items())
    return []


def compare(folder, targets, release):
    """Returns what is wrong: cases that take over 2 % more instructions, or are not in the file. For each target, the
    folder has a file with its output, and files with the output of programs with other settings, if these were run."""
    kept, wrong = read(), []
    for target in targets:
        now, known = measured(folder, target), len(wrong)
        run = {optimization for optimization, end in OUTPUTS.items() if Path(folder, target + end).exists()}
        before = {case: count for case, count in kept.get(target, {}).items() if case[0] in run}
        for case in sorted(before.keys() | now.keys()):
            name = f"{target} at {', '.join(case)},"
            if case not in now:
                wrong.append(f"{name} is in the file and was not measured")
            elif case not in before:
                wrong.append(f"{name} is not in the file")
            elif now[case] > before[case] * MOST:
                more = f"{(now[case] / before[case] - 1) * 100:.1f} % more than" if before[case] else "more than"
                wrong.append(f"{name} takes {now[case]} instructions, {more} {before[case]}")
        if not now:
            wrong.append(f"{target} printed no counts")
        print(f"{target}: {len(now)} counts, {len(wrong) - known} wrong")
        if better := sum(now[case] * MOST < count for case, count in before.items() if case in now):
            print(f"  over 2 % better: {better}; to keep that, .ci/firmware --renew {target}")
    if wrong and release != PINNED:
        wrong.append(f"The counts in {FILE} are from rustc {PINNED}, these from {release}. Each release makes other "
                     f"code, so compare with the same: rustup toolchain install {PINNED} --profile minimal --target "
                     f"{','.join(targets)}")
    elif wrong:
        wrong.append("If the growth is intended, .ci/firmware --renew rewrites the file.")
    return wrong
