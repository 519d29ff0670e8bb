"Does a camera keep to the protocol? Requirements, a peer that asks, verdicts and reports."
# Written by .ci/stubs.py from the live classes: do not edit.
