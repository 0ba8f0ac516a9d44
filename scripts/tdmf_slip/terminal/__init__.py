"""Terminal: tables of text, progress, interrupts from the keyboard."""
