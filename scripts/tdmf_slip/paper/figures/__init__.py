"""The paper's figures, remade, and what it could not show. One module per figure; `catalogue` has all."""
