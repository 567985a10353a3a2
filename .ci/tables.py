"""What the expressions in .ci/tables.md mean, and the claims in words that pages make about the same figures."""
import math

M4, M0, RISCV = "thumbv7em-none-eabi", "thumbv6m-none-eabi", "riscv32imc-unknown-none-elf"
M33 = "thumbv8m.main-none-eabi"
SCENES = ["floor", "cube", "sphere", "sphere-flat"]
LAYOUTS = ["frame", "bands", "prepared"]
# Columns: both cores, at opt-level 3 and "s".
SPEED = [(M4, "3"), (M0, "3")]
BOTH = [(M4, "3"), (M4, "s"), (M0, "3"), (M0, "s")]


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


def kb(value):
    return whole(value / 1000)


def texels(value):
    """Two digits, or five places."""
    if value >= 1:
        return f"{value:.0f}"
    return f"{value:.{min(5, 1 - math.floor(math.log10(value)))}f}"


def ring_rate(count):
    """Frames a second at 125 MHz, with two cycles for each instruction and with one."""
    return f"{whole(125e6 / (2 * count))} to {whole(125e6 / count)}"


FIXEL, TGX, SMALL3DLIB = "#d9822b", "#4a90d9", "#8a8f98"
# Spheres by their triangles: millions of instructions for interpolated colors with depth, and for one color, on
# Cortex-M4; tgx with an FPU, small3dlib at -O3 without. Measured once, on the scenes and with the poses of `kernels`.
OTHERS = {
    "tgx": (TGX, [(480, 1.19, 0.53), (1984, 1.93, 1.09), (4512, 3.01, 1.95), (6160, 3.68, 2.49), (7812, 4.34, 3.02),
                  (8064, 4.43, 3.10)]),
    "small3dlib": (SMALL3DLIB, [(480, 2.79, 0.70), (1984, 4.02, 1.65), (7812, 7.75, 4.74)]),
}


def drawing(width, height, label, parts):
    """A drawing in the page's own color of text."""
    return (f'<div><svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" '
            f'style="max-width:100%" role="img" aria-label="{label}" font-size="12" fill="currentColor">'
            + "".join(parts) + "</svg></div>")


def text(x, y, words, anchor="middle"):
    return f'<text x="{x:g}" y="{y:g}" text-anchor="{anchor}">{words}</text>'


def chart(left, title, curves):
    """Millions of instructions over triangles, from 0 to 8 and from 0 to 9,000; curves have a color and points."""
    def place(point):
        return f"{left + 28 + point[0] / 9000 * 270:.1f} {220 - point[1] / 8 * 180:.1f}"

    yield text(left + 163, 20, title)
    for million in range(0, 9, 2):
        yield f'<path d="M{place((0, million))}H{left + 298}" stroke="currentColor" stroke-opacity=".2"/>'
        yield text(left + 22, 224 - million / 8 * 180, f"{million} M", "end")
    for triangles in range(0, 9000, 2000):
        yield text(left + 28 + triangles / 9000 * 270, 238, f"{triangles:,}")
    for color, points in curves:
        yield f'<path d="M{"L".join(map(place, points))}" fill="none" stroke="{color}" stroke-width="2"/>'
        yield "".join(f'<path d="M{place(point)}h0" stroke="{color}" stroke-width="6" stroke-linecap="round"/>'
                      for point in points)


