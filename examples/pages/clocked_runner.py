"""A runner whose hip follows a clock in stance, and whose foot is placed by Raibert's law."""

from math import pi

from tdmf_slip.hybrid import atan2, event, parameter, select, sin, sqrt, state
from tdmf_slip.pages import PlainRunner


class ClockedRunner(PlainRunner):
    """Runner whose hip torque in stance follows a clock, and whose leg in flight aims at Raibert's point.

    Clock: tau = -tau0 sin(pi t/T) for the time T after touchdown, then 0, in place of (11). The hip needs no
    sensor of the leg angle. Legs like those of RHex are driven by such a clock (Seipel and Holmes 2007).

    Foot placement (Raibert 1986, chapter 2): at an apex with the speed v the foot aims at the distance
    v T_s/2 + k (v - v_d) ahead of the body. The first term alone keeps the speed, the second one corrects it.
    """

    prefix = "hip"
    pulse = parameter(1, "s", "Time after touchdown for which the hip drives, T", above=0, most=1e9)
    placing_time = parameter(1.1, "s", "Expected duration of a stance, T_s", least=0, most=1e9)
    placing_gain = parameter(0.3, "s", "Gain of the touchdown law, k", least=-1e9, most=1e9)
    speed_wanted = parameter(0.95, "m/s", "Desired speed, v_d", least=-1e9, most=1e9)

    aim = state(0, "rad", "Target of the leg angle before touchdown")

    def stance_torque(r):
        """A half wave of the torque, which begins at touchdown."""
        wave = sin(pi / r.pulse * (r.time - r.touchdown_time))
        return r.external_torque - r.driving * r.drive_torque * wave

    def land(r, was_placed):
        """Drive begins at every touchdown, whatever the leg angle."""
        return super().land(was_placed).replace(driving=1)

    @event("stick slip graze", when=lambda r: r.pulse - (r.time - r.touchdown_time), unit="s",
           only=lambda r: r.driving > 0)
    def mid_stance(r):
        """Drive ends by the clock."""
        return r.replace(driving=0)

    def begins(r):
        """Aim the leg at the start of a run."""
        return super().begins().aimed()

    def open_stride(r):
        """Aim the leg at each apex."""
        return super().open_stride().aimed()

    def aimed(r):
        """Aim the leg so that its foot lands at Raibert's distance; at most 60 degrees."""
        speed, most = r.center().vx, sin(pi / 3)
        share = (speed * r.placing_time / 2 + r.placing_gain * (speed - r.speed_wanted)) / r.free_length
        share = select(share < most, select(share > -most, share, -most), most)
        return r.replace(aim=atan2(share, sqrt(1 - share * share)))

    def placing_angle(r):
        """Raibert's target in (12)."""
        return r.aim
