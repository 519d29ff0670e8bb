"""Does a camera keep to the protocol? Requirements, a peer that asks, verdicts and reports."""
