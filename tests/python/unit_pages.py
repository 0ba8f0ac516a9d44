"""Pages that the tests of units build: two of the guide, and a hopper that has everything a page can have."""

import functools

import numpy as np
from page_runs import built_once, compiler, guide, texts_of  # puts the folder of c_core on the path, too

from c_core.hybrid import (
    Model,
    clock,
    coordinates,
    event,
    input,
    letters,
    mode,
    observe,
    on_set,
    output,
    parameter,
    require,
    select,
    setting,
    state,
)
from c_core.hybrid.unit_files import build_units

Ball, Yoyo = guide().Ball, guide().Yoyo
STRICT = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]


class Hopper(Model):
    """A mass on a massless spring that hops up and down, pushed by a force; no energy is lost."""

    start = "release", {}
    mass, gravity = parameter(1, "kg", above=0), parameter(10, "m/s2", above=0)
    length = parameter(1, "m", "Length of the unloaded spring", above=0)
    stiffness = parameter(200, "N/m", "Stiffness", name="spring.stiffness", tunable=True, above=0)
    push = input(0, "N", "Force on the mass, upward", least=-100, most=100)
    ground = setting(0, "m", "Height of the ground, in force from touchdown on", least=-10, most=10)
    time = clock()

    y = state(1.3, "m", "Height of the mass", of="world")
    vy = state(0, "m/s", "Velocity of the mass, upward", of="world")
    u = state(0, "m", "Compression of the spring", of="spring")
    w = state(0, "m/s", "Rate of the compression", of="spring")
    level = state(0, "m", "Height of the ground in force")
    work = state(0, "J", "Work of the force", name="push.work")
    lift = state(0, "J", "Positive work of the force", name="push.positive_work")
    given = state(0, "J", "Work of jumps of the stiffness", name="jump.work")
    peak_so_far = state(0, "N", "Largest force of the spring in this stance")
    peak = state(0, "N", "Largest force of the spring in the last stance", name="stance.peak_force")
    count = state(0, "1", "Number of hops", name="hop.count", values=int)
    landed = state(0, "s", "Time of the last touchdown", name="stance.time")
    word = state(0, "1", "What has happened: t touchdown, c greatest compression, l lift-off, a apex",
                 name="hop.word", values=letters("|tcla"))  # fmt: skip

    @coordinates("world")
    def seen(h):
        if h.seen_in == "spring":
            return {"y": h.level + h.length - h.u, "vy": -h.w}
        return {"y": h.y, "vy": h.vy}

    @coordinates("spring")
    def compressed(h):
        if h.seen_in == "spring":
            return {"u": h.u, "w": h.w}
        return {"u": h.level + h.length - h.y, "w": -h.vy}

    def write(h, letter):
        """The word with another letter; of at most ten letters the first ones are dropped."""
        return h.replace(word=select(h.word < 5.0**9, 5 * h.word + letter, letter))

    @require("y", "above the length of the spring")
    def starts_in_flight(h):
        return h.y - h.ground - h.length

    @mode(of="world")
    def release(h):
        return {}

    @mode(of="world")
    def flight(h):
        return {"y": h.vy, "vy": h.push / h.mass - h.gravity, "work": h.push * h.vy}

    @mode(of="spring")
    def stance(h):
        force = h.stiffness * h.u + h.push
        return {"u": h.w, "w": h.gravity - force / h.mass, "work": -h.push * h.w}

    @mode(of="world", ends=True)
    def broken(h):
        return {}

    @event("release", when=lambda h: -1, counted=False)
    def begins(h):
        return h.to("flight", level=h.ground)

    @event("flight", when=lambda h: h.y - h.ground - h.length, unit="m")
    def touchdown(h):
        """The spring touches the ground."""
        h = h.write(1).replace(level=h.ground, peak_so_far=0, landed=h.time, count=h.count + 1)
        return h.to("stance")

    @event("flight", when=lambda h: h.vy, unit="m/s", crossing=lambda h: True)
    def apex(h):
        return h.write(4)

    @event("stance", when=lambda h: h.length - h.u, unit="m")
    def breaks(h):
        """The spring has no length left."""
        return h.to("broken")

    @event("stance", when=lambda h: h.w, unit="m/s", crossing=lambda h: True, counted=False)
    def turns(h):
        return h.write(2)

    @event("stance", when=lambda h: h.u, unit="m")
    def lift_off(h):
        return h.write(3).replace(peak=h.peak_so_far).to("flight")

    @on_set("stiffness")
    def stiffened(h, after):
        """Work on the spring whose stiffness jumps."""
        if h.mode != "stance":
            return h
        return h.replace(given=h.given + (after.stiffness - h.stiffness) * h.u**2 / 2)

    @observe("flight stance", "positive integral", into="lift", unit="W")
    def power(h):
        """Power of the force."""
        return h.push * (h.vy if h.mode == "flight" else -h.w)

    @observe("stance", "largest", into="peak_so_far", unit="N")
    def force_of_spring(h):
        """Force of the spring."""
        return h.stiffness * h.u

    @output("N", name="spring.force")
    def force(h):
        """Force of the spring on the mass."""
        return h.stiffness * h.u if h.mode == "stance" else 0

    @output("J", name="energy.total")
    def energy(h):
        """Mechanical energy; it changes by the work of the force and of jumps of the stiffness."""
        at = h.seen()
        own = h.mass * at["vy"] ** 2 / 2 + h.mass * h.gravity * at["y"]
        return own + h.stiffness * h.u**2 / 2 if h.mode == "stance" else own

    @output(name="contact", kind=("flight", "stance", "broken"))
    def contact(h):
        """Contact of the spring with the ground, which may break the spring."""
        return {"stance": 2, "broken": 3}.get(h.mode, 1)


