"""Pages that are written wrongly: each gets one message, with file, line and name, before anything is compiled."""

import difflib
import importlib.util
import re

import page_runs
import pytest

from c_core.hybrid import Model, PageError, derive, event, mode, parameter, state

PAGE = """\
import math
import numpy
from c_core.hybrid import *

class Ball(Model):
    start = "fall", {{}}
    height = state(1, "m")
    speed = state(0, "m/s")
    gravity = parameter(9.81, "m/s2")
    {quantities}

    @mode()
    def fall(b):
        return {rates}

    {event}
    def bounce(b):
        {decision}

    {more}
"""
GOOD = {
    "quantities": "",
    "rates": "dict(height=b.speed, speed=-b.gravity)",
    "event": '@event("fall", when=lambda b: b.height, unit="m")',
    "decision": "return b.replace(speed=-b.speed)",
    "more": "",
}
OUTPUT = '@output("m")\n    def shown(b):\n        '
WORLD = '@coordinates("world")\n    def seen(b):\n        return dict(height=b.height)\n    '
GEAR = '@mode("gear")\n    def drive(b):\n        return dict(height=b.speed)\n    '
REST = '@mode(of="world")\n    def rest(b):\n        return {}\n    '
TABLE = (
    '@table(low="m", high="m")\n    def rows(b, row):\n        return dict(low=0, high=row * b.height)\n    '
)
SECTION = (
    '@section("bounce", "speed")\n    def after(b, at):\n        return b.replace(height=0, speed=at.speed)\n'
)
WRONG = [
    # tables
    ("an unknown table", {"more": TABLE, "decision": 'return b.replace(height=b.row_of("row", 1).low)'}, "looks up `row`, which is no table of the page; did you mean `rows`"),
    ("a row without an entry", {"more": TABLE.replace("low=0, ", ""), "decision": 'return b.replace(height=b.row_of("rows", 1).low)'}, "whose rows must have exactly low, high"),
    ("an entry in another unit", {"more": TABLE.replace("low=0", "low=b.speed"), "decision": 'return b.replace(height=b.row_of("rows", 1).low)'}, "gives `low` in m.s-1; its unit is m"),
    ("a unit of a column", {"more": TABLE.replace('"m"', '"metre"')}, "unit `metre`, in which `metre` is no unit"),
    ("a table in a rate", {"more": TABLE, "rates": 'dict(height=b.speed * b.row_of("rows", 1).low / b.height)'}, "looks up `rows`; only a decision may"),
    ("a table in a guard", {"more": TABLE, "event": '@event("fall", when=lambda b: b.row_of("rows", 1).high, unit="m")'}, "looks up `rows`; only a decision may"),
    # sections
    ("a section of no event", {"more": SECTION.replace("bounce", "bonce")}, "is taken at `bonce`, which is no event; did you mean `bounce`"),
    ("a coordinate that is no state", {"more": SECTION.replace('"speed"', '"sped"')}, "has the coordinate `sped`, which is no state; did you mean `speed`"),
    ("a section without a start", {"more": SECTION.replace("return", "")}, "has to return the model in the mode in which runs start"),
    ("a coordinate that is not there", {"more": SECTION.replace("at.speed", "at.height")}, "reads `height`, which it does not have here"),
    # declarations
    ("a name twice", {"quantities": 'height = state(2, "m")'}, "`height` is declared twice"),
    ("a function twice", {"more": "@mode()\n    def fall(b):\n        return {}"}, "`fall` is declared twice"),
    ("a word of the language", {"quantities": "start = parameter(1)"}, "`start` is"),
    ("a method of the language", {"quantities": "replace = parameter(1)"}, "`replace` is a word of the language"),
    ("the last name of a list", {"decision": "pass", "event": "@mode()\n    def COUNT(b):\n        return {}\n    " + GOOD["event"]}, "`COUNT` is a word of the language"),
    ("two modes of one name", {"more": GEAR + '@mode()\n    def drive_low(b):\n        return {}\n    @event("drive", when=lambda b: b.height, unit="m")\n    def leaves(b):\n        return b.to("drive_low")', "decision": 'return b.to("drive", gear="low", speed=1)'}, "has the name `drive_low` with its words, which another mode has"),
    ("a name that C cannot have", {"quantities": "größe = parameter(1)"}, "`größe` cannot be a name"),
    ("a private name", {"quantities": "_mass = parameter(1)"}, "`_mass` cannot be a name"),
    ("an unknown unit", {"quantities": 'a = parameter(1, "newton")'}, "unit `newton`, in which `newton` is no unit; allowed are 1, rad, kg, m"),
    ("an unknown bound", {"quantities": "a = parameter(1, atleast=0)"}, "`atleast`, which is no bound; did you mean"),
    ("out of its bounds", {"quantities": "a = parameter(-1, least=0)"}, "starts at -1; it must be at least 0"),
    ("nan", {"quantities": 'a = parameter(float("nan"))'}, "starts at nan; it has to be a finite number"),
    ("1e400", {"quantities": "a = parameter(1e400)"}, "starts at inf; it has to be a finite number"),
    ("a text", {"quantities": 'a = parameter("1")'}, "starts at '1'; it has to be a finite number"),
    ("an unknown start", {"quantities": "", "more": 'start = "fal", {}'}, "starts in `fal`, which is no mode; did you mean `fall`"),
    ("one name in a unit", {"quantities": 'a, b = parameter(1, name="x"), parameter(1, name="x")'}, "has the name `x` in a unit, which `a`"),
    ("unknown coordinates", {"quantities": 'a = state(0, of="moon")'}, "`moon` is no set of coordinates"),
    # rates
    ("a rate of no state", {"rates": "dict(heigth=b.speed)"}, "a rate to `heigth`, which is no state; did you mean `height`"),
    ("a rate in another unit", {"rates": "dict(height=b.gravity)"}, "gives `height` a rate in m.s-2; its unit is m.s-1"),
    ("no rates", {"rates": "None"}, "`fall` gives no rates"),
    ("a typo", {"rates": "dict(height=b.sped)"}, "reads `sped`, which it does not have here; did you mean `speed`"),
    ("a sum of units", {"rates": "dict(height=b.speed + b.height)"}, "adds or subtracts m.s-1 and m, which do not fit"),
    ("a branch on a number", {"rates": "dict(height=b.speed if b.height > 0 else 0)"}, "branches on a number that moves"),
    ("math.sin", {"rates": "dict(height=b.speed * math.sin(b.height))"}, "not from math"),
    ("an array", {"rates": "dict(height=b.speed * numpy.ones(2))"}, "gives `height` the rate|computes with a ndarray"),
    ("a number without end", {"rates": 'dict(height=b.speed * float("inf"))'}, "the rate|not finite"),
    ("the sine of a length", {"rates": "dict(height=b.speed * sin(b.height))"}, "takes `sin` of a quantity in m"),
    ("a kink", {"rates": "dict(height=b.speed, speed=-b.gravity * abs(b.height) / b.height)"}, "uses `abs` of what moves"),
    ("a choice", {"rates": "dict(height=b.speed, speed=select(b.height > 0, b.gravity, 0))"}, "uses `select` of what moves"),
    ("|x|^1.5 at 0", {"quantities": 'x, tau = state(0), parameter(1, "s")', "rates": "dict(x=(1 - abs(b.x) ** 1.5) / b.tau)"}, "cannot be computed|uses `abs`"),
    ("a root at 0", {"quantities": 'x, tau = state(0), parameter(1, "s")', "rates": "dict(x=(1 + sqrt(b.x)) / b.tau)"}, "cannot be computed"),
    ("division by 0", {"rates": "dict(height=b.speed, speed=b.gravity * b.speed / b.speed)"}, "cannot be computed: float division by zero"),
    ("a recursion", {"quantities": "law = lambda b: b.law()", "rates": "dict(height=b.law())"}, "calls itself without end"),
    ("== on a number", {"rates": "dict(height=b.speed if b.height == 2.5 else b.speed)"}, "compares with =="),
    # events
    ("an unknown mode", {"event": '@event("fal", when=lambda b: b.height, unit="m")'}, "the mode `fal`, which the page does not have; did you mean `fall`"),
    ("an unknown word", {"event": '@event("fall", when=lambda b: b.height, unit="m", gear="low")'}, "the word `gear`, which none of its modes has"),
    ("a decision that returns nothing", {"decision": "b.replace(speed=-b.speed)"}, "returns nothing; it has to return the model"),
    ("a decision that returns a number", {"decision": "return b.speed"}, "returns Expression; it has to return the model"),
    ("a decision that changes nothing", {"decision": "return b"}, "returns the model as it was in `fall`"),
    ("to an unknown mode", {"decision": 'return b.to("rest")'}, "goes to `rest`, which is no mode of the page"),
    ("a change of what is not there", {"decision": "return b.replace(sped=0)"}, "changes `sped`, which is neither a state nor a word; did you mean `speed`"),
    ("a change of a parameter", {"decision": "return b.replace(gravity=0)"}, "changes the parameter `gravity`"),
    ("a change in another unit", {"decision": "return b.replace(speed=b.height)"}, "sets `speed` in m; its unit is m.s-1"),
    ("a guard in another unit", {"event": '@event("fall", when=lambda b: b.speed, unit="m")'}, "is in m.s-1; its unit is m"),
    ("a guard that is zero for ever", {"event": '@event("fall", when=lambda b: b.height - b.height, unit="m")'}, "a guard that is 0 for ever in the mode `fall`"),
    ("a guard that is nothing", {"event": '@event("fall", when=lambda b: None, unit="m")'}, "has the guard None|returns nothing"),
    ("a loop on a number", {"decision": "while b.speed < 0: b = b.replace(speed=b.speed + 1)\n        return b"}, "more than 40 comparisons"),
    ("an endless chain", {"event": '@event("fall", when=lambda b: -1)', "decision": "return b.replace(speed=b.speed + 1)"}, "after 100 events in zero time: its guard stays below 0"),
    ("more events than a mode can watch", {"more": 'for i in range(33):\n        locals()[f"e{i}"] = event("fall", when=lambda b, i=i: b.height + i * b.height, unit="m")(lambda b: b.replace(speed=0))'}, "watches 34 events; at most 32"),
    ("a word that nothing gives", {"more": GEAR + '@event("drive", gear="lwo", when=lambda b: b.height, unit="m")\n    def stops(b):\n        return b.to("fall")', "decision": 'return b.to("drive", gear="low", speed=1)'}, "asks for gear=`lwo`, which no decision gives; did you mean `low`"),
    ("a word that is missing", {"more": GEAR, "decision": 'return b.to("drive", speed=1)'}, "goes to `drive` without its word `gear`"),
    ("no guard", {"event": '@event("fall", unit="m")'}, "`event` is given when=None; it takes a function of the model"),
    ("an event without its arguments", {"event": "@event"}, "it takes words in one string"),
    ("a guard that is no function", {"event": '@event("fall", when=3, unit="m")'}, "is given when=3; it takes a function"),
    ("a condition that is no function", {"event": '@event("fall", when=lambda b: b.height, unit="m", only=True)'}, "is given only=True; it takes a function"),
    ("a condition that is nothing", {"event": '@event("fall", when=lambda b: b.height, unit="m", only=lambda b: None)'}, "returns nothing; it has to return whether"),
    ("an assignment in a decision", {"decision": "b.speed = -b.speed\n        return b.replace(height=0)"}, "assigns to `speed`; an event returns m.replace(speed=...)"),
    ("an assignment in a law", {"rates": 'setattr(b, "speed", 1) or dict(height=b.speed)'}, "assigns to `speed`"),
    ("leaving that returns nothing", {"more": "def leaving(b, counted):\n        pass"}, "returns nothing; it has to return the model"),
    ("a jump that returns nothing", {"more": '@on_set("gravity")\n    def heavier(b, after):\n        pass'}, "returns nothing; it has to return the model"),
    ("a start that is only a mode", {"more": 'start = "fall"'}, "has the start 'fall'; it has to be a mode and its words"),
    ("a typo in a mode that no run reaches", {"more": "@mode()\n    def rests(b):\n        return dict(height=b.sped)"}, "`rests` reads `sped`, which it does not have here; did you mean `speed`"),
    ("a typo in an event that no run reaches", {"more": '@mode()\n    def rests(b):\n        return {}\n    @event("rests", when=lambda b: b.height, unit="m")\n    def leaves(b):\n        return b.to("fal")'}, "goes to `fal`, which is no mode of the page; did you mean `fall`"),
    ("a requirement that is nothing", {"more": '@require("height", "positive")\n    def above(b):\n        pass'}, "`above` returns nothing; it has to return a number"),
    # scales and kinds
    ("a scale of no unit", {"more": 'scales = {"metre": lambda b: 1}'}, "unit `metre`, in which `metre` is no unit"),
    ("a scale in another unit", {"more": 'scales = {"m": lambda b: b.gravity}'}, "`scale of m` is in m.s-2; its unit is m"),
    ("a scale that is zero", {"more": 'scales = {"m": lambda b: 0}'}, "`scale of m` is 0; it has to be above 0"),
    ("a scale that is nothing", {"more": 'scales = {"m": lambda b: None}'}, "returns nothing; it has to return a number"),
    ("a scale that is no function", {"more": 'scales = {"m": 1}'}, "`scale of m` is 1; it has to be a function"),
    ("a scale that moves", {"more": 'scales = {"m": lambda b: b.height}'}, "depends on a state; it may depend on parameters alone"),
    ("an unknown kind", {"more": '@output("m", kind=str)\n    def shown(b):\n        return b.height'}, "has the kind str; allowed are float, int, bool"),
    ("a kind in quotes", {"quantities": 'a = state(0, values="int")'}, "has the kind 'int'; allowed are float, int, bool"),
    ("texts in another order", {"quantities": 'a = parameter(1, "m", 3)'}, "is given 3 for a text; the order is value, unit, meaning, name"),
    ("a law named like a word of the language", {"more": "def to(b, mode):\n        return mode"}, "`to` is a word of the language"),
    ("an end with rates", {"more": "@mode(ends=True)\n    def lies(b):\n        return dict(height=b.speed)", "decision": 'return b.to("lies")'}, "gives a rate to `height`, but the mode ends the run"),
    # numbers
    ("a power of a negative number", {"quantities": 'x, tau = state(-2), parameter(1, "s")', "rates": "dict(x=b.x**1.5 / b.tau)"}, "gives `x` the rate (-"),
    ("a negative number to a power", {"quantities": 'x, tau = state(1), parameter(1, "s")', "rates": "dict(x=(-2) ** b.x / b.tau)"}, "raises -2 to a power; the base has to be above 0"),
    ("a power that is too high", {"quantities": 'x, tau = state(1), parameter(1, "s")', "rates": "dict(x=b.x**65 / b.tau)"}, "raises to the power 65; at most 64"),
    ("an array as a quantity", {"quantities": "a = parameter(numpy.ones(2))"}, "starts at array([1., 1.]); it has to be a finite number"),
    ("a name that is too long", {"quantities": f"{'a' * 61} = parameter(1)"}, "cannot be a name: use at most 60"),
    ("math.sqrt in a guard", {"event": '@event("fall", when=lambda b: math.sqrt(b.height), unit="m")'}, "not from math"),
    ("nan in a decision", {"decision": 'return b.replace(speed=-b.speed * float("nan"))'}, "uses the number nan, which is not finite"),
    ("a choice in a guard", {"event": '@event("fall", when=lambda b: abs(b.height), unit="m")'}, "uses `abs` of what moves"),
    # coordinates, outputs and what is observed
    ("a coordinate that is no state of the page", {"quantities": 'x = state(0, "m", of="world")', "more": WORLD.replace("height=", "hight=") + REST, "decision": 'return b.to("rest")'}, "gives the coordinate `hight`, which is no state; did you mean `height`"),
    ("a coordinate that is not given", {"quantities": 'x = state(0, "m", of="world")', "more": WORLD + REST, "decision": 'return b.to("rest")'}, "does not give `x`, which belongs to the coordinates `world`"),
    ("coordinates that are nothing", {"quantities": 'x = state(0, "m", of="world")', "more": WORLD.replace("return dict(height=b.height)", "pass") + REST, "decision": 'return b.to("rest")'}, "gives no coordinates; it returns dict(state=value, ...)"),
    ("a state of other coordinates", {"quantities": 'x = state(0, "m", of="world")', "more": WORLD, "rates": "dict(height=b.x)"}, "reads `x` in the mode `fall`, whose coordinates do not have it"),
    ("an output in another unit", {"more": OUTPUT + "return b.speed"}, "is in m.s-1; its unit is m"),
    ("an output that is nothing", {"more": OUTPUT + "pass"}, "returns nothing; it has to return a number"),
    ("a part that is unknown", {"more": '@observe("fall", "smallest", into="height")\n    def low(b):\n        return b.height'}, "observes the `smallest`"),
    ("into no state", {"more": '@observe("fall", "largest", into="top")\n    def low(b):\n        return b.height'}, "goes into `top`, which is no state"),
    ("a set of nothing", {"more": '@on_set("gravitation")\n    def with_it(b, value):\n        return b'}, "is about `gravitation`, which the page does not have"),
]  # fmt: skip


