"""Products of enclosed derivatives: they hold the true ones, and do not widen at each turn."""

import numpy as np
import pytest

pytest.importorskip("flint")

from flint import arb, arb_mat, ctx
from tdmf_slip.proof.travelling_set import Spread

BITS, FACTORS, SIZE, RADIUS = 256, 90, 3, 1e-6
RNG = np.random.default_rng(27)


def turns():
    """Rotations, seen in axes that are not of one length: each product of absolute values grows."""
    stretch = np.diag([1.0, 3.0, 0.4])
    for _ in range(FACTORS):
        turn, _ = np.linalg.qr(RNG.standard_normal((SIZE, SIZE)))
        yield stretch @ turn @ np.linalg.inv(stretch)


def balls(matrix):
    return arb_mat(SIZE, SIZE, [arb(float(x), RADIUS) for x in matrix.ravel()])


@pytest.fixture(scope="module")
def followed():
    """A product as it is enclosed, the same one factor after the other, and true ones."""
    with ctx.workprec(BITS):
        first = arb_mat(SIZE, SIZE, [int(i == j) for i in range(SIZE) for j in range(SIZE)])
        spread, plain, middles = Spread(first), first, list(turns())
        for k, middle in enumerate(middles):
            spread.follow(balls(middle), is_event=k == FACTORS - 1)
            plain = balls(middle) * plain
        members = []
        for _ in range(20):
            true = first
            for middle in middles:
                off = RADIUS * RNG.choice([-1.0, 1.0], (SIZE, SIZE))
                inside = [
                    arb(float(x)) + arb(float(y)) for x, y in zip(middle.ravel(), off.ravel(), strict=True)
                ]
                true = arb_mat(SIZE, SIZE, inside) * true
            members.append(true)
        return spread.product, plain, members


def test_every_product_of_members_is_enclosed(followed):
    product, _, members = followed
    for true in members:
        assert all(ball.contains(x) for ball, x in zip(product.entries(), true.entries(), strict=True))