def names(instructions, other):
    """The functions for expressions. instructions[target, optimization, mode, what, per] are the counts of
    tests/instructions.csv; other[what] are the figures of tests/figures.csv."""
    units = {key[3]: key[4] for key in instructions if key[2] == "kernel" and "long" not in key[4]}

    def cells(show, values):
        return " | ".join(map(show, values))

    def measured(show, *what):
        return cells(show, [other[name] for name in what])

    def mean(target, optimization, mode, *scenes):
        """Of eight poses."""
        key = target, optimization, mode
        return cells(million, [instructions[*key, scene, "mean-of-poses"] for scene in scenes or SCENES])

    def means(mode, scene, *targets):
        return cells(million, [instructions[target, "3", mode, scene, "mean-of-poses"] for target in targets])

    def bands(scene, *targets):
        counts = [instructions[target, "3", "newton", scene, layout] for target in targets for layout in LAYOUTS]
        return cells(million, counts)

    def each_mode(scene):
        modes = ["exact", "newton", "fast", "affine"]
        return cells(short_million, [instructions[M0, "3", mode, scene, "frame"] for mode in modes])

    def kernel(name, unit=None, less=None, on=BOTH, show=whole):
        """The cost of a kernel, or its excess over another one."""
        def cost(name, column, unit=None):
            return instructions[*column, "kernel", name, unit or units[name]] / 1000

        return cells(show, [cost(name, column, unit) - (cost(less, column) if less else 0) for column in on])

    def code(name, target=M4, optimization="s"):
        return other[f"{target} {optimization} {name} code"]

    def sizes(name):
        small, large = ([code(name, M4, opt), other[f"{M4} {opt} {name} stack"]] for opt in ["s", "3"])
        goal = f" {whole(other[f'{name} goal'])} |" if f"{name} goal" in other else " |"
        return f"{whole(small[0])} |{goal} {whole(small[1])} | {cells(whole, large)}"

    def errors(case, *kinds):
        return cells(texels, [other[f"{case} error {kind}"] for kind in kinds or ["max", "mean"]])

    def ring(name, show=lambda value: tenths(value / 1e6)):
        ways = ["240 bands", "40 bands", "40 prepared", "16 bands", "16 prepared"]
        return measured(show, *(f"ring {name} {way}" for way in ways))

    def painter(scene):
        wrong, size = other[f"painter {scene} wrong"], other[f"painter {scene} list"]
        costs = measured(million, f"painter {scene} depth", f"painter {scene} sorted")
        return f"{f'{wrong:.2f} %' if wrong else '0'} | {tenths(size / 1024)} KiB | {costs}"

    def spheres():
        """Instructions for spheres of different numbers of triangles."""
        def ours(name):
            return [(count, instructions[M4, "3", "newton", f"{name}-{count}", "mean-of-poses"] / 1e6)
                    for count, *_ in OTHERS["tgx"][1]]

        parts = []
        for way, (title, name) in enumerate([("interpolated colors, with depth", "sphere"), ("one color", "sphere-flat")]):
            theirs = [(color, [(point[0], point[1 + way]) for point in points]) for color, points in OTHERS.values()]
            parts += chart(340 * way, title, [(FIXEL, ours(name)), *theirs])
        colors = {"fixel": FIXEL, "tgx, with an FPU": TGX, "small3dlib": SMALL3DLIB}
        for at, (who, color) in enumerate(colors.items()):
            parts.append(f'<path d="M{170 + 130 * at} 258h16" stroke="{color}" stroke-width="3"/>')
            parts.append(text(192 + 130 * at, 262, who, "start"))
        return drawing(660, 270, "Millions of instructions for a frame over the triangles of a sphere, for fixel, tgx and "
                       "small3dlib", parts)

    def skins():
        """Instructions for a pixel of each kind of texture."""
        kinds = [("rows, <tspan font-family='monospace'>[[C; 64]; 64]</tspan>", "affine"), ("Texture", "affine-texture"),
                 ("Texture, clamped", "affine-texture-clamped"), ("Indexed, 256 colors", "affine-texture-indexed"),
                 ("Raw, bytes", "affine-texture-raw"), ("Argb1555, with holes", "affine-texture-argb1555"),
                 ("rows with a cut-out color", "affine-cut-out"), ("Mipmap", "affine-mipmap"),
                 ("rows, bilinear", "affine-bilinear"), ("Texture, bilinear", "affine-texture-bilinear"),
                 ("Mipmap, bilinear", "affine-mipmap-bilinear"), ("Mipmap, trilinear", "affine-trilinear")]
        parts = []
        for at, (name, what) in enumerate(kinds):
            y, count = 16 + 20 * at, instructions[M4, "3", "kernel", what, units[what]] / 1000
            parts.append(text(188, y + 4, name, "end"))
            parts.append(f'<path d="M196 {y}h{count * 1.6:.1f}" stroke="{FIXEL}" stroke-width="11"/>')
            parts.append(text(202 + count * 1.6, y + 4, tenths(count), "start"))
        return drawing(660, 20 * len(kinds) + 12, "Instructions for a pixel of each kind of texture", parts)

    def kib(what):
        return whole(math.ceil(other[what] / 1024))

    def a_second(core_mhz, target, scene, layout):
        """Frames, if each instruction takes 1.5 cycles."""
        return whole(core_mhz * 1e6 / (1.5 * instructions[target, "3", "newton", scene, layout]))

    def rate(what):
        """Frames a second of a Pico."""
        return f"{125e6 / other[what]:.0f}"

    def board(name, bands):
        ram = [bands, other[f"{name} RAM"] - bands, other[f"{name} stack"]]
        return f"{cells(rate, [f'{name} cycles', f'{name} instant'])} | {' + '.join(kb(size) for size in ram)}"

    def estimated_board(name, bands, mhz):
        ram = [bands, other[f"{name} RAM"] - bands, other[f"{name} stack"]]
        alone = mhz * 1e6 / 1.5 / other[f"{name} instructions"]
        return f"{1e6 / other[f'{name} us']:.0f} | {alone:.0f} | {' + '.join(kb(size) for size in ram)}"

    def cycles(name):
        counts = f"{other[f'{name} cycles'] / 1e6:.2f}"
        rates = cells(rate, [f"{name} {bus}" for bus in ["cycles", "gaps", "instant"]])
        return f"{counts} | {rates} | {whole(other[f'{name} stack'])}"

    return globals() | locals()


