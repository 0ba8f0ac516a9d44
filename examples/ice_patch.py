"""A runner crosses a patch of ice: `ground.friction` is switched by this script as the foot moves on.

    python examples/ice_patch.py

What a co-simulation is for: the ground is somebody else's business. The runner goes by its own solver; the
script only says, twenty times in each sqrt(m/k), how slippery the ground under the foot is.
"""

from runner import Runner

ICE = (60.0, 140.0)
"""Beginning and end of the ice, in l0."""
FRICTION_ON_ICE, FRICTION_ELSEWHERE = 0.15, 0.6
STEP = 0.05


def friction_at(x):
    """Coefficient of friction of the ground at a position."""
    return FRICTION_ON_ICE if ICE[0] <= x <= ICE[1] else FRICTION_ELSEWHERE


def cross(strides=20):
    """Run; return (position, word, speed) of each completed stride."""
    seen = []
    with Runner(STEP) as runner:
        while len(seen) < strides and not runner["status.fallen"]:
            runner["ground.friction"] = friction_at(runner["foot.x"])
            if runner.advance():
                seen.append((runner["com.x"], runner["stride.word"], runner["stride.speed"]))
    return seen


if __name__ == "__main__":
    for position, word, speed in cross():
        ground = "ice" if friction_at(position) == FRICTION_ON_ICE else ""
        print(f"x = {position:7.1f}   {word:8}  speed {speed:.3f}  {ground}")
