"""The pages in examples/pages, beside closed forms, published values and independent integrations."""

import importlib
import sys

import numpy as np
import pytest
from conftest import RELEASE, reference_gaits, some_of
from page_runs import ROOT, CompiledPage, central_difference
from references import read
from runner_pages import section, word, world_of
from scipy.integrate import solve_ivp
from scipy_strides import Stride, torque_of_gains
from tdmf_slip import find_gait
from tdmf_slip.library.page_model import package_model

from c_core.hybrid import parameter, sin
from c_core.pages.runner import PlainRunner

TIGHT = {"tolerance": 1e-13}
PAGES = ROOT / "examples" / "pages"
sys.path.append(str(PAGES))
COMPLIANT = read("compliant_gaits.json")


def compiled(module, name):
    """A fixture: an example page in C."""
    load = lambda: CompiledPage(getattr(importlib.import_module(module), name), "-O1")  # noqa: E731
    return pytest.fixture(scope="module")(load)


ball = compiled("bouncing_ball", "BouncingBall")
wheel = compiled("rimless_wheel", "RimlessWheel")
walker = compiled("simplest_walker", "SimplestWalker")
biped = compiled("spring_mass_walker", "SpringMassWalker")
pd_runner = compiled("pd_runner", "PdRunner")
clocked = compiled("clocked_runner", "ClockedRunner")
compliant = compiled("compliant_runner", "CompliantRunner")


# ---- the bouncing ball ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("height", "restitution", "gravity"), [(1, 0.8, 9.81), (3, 0.5, 1.62), (0.2, 0.99, 9.81)]
)
def test_the_ball_bounces_by_its_closed_form_until_it_rests(ball, height, restitution, gravity):
    """Bounce n comes after sqrt(2 h/g) (1 + 2 e (1 - e^(n - 1))/(1 - e)), and leaves e^n sqrt(2 g h)."""
    slowest = 0.05 * np.sqrt(2 * gravity * height)
    given = {"height": height, "restitution": restitution, "gravity": gravity, "slowest": slowest}
    run = ball.start(**given, **TIGHT).to(1e3)
    count = int(np.ceil(np.log(0.05) / np.log(restitution)))
    n = np.arange(1, count + 1)
    falls = np.sqrt(2 * height / gravity)
    times = falls * (1 + 2 * restitution * (1 - restitution ** (n - 1)) / (1 - restitution))
    assert [time for time, *_ in run.log] == pytest.approx(times, abs=1e-11)
    assert (run.mode, run.bounces, run.height, run.speed) == ("rest", count, 0, 0)
    assert run.speed_up == pytest.approx(restitution**count * np.sqrt(2 * gravity * height), abs=1e-11)


def test_the_return_map_of_the_ball_and_its_derivatives(ball):
    at = ball.section("after_bounce", seeds=["restitution", "gravity"], **TIGHT).after([2.0], varies=True)
    assert at.next == pytest.approx([1.6], abs=1e-13)
    assert np.hstack([at.jacobian, at.by_seeds]) == pytest.approx(np.array([[0.8, 2, 0]]), abs=1e-13)
    assert at.crossing.time == pytest.approx(4 / 9.81, abs=1e-13)


# ---- the rimless wheel ---------------------------------------------------------------------------------


WHEELS = [
    {},
    {"slope": 0.15, "half_angle": 0.4, "length": 0.7},
    {"slope": 0.03, "half_angle": 0.1, "gravity": 1.62},
]


@pytest.mark.parametrize("given", WHEELS)
def test_the_wheel_rolls_by_its_closed_form_map(wheel, given):
    rate, seeds = 1.3, ["slope", "half_angle"]
    at = wheel.section("at_landing", seeds=seeds, **given, **TIGHT)
    slope, half, length, gravity = (
        getattr(at.given, name) for name in ("slope", "half_angle", "length", "gravity")
    )

    def after(rate, slope, half):
        gained = 4 * gravity / length * np.sin(slope) * np.sin(half)
        return np.cos(2 * half) * np.sqrt(rate**2 + gained)

    at.after([rate], varies=True)
    assert at.next == pytest.approx([after(rate, slope, half)], abs=1e-12)
    shifts = 1e-20j * np.eye(3)  # complex steps are exact
    slopes = [after(*(np.array([rate, slope, half]) + shift)).imag / 1e-20 for shift in shifts]
    assert np.hstack([at.jacobian, at.by_seeds])[0] == pytest.approx(slopes, abs=1e-12)
    share = np.cos(2 * half) ** 2
    rolling = np.sqrt(share / (1 - share) * 4 * gravity / length * np.sin(slope) * np.sin(half))
    assert at.fixed_point([rate]) == pytest.approx([rolling], abs=1e-12)
    assert at.jacobian == pytest.approx(np.array([[share]]), abs=1e-12)


