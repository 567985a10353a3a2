#!/usr/bin/env python3
"""Compares the instructions of programs on each target with tests/instructions.csv, and prints the changes.

Arguments: `--renew`, to rewrite the targets' part of the file; a folder; the targets. For each target, the folder has
a file with its output, and a file ending in .size with the output of programs optimized for size, if these were run.
The file `rustc` has the compiler's release. Fails if a case takes over 2 % more instructions, or is not in
tests/instructions.csv. The first line of tests/instructions.csv has the compiler's release for all counts. Counts of
another release are compared, too: if one has grown, the message names both releases."""
import csv
import re
import sys
from pathlib import Path

MOST = 1.02
FILE = Path("tests/instructions.csv")
HEAD = ["target", "optimization", "mode", "what", "per", "instructions"]
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
            per = f"{COUNTED} {fields['unit']}s"
            found["kernel", fields["kernel"], per] = round(instructions * COUNTED / int(fields["units"]))
    return found


def read():
    """Returns the compiler's release, and instructions by target and case."""
    kept = {}
    first, *lines = FILE.read_text().splitlines()
    for target, *case, instructions in list(csv.reader(lines))[1:]:
        kept.setdefault(target, {})[tuple(case)] = int(instructions)
    return first.removeprefix("# rustc "), kept


def write(release, kept):
    with FILE.open("w", newline="") as file:
        file.write(f"# rustc {release}\n")
        out = csv.writer(file, lineterminator="\n")
        out.writerow(HEAD)
        for target in sorted(kept):
            out.writerows([target, *case, count] for case, count in kept[target].items())


def compare(target, before, now):
    """Returns the failures, and the number of cases that take fewer instructions."""
    wrong, better = [], 0
    for case in before.keys() | now.keys():
        optimization, mode, what, per = case
        name = f"{target} at {optimization}: {what} in mode {mode}, {per},"
        if mode == "kernel":
            name = f"{target} at {optimization}: kernel {what}, {per},"
        if case not in now:
            wrong.append(f"{name} is in the file and was not measured")
        elif case not in before:
            wrong.append(f"{name} is not in the file")
        elif now[case] > before[case] * MOST:
            wrong.append(f"{name} takes {now[case]} instructions, {more(before[case], now[case])} than {before[case]}")
        better += case in now and case in before and now[case] * MOST < before[case]
    return sorted(wrong), better


def more(before, now):
    return f"{(now / before - 1) * 100:.1f} % more" if before else "more"


def main():
    arguments = sys.argv[1:]
    renew = "--renew" in arguments
    folder, *targets = [argument for argument in arguments if argument != "--renew"]
    pinned, kept = read()
    release = Path(folder, "rustc").read_text().strip()
    failed = False
    if renew and release != pinned and kept.keys() - set(targets):
        sys.exit(f"{FILE} has counts of rustc {pinned}: renew those of all targets with {release}")
    for target in targets:
        now = measured(folder, target)
        if not now:
            failed = True
            print(f"{target} printed no counts")
        elif renew:
            kept[target] = now
            print(f"{target}: {len(now)} counts written to {FILE}")
        elif target not in kept:
            failed = True
            print(f"{target} is not in {FILE}: .ci/firmware --renew {target}")
        else:
            run = {optimization for optimization, end in OUTPUTS.items() if Path(folder, target + end).exists()}
            before = {case: count for case, count in kept[target].items() if case[0] in run}
            wrong, better = compare(target, before, now)
            failed |= bool(wrong)
            print(*wrong, f"{target}: {len(now)} counts, {len(wrong)} wrong", sep="\n")
            if better:
                print(f"  over 2 % better: {better}; to keep that, .ci/firmware --renew {target}")
    if renew:
        write(release, kept)
    elif failed and release != pinned:
        print(f"The counts in {FILE} are from rustc {pinned}, these from {release}. Each release makes other code, so "
              f"compare with the same: rustup toolchain install {pinned} --profile minimal --target {','.join(targets)}")
    elif failed:
        print("If the growth is intended, .ci/firmware --renew rewrites the file.")
    sys.exit(failed)


main()
