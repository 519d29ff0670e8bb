"""Gimbals: they point cameras, and have never heard of MAVLink."""
from UAV.gimbals.values import (Axis, GimbalAttitude, GimbalError, GimbalInformation, HeadingUnknown, Setpoint, VehicleState)
from UAV.gimbals.gimbal import Gimbal
from UAV.gimbals.vehicle import SimVehicle, circle, hover, line
from UAV.gimbals.region import Location, PositionUnknown, RegionOfInterest, direction
from UAV.gimbals.sim import SimGimbal
