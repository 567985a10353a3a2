"""What is in the size probes: sections and functions of little-endian 32-bit ELF files.

sizes.py measure BASELINE PROBE       prints bytes of code, of those the compiler's routines, bytes of constants
sizes.py functions [BASELINE] PROBE   prints functions by size, those that the baseline has too left out
sizes.py names PROBE                  prints the names of all functions, a line each
"""
import re
import struct
import subprocess
import sys

FUNCTION = 2  # STT_FUNC
# Routines that the compiler calls by itself; those that Rust names in full come from this crate.
ROUTINE = re.compile(r"compiler_builtins|^__aeabi_|^__[a-z]+[sdt]i[234]$|^mem(cpy|set|move|cmp)$")


def read(path):
    """Sizes of sections by name, and (size, address, name) of functions."""
    data = open(path, "rb").read()

    def text(at):
        return data[at : data.index(b"\0", at)].decode()

    offset, = struct.unpack_from("<I", data, 32)
    size, count, names = struct.unpack_from("<HHH", data, 46)
    headers = [struct.unpack_from("<10I", data, offset + i * size) for i in range(count)]
    sections = {text(headers[names][4] + header[0]): header[5] for header in headers}
    functions = {}
    for header in headers:
        if header[1] != 2:  # SHT_SYMTAB
            continue
        strings = headers[header[6]][4]
        for at in range(header[4], header[4] + header[5], 16):
            name, address, length, info = struct.unpack_from("<IIIB", data, at)
            # One function may have more than one name.
            if info & 15 == FUNCTION and (address not in functions or length):
                functions[address] = (length, text(strings + name))
    return sections, functions


def names(path):
    data = read(path)
    return sorted(name for _, name in data[1].values())


def routines(path):
    return sum(size for size, name in read(path)[1].values() if ROUTINE.search(name))


def measure(baseline, probe):
    before, after = read(baseline)[0], read(probe)[0]
    # Variables with a value take as much flash as RAM; the library has none.
    constants = sum(after.get(s, 0) - before.get(s, 0) for s in (".rodata", ".data"))
    print(after[".text"] - before[".text"], routines(probe) - routines(baseline), constants)


def functions(*paths):
    def plain(name):  # without the hash of the crate that it is in
        return re.sub(r"Cs[0-9A-Za-z]+_|\.llvm\.\d+$", "", name)

    known = {plain(name) for path in paths[:-1] for name in names(path)}
    rows = sorted(read(paths[-1])[1].values(), reverse=True)
    rows = [(size, name) for size, name in rows if size and plain(name) not in known]
    text = "\n".join(f"{size:6} {name}" for size, name in rows)
    try:
        text = subprocess.run(["c++filt"], input=text, capture_output=True, text=True).stdout
    except FileNotFoundError:
        pass  # binutils make names readable; without them they are told as they are
    # Without crates' hashes and the paths within them.
    text = re.sub(r"\[[0-9a-f]{8,}\]", "", text)
    text = re.sub(r"\b(?:[a-z_0-9]+::)+(?=[A-Z])", "", text)
    print(text)
    print(f"{sum(size for size, _ in rows):6} in all")


if __name__ == "__main__":
    if sys.argv[1:2] == ["measure"] and len(sys.argv) == 4:
        measure(*sys.argv[2:])
    elif sys.argv[1:2] == ["functions"] and len(sys.argv) in (3, 4):
        functions(*sys.argv[2:])
    elif sys.argv[1:2] == ["names"] and len(sys.argv) == 3:
        print("\n".join(names(sys.argv[2])))
    else:
        sys.exit(__doc__)
