"""Checks everything that must hold before a merge: the README's commands, formatting, lints, documentation, and the
same pixels on microcontrollers as on the host. Installs the tools it needs. `nightly` runs the checks that take longer.

    .ci/run [LANE ...]     (default: all lanes)

Prints each step's output when the step has ended; until then, the output is in target/run/.
"""
import os
import shutil
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

os.chdir(Path(__file__).resolve().parent.parent)
# The lanes run side by side on two cores: while a compiler keeps only one core busy, or a build waits for another build
# in the same folder, the other lanes go on.
LANES = {
    "crate": {
        "tests: the README command": "cargo test",
        "lints: formatting and clippy": ".ci/lint",
        "release: what would be published, and its documentation": ".ci/release",
        "pages: links of the guide, README, CONTRIBUTING and CHANGELOG; their figures; the path of a pixel":
            ".ci/links && .ci/figures --check && .ci/path",
        "boards: the bytes on their buses, and the same pixels on an emulated Pico": ".ci/boards quick",
    },
    "programs": {
        "programs: their tests": "cargo test --workspace --exclude fixel --exclude support",
        "main job: the README command": "cargo run --release -p simulator && test -s lighthouse.png",
        "playground: the same pixels in WebAssembly": ".ci/playground quick",
    },
    # These steps test the core that differs most from the host, and the one whose speed the documentation states;
    # `nightly` tests all six.
    "targets": {
        "firmware: the same pixels on microcontrollers, in no more instructions":
            ".ci/firmware --quick thumbv6m-none-eabi thumbv7em-none-eabi",
        "cookbook: the same pixels on microcontrollers, in no more instructions and RAM":
            ".ci/recipes thumbv6m-none-eabi thumbv7em-none-eabi",
        "size: flash and stack of each class of scene": ".ci/sizes thumbv7em",
    },
}
# Everything is built only once, so keeping data for an incremental build would only take time.
os.environ["CARGO_INCREMENTAL"] = "0"
LOGS = Path("target/run")
times, failed, printing = [], [], threading.Lock()


def run(lane):
    """Runs the steps of a lane. Once a step has failed, no other step begins."""
    for name, command in LANES[lane].items():
        if failed:
            return
        log, began = LOGS / name.split(":")[0], time.monotonic()
        with log.open("wb") as output:
            process = subprocess.Popen(command, shell=True, stdin=subprocess.DEVNULL, stdout=output, stderr=output)
            _, process.returncode, used = os.wait4(process.pid, 0)
        failed.extend([name] * bool(process.returncode))
        took, processors = time.monotonic() - began, used.ru_utime + used.ru_stime
        times.append(f"{took:5.0f} s {processors:5.0f} s of processors  {name}{' FAILED' * bool(process.returncode)}")
        with printing:
            print(f"\n== {name}\n{log.read_text(errors='replace')}{times[-1]}", flush=True)


lanes = sys.argv[1:] or list(LANES)
if set(lanes) - LANES.keys():
    sys.exit(__doc__)
began = time.monotonic()
shutil.rmtree(LOGS, ignore_errors=True)
LOGS.mkdir(parents=True)
# Installs the tools of the later steps, which wait until the installation has ended.
with ThreadPoolExecutor() as pool, (LOGS / "install").open("wb") as output:
    pool.submit(subprocess.run, ".ci/install.py", stdout=output, stderr=output)
    list(pool.map(run, lanes))  # raises what a lane has raised
print(f"\n{time.monotonic() - began:5.0f} s in all, the longest first:", *sorted(times, reverse=True), sep="\n")
print("", *(f"failed: {name}" for name in failed) if failed else ["all passed"], sep="\n")
sys.exit(bool(failed))
