"""The generator of series on a motion that is none of the model's: an oscillator, against its closed form."""

import importlib
import math
import shutil
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace as Record

import pytest

CORE = Path(__file__).parents[2] / "c_core"
ORDER = 24
END = 0.25
COMPILER = shutil.which("cc")

pytestmark = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler")


@pytest.fixture(scope="module")
def derive():
    sys.path.insert(0, str(CORE))
    try:
        return Record(
            motion=importlib.import_module("equations.derive.motion"),
            laws=importlib.import_module("equations.derive.motions"),
            table=importlib.import_module("equations.motions"),
            functions=importlib.import_module("equations.functions"),
        )
    finally:
        sys.path.remove(str(CORE))


def page(functions):
    """xddot = pull - stiffness x - 2 damping xdot, and one quantity of each kind made of it."""

    def start(at):
        """Position and velocity."""
        return Record(x=at.x, v=at.v)

    def end(s):
        """Position and velocity at a time, and the energy of a unit spring."""
        return Record(x=s.x, v=s.v, energy=(s.x * s.x + s.v * s.v) / 2)

    def motion(c, s):
        """The oscillator."""
        distance = functions.sqrt(1 + s.x * s.x)
        exponent = s.x - s.v
        acceleration = c.pull - c.stiffness * s.x - 2 * (c.damping * s.v)
        return Record(
            rates=Record(x=s.v, v=acceleration),
            distance=distance,
            distance_rate=s.x * s.v / distance,
            ratio=(c.pull + s.v) / distance,
            wave=functions.sin(s.x) * functions.cos(s.x),
            growth=functions.exp(exponent),
            pulled=c.pull * s.x,
            power=acceleration * s.v,
        )

    return Record(start=start, end=end, motion=motion)


def constants_of(model):
    """What the motion depends on."""
    return Record(stiffness=model.stiffness, damping=model.damping, pull=model.pull)


QUANTITIES = ["x", "v", "distance", "distance_rate", "ratio", "wave", "growth", "pulled", "power"]
CONSTANTS = {"stiffness": 1.7, "damping": 0.15, "pull": 0.3, "pull_rate": 0.2}
STARTS = {"x": 0.4, "v": -0.6}


def closed_form(t, stiffness, damping, pull, pull_rate, x, v):
    """All quantities at a time; the ramp has a particular solution that is a straight line."""
    slope = pull_rate / stiffness
    level = (pull - 2 * damping * slope) / stiffness
    frequency = math.sqrt(stiffness - damping * damping)
    a, decay = x - level, math.exp(-damping * t)
    b = (v - slope + damping * a) / frequency
    sine, cosine = math.sin(frequency * t), math.cos(frequency * t)
    swing = decay * (a * cosine + b * sine)
    at = level + slope * t + swing
    rate = slope - damping * swing + decay * frequency * (b * cosine - a * sine)
    force = pull + pull_rate * t
    distance = math.sqrt(1 + at * at)
    acceleration = force - stiffness * at - 2 * damping * rate
    return [
        at,
        rate,
        distance,
        at * rate / distance,
        (force + rate) / distance,
        math.sin(at) * math.cos(at),
        math.exp(at - rate),
        force * at,
        acceleration * rate,
    ]


def change_of_closed_form(t, name):
    """By differences, whose error falls with the fourth power of the step."""
    given = {**CONSTANTS, **STARTS}
    step = 1e-3

    def at(share):
        return closed_form(t, **{**given, name: given[name] + share * step})

    sides = zip(at(1), at(-1), at(2), at(-2), strict=True)
    return [(8 * (a - b) - (c - d)) / (12 * step) for a, b, c, d in sides]