def loaded(file):
    """The module in a file."""
    spec = importlib.util.spec_from_file_location(file.stem, file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize(("changes", "words"), [case[1:] for case in WRONG], ids=[case[0] for case in WRONG])
def test_a_wrong_page_is_refused_with_file_line_and_name(tmp_path, changes, words):
    file = tmp_path / "ball.py"
    text, right = PAGE.format(**GOOD | changes), PAGE.format(**GOOD)
    edits = difflib.SequenceMatcher(None, right.splitlines(), text.splitlines()).get_opcodes()
    wrong = {line + 1 for kind, _, _, low, high in edits if kind != "equal" for line in range(low, high)}
    file.write_text(text, encoding="utf-8")
    with pytest.raises(PageError) as refused:
        derive(loaded(file).Ball)
    message = str(refused.value)
    place, line, rest = message.split(":", 2)
    assert place == str(file)
    assert int(line) in wrong, message
    assert rest.startswith(" `"), message
    assert any(word in message for word in words.split("|")), message


PARENT = """\
from c_core.hybrid import *

class Base(Model):
    start = "fall", {{}}
    height, speed = state(1, "m"), state(0, "m/s")
    gravity = parameter(9.81, "m/s2", above=0)

    @mode()
    def fall(b):
        return dict(height=b.speed, speed=-b.gravity)

class Ball(Base):
    {line}
"""
HIDDEN = [
    ("speed = lambda b: 1", "`speed` is Ball.<lambda> in place of the state that it was; a finite number fixes it"),
    ('gravity = "9.81"', "`gravity` is '9.81' in place of the parameter that it was"),
    ("gravity = None", "`gravity` is None in place of the parameter that it was"),
    ('gravity = float("inf")', "`gravity` is inf in place of the parameter that it was"),
    ("gravity = -9.81", "`gravity` is fixed at -9.81; it must be above 0"),
    ("fall = state(1)", "`fall` is in place of a function of the page; a function overrides it, and None drops it"),
    ("fall = 3", "`fall` is in place of a function of the page"),
]  # fmt: skip


@pytest.mark.parametrize(("line", "words"), HIDDEN, ids=[line for line, _ in HIDDEN])
def test_a_subclass_that_hides_a_declaration_is_refused(tmp_path, line, words):
    file = tmp_path / "parent.py"
    file.write_text(PARENT.format(line=line), encoding="utf-8")
    with pytest.raises(PageError, match=re.escape(f"{file}:13: {words}")):
        loaded(file)


def test_two_parts_with_one_name_are_refused():
    namespace = {}
    code = (
        "from c_core.hybrid import *\nclass A(Model):\n    size = parameter(1)\n"
        "class B(Model):\n    size = parameter(2)\nclass C(A, B):\n    pass\n"
    )
    with pytest.raises(PageError, match="`size` is declared by the parts A and B"):
        exec(compile(code, "parts.py", "exec"), namespace)


def test_the_page_that_the_wrong_ones_are_made_of_is_right(tmp_path):
    file = tmp_path / "right_ball.py"
    file.write_text(PAGE.format(**GOOD), encoding="utf-8")
    assert set(derive(loaded(file).Ball)) == {"ball.h", "ball_motions.c", "ball.c"}


class Sinks(Model):
    """A ball that comes to rest, or that an event leaves below the ground."""

    start = "fall", {}
    height, speed = state(1, "m"), state(0, "m/s")
    gravity, restitution = parameter(9.81, "m/s2"), parameter(0.5)
    ground, depth, jolt = parameter(0, "m"), parameter(0, "m"), parameter(0, "m/s")

    @mode()
    def fall(b):
        return {"height": b.speed, "speed": -b.gravity}

    @event("fall", when=lambda b: b.height - b.ground, unit="m")
    def bounce(b):
        """Stays below the guard, or comes to rest."""
        return b.replace(speed=-b.restitution * b.speed - b.jolt, height=b.height - b.depth)


@pytest.mark.parametrize(
    ("given", "time"),
    [
        *(({"restitution": e}, f"{(2 / 9.81) ** 0.5 * (1 + e) / (1 - e):g}") for e in (0.9, 0.5, 0.0)),
        ({"restitution": 1, "ground": 0.1, "depth": 0.01, "jolt": 1}, "0.428353"),
        ({"depth": 0.01, "height": 0.5}, "0.[0-9]+"),
    ],
)
def test_a_chain_that_does_not_end_names_the_event_the_mode_and_the_time(given, time):
    words = rf"due again and again in the mode `fall` at t = {time}: `bounce`"
    with pytest.raises(page_runs.StuckError, match=words):
        page_runs.CompiledPage(Sinks).start(**given).to(50.0)