def claims(instructions, other):
    """Sentences that pages must contain, each with its page and a condition that must hold."""
    benchmarks, modes, firmware = (f"src/guide/{name}.md" for name in ["benchmarks", "modes", "firmware"])

    def frame(target, mode, scene, layout="frame"):
        return instructions[target, "3", mode, scene, layout]

    def kernel(name, target=M4):
        return next(count for key, count in instructions.items()
                    if key[:4] == (target, "3", "kernel", name) and "long" not in key[4])

    def ratios(optimization, target, mode, scenes=SCENES[:3]):
        """The cost of `Compact`, for size, or of `Newton`, compared with a mode."""
        other_mode = "compact" if optimization == "s" else "newton"
        means = [[instructions[target, optimization, which, scene, "mean-of-poses"] for scene in scenes]
                 for which in [other_mode, mode]]
        return [a / b for a, b in zip(*means)]

    def code(name):
        return other[f"{M4} s {name} code"]

    goals = [name.removesuffix(" goal") for name in other if name.endswith(" goal")]
    compact, compact_m0 = ratios("s", M4, "newton"), ratios("s", M0, "fast")
    cube = [frame(M0, "fast", "cube", layout) for layout in LAYOUTS]
    missed = {name for name in goals if code(name) > other[f"{name} goal"]}
    yield benchmarks, "Two goals are missed: those of points and lines and of triangles of one color.", (
        missed == {"lines", "flat"})
    yield (modes, "its error is as large as the error of `Fast` within a quarter",
           texels(other["sphere fast error max"]) == texels(other["sphere affine error max"]))
    yield (modes, "`Newton`; `Affine` takes as long",
           0.95 < frame(M4, "affine", "sphere") / frame(M4, "newton", "sphere") < 1.05)
    yield (modes, "half of `Newton`'s time, unless rows are level",
           frame(M0, "fast", "cube") <= 0.5 * frame(M0, "newton", "cube"))
    yield (modes, "on a Cortex-M4 it takes at most six tenths of `Exact`'s time",
           all(frame(M4, "newton", scene) <= 0.6 * frame(M4, "exact", scene) for scene in SCENES[:3]))
    yield (modes, "a program with textures and a depth buffer is a fifth smaller",
           0.75 <= code("compact") / code("depth") < 0.85)
    yield modes, "[takes at least twice the instructions]", min(ratios("s", M4, "newton") + compact_m0) >= 1.95
    yield modes, "The mean error of `Fast` on the cube, about a hundredth of a texel", (
        0.005 <= other["cube fast error mean"] < 0.015)
    yield (firmware, "take a quarter more in bands of 16 rows than in a whole frame, and a twelfth more when they are "
           "prepared", round(4 * (cube[1] / cube[0] - 1)) == 1 and round(12 * (cube[2] / cube[0] - 1)) == 1)
    yield (firmware, "takes a fifth of the instructions that it takes [here]",
           4.5 <= kernel("newton-depth-pass", M0) / kernel("newton-depth-pass") < 6.5)
    yield "src/span/mode.rs", "takes a fifth less code than in mode [`Newton`]", (
        0.75 <= code("compact") / code("depth") < 0.85)
    yield "src/span/mode.rs", "and 2 to 2.7 times the instructions", 1.95 <= min(compact) and max(compact) < 2.75
    yield ("src/span/mode.rs", "it takes 3 to 5 times the instructions of [`Fast`]",
           2.5 <= min(compact_m0) and max(compact_m0) < 5.5)
    yield ("src/span/mode.rs", "costs more than five times the instructions, and a frame of the measured cube about twice",
           kernel("newton", M0) > 5 * kernel("fast-16", M0) and 1.75 <= ratios("3", M0, "fast")[1] < 2.25)
    yield ("src/pipeline/on_screen.rs", "takes as many instructions as two or three triangles of one pixel",
           2 <= kernel("in-view") / kernel("setup-one-pixel") < 3.5)
    yield ("src/mesh/mod.rs", "For normals, this takes a few percent of the instructions on Cortex-M4",
           1.01 <= kernel("lit-quantized") / kernel("lit") < 1.05)
