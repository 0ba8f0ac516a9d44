"""The unit TDMF_SLIP.fmu: its variables, parameter files, and runs of it through FMPy."""