@pytest.mark.parametrize("share", [0.999999, 1.000001])
def test_a_wheel_that_is_too_slow_rocks_until_it_stands(wheel, share):
    """The wheel passes the top if thetadot^2 > 2 g/l (1 - cos(s - a)) where the vault begins."""
    slope, half = 0.01, np.radians(15)
    enough = np.sqrt(2 * 9.81 * (1 - np.cos(slope - half)))
    run = wheel.start(slope=slope, angle=slope - half, rate=share * enough, **TIGHT).to(60.0)
    assert (run.log[0][1], run.mode) == ("lands_uphill" if share < 1 else "lands_downhill", "stands")
    assert run.rate == 0
    rocking = [name for _, name, *_ in run.log]
    assert rocking[-6:] == rocking[-2:] * 3 and rocking[-1] != rocking[-2]


def first_event(rates, guards, time, y):
    """Integrate by SciPy to the first guard that falls through zero; one that begins at zero has to rise."""
    falls = [guard for guard in guards.values() if guard(y) < 1e-9]
    hooks = [
        lambda t, y, guard=g: guard(y) if t > time or guard not in falls else -1.0 for g in guards.values()
    ]
    for hook in hooks:
        hook.terminal, hook.direction = True, -1
    tight = {"method": "DOP853", "rtol": 1e-13, "atol": 1e-14}
    found = solve_ivp(lambda _, y: rates(y), (time, time + 100), y, events=hooks, **tight)
    return found.t[-1], found.y[:, -1], list(guards)[[len(times) > 0 for times in found.t_events].index(True)]


# ---- the simplest walking model ------------------------------------------------------------------------


def spectrum(jacobian):
    """Eigenvalues, sorted by size and angle."""
    return sorted(np.linalg.eigvals(jacobian), key=lambda value: (-round(abs(value), 6), np.angle(value)))


@pytest.mark.parametrize(
    ("gait", "eigenvalues"),
    [((0.2003, -0.1998), [-0.190 - 0.558j, -0.190 + 0.558j]), ((0.1939, -0.2039), [4.00, 0.46])],
    ids=["long period", "short period"],
)
def test_the_gaits_of_the_walker_are_the_published_ones(walker, gait, eigenvalues):
    at = walker.section("at_heel_strike", **TIGHT)
    assert at.fixed_point(gait) == pytest.approx(gait, abs=5e-5)
    assert spectrum(at.jacobian) == pytest.approx(eigenvalues, abs=5e-3 if eigenvalues[0].imag == 0 else 6e-4)


def test_a_step_of_the_walker_is_that_of_scipy(walker):
    start = np.array([0.199, -0.2005])

    def rates(y):
        stance, stance_rate, swing, swing_rate = y
        turn = np.sin(stance - 0.009)
        along = stance_rate**2 - np.cos(stance - 0.009)
        return [stance_rate, turn, swing_rate, turn + along * np.sin(swing)]

    angle, rate = start
    begin = [angle, rate, 2 * angle, (1 - np.cos(2 * angle)) * rate]

    def strikes(_, y):
        return 2 * y[0] - y[2]

    strikes.direction = -1
    found = solve_ivp(lambda _, y: rates(y), (0, 6), begin, "DOP853", events=strikes, rtol=1e-13, atol=1e-14)
    time, y = next((t, y) for t, y in zip(found.t_events[0], found.y_events[0], strict=True) if t > 0.1)
    at = walker.section("at_heel_strike", **TIGHT).after(start)
    assert at.crossing.time == pytest.approx(time, abs=1e-9)
    assert at.next == pytest.approx([-y[0], np.cos(2 * y[0]) * y[1]], abs=1e-9)


def test_a_walker_that_is_pushed_too_hard_or_too_little_falls(walker):
    for rate, way in ((-0.05, 1), (-0.9, -1)):
        run = walker.start(stance_rate=rate, **TIGHT).to(50.0)
        assert (run.outcome, run.mode) == ("ended", "fallen")
        assert run.stance == pytest.approx(way * np.pi / 2, abs=1e-9)


