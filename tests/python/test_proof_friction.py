"""Proofs of gaits whose friction falls with speed, against an independent program's, good to 1e-14."""

import numpy as np
import pytest
import tdmf_slip
from conftest import CLAMPED, some_of
from tdmf_slip.errors import TdmfSlipError
from tdmf_slip.library.fixed_point import gait_near

pytest.importorskip("flint")

GAITS = {
    "+0-0+": (
        {"ground.friction": 0.6, "ground.static_friction_ratio": 1.5, "ground.stribeck_velocity": 0.1},
        [1.40972356670522, 1.066448103318236, 1.0043163487103521, 1.257381267179432, 1.1607305467725332e-06,
         0.21744777438228968],
        {"period": 24.826469500192452, "speed": 1.0653154905798374, "slip_distance": 0.21589019070489787,
         "work": 0.10729014401592044, "stance_time": 1.1020728233451413},
        [0.8564188307212651, -0.3804347226179455, 0.008377243594855532, 0, 0, 0],
    ),
    "+-": (
        {"ground.friction": 0.1, "ground.static_friction_ratio": 1.5, "ground.stribeck_velocity": 0.3},
        [1.655039728245558, 0.7684465628165357, 1.0061843177001462, 2.1512898516854717,
         1.7489271864933785e-07, 0.26002010601818293],
        {"period": 28.840539637494143, "speed": 0.7681458351930202, "slip_distance": 0.41466266050696066,
         "work": 0.09671078769808303, "stance_time": 1.2336225110950159},
        [0.9390909516524336, -0.12800089740681778, -0.01395531083895521, -5.523203561596028e-08, 0, 0],
    ),
}  # fmt: skip
"""By word: start values, apex, quantities of the stride, eigenvalues."""


@pytest.mark.parametrize("word", some_of(GAITS, 1))
def test_a_gait_under_falling_friction_is_proved_with_the_values_of_another_program(word):
    given, apex, quantities, eigenvalues = GAITS[word]
    proof = tdmf_slip.prove(gait_near(tdmf_slip.Runner(given | CLAMPED), apex), digits=13)
    assert proof.proved, proof.sentence
    assert (proof.word, proof.stable) == (word, True)
    for ball, value in zip(proof.apex, apex, strict=True):
        assert abs(float(ball) - value) < 1e-13
    for name, value in quantities.items():
        assert abs(float(proof.quantities[name]) - value) < 1e-13 * max(1.0, value), name
    for ball, value in zip(proof.eigenvalues, eigenvalues, strict=True):
        assert abs(float(ball.real) - value) < 1e-9
    assert "ground.stribeck_velocity" in proof.sentence


def test_a_range_of_the_speed_at_which_friction_falls_is_proved():
    given, apex, _, _ = GAITS["+-"]
    gait = gait_near(tdmf_slip.Runner(given | CLAMPED), apex)
    proof = tdmf_slip.prove(gait, vary={"ground.stribeck_velocity": ("0.3", "0.3000004")})
    assert proof.proved, proof.sentence
    assert proof.words == ("+-",)
    assert proof.stable
    centre = np.array(proof.subintervals[0].centre)
    assert np.allclose(centre, apex, atol=1e-5)


def test_a_patch_is_refused_by_name():
    with pytest.raises(TdmfSlipError, match=r"ground\.patch"):
        tdmf_slip.prove({"ground.friction": "0.6", "ground.patch_begin": "1", "ground.patch_end": "2"})
