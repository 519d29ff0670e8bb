"Digest authentication from both ends: the server sends a random number, and the player proves that it knows the password."
# Written by .ci/stubs.py from the live classes: do not edit.

def auth_fields(header: str) -> dict:
    """Its fields by their names in small letters

    Args:
        header: WWW-Authenticate or Authorization
    """
def hashed(*parts: str, kind: str = 'md5') -> str:
    """A hash of the parts

    Args:
        parts: Joined by colons
        kind: Or 'sha256'
    """
def proof(secret: str, method: str, given: dict, kind: str = 'md5') -> str:
    """The field `response`, with which a player proves that it knows the secret

    Args:
        secret: `hashed(user, realm, password)`
        method: Of the request
        given: The fields of the header: `nonce`, `uri`, and with a `qop` also `nc` and `cnonce`
        kind: Or 'sha256'
    """
def authorization(challenge: str, method: str, url: str, user: str, password: str) -> str:
    """The header Authorization that answers it

    Args:
        challenge: The header WWW-Authenticate
        method: Of the request
        url: Of the request
        user: Who we are
        password: Of that user
    """

class Digest:
    "Checks the password of one user, of which it keeps only a hash; players show the `realm` when they ask for it"
    realm: str
    def __init__(self, user: str, password: str, realm: str = 'UAV') -> None: ...
    def challenge(self, method: str, header: str, nonce: str) -> str:
        """The header WWW-Authenticate of a 401; empty when the request has the right answer to this nonce

        Args:
            method: Of the request
            header: Its header Authorization, or nothing
            nonce: That of its connection
        """

__all__ = ['auth_fields', 'hashed', 'proof', 'authorization', 'Digest']
