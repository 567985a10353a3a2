"""Reads sections and functions of programs."""
import collections
import re
import subprocess

from elftools.elf.elffile import ELFFile

# Routines that the compiler calls implicitly. Those with a full Rust name come from the crate compiler_builtins.
ROUTINE = re.compile(r"compiler_builtins|^__aeabi_|^__[a-z]+[sdt]i[234]$|^mem(cpy|set|move|cmp)$")


def read(path):
    """Returns sizes of sections by name; sizes and names of functions by address; all names of functions."""
    functions, names = {}, []
    with open(path, "rb") as file:
        program = ELFFile(file)
        sections = {section.name: section["sh_size"] for section in program.iter_sections()}
        symbols = program.get_section_by_name(".symtab")
        for symbol in symbols.iter_symbols() if symbols else []:
            if symbol["st_info"]["type"] == "STT_FUNC":
                names.append(symbol.name)
                # A function may have several names.
                if symbol["st_value"] not in functions or symbol["st_size"]:
                    functions[symbol["st_value"]] = (symbol["st_size"], symbol.name)
    return sections, functions, sorted(names)


def routines(path):
    return sum(size for size, name in read(path)[1].values() if ROUTINE.search(name))


def measure(baseline, probe):
    """Returns bytes of code, of compiler routines in it, and of constants, each less the baseline's."""
    before, after = read(baseline)[0], read(probe)[0]
    # Initialized variables take as much flash as RAM; the library has none.
    constants = sum(after.get(s, 0) - before.get(s, 0) for s in (".rodata", ".data"))
    return after[".text"] - before[".text"], routines(probe) - routines(baseline), constants


def memory(path):
    """Returns bytes of flash, and of RAM without the stack."""
    sections = read(path)[0]

    def total(*names):
        return sum(sections.get(name, 0) for name in names)

    # The startup code copies these from flash to RAM: initialized variables, and an ESP32's code that must not wait
    # for flash.
    both = total(".data", ".trap", ".rwtext")
    return (both + total(".vector_table", ".start_block", ".boot2", ".flash.appdesc", ".text", ".rodata"),
            both + total(".bss", ".uninit", ".noinit"))


def readable(text):
    """Removes the hashes of crates and the paths within them."""
    text = re.sub(r"\[[0-9a-f]{8,}\]|: usize\b", "", text)
    return re.sub(r"\b(?:[a-z_0-9]+::)+(?=[A-Z])", "", text)


def functions(baseline, probe):
    """Prints functions by size, less the baseline's function of that name."""
    def plain(name):  # without the parts that differ between probes
        return re.sub(r"Cs[0-9A-Za-z]+_|\d+size_[a-z]+|\.llvm\.\d+$", "", name)

    known = collections.Counter()
    for size, name in read(baseline)[1].values():
        known[plain(name)] += size
    rows = [(size - known[plain(name)], name) for size, name in read(probe)[1].values()]
    rows = sorted((row for row in rows if row[0]), reverse=True)
    text = "\n".join(f"{size:6} {name}" for size, name in rows)
    try:
        text = subprocess.run(["c++filt"], input=text, capture_output=True, text=True).stdout
    except FileNotFoundError:
        pass  # without binutils, which make names readable, print the raw names
    print(readable(text.rstrip()))
    print(f"{sum(size for size, _ in rows):6} in all")


def sources(path):
    """Prints the library's functions by size, inlined or not. Counts every two bytes of code for the innermost function
    of this project from which they were inlined. Needs llvm-symbolizer."""
    ranges = ((at & ~1, size) for at, (size, _) in read(path)[1].items())
    addresses = sorted({at for start, size in ranges for at in range(start, start + size, 2)})
    command = ["llvm-symbolizer", "--obj=" + path, "--inlines", "--demangle"]
    text = "\n".join(map(hex, addresses))
    text = subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout
    sizes = collections.Counter()
    for block in text.strip().split("\n\n"):
        lines = block.splitlines()
        frames = list(zip(lines[::2], lines[1::2]))
        # Keep frames of this project: paths of dependencies contain /registry/, paths of the compiler /library/.
        own = [name for name, at in frames if re.search(r"/(src|examples)/", at)
               and "/registry/" not in at and "/library/" not in at]
        sizes[readable((own or [frames[0][0]])[0])] += 2
    for name, size in sizes.most_common():
        print(f"{size:6} {name}")