# ---- the bipedal spring-mass model ---------------------------------------------------------------------


RUNNING = {"stiffness": 20000.0, "energy_given": 1800.0, "attack": np.radians(68)}


class Biped:
    """The spring-mass model by SciPy: a list of feet, however many."""

    def __init__(self, stiffness, attack, feet, y):
        self.share, self.attack, self.feet, self.y, self.time = stiffness / 80, attack, feet, y, 0.0

    def rates(self, y):
        force = np.array([0, -9.81])
        for foot in self.feet:
            leg = y[:2] - [foot, 0]
            force = force + self.share * (1 / np.hypot(*leg) - 1) * leg
        return [*y[2:], *force]

    def step(self):
        """Walk to the next passage over the only foot."""
        while True:
            guards = {i: lambda y, x=x: 1 - np.hypot(y[0] - x, y[1]) for i, x in enumerate(self.feet)}
            if len(self.feet) < 2:
                guards["lands"] = lambda y: y[1] - np.sin(self.attack)
            if len(self.feet) == 1:
                guards["passes"] = lambda y: self.feet[0] - y[0]
            self.time, self.y, name = first_event(self.rates, guards, self.time, self.y)
            if name == "passes":
                return self
            if name == "lands":
                self.feet.append(self.y[0] + np.cos(self.attack))
            else:
                self.feet.pop(name)


def test_the_biped_walks_by_the_published_gait(biped):
    at = biped.section("above_foot", **TIGHT)
    assert at.fixed_point([0.97, 0.01]) == pytest.approx([0.976754873, 0], abs=1e-9)
    assert spectrum(at.jacobian) == pytest.approx([0.7720 - 0.4913j, 0.7720 + 0.4913j], abs=6e-5)


@pytest.mark.parametrize(
    ("given", "point", "events"),
    [
        ({}, [0.972, 0.01], ["touchdown", "take_off", "passes_foot"]),
        (RUNNING, [0.9, 0.05], ["take_off", "apex", "touchdown", "passes_foot"]),
    ],
    ids=["walks", "runs"],
)
def test_a_step_of_the_biped_is_that_of_scipy(biped, given, point, events):
    at = biped.section("above_foot", **given, **TIGHT)
    energy, stiffness, attack = (getattr(at.given, name) for name in ("energy_given", "stiffness", "attack"))
    height, rise = point
    speed = np.sqrt(2 / 80 * (energy - 80 * 9.81 * height - stiffness * (1 - height) ** 2 / 2) - rise**2)
    found = Biped(stiffness, attack, [0.0], np.array([0, height, speed, rise])).step()
    at.after(point)
    assert at.crossing.time == pytest.approx(found.time, abs=1e-9)
    assert at.next == pytest.approx(found.y[[1, 3]], abs=1e-9)
    run = biped.start(y=height, vx=speed, vy=rise, **given, **TIGHT).to(at.crossing.time)
    assert [name for _, name, *_ in run.log] == events
    assert run.outputs["energy"] == pytest.approx(energy, rel=1e-12)


def test_a_running_biped_is_the_classic_slip_on_alternate_legs(biped):
    at = biped.section("above_foot", **RUNNING, **TIGHT)
    at.after(at.fixed_point([0.9, 0.0]), varies=True)
    given = {"energy": 1800.0, "touchdown_angle": np.radians(22), "stiffness": 20000.0}
    guess = [at.state("apex_height") + 1e-3]
    gait = find_gait(package_model("classic_slip", "at_energy"), guess=guess, **given)
    assert gait.apex == pytest.approx([at.state("apex_height")], abs=1e-11)
    assert spectrum(at.jacobian) == pytest.approx([gait.jacobian[0, 0], 0], abs=1e-9)


# ---- runners with laws of their own: gains in stance, and a clock with Raibert's law -------------------


GAINS = {"stance_kp": 0.05, "stance_kd": 0.02, "stance_target": -np.radians(20)}
CLOCK = {"pulse": 1.0, "placing_time": 1.1, "placing_gain": 0.3, "speed_wanted": 0.95}
APEX, CLOCKED_APEX = (1.4, 1.05, 1.0, -0.55, 0.0, 0.0), (1.08, 0.98, 1.0, -0.45, 0.0, -0.005)


