"""Programs for a shell: a room for each."""
