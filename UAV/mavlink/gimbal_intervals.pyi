"Change how often a gimbal sends its attitude and its status: more often, less often, or not at all."
# Written by .ci/stubs.py from the live classes: do not edit.

usual: dict
to_asker: int

__all__ = ['usual', 'to_asker']