class Cart(Model):
    """A cart on a spring whose other end is moved."""

    start = "rolls", {}
    mass, stiffness = parameter(1, "kg", above=0), parameter(20, "N/m", above=0)
    hand = input(0, "m", "Position of the other end")
    x, v = state(0.1, "m"), state(0, "m/s")
    work = state(0, "J", "Work of the hand")

    def pull(c):
        """Force of the spring on the cart."""
        return c.stiffness * (c.hand - c.x)

    @mode()
    def rolls(c):
        return {"x": c.v, "v": c.pull() / c.mass, "work": c.pull() * c.hand_rate}

    @on_set("hand")
    def jumped(c, after):
        """Work of a jump of the hand."""
        return c.replace(work=c.work + (c.pull() + after.pull()) / 2 * (after.hand - c.hand))

    @output("J")
    def energy(c):
        """Energy of cart and spring, which is the work of the hand and that of the start."""
        return c.mass * c.v**2 / 2 + c.stiffness * (c.hand - c.x) ** 2 / 2


def ball_at(time, restitution=0.8, height=1.0, gravity=9.81):
    """Height and bounces of a ball that was dropped."""
    speed, left, bounces = np.sqrt(2 * gravity * height), time - np.sqrt(2 * height / gravity), 1
    while left > 2 * restitution * speed / gravity:
        left -= 2 * restitution * speed / gravity
        speed, bounces = speed * restitution, bounces + 1
    return restitution * speed * left - gravity * left**2 / 2, bounces


@functools.cache
def units_of(model):
    """The units of a page by the version of FMI. The hopper, which has everything, is optimised."""
    flags = STRICT if model is Hopper else [*STRICT, "-O0"]
    folder = built_once(
        f"units-{model.__name__}",
        texts_of(model),
        lambda folder: build_units(model, folder, compiler=compiler(), flags=flags),
    )
    return {2: str(folder / f"{model.__name__}.fmu"), 3: str(folder / f"{model.__name__}_FMI3.fmu")}
