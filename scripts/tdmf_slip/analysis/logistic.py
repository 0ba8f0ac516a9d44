"""Logistic regression with a ridge, by Newton's method."""

import numpy as np
from numpy.typing import NDArray

RIDGE, ITERATIONS = 1e-3, 25


def logistic_weights(features: NDArray[np.float64], falls: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Intercept and weights by which the odds of an event are told from features."""
    rows = np.concatenate([np.ones((len(features), 1)), features], axis=1)
    weights = np.zeros(rows.shape[1])
    ridge = RIDGE * len(rows) * np.eye(rows.shape[1])
    for _ in range(ITERATIONS):
        chance = 1.0 / (1.0 + np.exp(-np.clip(rows @ weights, -30.0, 30.0)))
        slope = rows.T @ (falls - chance) - ridge @ weights
        bend = (rows * (chance * (1.0 - chance))[:, None]).T @ rows + ridge
        step = np.linalg.solve(bend, slope)
        weights += step
        if np.max(np.abs(step)) < 1e-8:
            break
    return weights
