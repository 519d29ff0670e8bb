"Cameras and gimbals for MAVLink, in Python."
# Written by .ci/stubs.py from the live classes: do not edit.
import os as os
