#!/usr/bin/env python3
"""Installs what scripts need and is missing: Debian's packages, and npm's for the emulated Pico. Where that takes
another user or another package manager, says in one line what is missing.

install.py [PURPOSE or TARGET ...]     (default: everything that `run` needs)
"""
import fcntl
import importlib.util
import os
import shutil
import subprocess
import sys

import __main__
from cross import TARGETS, toolchain

# Debian's packages for each purpose, and for each target that rustup has not installed.
PACKAGES = {
    "links": ["linkchecker"],
    "counts": ["valgrind"],
    "emulators": ["qemu-system-arm", "qemu-system-misc", "python3-pyelftools"],
    "boards": ["python3-pyelftools", "python3-unicorn", "nodejs", "npm"],
    "browser": ["chromium", "nodejs", "npm"],
    "node": ["nodejs", "npm"],
}
COMPILER = ["rustc-web", "cargo-web", "rust-web-src", "lld"]
# Modules of Python, which pip also installs, under the packages' names without "python3-".
MODULES = {"python3-pyelftools": "elftools", "python3-unicorn": "unicorn"}
# The command or the folder that a package brings, if its name is another one.
BRINGS = {"qemu-system-misc": "qemu-system-riscv32", "nodejs": "node", "rustc-web": "/usr/bin/rustc",
          "cargo-web": "/usr/bin/cargo", "rust-web-src": "/usr/lib/rustlib/src", "lld": "ld.lld"}
DEBIANS = "/usr/bin/python3"


def is_missing(package):
    if package in MODULES:
        return importlib.util.find_spec(MODULES[package]) is None
    brought = BRINGS.get(package, package)
    return not shutil.which(brought) and not os.path.isdir(brought)


def install(*purposes):
    os.makedirs("target", exist_ok=True)
    with open("target/install.lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # other scripts may call this at the same time
        targets = [target for target in purposes if target not in PACKAGES and not toolchain(target)]
        wanted = [package for purpose in purposes for package in PACKAGES.get(purpose, [])] + COMPILER * bool(targets)
        missing = sorted(filter(is_missing, set(wanted)))
        modules = [package.removeprefix("python3-") for package in missing if package in MODULES]
        if modules and sys.executable != DEBIANS and shutil.which("apt-get"):
            # Only Debian's own Python finds Debian's packages, so it runs the script instead.
            os.execv(DEBIANS, [DEBIANS, __main__.__file__, *sys.argv[1:]])
        sudo = ["sudo"] if os.getuid() else []
        if missing and not all(map(shutil.which, ["apt-get", *sudo])):
            others = [f"pip install {' '.join(modules)}"] * bool(modules)
            others += [f"rustup target add {' '.join(targets)}"] * bool(targets)
            sys.exit(f"missing, as Debian's packages: {' '.join(missing)}" + "".join(f" (or: {way})" for way in others))
        if missing:
            subprocess.run([*sudo, "apt-get", "update", "-qq"], check=True)
            subprocess.run([*sudo, "apt-get", "install", "-y", "-qq", "--no-install-recommends", *missing], check=True)
        if {"boards", "browser"} & set(purposes):
            npm = ["npm", "--prefix", "examples/boards/emulator", "--no-audit", "--no-fund", "--loglevel=error"]
            if subprocess.run([*npm, "ls"], capture_output=True).returncode:
                subprocess.run([*npm, "install"], check=True)


if __name__ == "__main__":
    install(*sys.argv[1:] or ["links", "counts", "emulators", "boards", *TARGETS, "wasm32-unknown-unknown"])
