"""What ends a command without a traceback: what the user gave, or the machine it runs on, is at fault."""


class FaultError(Exception):
    """Base of all errors that are told to the user as they stand: each line is clear by itself (DESIGN 8, exit 1)."""
