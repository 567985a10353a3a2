"""Says where README, the guide and the documentation of types give figures of our own measurements.

`says(page, text, figures)` names a place: its text, with `{}` for each figure and `…` for words between. Line breaks
and comment markers do not matter. `holds(page, text, condition)` names a sentence that the page must
contain, and a condition on the figures that must hold."""
import math

M4, M0, RISCV = "thumbv7em-none-eabi", "thumbv6m-none-eabi", "riscv32imc-unknown-none-elf"
M33 = "thumbv8m.main-none-eabi"
SCENES = ["floor", "cube", "sphere", "sphere-flat"]
# The columns of the tables with both cores, each at opt-level 3 and "s".
COLUMNS = [(M4, "3"), (M4, "s"), (M0, "3"), (M0, "s")]

README = "README.md"
BENCHMARKS, MODES, FIRMWARE = (f"src/guide/{name}.md" for name in ["benchmarks", "modes", "firmware"])


def whole(value):
    return f"{math.floor(value + 0.5):,}"


def tenths(value):
    return f"{value:.1f}"


def million(value):
    """Millions, with three digits."""
    value /= 1e6
    return f"{value:.2f}" if value < 9.995 else f"{value:.1f}"


def short_million(value):
    """Millions, with two digits."""
    value /= 1e6
    return f"{value:.1f}" if value < 9.95 else f"{value:.0f}"


def kilo(value):
    return f"{value / 1000:.1f}"


def error(value):
    """Two digits, or five places."""
    if value >= 1:
        return f"{value:.0f}"
    return f"{value:.{min(5, 1 - math.floor(math.log10(value)))}f}"


