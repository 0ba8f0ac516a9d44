"""The command `tdmf-slip`: one module per command, thin over the package's functions."""
