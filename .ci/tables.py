"""Functions for the expressions in .ci/tables.md, and the claims in words that pages make about the same figures."""
import math
import re

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
    """Millions, with three significant digits."""
    value /= 1e6
    return f"{value:.{3 if value < 0.005 else 2 if value < 9.995 else 1}f}"


def short_million(value):
    """Millions, with two significant digits."""
    value /= 1e6
    return f"{value:.1f}" if value < 9.95 else f"{value:.0f}"


def kb(value):
    return whole(value / 1000)


def texels(value):
    """Texels, with two significant digits, but at most five decimals below 1."""
    if value >= 1:
        return f"{value:.0f}"
    return f"{value:.{min(5, 1 - math.floor(math.log10(value)))}f}"


def recipes(text):
    """Returns the figures in the output of the firmware `recipes`."""
    found = {}
    for name, instructions, ram in re.findall(r"^recipe (\S+) .*instructions=(\d+) RAM=(\d+)", text, re.M):
        found[f"recipe {name} instructions"], found[f"recipe {name} RAM"] = int(instructions), int(ram)
    return found


def ring_rate(count):
    """Frames a second at 125 MHz, with two cycles for each instruction and with one."""
    return f"{whole(125e6 / (2 * count))} to {whole(125e6 / count)}"


# Other libraries, measured once: instructions for a frame of the four scenes, the mean of their poses. The guide's page
# of benchmarks gives their versions and settings. "FPU" and "x86-64" name what is not a Cortex-M4 without an FPU.
OTHERS = {
    "small3dlib": [3_291_840, 2_159_175, 4_034_870, 1_657_715],
    "small3dlib -Os": [4_195_280, 2_707_570, 5_327_790, 1_863_695],
    "small3dlib x86-64": [3_804_000, 2_498_000, 4_328_000, 1_670_000],
    "TinyGL": [4_935_720, 3_691_155, 17_967_125, 15_583_475],
    "TinyGL FPU": [1_063_720, 707_555, 4_309_245, 2_942_740],
    "rlsw": [36_251_200, 25_799_535, 46_974_395, 16_893_490],
    "rlsw FPU": [5_622_720, 3_711_055, 4_422_500, 2_610_030],
    "tgx": [24_119_935, 16_537_855, 13_186_025, 7_301_340],
    "tgx FPU": [1_596_450, 1_053_180, 1_972_630, 1_089_025],
    "tgx x86-64": [1_649_000, 1_095_000, 1_908_000, 1_170_000],
    "retrofire": [63_048_295, 42_140_400, 66_524_280, 58_108_195],
    "retrofire FPU": [4_592_260, 3_033_730, 7_206_220, 3_757_115],
    "embedded-3dgfx": [31_489_600, 16_893_150, 32_660_545, 16_428_935],
    "embedded-3dgfx FPU": [3_655_560, 1_865_610, 7_604_705, 4_895_550],
}
# The same for spheres, by their triangles: with interpolated colors and depth, and in one color.
SPHERES = {
    "tgx FPU": [(480, 1_247_420, 515_600), (1984, 1_972_620, 1_027_040), (4512, 3_017_025, 1_800_690),
                (6160, 3_657_970, 2_283_695), (7812, 4_283_715, 2_759_040), (8064, 4_375_190, 2_829_105)],
    "small3dlib": [(480, 2_813_785, 716_925), (1984, 4_034_870, 1_674_965), (4512, 5_710_115, 3_064_910),
                   (6160, 6_737_160, 3_928_475), (7812, 7_741_515, 4_779_535), (8064, 7_893_915, 4_909_535)],
}
# tgx 1.1.4 with an FPU, measured once: instructions for a frame of the meshes that `kernels` draws.
MESHES = {
    "wreath-far": 1_860_680, "wreath-mid": 2_573_200, "wreath-near": 3_302_840, "wreath-cut": 3_335_960,
    "wreath-away": 800, "wreath-lit-far": 2_236_800, "wreath-lit-mid": 3_142_840, "wreath-lit-near": 4_196_440,
    "wreath-lit-cut": 4_317_760, "wreath-lit-away": 760, "cubes-flat": 3_683_360, "cubes-textured": 4_921_880,
    "cubes-lit": 4_973_880, **{f"sphere-lit-{point[0]}": point[1] for point in SPHERES["tgx FPU"]},
}
FIXEL = "#d9822b"
COLORS = {"fixel, lit": "#a33b2b", "tgx FPU": "#4a90d9", "small3dlib": "#8a8f98"}


