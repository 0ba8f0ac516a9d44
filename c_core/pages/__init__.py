"""Pages of equations: each is a model, from which C is derived by the language in c_core/hybrid."""
