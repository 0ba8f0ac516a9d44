"""Pictures of runs, strides, maps and the model, and the style that all of them share."""
