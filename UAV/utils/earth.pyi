"From latitude and longitude to metres, and from metres to latitude and longitude, on an earth that is flat as far as a camera sees."
# Written by .ci/stubs.py from the live classes: do not edit.

degree: float
polar: float
def moved(lat: float, lon: float, north: float = 0.0, east: float = 0.0) -> tuple:
    """`(lat, lon)` of the place that lies so far from there

    Args:
        lat, lon: Degrees
        north, east: m
    """
def metres(lat: float, lon: float, to_lat: float, to_lon: float) -> tuple:
    """`(north, east)` from here to there, m

    Args:
        lat, lon: Here, degrees
        to_lat, to_lon: There, degrees
    """
def great_circle(lat: float, lon: float, to_lat: float, to_lon: float) -> float:
    """m from here to there

    Args:
        lat, lon: Here, degrees
        to_lat, to_lon: There, degrees
    """
def velocity_here(lat: float, lon: float, to_lat: float, to_lon: float, north: float, east: float) -> tuple:
    """`(north, east)` of a velocity there, as the directions are here

    Args:
        lat, lon: Here, degrees
        to_lat, to_lon: There, degrees
        north, east: A velocity there
    """

__all__ = ['degree', 'polar', 'moved', 'metres', 'great_circle', 'velocity_here']
