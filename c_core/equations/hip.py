"""The hip's law, with the corrections to the printed one that its text and its gaits ask for.

    stance (11):  tau = -tau0 from touchdown with theta >= 0 to mid-stance, then 0
    retract (12): tau = -kp (theta - eta theta_LO) - kd thetadot              while the centre of mass rises
                  with swing_clamp never below 0
    place (12):   tau = -kp (theta - theta_ref) - kd (thetadot + omega)       from the apex on

The sign of (11) is reversed: theta falls in forward running, and only a negative torque then does positive
work. The text asks for a positive torque that stops the leg's backward rotation, which the printed
min{..., 0} of (12) excludes. With hip.swing_clamp (12) is max{..., 0}; without, it has no clamp.

In place the leg is retracted: theta_ref = theta0 - omega s, with s the time since place began; the paper has
omega = 0.

In every phase the law is affine in the leg's angle, its rate and time, and is data, with t counted from now:

    tau = gain (target + target_rate t - theta) - rate_gain thetadot + torque + torque_rate t
"""

from .functions import Record, where

CONSTANT_INPUTS = Record(hip=Record(external_torque=0))  # rates of inputs that do not change


def law_of(gain=0, rate_gain=0, target=0, target_rate=0, torque=0, torque_rate=0):
    """A law of the hip as data, with t counted from now; gains in N.m/rad and N.m.s/rad.

    tau = gain (target + target_rate t - theta) - rate_gain thetadot + torque + torque_rate t
    """
    return Record(
        gain=gain,
        rate_gain=rate_gain,
        target=target,
        target_rate=target_rate,
        torque=torque,
        torque_rate=torque_rate,
    )


def external(inputs, rates):
    """The torque from outside alone; `rates` are those of the inputs."""
    return law_of(torque=inputs.hip.external_torque, torque_rate=rates.hip.external_torque)


def stance(model, inputs, rates, drives):
    """-tau0 while the stance drives, then 0  (11), and the torque from outside."""
    drive = where(drives, True, model.parameters.hip.stance_torque + inputs.control.stance_torque, 0)
    return law_of(torque=inputs.hip.external_torque - drive, torque_rate=rates.hip.external_torque)


def retract(hip, liftoff_angle):
    """-kp (theta - eta theta_LO) - kd thetadot  (12)."""
    return law_of(gain=hip.kp, rate_gain=hip.kd, target=hip.liftoff_angle_factor * liftoff_angle)


def place(hip, control, place_time):
    """-kp (theta - theta0 + omega s) - kd (thetadot + omega)  (12)."""
    return law_of(
        gain=hip.kp,
        rate_gain=hip.kd,
        target=hip.touchdown_angle + control.touchdown_angle - hip.retraction_rate * place_time,
        target_rate=-hip.retraction_rate,
        torque=-hip.kd * hip.retraction_rate,
    )


def servo(model, inputs, phase, liftoff_angle, place_time):
    """The servo of the flight's law, without clamp and external torque."""
    hip = model.parameters.hip
    return place(hip, inputs.control, place_time) if phase == "place" else retract(hip, liftoff_angle)


def flight(model, inputs, rates, phase, clamp_closed, liftoff_angle, place_time):
    """Law off the ground: the servo, 0 where the clamp of (12) is closed, plus the external torque."""
    if phase != "place" and clamp_closed:
        return external(inputs, rates)
    law = servo(model, inputs, phase, liftoff_angle, place_time)
    law.torque = law.torque + inputs.hip.external_torque
    law.torque_rate = rates.hip.external_torque
    return law


def place_time_rate(phase):
    """The clock of place runs while that lasts."""
    return where(phase, "place", 1, 0)


def rates(at):
    """The right-hand side of the states that are the hip's own, at an instant."""
    return Record(hip_place_time=place_time_rate(at.mode.phase))


def torque(law, angle, angle_rate):
    """gain (target - theta) - rate_gain thetadot + torque, now."""
    return law.gain * (law.target - angle) - law.rate_gain * angle_rate + law.torque


def servo_torque(model, inputs, state, phase, liftoff_angle):
    """The torque of the servo alone; with swing_clamp its sign decides the clamp of (12)."""
    law = servo(model, inputs, phase, liftoff_angle, state.hip_place_time)
    return torque(law, state.leg_angle, state.leg_angle_rate)


def stance_torque(model, inputs, state, drives):
    """Under the law of stance  (11), with the inputs held."""
    return torque(stance(model, inputs, CONSTANT_INPUTS, drives), state.leg_angle, state.leg_angle_rate)


def flight_torque(model, inputs, state, phase, clamp_closed, liftoff_angle):
    """Under the law of flight  (12), with the inputs held."""
    law = flight(model, inputs, CONSTANT_INPUTS, phase, clamp_closed, liftoff_angle, state.hip_place_time)
    return torque(law, state.leg_angle, state.leg_angle_rate)