def program(derive, lanes):
    """Expand the motion and each of its variations, and print all coefficients of the first lane."""
    family = derive.table.Family(
        name="oscillator",
        page=page(derive.functions),
        start="x v energy",
        constants=constants_of,
        ramps={"pull": "drift"},
        rates={"distance_rate": "distance"},
        stored=" ".join(QUANTITIES[2:]),
        varied=" ".join(QUANTITIES[2:]),
        cases={"swinging": {}},
    )
    motion = derive.motion.Motion(family, "swinging")
    code = [derive.motion.structs(family), derive.motion.end(family), motion.source(), motion.variation()]
    lane = "[0]" if lanes else ""
    show = [
        f'for (int k = 0; k <= {ORDER}; ++k) printf("%.17g ", (double)%s.{q}[k]{lane});' for q in QUANTITIES
    ]
    ends = f'printf("%.17g %.17g %.17g ", e.x{lane}, e.v{lane}, e.energy{lane});'
    at = f"&s, &elapsed, {ORDER}"
    series = [line.replace("%s.", "s.") for line in show]
    series += [f"e = tdmf_end_oscillator({at});", ends]
    tangent = [line.replace("%s.", "t.") for line in show]
    tangent += [f"e = tdmf_vary_end_oscillator({at}, &t);", ends]
    constants = [f"c.{name} = broadcast({value});" for name, value in CONSTANTS.items()]
    starts = [f"start.{name} = broadcast({value});" for name, value in STARTS.items()]
    runs = []
    for name in [*CONSTANTS, *STARTS]:
        which = "d" if name in CONSTANTS else "d_start"
        runs += [f"d = no_c; d_start = no_start; {which}.{name} = broadcast(1.0);"]
        runs += [
            "tdmf_vary_begin_oscillator(&start, &d_start, &t);",
            f"vary_swinging(&c, &s, &d, {ORDER}, &t);",
        ]
        runs += tangent
    return "\n".join(
        [
            f"#define TDMF_LANES {lanes}" if lanes else "",
            '#include "step_sums.h"',
            '#include "series_products.h"',
            "#include <stdio.h>",
            *code,
            "int main(void) {",
            "static oscillator_coefficients c, d, no_c; static oscillator_start start, d_start, no_start;",
            "static oscillator_series s; static oscillator_variation t; oscillator_start e;",
            f"elapsed_time elapsed; real power[SERIES_TERMS]; set_powers(power, broadcast({END}), {ORDER});",
            f"set_elapsed(&elapsed, power, broadcast({END}), broadcast({END}), {ORDER});",
            *constants,
            *starts,
            "tdmf_begin_oscillator(&start, &s);",
            f"expand_swinging(&c, {ORDER}, &s);",
            *series,
            *runs,
            "return 0; }",
        ]
    )


@pytest.fixture(scope="module", params=[0, 2], ids=["one", "two lanes"])
def coefficients(request, derive, tmp_path_factory):
    """Blocks of coefficients: the motion's, then those of its variation by each constant and start."""
    folder = tmp_path_factory.mktemp("oscillator")
    (folder / "oscillator.c").write_text(program(derive, request.param))
    flags = ["-std=c99", "-O1", "-Wall", "-Wextra", "-Werror", f"-I{CORE / 'kernel'}"]
    command = [COMPILER, *flags, "oscillator.c", "-o", "oscillator", "-lm"]
    subprocess.run(command, cwd=folder, check=True)
    numbers = subprocess.run(
        [folder / "oscillator"], check=True, capture_output=True, text=True
    ).stdout.split()
    size = len(QUANTITIES) * (ORDER + 1) + 3
    assert len(numbers) == size * (1 + len(CONSTANTS) + len(STARTS))
    return [[float(number) for number in numbers[i : i + size]] for i in range(0, len(numbers), size)]


def values_at(block, t):
    """The series at a time; the last coefficient of what is not a state is not there."""
    series = [block[i * (ORDER + 1) :][: ORDER + 1] for i in range(len(QUANTITIES))]
    return [sum(c * t**k for k, c in enumerate(row[:ORDER])) for row in series]


TIMES = [0.0, 0.1, END]


