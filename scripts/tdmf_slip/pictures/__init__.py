"""Pictures: the paper's figures of single gaits, one stride, the model. One module per picture."""