class OwnLaws(PlainRunner):
    """A hardening spring, viscous friction, and a torque that follows a clock; each is a few lines."""

    hardening = parameter(3, "m-2", "The spring hardens with the cube of its compression")
    viscosity = parameter(0.3, "s/m", "Friction grows with the speed of the slip")
    amplitude = parameter(0.02, "N.m", "Torque that follows a clock")
    frequency = parameter(1.5, "rad/s", "Angular frequency of the clock")

    def stance_torque(r):
        return super().stance_torque() + r.amplitude * sin(r.frequency * r.time)

    def spring(r):
        short = r.free_length - r.leg().length
        return super().spring() + r.stiffness * r.hardening * short**3

    def slip_friction(r):
        return super().slip_friction() + r.viscosity * r.way * r.foot_vx


OWN = {"hardening": 3.0, "viscosity": 0.3, "amplitude": 0.02, "frequency": 1.5}
LAWS = {"spring": lambda short: short + 3 * short**3, "viscosity": 0.3}
LAWS["torque"] = lambda t, _angle, _turn, drives: -0.2 * drives + 0.02 * np.sin(1.5 * t)


@pytest.fixture(scope="module")
def own_laws():
    return CompiledPage(OwnLaws, "-O1")


class ClockedStride(Stride):
    """A stride whose drive begins at touchdown and ends by the clock."""

    def __init__(self, friction, speed):
        super().__init__(
            friction, torque=lambda t, *_: -0.2 * self.drives * np.sin(np.pi * (t - self.landed))
        )
        self.touchdown_angle = np.arcsin(speed * 1.1 / 2 + 0.3 * (speed - 0.95))

    @property
    def drives(self):
        return self.phase == "drive"

    def guards(self):
        guards = super().guards()
        return (
            guards | {"upright": lambda leg: 1 - (leg.time - self.landed)} if "upright" in guards else guards
        )

    def take(self, event, z):
        if event == "touchdown":
            self.landed = self.time
        super().take(event, z)
        if event == "touchdown":
            self.phase = "drive"


@pytest.mark.parametrize(
    ("name", "point", "stride"),
    [
        ("pd_runner", APEX, Stride(0.43, torque=torque_of_gains(**GAINS))),
        ("clocked", CLOCKED_APEX, ClockedStride(0.6, CLOCKED_APEX[1])),
        ("own_laws", APEX, Stride(0.43, **LAWS)),
    ],
    ids=["gains", "clock", "spring, friction and torque"],
)
def test_own_laws_act_as_in_an_independent_program(request, name, point, stride):
    run = request.getfixturevalue(name).start(friction=stride.friction, **TIGHT, **world_of(point))
    run.to(stop="apex")
    wanted = stride.run(point)
    assert word(run) == wanted["word"]
    assert section(run) == pytest.approx(wanted["apex"], abs=1e-9)
    assert (run.time, run.work) == pytest.approx((wanted["period"], wanted["work"]), abs=1e-9)


def test_raibert_s_law_forgets_a_wrong_speed_sooner_than_the_papers_fixed_angle(clocked, pd_runner):
    """The gait without gains in stance is the published one."""
    at = clocked.section("at_apex", friction=0.6, **TIGHT)
    at.fixed_point(CLOCKED_APEX)
    largest = np.abs(np.linalg.eigvals(at.jacobian)).max()
    gait = next(gait for gait in reference_gaits(False) if gait["friction"] == 0.6)
    paper = pd_runner.section("at_apex", friction=0.6, stance_kp=0.0, stance_kd=0.0, **TIGHT)
    assert paper.fixed_point(gait["apex"]) == pytest.approx(gait["apex"], abs=1e-11)
    assert largest < 0.65 * np.abs(np.linalg.eigvals(paper.jacobian)).max()


NEAR = {"friction": 0.43, "drive_torque": 0.2, "damping": 0.2, "stiffness": 1.0, "foot_mass": 0.1}
NEAR |= {"kp": 0.1, "kd": 0.1, "gravity": 0.01}
"""Parameters of the runner that are drawn, each up to a fifth off."""
STEP = 1e-5


