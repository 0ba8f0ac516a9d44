"""The laws of the model, once: a page a topic, over any number type."""