def drawing(width, height, label, parts):
    """A drawing in the page's own color of text."""
    return (f'<div><svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" '
            f'style="max-width:100%" role="img" aria-label="{label}" font-size="12" fill="currentColor">'
            + "".join(parts) + "</svg></div>")


def text(x, y, words, anchor="middle"):
    return f'<text x="{x:g}" y="{y:g}" text-anchor="{anchor}">{words}</text>'


def chart(top, title, curves):
    """Millions of instructions over triangles, from 0 to 8 and from 0 to 9,000; curves have a color and points."""
    def place(point):
        return f"{36 + point[0] / 9000 * 390:.1f} {top + 220 - point[1] / 8 * 180:.1f}"

    yield text(231, top + 20, title)
    for million in range(0, 9, 2):
        yield f'<path d="M{place((0, million))}H426" stroke="currentColor" stroke-opacity=".2"/>'
        yield text(30, top + 224 - million / 8 * 180, f"{million} M", "end")
    for triangles in range(0, 9000, 2000):
        yield text(36 + triangles / 9000 * 390, top + 238, f"{triangles:,}")
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
        """The mean over a scene's eight poses."""
        key = target, optimization, mode
        return cells(million, [instructions[(*key, scene, "mean-of-poses")] for scene in scenes or SCENES])

    def others(who, *scenes):
        return cells(million, [OTHERS[who][SCENES.index(scene)] for scene in scenes or SCENES])

    def means(mode, scene, *targets):
        return cells(million, [instructions[target, "3", mode, scene, "mean-of-poses"] for target in targets])

    def bands(scene, *targets):
        counts = [instructions[target, "3", "newton", scene, layout] for target in targets for layout in LAYOUTS]
        return cells(million, counts)

    def each_mode(scene):
        modes = ["exact", "newton", "fast", "affine"]
        return cells(short_million, [instructions[M0, "3", mode, scene, "frame"] for mode in modes])

    def kernel(name, unit=None, less=None, on=BOTH, show=whole, by=1):
        """The cost of a kernel, or how far it exceeds the cost of the kernel `less`; divided by `by`."""
        def cost(name, column, unit=None):
            return instructions[(*column, "kernel", name, unit or units[name])] / 1000

        costs = [cost(name, column, unit) - (cost(less, column) if less else 0) for column in on]
        return cells(show, [cost / by for cost in costs])

    def lit_triangle():
        """What light adds to the textured sphere, for each of its 1,984 triangles."""
        frames = [[mesh_cost(name, column) for column in BOTH] for name in ["sphere-textured-lit", "sphere-textured"]]
        return cells(whole, [(lit - unlit) / 1984 for lit, unlit in zip(*frames)])

    def mesh_cost(name, column):
        """The cost of a frame of a mesh: the mean over its poses, or of one frame. The cubes are 300 calls."""
        if name.startswith("sphere"):
            return instructions[(*column, "newton", name, "mean-of-poses")]
        return instructions[(*column, "kernel", name, units[name])] / 1000 * (300 if "call" in units[name] else 1)

    def of_mesh(name):
        return million(mesh_cost(name, (M4, "3")))

    def of_tgx(name):
        return million(MESHES[name])

    def mesh(name):
        ours = cells(million, [mesh_cost(name, column) for column in BOTH])
        return f"{ours} | {million(MESHES[name]) if name in MESHES else '–'}"

    def meshes():
        """Millions of instructions for a frame of meshes, for fixel and for tgx."""
        kinds = [("textured model, 350 pixels", "wreath-far"), ("2,500 pixels", "wreath-mid"),
                 ("9,500 pixels", "wreath-near"), ("cut by the edge", "wreath-cut"),
                 ("lit and textured, 350 pixels", "wreath-lit-far"), ("2,500 pixels", "wreath-lit-mid"),
                 ("9,500 pixels", "wreath-lit-near"), ("cut by the edge", "wreath-lit-cut"),
                 ("300 cubes: one color", "cubes-flat"), ("textured", "cubes-textured"), ("lit", "cubes-lit"),
                 ("lit sphere: 480 triangles", "sphere-lit-480"), ("1,984", "sphere-lit-1984"),
                 ("7,812", "sphere-lit-7812")]
        parts = []
        for at, (name, what) in enumerate(kinds):
            parts.append(text(188, 24 + 34 * at, name, "end"))
            for y, color, count in [(13, FIXEL, mesh_cost(what, (M4, "3"))), (27, COLORS["tgx FPU"], MESHES[what])]:
                parts.append(f'<path d="M196 {y + 34 * at}h{count / 1e6 * 32:.1f}" stroke="{color}" stroke-width="11"/>')
                parts.append(text(202 + count / 1e6 * 32, y + 4 + 34 * at, million(count), "start"))
        bottom = 34 * len(kinds) + 22
        for x, color, who in [(196, FIXEL, "fixel"), (300, COLORS["tgx FPU"], "tgx, with an FPU")]:
            parts.append(f'<path d="M{x} {bottom - 4}h16" stroke="{color}" stroke-width="9"/>')
            parts.append(text(x + 22, bottom, who, "start"))
        return drawing(440, bottom + 8, "Millions of instructions for a frame of meshes, for fixel and tgx", parts)

    def code(name, target=M4, optimization="s"):
        return other[f"{target} {optimization} {name} code"]

    def sizes(name):
        small, large = ([code(name, M4, opt), other[f"{M4} {opt} {name} stack"]] for opt in ["s", "3"])
        goal = f" {whole(other[f'{name} goal'])} |" if f"{name} goal" in other else " |"
        return f"{whole(small[0])} |{goal} {whole(small[1])} | {cells(whole, large)}"

    def sphere(who, triangles):
        return next(million(cost) for count, cost, _ in SPHERES[who] if count == triangles)

    def errors(case, *kinds):
        return cells(texels, [other[f"{case} error {kind}"] for kind in kinds or ["max", "mean"]])

    def ring(name, show=lambda value: tenths(value / 1e6)):
        ways = ["240 bands", "40 bands", "40 prepared", "16 bands", "16 prepared"]
        return measured(show, *(f"ring {name} {way}" for way in ways))

    def needle(name, sent):
        """Instructions, bytes on the bus, and milliseconds for both: two cycles for an instruction at 125 MHz, and a bus
        of 62.5 MHz."""
        count = other[f"needle {name}"]
        return f"{whole(count)} | {whole(sent)} | {tenths(1000 * (2 * count / 125e6 + 8 * sent / 62.5e6))}"

    def painter(scene):
        wrong, size = other[f"painter {scene} wrong"], other[f"painter {scene} list"]
        costs = measured(million, f"painter {scene} depth", f"painter {scene} sorted")
        return f"{f'{wrong:.2f} %' if wrong else '0'} | {tenths(size / 1024)} KiB | {costs}"

    def spheres():
        """Instructions for spheres of different numbers of triangles."""
        def ours(name):
            return [(count, instructions[M4, "3", "newton", f"{name}-{count}", "mean-of-poses"] / 1e6)
                    for count, *_ in SPHERES["tgx FPU"]]

        parts = []
        for way, (title, name) in enumerate([("interpolated colors, with depth", "sphere"), ("one color", "sphere-flat")]):
            theirs = [(COLORS[who], [(point[0], point[1 + way] / 1e6) for point in points])
                      for who, points in SPHERES.items()]
            lit = [(count, mesh_cost(f"sphere-lit-{count}", (M4, "3")) / 1e6) for count in [480, 1984, 7812]]
            lit = [] if way else [(COLORS["fixel, lit"], lit)]
            parts += chart(256 * way, title, [(FIXEL, ours(name)), *lit, *theirs])
        colors = {"fixel": FIXEL, "fixel, lit": COLORS["fixel, lit"], "tgx, with an FPU": COLORS["tgx FPU"],
                  "small3dlib": COLORS["small3dlib"]}
        for at, (who, color) in enumerate(colors.items()):
            x, y = 60 + 190 * (at % 2), 518 + 20 * (at // 2)
            parts.append(f'<path d="M{x} {y - 4}h16" stroke="{color}" stroke-width="3"/>')
            parts.append(text(x + 22, y, who, "start"))
        return drawing(440, 546, "Millions of instructions for a frame over the triangles of a sphere, for fixel, tgx and "
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
            parts.append(f'<path d="M196 {y}h{count * 0.75:.1f}" stroke="{FIXEL}" stroke-width="11"/>')
            parts.append(text(202 + count * 0.75, y + 4, tenths(count), "start"))
        return drawing(440, 20 * len(kinds) + 12, "Instructions for a pixel of each kind of texture", parts)

    def trade():
        """The error of each mode over its cost, for the floor and the cube; both axes are logarithmic."""
        def place(cost, error):
            return f"{68 + math.log10(cost / 0.4) * 284:.1f} {288 - math.log10(error / 1e-5) * 31:.1f}"

        yield text(4, 16, "largest error of a pixel, in texels", "start")
        for power in range(-5, 4):
            x, y = place(0.4, 10**power).split()
            yield f'<path d="M{x} {y}H436" stroke="currentColor" stroke-opacity=".2"/>'
            yield text(62, float(y) + 4, f"{10**power:.{max(-power, 0)}f}", "end")
        for cost in [0.5, 0.7, 1, 1.5, 2, 3, 5, 7]:
            yield text(float(place(cost, 1).split()[0]), 306, f"{cost:g}")
        yield text(436, 326, "millions of Cortex-M4 instructions a frame", "end")
        yield '<path d="M106 271l-32 13m13 1l-13-1l8-10" fill="none" stroke="currentColor" stroke-width="1.5"/>'
        yield text(110, 277, "better", "start")
        # A label is to the left or the right of its point, or below.
        left, right, below = (-9, 4, "end"), (9, -3, "start"), (0, 19, "middle")
        scenes = [("floor", FIXEL, "round", "floor of 2 triangles", 60,
                   {"affine": right, "fast": right, "newton": right, "exact": (0, -10, "middle")}),
                  ("cube", COLORS["tgx FPU"], "square", "cube of 12 triangles", 91,
                   {"affine": left, "fast": left, "newton": left, "exact": below})]
        words = {"floor newton": "Newton, the default", "floor fast": "Fast, within ¼ texel"}
        for scene, color, cap, name, y, labels in scenes:
            points = {mode: place(instructions[M4, "3", mode, scene, "mean-of-poses"] / 1e6,
                                  other[f"{scene} {mode} error max"]) for mode in labels}
            mark = f'stroke="{color}" stroke-width="11" stroke-linecap="{cap}"'
            yield f'<path d="M{"L".join(points.values())}" fill="none" stroke="{color}" stroke-opacity=".6"/>'
            for mode, (across, down, anchor) in labels.items():
                x, at = map(float, points[mode].split())
                yield f'<path d="M{points[mode]}h0" {mark}/>'
                yield text(x + across, at + down, words.get(f"{scene} {mode}", mode.capitalize()), anchor)
            yield f'<path d="M292 {y - 4}h0" {mark}/>' + text(304, y, name, "start")

    def rate(what):
        """Frames a second of a Pico."""
        return f"{125e6 / other[what]:.0f}"

    def ram(name):
        """Bands, other statics and stack, in KB."""
        return kb(other[f"{name} RAM"] + other[f"{name} stack"])

    def board(name):
        return f"{cells(rate, [f'{name} gaps', f'{name} instant'])} | {ram(name)}"

    def estimated_board(name, mhz):
        alone = mhz * 1e6 / 1.5 / other[f"{name} instructions"]
        return f"{1e6 / other[f'{name} us']:.0f} | {alone:.0f} | {ram(name)}"

    def alone(name):
        """Frames of a mesh that an STM32F4 at 168 MHz draws in a second, at 1.5 cycles for each instruction."""
        return whole(168e6 / 1.5 / mesh_cost(name, (M4, "3")))

    def frames(name):
        """Frames a second that an STM32F4 at 168 MHz draws of a recipe, at 1.5 cycles for each instruction."""
        rate = 168e6 / 1.5 / other[f"recipe {name} instructions"]
        return f"{rate:.1f}" if rate < 9.5 else whole(rate)

    def costs():
        """Arms of a macro: what each recipe costs."""
        names = [what.split()[1] for what in other if what.startswith("recipe ") and what.endswith(" RAM")]
        for name in sorted(names):
            count, ram = (other[f"recipe {name} {what}"] for what in ["instructions", "RAM"])
            yield (f'("{name}") => {{ "{short_million(count)} M instructions, about {frames(name)} frames a second on an '
                   f'STM32F4 at 168 MHz, {kb(ram)} KB of RAM." }};')

    def grid():
        """Animations of recipes in two columns, which fit on a phone: page and anchor, name, caption."""
        cells = [("scenes/index.html#terrain", "terrain", "Terrain in fog"),
                 ("surfaces/index.html#modes", "corridor", "Two modes"),
                 ("light/index.html#cartoon", "toon", "Cartoon"),
                 ("scenes/index.html#a-drones-display", "drone", "A drone's display"),
                 ("lines/index.html#black-and-white", "packed", "128x64, black and white"),
                 ("scenes/index.html#picking", "picking", "Picking"),
                 ("models/index.html#files", "files", "A model from a GLB file"),
                 ("scenes/index.html#instruments", "instruments", "Instruments")]
        yield "<table>"
        for at, (page, name, caption) in enumerate(cells):
            if at % 2 == 0:
                yield "<tr>"
            link = f"https://fixel-rs.github.io/fixel/doc/fixel/guide/cookbook/{page}"
            yield (f'<td align="center"><a href="{link}"><img src="examples/assets/{name}.webp" width="320" '
                   f'alt="{caption}"></a><br>{caption}<br><sub>STM32F4: {frames(name)} frames a second, '
                   f'{kb(other[f"recipe {name} RAM"])} KB</sub></td>')
            if at % 2 == 1:
                yield "</tr>"
        yield "</table>"

    def cycles(name):
        counts = f"{other[f'{name} cycles'] / 1e6:.2f}"
        rates = cells(rate, [f"{name} {bus}" for bus in ["cycles", "gaps", "instant"]])
        return f"{counts} | {rates} | {whole(other[f'{name} stack'])}"

    newline = "\n"
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
    yield benchmarks, "Two goals are missed: the goal for points and lines, and the goal for triangles of one color.", (
        missed == {"lines", "flat"})
    m4 = {name: [instructions[M4, optimization, "newton", scene, "mean-of-poses"] for scene in SCENES]
          for name, optimization in [("speed", "3"), ("size", "s")]}
    spheres = [[(instructions[M4, "3", "newton", f"{name}-{point[0]}", "mean-of-poses"], point[1 + way], point[0])
                for point in SPHERES["tgx FPU"]] for way, name in enumerate(["sphere", "sphere-flat"])]
    without_fpu = [costs for who, costs in OTHERS.items() if "FPU" not in who and "x86" not in who]
    yield (benchmarks, "Without an FPU, fixel's default mode is faster than all other libraries on every scene, even when "
           "it is optimized for size.",
           all(ours < theirs for costs in without_fpu for ours, theirs in zip(m4["size"], costs)))
    faster = {who: [theirs < ours for ours, theirs in zip(m4["speed"], costs)]
              for who, costs in OTHERS.items() if "FPU" in who}
    yield (benchmarks, "TinyGL is faster on the floor and the cube, but it bends their textures.",
           faster.pop("TinyGL FPU") == [True, True, False, False] and not any(map(any, faster.values())))
    loses_to_tgx = all((theirs < ours) == (count != 1984) for ours, theirs, count in spheres[0])
    yield (benchmarks, "With interpolated colors, tgx is faster on every measured sphere, except on the sphere of 1,984 "
           "triangles.",
           loses_to_tgx and all(ours < theirs for ours, theirs, _ in spheres[1]))
    slower = {name for name in MESHES if not name.startswith("sphere")
              and kernel(name) * (300 if "cubes" in name else 1) < 1000 * MESHES[name]}
    yield benchmarks, "With its FPU, tgx is faster on all of these meshes, except on the model on 350 pixels.", (
        slower == {"wreath-far", "wreath-lit-far"})
    models = [name for name in MESHES if name.startswith("wreath") and name[-3:] in ["mid", "ear", "cut"]]
    yield ("README.md", "With an FPU, tgx is faster on lit meshes, on dense models and on small objects, and TinyGL is faster "
           "on the floor, but bends its texture.",
           all(1e3 * MESHES[name] < kernel(name) for name in models) and slower == {"wreath-far", "wreath-lit-far"}
           and OTHERS["TinyGL FPU"][0] < m4["speed"][0])
    yield "README.md", "A scene with textures and depth adds 13 KB of code", 12_500 <= code("depth") < 13_500
    yield (modes, "its error is as large as the error of `Fast` within a quarter",
           texels(other["sphere fast error max"]) == texels(other["sphere affine error max"]))
    yield (modes, "`Newton`; `Affine` takes as long",
           0.95 < frame(M4, "affine", "sphere") / frame(M4, "newton", "sphere") < 1.05)
    yield (modes, "half of `Newton`'s time, except on a level floor",
           frame(M0, "fast", "cube") <= 0.5 * frame(M0, "newton", "cube"))
    yield (modes, "on a Cortex-M4 it takes at most six tenths of `Exact`'s time",
           all(frame(M4, "newton", scene) <= 0.6 * frame(M4, "exact", scene) for scene in SCENES[:3]))
    yield (modes, "a program with textures and a depth buffer is a fifth smaller",
           0.75 <= code("compact") / code("depth") < 0.85)
    yield modes, "[takes at least twice the instructions]", min(ratios("s", M4, "newton") + compact_m0) >= 1.95
    yield modes, "The mean error of `Fast` on the cube, about a hundredth of a texel", (
        0.005 <= other["cube fast error mean"] < 0.015)
    yield (firmware, "take a quarter more instructions in bands of 16 rows than in a whole frame, but only a twelfth more "
           "if they are prepared", round(4 * (cube[1] / cube[0] - 1)) == 1 and round(12 * (cube[2] / cube[0] - 1)) == 1)
    rates = [whole(rate) for scene in ["model lighthouse", "world world"]
             for rate in [125e6 / other[f"pico_{scene} cycles"], 1e6 / other[f"pico2_{scene} us"]]]
    flash = "examples/boards/flash.md"
    yield flash, f"an emulated Pico shows {rates[0]} frames a second, and an emulated Pico 2 shows {rates[1]}.", True
    yield flash, f"walk through a garden at dusk, with {rates[2]} and {rates[3]} frames a second.", True
    yield ("src/guide/displays.rs",
           "At ten steps a second, the processor sleeps for more than nine tenths of the time.",
           10 * (2 * other["needle step"] / 125e6 + 8 * 7411 / 62.5e6) < 0.1)
    yield (firmware, "takes [a sixth of an M0+'s instructions]",
           5.5 <= kernel("newton-depth-pass", M0) / kernel("newton-depth-pass") < 6.5)
    yield "src/span/mode.rs", "takes a fifth less code than in mode [`Newton`]", (
        0.75 <= code("compact") / code("depth") < 0.85)
    yield "src/span/mode.rs", "and 2 to 2.7 times the instructions", 1.95 <= min(compact) and max(compact) < 2.75
    yield ("src/span/mode.rs", "it takes 3 to 5 times the instructions of [`Fast`]",
           2.5 <= min(compact_m0) and max(compact_m0) < 5.5)
    yield ("src/span/mode.rs", "takes more than five times the instructions of `Fast` for a pixel with a Newton step, and "
           "about twice as many for a frame of the measured cube",
           kernel("newton", M0) > 5 * kernel("fast-16", M0) and 1.75 <= ratios("3", M0, "fast")[1] < 2.25)
    yield ("src/pipeline/on_screen.rs", "takes as many instructions as one or two triangles of one pixel",
           1 <= kernel("in-view") / kernel("setup-one-pixel") < 2.5)
    yield ("src/mesh/mod.rs", "For normals, this takes a few percent of the instructions on Cortex-M4",
           1.01 <= kernel("lit-quantized") / kernel("lit") < 1.05)