def test_series_are_those_of_the_closed_form(coefficients):
    for t in TIMES:
        assert values_at(coefficients[0], t) == pytest.approx(
            closed_form(t, **CONSTANTS, **STARTS), rel=1e-12, abs=1e-13
        )


def test_variations_are_those_of_the_closed_form(coefficients):
    for name, block in zip([*CONSTANTS, *STARTS], coefficients[1:], strict=True):
        for t in TIMES:
            assert values_at(block, t) == pytest.approx(change_of_closed_form(t, name), rel=1e-9, abs=1e-9), (
                name
            )


def test_a_motion_leads_where_the_closed_form_does(coefficients):
    x, v, *_ = closed_form(END, **CONSTANTS, **STARTS)
    assert coefficients[0][-3:] == pytest.approx([x, v, (x * x + v * v) / 2], rel=1e-12)


def test_ends_vary_as_those_of_the_closed_form(coefficients):
    x, v, *_ = closed_form(END, **CONSTANTS, **STARTS)
    for name, block in zip([*CONSTANTS, *STARTS], coefficients[1:], strict=True):
        d_x, d_v, *_ = change_of_closed_form(END, name)
        assert block[-3:] == pytest.approx([d_x, d_v, x * d_x + v * d_v], rel=1e-9, abs=1e-9), name


def made_of(derive, quantities, stored, rates=()):
    """An oscillator of which a page makes `quantities`."""
    family = derive.table.Family(
        name="oscillator",
        page=Record(
            start=page(derive.functions).start,
            motion=lambda c, s: Record(rates=Record(x=s.v, v=-s.x), **quantities(s)),
        ),
        start="x v",
        constants=constants_of,
        ramps={},
        rates=dict(rates),
        stored=stored,
        varied="",
        cases={"swinging": {}},
    )
    return derive.motion.Motion(family, "swinging")


def test_what_is_not_known_ahead_has_no_rate(derive):
    """A rate is taken of what is made of states that are the integrals of others, else of nothing."""

    def powers(s):
        return {"power": s.x * s.v, "power_rate": s.v}

    with pytest.raises(ValueError, match="a coefficient ahead"):
        made_of(derive, powers, "power_rate", {"power_rate": "power"})


def test_a_sine_asks_for_the_rate_of_its_angle(derive):
    """Its rate is a sum that no page has named, and that nobody else needs."""
    with pytest.raises(ValueError, match="needed as a series"):
        made_of(derive, lambda s: {"wave": (s.x + s.v).sin()}, "wave")


def test_two_series_of_one_name_are_refused(derive):
    def twice(s):
        product = s.x * s.v
        product.name = "x"
        return {"square": product * product}

    with pytest.raises(ValueError, match="two series are called s->x"):
        made_of(derive, twice, "square")


def test_a_law_of_series_has_no_root(derive):
    def distance(x):
        """|x|."""
        return derive.functions.sqrt(x * x)

    with pytest.raises(ValueError, match="is a root"):
        derive.laws.law_series(distance, {"x"}, {})


def test_a_law_of_series_is_handed_what_it_asks_for(derive):
    def height(length, share, more):
        """Some of it, and more."""
        return share.part * length + share.whole * more

    shares = {"share": ("const shares *share", ["part", "part_rate", "whole"])}
    text = derive.laws.law_series(height, {"length"}, shares)
    assert "const real *length, const shares *share, real more, int order" in text
    drifts = "drift_times(k, share->part, share->part_rate, length)"
    assert f"height[k] = with_constant(k, {drifts}, share->whole * more);" in text


def test_a_law_of_series_turns_by_the_rate_of_its_angle(derive):
    def ahead(angle, slope):
        """The sine of an angle."""
        return derive.functions.sin(angle - slope)

    text = derive.laws.law_series(ahead, {"angle", "angle_rate"}, {})
    assert "const real *angle, real slope, const real *angle_rate, int order" in text
    assert "sine_and_cosine_term(k, angle_minus_slope, angle_rate, ahead, cos_of_angle_minus_slope);" in text
