"""What the SIYI driver costs at 20 Hz: its process's CPU time, standing and turning. The camera is simulated in another process. See README.md."""
import argparse, json, os, subprocess, sys, time

from trees import HERE, environment

def play():
    "Be the camera, until stdin ends"
    sys.path.insert(0, str(HERE.parent))
    from tests.siyi import SiyiSimulator
    with SiyiSimulator('ZR10', rtsp=False) as sim:
        print(sim.port, flush=True)
        sys.stdin.read()

def measure(seconds:float, do)->float:
    "% of a core, while `do()` is called ten times a second"
    began,used = time.monotonic(),time.process_time()
    while time.monotonic()-began<seconds:
        do()
        time.sleep(.1)
    return round(100*(time.process_time()-used)/(time.monotonic()-began), 2)

def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--seconds', type=float, default=10.)
    parser.add_argument('--sim', action='store_true', help='be the camera')
    typed = parser.parse_args()
    if typed.sim: return play()
    sim = subprocess.Popen([sys.executable, __file__, '--sim'], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment(HERE.parent))
    from UAV.gimbals import VehicleState
    from UAV.gimbals.siyi import Siyi
    from UAV.gimbals.siyi_link import SiyiLink
    state = VehicleState(0., 0., 10., 0., 47., 8., 500., 30., (0.,0.,0.))
    with Siyi(SiyiLink('127.0.0.1', int(sim.stdout.readline()))) as gimbal:
        time.sleep(1)
        found = dict(standing=measure(typed.seconds, lambda: None), with_vehicle=measure(typed.seconds, lambda: gimbal.set_vehicle(state)),
                     turning=measure(typed.seconds, lambda: (gimbal.set_vehicle(state), gimbal.set_rates(yaw=2.))))
    sim.stdin.close()
    sim.wait()
    print(json.dumps(dict(percent_of_a_core=found, load=os.getloadavg()[0]), indent=1))

if __name__=='__main__': main()