@pytest.mark.parametrize(
    ("name", "own", "point"),
    [
        ("pd_runner", GAINS, APEX),
        ("clocked", CLOCK, CLOCKED_APEX),
        ("own_laws", OWN, APEX),
        ("compliant", {"ground_stiffness": 100.0, "dissipation": 20.0}, APEX),
    ],
    ids=["gains", "clock", "spring, friction and torque", "compliant ground"],
)
def test_jacobians_of_own_laws_are_differences(request, name, own, point, count=100 if RELEASE else 15):
    """Random parameters, with those of the page itself. Differences across an event are left out."""
    page, random, compared = request.getfixturevalue(name), np.random.default_rng(50), 0

    def crossing(given, point, **options):
        return page.section("at_apex", tolerance=1e-14, **options, **given).after(point, varies=bool(options))

    for _ in range(2 * count + 5):
        given = {of: value * random.uniform(0.8, 1.2) for of, value in (NEAR | own).items()}
        point_of = dict(enumerate(np.array(point) + 0.02 * random.uniform(-1, 1, 6)))
        columns, kinds = [], set()
        for varied in (*point_of, *own):
            ends = {}
            for n in (-2, -1, 1, 2):
                values = point_of | given
                values[varied] += STEP * n
                at = crossing({of: values[of] for of in given}, [values[i] for i in range(6)])
                ends[n] = at.next
                kinds.add(tuple(at.state(of) for of in ("events", "word_code", "touchdowns")))
            columns.append(central_difference(ends, STEP))
        if len(kinds) == 1:
            at = crossing(given, list(point_of.values()), seeds=list(own))
            exact = np.hstack([at.jacobian, at.by_seeds])
            size = 1e-7 * (1 + np.abs(exact).max())
            assert exact == pytest.approx(np.transpose(columns), abs=size), given
            compared += 1
        if compared == count:
            return
    pytest.fail(f"only {compared} of {count} strides are away from events")


# ---- the runner on compliant ground --------------------------------------------------------------------


RUNS = [*COMPLIANT["strides"], *COMPLIANT["gaits"], *COMPLIANT["falls"]]
REPORTED = {
    "contact_ends": "contact_ends", "comes_to_rest": "slip_velocity_zero", "slips_forward": "slip_onset",
    "slips_backward": "slip_onset", "mid_stance": "midstance", "lift_off": "liftoff",
    "graze_to_flight": "release_ends", "clamp": "clamp", "release": "clamp", "apex": "apex", "falls": "fall",
}  # fmt: skip


def on_compliant_ground(case):
    """Parameters of a case, with the clamp."""
    given = {name.removeprefix("ground."): value for name, value in case["given"].items()}
    given["ground_stiffness"] = given.pop("stiffness")
    return {"swing_clamp": 1.0, **given}


def reported_events(run):
    """Events and their times in the words of the reference.

    The end of a contact may be a lift-off, and a release may end as it begins.
    """
    found = []
    for time, name, before, _ in run.log[1:]:
        what = REPORTED.get(name)
        if name == "touchdown":
            what = "touchdown" if before.startswith("flight") else "contact_begins"
        if name == "graze_to_contact":
            what = None if before == "graze_bounce" else "release_undone"
        if what == "liftoff" and found[-1] == ("contact_ends", time):
            found.pop()
        if what == "release_ends" and found[-1] == ("liftoff", time):
            continue
        if what:
            found.append((what, time))
    return found


@pytest.mark.parametrize("case", RUNS, ids=lambda case: case["name"])
def test_runs_on_compliant_ground_are_those_of_the_reference(compliant, case):
    start, ends = case.get("start_apex") or case["apex"], "period" not in case
    run = compliant.start(**on_compliant_ground(case), **TIGHT, **world_of(start))
    energy = run.to(0.0).outputs["energy"]
    run.to(stop=None if ends else "apex")
    events = reported_events(run)
    assert [name for name, _ in events] == [name for name, _ in case["events"]]
    assert [time for _, time in events] == pytest.approx([time for _, time in case["events"]], abs=1e-10)
    lost = run.damper_loss + run.friction_loss + run.ground_loss
    assert run.outputs["energy"] - energy == pytest.approx(run.work - lost, abs=1e-13)
    assert run.mode == ("fallen" if ends else "flight_calm")
    if ends:
        return
    assert section(run) == pytest.approx(case.get("next_apex") or start, abs=1e-11)
    assert (word(run), run.contacts, run.touchdowns) == (case["word"], case["contacts"], case["touchdowns"])
    assert run.x[compliant.states.index("events")] == len([e for e in events if e[0] != "clamp"])
    found = {"period": run.period, "length": run.distance, "speed": run.speed, "work": run.work_of_stride}
    found |= {"cost_of_transport": run.cost_of_transport, "stance_time": run.stance_time}
    found |= {"slip_distance": run.slip_distance, "peak_force": run.peak_force, "peak_penetration": run.depth}
    found |= {name: getattr(run, name) for name in ("damper_loss", "friction_loss", "ground_loss")}
    assert found == pytest.approx({name: case[name] for name in found}, abs=1e-11)


