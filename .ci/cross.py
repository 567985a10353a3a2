"""Builds for other targets. Importing this module changes to the project's folder, and lets a script that ends because
a command failed say that in one line."""
import functools
import os
import shutil
import subprocess
import sys
from pathlib import Path

os.chdir(Path(__file__).resolve().parent.parent)
sys.stdout.reconfigure(line_buffering=True)  # keeps the order of what scripts and their commands print
TARGETS = ["thumbv6m-none-eabi", "thumbv7m-none-eabi", "thumbv7em-none-eabi", "thumbv8m.base-none-eabi",
           "thumbv8m.main-none-eabi", "riscv32imc-unknown-none-elf"]
# All counts of instructions are from one release of the compiler.
PINNED = Path("tests/instructions.csv").read_text().splitlines()[0].removeprefix("# rustc ")
# Names that no program may link: float routines (Arm's, those of other compiler runtimes, and Rust's own conversions to
# and from text), and an allocator.
FLOATS = (r"__aeabi_c?[fd]r?(add|sub|mul|div|neg|cmp|2)|__aeabi_u?[il]2[fd]|__aeabi_h2f"
          r"|[a-z][sd]f[23]?$|__fix(uns)?[sd]f[sd]i|flt2dec|dec2flt")
ALLOCATOR = "__rust_alloc|__rg_alloc|__rdl_alloc"


def say(kind, error, trace):
    if issubclass(kind, subprocess.SubprocessError):
        return print(error, file=sys.stderr)
    sys.__excepthook__(kind, error, trace)


sys.excepthook = say


@functools.lru_cache
def toolchain(target):
    """Returns a release that rustup has with a target: the pinned one or else the default one (""). Returns None if
    Debian's compiler must build the target."""
    for release in [PINNED, os.environ.get("RUSTUP_TOOLCHAIN", "")] if shutil.which("rustc") else []:
        settings = {"RUSTUP_TOOLCHAIN": release, "RUSTUP_AUTO_INSTALL": "0"}
        found = subprocess.run(["rustc", "--print", "target-libdir", "--target", target], env=os.environ | settings,
                               capture_output=True, text=True)
        if found.returncode == 0 and os.path.isdir(found.stdout.strip()):
            return release
    return None


def compiler(target):
    """Returns the release of the compiler that `cross` uses for a target."""
    release = toolchain(target)
    command, settings = ("/usr/bin/rustc", {}) if release is None else ("rustc", {"RUSTUP_TOOLCHAIN": release})
    return subprocess.check_output([command, "--version"], env=os.environ | settings, text=True).split()[1]


def cross(targets, *arguments, library="core", **options):
    """Runs cargo for targets. Several targets build side by side, which keeps both cores busy: most of the time goes to
    crates that are compiled in one piece. Debian's compiler also builds the library: `core`, or the crates named."""
    cargo, settings = "cargo", {"RUSTUP_TOOLCHAIN": toolchain(targets[-1])}
    flags = [flag for target in targets for flag in ("--target", target)] + ["--target-dir", "target/cross"]
    if None in map(toolchain, targets):
        cargo, settings = "/usr/bin/cargo", {"RUSTC_BOOTSTRAP": "1", "RUSTC": "/usr/bin/rustc"}
        # Debian's compiler comes without a linker of its own.
        flags += [f"-Zbuild-std={library}", "--config", r'target."cfg(target_os = \"none\")".linker = "ld.lld"']
    settings = {**os.environ, **settings, **options.pop("env", {})}
    return subprocess.run([cargo, *arguments, *flags], **{"check": True, "env": settings, **options})
