"""The unit TDMF_SLIP.fmu: its variables, parameter files, the apex section, and runs of it through FMPy."""