@pytest.mark.parametrize("gait", COMPLIANT["gaits"], ids=lambda case: case["name"])
def test_gaits_on_compliant_ground_are_those_of_the_reference(compliant, gait):
    at = compliant.section("at_apex", **on_compliant_ground(gait), tolerance=1e-14)
    assert at.fixed_point(np.array(gait["apex"]) * (1 + 1e-4)) == pytest.approx(gait["apex"], abs=1e-12)
    assert at.jacobian == pytest.approx(np.array(gait["jacobian"]), abs=1e-9)
    sizes = np.sort(np.abs(np.linalg.eigvals(at.jacobian)))
    assert sizes == pytest.approx(np.sort(np.abs(gait["eigenvalues"])), abs=1e-9)


def test_random_runs_on_compliant_ground_keep_the_ledger_of_energy(compliant):
    """Starts are above, on and below the ground, with light and heavy feet, without and with much damping."""
    random, ends = np.random.default_rng(12), set()

    def between(low, high):
        return float(np.exp(random.uniform(np.log(low), np.log(high))))

    for number in range(150 if RELEASE else 60):
        far = number % 3 == 0
        given = {
            "ground_stiffness": between(0.5, 1e7) if far else between(5, 1e5),
            "dissipation": 0.0 if random.random() < 0.15 else between(0.1, 1e3),
            "foot_mass": between(1e-3, 2) if far else between(0.05, 0.2),
            "damping": between(1e-3, 3) if far else between(0.05, 0.5),
            "gravity": between(1e-4, 0.5) if far else between(0.005, 0.02),
            "friction": between(0.02, 20), "swing_clamp": float(random.random() < 0.5),
            "drive_torque": random.uniform(-0.1, 0.3), "liftoff_factor": random.uniform(0.5, 1.6),
            "kp": between(0.03, 0.3), "kd": between(0.03, 0.3),
        }  # fmt: skip
        deepest = min(0.02, 3 / given["ground_stiffness"])
        heights = 0.0, 1e-13, -1e-13, -deepest, -deepest * random.random(), random.random()
        follows = 1 / given["dissipation"] if given["dissipation"] else 0.0
        start = {
            "seen_y": random.choice(heights), "seen_vx": random.choice([0, random.normal()]),
            "seen_vy": random.choice([0, follows, -0.1, 0.3 * random.normal()]),
            "length": random.uniform(0.8, 1.1), "length_rate": 0.2 * random.normal(),
            "angle": random.uniform(-1, 1), "angle_rate": 0.3 * random.normal(),
        }  # fmt: skip
        run = compliant.start(**given, **start, tolerance=1e-12)
        energy = run.to(0.0).outputs["energy"]
        run.to(60.0)
        losses = np.array([run.damper_loss, run.friction_loss, run.ground_loss])
        assert run.outputs["energy"] - energy == pytest.approx(
            run.work - losses.sum(), abs=1e-9 * (1 + losses.sum())
        )
        assert run.outcome in ("arrived", "ended") and losses.min() > -1e-12
        ends.add(run.outcome)
    assert ends == {"arrived", "ended"}


def test_gaits_approach_those_of_rigid_ground_as_in_the_reference(compliant):
    """The ground stiffens up to a million leg stiffnesses, with damping by which no foot bounces."""
    rigid = {gait["friction"]: gait["apex"] for gait in reference_gaits(True)}
    assert len(COMPLIANT["convergence"]) == 40
    for case in some_of(COMPLIANT["convergence"], 10):
        given = on_compliant_ground(case)
        at = compliant.section("at_apex", **given, **TIGHT)
        at.after(at.fixed_point(rigid[given["friction"]]), varies=True)
        largest = np.abs(np.linalg.eigvals(at.jacobian)).max()
        found = at.state("speed"), at.state("cost_of_transport"), largest
        wanted = case["speed"], case["cost_of_transport"], case["largest_eigenvalue"]
        assert found == pytest.approx(wanted, abs=1e-8 + 1e-8 * 1e3 / case["given"]["ground.stiffness"]), case
