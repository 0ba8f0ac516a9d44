"""What a terminal shows and sends: tables of text, progress, interrupts from the keyboard."""
