"""The runner with a proportional-derivative law of the hip in stance."""

from tdmf_slip.hybrid import parameter, radians
from tdmf_slip.pages import PlainRunner


class PdRunner(PlainRunner):
    """The hip swings the leg back in stance by gains, besides the torque of (11).

    In stance (11) drives the leg with a constant torque up to mid-stance. Here two gains are added to it, as
    the hip has them in flight (12): tau = tau(11) - k (theta - theta_s) - d thetadot. A law is one function:
    slip, lift-off, works and all derivatives follow from it.
    """

    prefix = "hip"
    stance_kp = parameter(0.05, "N.m/rad", "Proportional gain of the hip in stance, k", least=0, most=1e18)
    stance_kd = parameter(0.02, "N.m.s/rad", "Derivative gain of the hip in stance, d", least=0, most=1e18)
    stance_target = parameter(
        -radians(20), "rad", "Target of the leg angle in stance, theta_s",
        least=-radians(90), most=radians(90))

    def stance_torque(r):
        """Torque of (11), and that of the gains."""
        leg = r.leg()
        servo = -r.stance_kp * (leg.angle - r.stance_target) - r.stance_kd * leg.angle_rate
        return super().stance_torque() + servo
