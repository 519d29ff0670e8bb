"""Gimbals: they point cameras, and have never heard of MAVLink."""
from UAV.gimbals.values import (Axis, GimbalAttitude, GimbalError, GimbalInformation, HeadingUnknown, PositionUnknown, Setpoint, VehicleState)
from UAV.gimbals.gimbal import Gimbal
from UAV.gimbals.contract import check_gimbal
from UAV.gimbals.vehicle import SimVehicle, circle, hover, line, strips
from UAV.gimbals.region import Location, RegionOfInterest, direction
from UAV.gimbals.sim import SimGimbal
from UAV.gimbals import viewsheen_camera       # the class grows in a later room
from UAV.gimbals.viewsheen import Viewsheen, ViewsheenSetup
from UAV.gimbals.viewsheen_simulator import ViewsheenSimulator
