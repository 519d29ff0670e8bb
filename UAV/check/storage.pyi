"STORAGE_INFORMATION says what is true, and formatting and resetting do what they should; they are tried only when you allow it."
# Written by .ci/stubs.py from the live classes: do not edit.


__all__ = []
