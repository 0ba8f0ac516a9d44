"""A runner crosses a patch of ice: `ground.friction` is switched by this script as the foot moves on.

    python examples/ice_patch.py

What a co-simulation is for: the ground is somebody else's business. The runner goes by its own solver; the
script only says, twenty times in each sqrt(m/k), how slippery the ground under the foot is.
"""

import shutil

import fmpy
import tdmf_slip
from fmpy.fmi2 import FMU2Slave

ICE = (60.0, 140.0)
"""Where the ice begins and ends, in l0."""
FRICTION_ON_ICE, FRICTION_ELSEWHERE = 0.15, 0.6
STEP = 0.05


def friction_at(x):
    """Coefficient of friction of the ground at a place."""
    return FRICTION_ON_ICE if ICE[0] <= x <= ICE[1] else FRICTION_ELSEWHERE


def cross(strides=20):
    """Run; return (place, word, speed) of each completed stride."""
    unit = str(tdmf_slip.fmu_path())
    description = fmpy.read_model_description(unit)
    reference = {variable.name: variable.valueReference for variable in description.modelVariables}
    folder = fmpy.extract(unit)
    runner = FMU2Slave(
        guid=description.guid,
        unzipDirectory=folder,
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="runner",
    )
    runner.instantiate()
    runner.setupExperiment()
    runner.enterInitializationMode()
    runner.exitInitializationMode()
    seen, step = [], 0
    while len(seen) < strides and not runner.getBoolean([reference["status.fallen"]])[0]:
        (x,) = runner.getReal([reference["foot.x"]])
        runner.setReal([reference["ground.friction"]], [friction_at(x)])
        runner.doStep(currentCommunicationPoint=step * STEP, communicationStepSize=STEP)
        step += 1
        if runner.getInteger([reference["stride.count"]])[0] > len(seen):
            word = runner.getString([reference["stride.word"]])[0].decode()
            place, speed = runner.getReal([reference["com.x"], reference["stride.speed"]])
            seen.append((place, word, speed))
    runner.terminate()
    runner.freeInstance()
    shutil.rmtree(folder)
    return seen


if __name__ == "__main__":
    for place, word, speed in cross():
        ground = "ice" if friction_at(place) == FRICTION_ON_ICE else ""
        print(f"x = {place:7.1f}   {word:8}  speed {speed:.3f}  {ground}")
