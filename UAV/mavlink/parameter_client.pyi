"List a camera's settings in words, set one, and follow what others set; on a bad radio, too."
# Written by .ci/stubs.py from the live classes: do not edit.

async def fetch(url: str, timeout: float = 30.0) -> bytes:
    """What a web server has there, `most_bytes` of it at most; raises `ValueError`, `NoAnswer`

    Args:
        url: http:// or https://
        timeout: Seconds
    """

__all__ = ['fetch']