def places(instructions, other):
    """Returns lists of places and of claims.

    instructions[target, optimization, mode, what, per] are the counts of tests/instructions.csv; other[what] are the
    figures of tests/figures.csv."""
    said, held = [], []

    def says(page, text, figures):
        said.append((page, text, list(figures)))

    def holds(page, text, condition):
        held.append((page, text, condition))

    def frame(target, mode, scene, layout="frame"):
        return instructions[target, "3", mode, scene, layout]

    def mean(target, optimization, mode, scene):
        return instructions[target, optimization, mode, scene, "mean-of-poses"]

    def means(target, optimization, mode):
        return [million(mean(target, optimization, mode, scene)) for scene in SCENES]

    units = {key[3]: key[4] for key in instructions if key[2] == "kernel" and "long" not in key[4]}

    def kernel(name, column, unit=None):
        return instructions[*column, "kernel", name, unit or units[name]] / 1000

    def row(page, label, show, *names):
        """A row for both cores and optimizations: the cost of a kernel, or its excess over a second one."""
        figures = []
        for column in COLUMNS:
            less = kernel(names[1], column) if len(names) == 2 else 0
            figures.append(show(kernel(names[0], column) - less))
        says(page, f"| {label} | {{}} | {{}} | {{}} | {{}} |", figures)

    def size(name, target=M4, optimization="s"):
        return other[f"{target} {optimization} {name} code"]

    def stack(name, optimization):
        return other[f"{M4} {optimization} {name} stack"]

    # README
    def a_second(core_mhz, count):
        """Frames, if each instruction takes 1.5 cycles."""
        return whole(core_mhz * 1e6 / (1.5 * count))

    board = "| {} + {} KB | {} |"
    list_kib = whole(math.ceil(other["sphere list"] / 1024))
    says(README, f"bands of 16 rows | 10 KiB + list {{}} KiB {board}", [
        list_kib, whole(size("flat", M0, "3") / 1000), whole(other["sphere-flat flash"] / 1000),
        a_second(133, frame(M0, "newton", "sphere-flat", "prepared"))])
    says(README, f"interpolated colors and depth | 20 KiB + list {{}} KiB {board}", [
        list_kib, whole(size("gouraud", M4, "3") / 1000), whole(other["sphere flash"] / 1000),
        a_second(168, frame(M4, "newton", "sphere", "prepared"))])
    says(README, f"whole frame | 300 KiB {board}", [
        whole(size("depth", M4, "3") / 1000), whole(other["default flash"] / 1000),
        a_second(150, frame(M33, "newton", "default"))])
    for scene in ["floor", "sphere"]:
        cost = million(mean(M4, "3", "newton", scene))
        for fpu in ["without", "with"]:
            says(README, f"| {scene} {fpu} an FPU | {{}} |", [cost])
    says(README, "| largest error on a floor, texels | {} |", [f"{other['floor newton error max']:.4f}"])
    small, large = sorted([size("depth", M4, "s"), size("compact", M4, "s")])
    says(README, "| code, textured with depth | {} to {} KB |", [whole(small / 1000), whole(large / 1000)])

    # Beside other libraries; instructions for a frame.
    newton_error, fast_error = error(other["floor newton error max"]), error(other["floor fast error max"])
    for name, column, mode, most in [
        ("default (`Newton`)", (M4, "3"), "newton", newton_error),
        ('default, `opt-level = "s"`', (M4, "s"), "newton", newton_error),
        ("`Fast` within ¼ texel", (M4, "3"), "fast", fast_error),
        ("`Fast` within ¼ texel, Cortex-M0+", (M0, "3"), "fast", fast_error),
        ("default, Cortex-M0+", (M0, "3"), "newton", newton_error),
    ]:
        says(BENCHMARKS, f"| **fixel, {name}** | {{}} | {{}} | {{}} | {{}} | {{}} | 0 |", [*means(*column, mode), most])
    for core, target in [("Cortex-M4 without an FPU", M4), ("Cortex-M0+", M0)]:
        for name, purpose, optimization, mode in [
            ("default (`Newton`)" if target == M4 else "default", "speed", "3", "newton"),
            ("default", 'size, "s"', "s", "newton"),
            ("`Fast` within ¼ texel", "speed", "3", "fast"),
            ("`Fast` within ¼ texel", 'size, "s"', "s", "fast"),
            ("`Compact`", 'size, "s"', "s", "compact"),
        ]:
            says(BENCHMARKS, f"| **{core}** | … | fixel, {name} | {purpose} | {{}} | {{}} | {{}} | {{}} |",
                 means(target, optimization, mode))
    says(BENCHMARKS, "| **x86-64** | … | fixel, default | speed | {} | {} | {} | {} |",
         [million(other[f"x86-64 {scene}"]) for scene in SCENES])

    # Frames, bands and prepared bands.
    layouts = ["frame", "bands", "prepared"]
    nine = " | ".join(["{}"] * 9)
    for scene, pixels in zip([*SCENES, "default"], ["47,610", "28,549", "30,584", "30,584", "54,735"]):
        says(BENCHMARKS, f"| {scene.replace('-', ', ')} | {pixels} | {nine} |",
             [million(frame(target, "newton", scene, layout)) for target in [M4, M0, RISCV] for layout in layouts])
    says(BENCHMARKS, f"| deepest stack, bytes | | {nine} |",
         [whole(other[f"{target} stack {layout}"]) for target in [M4, M0, RISCV] for layout in layouts])
    six = " | ".join(["{}"] * 6)
    for name, scene in [("floor: 2 triangles", "floor"), ("sphere: 1,984 triangles", "sphere"),
                        ("the lighthouse: 1,176 triangles", "default")]:
        says(MODES, f"| {name} | {six} |",
             [million(frame(target, "newton", scene, layout)) for target in [M4, M0] for layout in layouts])

    # Inner loops.
    row(BENCHMARKS, "a pixel of one color", tenths, "flat")
    row(BENCHMARKS, "colors by height (`Gradient`), `Newton`", whole, "gradient")
    for label, *names in [
        ("textured, affine", "affine"),
        ("textured, `Newton`", "newton"),
        ("textured, `Newton`, depth test passed", "newton-depth-pass"),
        ("textured, `Newton`, depth test failed", "newton-depth-fail"),
        ("a triangle of one pixel, three attributes", "setup-one-pixel"),
        ("whether a mesh's box is in view, with the set-up for it", "in-view"),
        ("a vertex under a `Light`", "light-sun"),
        ("under a `PointLight`", "light-point"),
        ("under a `SpotLight`", "light-spot"),
        ("under a shiny `Light`, with its highlight", "light-sun-shiny"),
        ("under a two-sided `Light`", "light-two-sided"),
        ("a textured pixel in linear fog, affine", "affine-fog", "affine"),
        ("in linear fog, `Newton`", "newton-fog", "newton"),
        ("in exponential fog, `Newton`", "newton-fog-exponential", "newton"),
        ("of a cut-out texture, affine", "affine-cut-out", "affine"),
        ("of a cut-out texture, `Newton`", "newton-cut-out", "newton"),
        ("a pixel of one color, `Opacity`", "flat-opacity", "flat"),
        ("a textured pixel, `Opacity`", "affine-opacity", "affine"),
        ("a textured pixel, `Add`", "affine-add", "affine"),
        ("a textured pixel, `Multiply`", "affine-multiply", "affine"),
        ("a pixel of `Argb4444` texels", "affine-argb4444", "affine"),
        ("a pixel with a mip level, nearest", "affine-mipmap", "affine"),
        ("a pixel with a mip level, bilinear (without: `Bilinear`)", "affine-mipmap-bilinear", "affine-bilinear"),
        ("a trilinear pixel (without: `Bilinear`)", "affine-trilinear", "affine-bilinear"),
        ("a sprite of 4x4 pixels", "sprite"),
        ("the same, about an axis", "sprite-on-axis"),
        ("two triangles of a mesh in its place", "two-triangles"),
        ("a line of a ball", "line"),
        ("the same, 3 pixels wide", "line-3-wide"),
        ("the same, anti-aliased, 1 pixel wide", "line-smooth"),
        ("an edge of an outline, drawn or not", "outline"),
        ("a point", "point"),
        ("a disc of 3 pixels", "disc-3-wide"),
        ("a triangle of a list, sorted back to front (added to its cost in the order of the mesh)", "sort"),
        ("a triangle tested against a ray", "ray"),
        ("a keyframe's vertex, with its normal", "keyframe"),
        ("a triangle of a mesh whose smooth normals are computed", "smooth-normals"),
        ("the same, with creases (352 triangles; the time grows with their square)", "creased-normals"),
        ("a triangle of a lit ball", "lit"),
        ("the same, with normals of 8 bits", "lit-quantized"),
        ("a textured pixel in black and white, a color in memory", "mono-native"),
        ("a pixel in black and white, packed into a page of an SSD1306", "mono-pages"),
        ("a gray, diffused to black or white", "mono-diffused"),
    ]:
        row(BENCHMARKS, label, whole, *names)
    says(BENCHMARKS, "| the same, prepared once (in these columns, for {}, {}, {}, {}) and drawn | {} | {} | {} | {} |",
         [whole(kernel(name, column)) for name in ["prepare-line", "prepared-line"] for column in COLUMNS])

    # Bytes.
    for label, name in [
        ("points and lines", "lines"),
        ("triangles of one color", "flat"),
        ("Gouraud", "gouraud"),
        ("textured", "textured"),
        ("textured, with depth", "depth"),
        ("the same in mode `Compact`", "compact"),
        ("all of these in one program", "everything"),
        ("all of these, in mode `Compact`", "everything-compact"),
        ("all shaders of the crate", "shades"),
    ]:
        goal = other.get(f"{name} goal")
        says(BENCHMARKS, f"| {label} | {{}} | {'{} ' if goal else ''}| {{}} | {{}} | {{}} |", [
            whole(size(name)), *([whole(goal)] if goal else []), whole(stack(name, "s")),
            whole(size(name, M4, "3")), whole(stack(name, "3"))])
    over = [name for name in ["lines", "flat", "depth", "compact", "everything", "everything-compact"]
            if size(name) > other[f"{name} goal"]]
    holds(BENCHMARKS, "Every goal is met.", not over)

    # Modes.
    for scene, head in [("floor", "floor: 2 triangles, 47,610 pixels"), ("cube", "cube: 12 triangles, 28,549 pixels"),
                        ("sphere", "sphere: 1,984 triangles, 30,584 pixels")]:
        for name, mode in [("`Exact`", "exact"), ("`Newton`", "newton"), ("`Fast`, ¼", "fast"), ("`Affine`", "affine")]:
            start = f"| {head} |" if mode == "exact" else f"| {head} | … |"
            says(MODES, f"{start} {name} | {{}} | {{}} | {{}} | {{}} |", [
                *(error(other[f"{scene} {mode} error {kind}"]) for kind in ["max", "mean"]),
                *(million(frame(target, mode, scene)) for target in [M4, M0])])
    says(MODES, "`Compact`** … program with textures and a depth buffer is {} KB smaller",
         [kilo(size("depth") - size("compact"))])
    compact, newton = ([[short_million(mean(target, "3", mode, scene)) for scene in SCENES[:3]] for target in [M4, M0]]
                       for mode in ["compact", "newton"])
    says(MODES, "On a Cortex-M4 the floor takes {} million instructions, the cube {} and the sphere {} (mean of eight "
         "poses; `Newton` takes {}, {} and {}); on a Cortex-M0+ they take {}, {} and {}.",
         [*compact[0], *newton[0], *compact[1]])
    for label, name in [
        ("`Affine`", "affine"),
        ("`Fast`, pieces of 16 pixels", "fast-16"),
        ("`Fast::NARROW`, pieces of 4", "narrow"),
        ("`Newton`", "newton"),
        ("`Newton` with depth, drawn", "newton-depth-pass"),
        ("`Newton` with depth, hidden", "newton-depth-fail"),
        ("`Exact`", "exact"),
        ("a triangle's set-up, three attributes", "setup-no-pixel"),
    ]:
        says(MODES, f"| | Cortex-M4 | Cortex-M0+ | … | {label} | {{}} | {{}} |",
             [whole(kernel(name, (target, "3"))) for target in [M4, M0]])
    says(MODES, "| a color | {} | {} |", [tenths(kernel("flat", (target, "3"))) for target in [M4, M0]])
    says(MODES, "| a span's start, divided by its 64 pixels, `Newton` | {} | {} |", [
        tenths(kernel("newton", (target, "3"), "1000 long-pixels") - kernel("newton", (target, "3")))
        for target in [M4, M0]])
    cube_mean = other["cube fast error mean"]
    says(MODES, "The mean error of `Fast` on the cube, {} texels, changes at most 1 pixel in {},",
         [error(cube_mean), str(math.floor(1 / (2 * cube_mean)))])
    sphere_error = error(other["sphere affine error max"])
    says(MODES, "On the sphere of 1,984 triangles, its error is {} texels, as large as the error of `Fast`", [sphere_error])
    holds(MODES, "as large as the error of `Fast` within a quarter", error(other["sphere fast error max"]) == sphere_error)
    more = frame(M4, "affine", "sphere") / frame(M4, "newton", "sphere") - 1
    says(MODES, "`Newton`; `Affine` takes {} % more", [whole(100 * more)])
    holds(MODES, "half of `Newton`'s time, unless rows are level",
          frame(M0, "fast", "cube") <= 0.5 * frame(M0, "newton", "cube"))
    holds(MODES, "on a Cortex-M4 it takes at most six tenths of `Exact`'s time",
          all(frame(M4, "newton", scene) <= 0.6 * frame(M4, "exact", scene) for scene in SCENES[:3]))

    # Firmware.
    for name, scene in [("floor, textured: 47,610 pixels", "floor"), ("cube, textured: 28,549 pixels", "cube"),
                        ("sphere, Gouraud: 1,984 triangles, 30,584 pixels", "sphere"),
                        ("the same with a color per triangle, no depth", "sphere-flat")]:
        says(FIRMWARE, f"| {name} | {{}} | {{}} | {{}} | {{}} |",
             [short_million(frame(M0, mode, scene)) for mode in ["exact", "newton", "fast", "affine"]])
    ways = ["240 bands", "40 bands", "40 prepared", "16 bands", "16 prepared"]
    for name, ring in [("a color per triangle, [`lit_faces`](crate::Shader::lit_faces)", "faces"),
                       ("textured and lit, [`lit`](crate::Shader::lit), in `Fast`", "fast"),
                       ("the same in the default mode", "newton")]:
        says(FIRMWARE, f"| {name} | {{}} | {{}} | {{}} | {{}} | {{}} |",
             [tenths(other[f"ring {ring} {way}"] / 1e6) for way in ways])
    prepared = other["ring faces 40 prepared"]
    says(FIRMWARE, "The ring of this page, prepared, takes {} million instructions in bands of 40 rows. At 125 MHz that "
         "makes {} to {} frames a second", [
             short_million(prepared), whole(125e6 / (2 * prepared)), whole(125e6 / prepared)])
    cube = [frame(M0, "fast", "cube", layout) for layout in layouts]
    holds(FIRMWARE, "take a quarter more in bands of 16 rows than in a whole frame, and a twelfth more when they are "
          "prepared",
          round(4 * (cube[1] / cube[0] - 1)) == 1 and round(12 * (cube[2] / cube[0] - 1)) == 1)
    says(FIRMWARE, "on an M4, a textured pixel with depth takes {} instructions",
         [whole(kernel("newton-depth-pass", (M4, "3")))])
    for name in ["pico", "stm32f4", "esp32c3"]:
        says(FIRMWARE, f"| `{name}` | {{}} | {{}} |", [whole(other[f"{name} {kind}"]) for kind in ["flash", "RAM"]])

    says(FIRMWARE, "reports about {} KB of flash at opt-level 3, including the mesh, the font, the HAL and the driver. It "
         "reports {} bytes of RAM", [whole(other["pico flash"] / 1000), whole(other["pico RAM"])])

    # Types.
    mode = "src/span/mode.rs"
    says(mode, "takes {} KB of code in place of {} KB in mode [`Newton`], and",
         [kilo(size("compact")), kilo(size("depth"))])
    times = [mean(M4, "s", "compact", scene) / mean(M4, "s", "newton", scene) for scene in SCENES[:3]]
    holds(mode, "and 2 to 2.5 times the instructions", 1.95 <= min(times) and max(times) < 2.55)
    times = [mean(M0, "s", "compact", scene) / mean(M0, "s", "fast", scene) for scene in SCENES[:3]]
    holds(mode, "it takes 3 to 5 times the instructions of [`Fast`]", 2.5 <= min(times) and max(times) < 5.5)
    says(mode, "a pixel that takes a Newton step costs {} instructions in place of {}, and a frame of the measured cube "
         "{} million in place of {}.", [
             *(whole(kernel(name, (M0, "3"))) for name in ["newton", "fast-16"]),
             *(short_million(mean(M0, "3", mode, "cube")) for mode in ["newton", "fast"])])
    says("src/pipeline/on_screen.rs", "On a Cortex-M4 the test takes {} instructions",
         [whole(round(kernel("in-view", (M4, "3")), -2))])
    unpacked = kernel("lit-quantized", (M4, "3")) - kernel("lit", (M4, "3"))
    says("src/mesh/mod.rs", "for normals, this takes {} instructions on Cortex-M4", [whole(round(unpacked, -1))])
    for label, scene in [
        ("sphere", "sphere"),
        ("two rings around a cube", "rings"),
        ("27 towers, after the floor", "towers"),
        ("island with a lighthouse", "island"),
        ("the same in a sea, which crosses the island", "lighthouse"),
    ]:
        wrong = other[f"painter {scene} wrong"]
        says("src/pipeline/list.rs", f"| {label} | {'{} %' if wrong else '0'} | {{}} KiB | {{}} | {{}} |", [
            *([f"{wrong:.2f}"] if wrong else []), tenths(other[f"painter {scene} list"] / 1024),
            *(million(other[f"painter {scene} {way}"]) for way in ["depth", "sorted"])])
    return said, held
