"""The benchmark: this project's solvers and ensemble engine against their peers, on the same strides."""
