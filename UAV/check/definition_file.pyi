"Fetch a camera's definition file, unpack it, and read it as strictly as the ground stations do."
# Written by .ci/stubs.py from the live classes: do not edit.
from typing import Any

def unpacked(content: bytes, most: int = ...) -> bytes:
    "A definition file without its compression; raises `ValueError`"
def definition_tree(content: bytes) -> Any:
    "The XML in a definition file; raises `ValueError`"
value_kinds: dict
def text_value(kind: str, text: str) -> Any:
    "A value of the file as a number (`bytes` for custom); raises `ValueError`"

__all__ = ['value_kinds', 'unpacked', 'definition_tree', 'text_value']
