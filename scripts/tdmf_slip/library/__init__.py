"""The C library: its functions and structs, a runner's parameters, gaits, ensembles, and the classic SLIP."""
