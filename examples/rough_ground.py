"""A runner on rough ground: up a slope, over steps of random height, and down again.

    python examples/rough_ground.py [picture]

`tdmf_slip.simulate` gives the unit, at each communication point, the line of the profile below the foot.
The picture shows the ground, where foot and centre of mass go, and the leg wherever it carries the body.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np
from tdmf_slip import Profile, simulate

STRIDES = 8
RECORDED = ("foot.x", "foot.y", "body.x", "body.y", "com.x", "com.y", "contact.normal")


def ground():
    """A slope of 1.7 degrees from 40 to 60 leg lengths, random steps up to 170, and the way down."""
    walk = Profile.random_steps(count=16, tread=7.0, roughness=0.12, seed=5, begin=62.0)
    x = np.array([40.0, 60.0, *walk.x, 185.0, 205.0])
    y = np.array([0.0, 0.6, *(0.6 + walk.y), 0.6 + walk.y[-1], 0.0])
    return Profile(x, y)


def run():
    """Eight strides, or until a fall."""
    return simulate(strides=STRIDES, profile=ground(), variables=RECORDED)


def draw(path, profile, rows):
    """Draw the rows of a run."""
    figure, axes = plt.subplots(figsize=(7.6, 3.2), layout="constrained")
    end = float(rows["com.x"][-1])
    inside = (profile.x > 0) & (profile.x < end)
    x = np.concatenate([[0.0], profile.x[inside], [end]])
    y = np.concatenate([profile.height([0.0]), profile.y[inside], profile.height([end])])
    axes.fill_between(x, y, y.min() - 0.4, color="0.82", linewidth=0)
    axes.plot(rows["com.x"], rows["com.y"], color="#22303c", label="centre of mass")
    axes.plot(rows["foot.x"], rows["foot.y"], color="#0b7a75", linewidth=1.0, label="foot")
    loaded = np.flatnonzero(rows["contact.normal"] > 0)[::4]
    coordinates = (
        (rows["foot.x"].values, rows["body.x"].values),
        (rows["foot.y"].values, rows["body.y"].values),
    )
    legs = [np.array([foot[loaded], body[loaded]]) for foot, body in coordinates]
    axes.plot(*legs, color="0.6", linewidth=0.7, zorder=1)
    axes.set(xlim=(0.0, end), ylim=(y.min() - 0.4, 3.4), xlabel="x (l₀)", ylabel="height (l₀)")
    axes.legend(loc="upper right", ncols=2)
    figure.savefig(path, dpi=150)


def main():
    """Run, report and draw."""
    ran = run()
    fate = "fell" if ran.fallen else "ran on"
    print(f"{fate} after {ran.attrs['stride.count']} strides and {ran['com.x'].values[-1]:.1f} leg lengths")
    draw(sys.argv[1] if len(sys.argv) > 1 else "rough_ground.png", ground(), ran)


if __name__ == "__main__":
    main()
