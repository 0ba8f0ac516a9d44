"""Results on file: written whole or not at all, and gone on with where they are not complete."""
