"""What the GUI shows of illustrations."""
