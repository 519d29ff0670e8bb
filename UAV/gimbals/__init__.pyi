"Gimbals: they point cameras, and have never heard of MAVLink."
# Written by .ci/stubs.py from the live classes: do not edit.
from UAV.gimbals import viewsheen_camera as viewsheen_camera
from UAV.gimbals.contract import check_gimbal as check_gimbal
from UAV.gimbals.gimbal import Gimbal as Gimbal
from UAV.gimbals.region import Location as Location, RegionOfInterest as RegionOfInterest, direction as direction
from UAV.gimbals.sim import SimGimbal as SimGimbal
from UAV.gimbals.values import (
    Axis as Axis, GimbalAttitude as GimbalAttitude, GimbalError as GimbalError, GimbalInformation as GimbalInformation,
    HeadingUnknown as HeadingUnknown, PositionUnknown as PositionUnknown, Setpoint as Setpoint,
    VehicleState as VehicleState,
)
from UAV.gimbals.vehicle import (
    SimVehicle as SimVehicle, circle as circle, hover as hover, line as line, strips as strips,
)
from UAV.gimbals.viewsheen import Viewsheen as Viewsheen, ViewsheenSetup as ViewsheenSetup
from UAV.gimbals.viewsheen_simulator import ViewsheenSimulator as ViewsheenSimulator
