"""How well trackers follow the car of the simulated world, and how long a picture takes them: `python benchmarks/tracking.py`.
Six cameras look at it; IoU is what two rectangles share of all that they cover. Prints the table of `42_cameras.follower`."""
import math, os, pathlib, time

import cv2, numpy as np
from UAV.cameras.tracker import Follower
from UAV.cameras.lens import View
from UAV.cameras.sim_world import sim_world
from UAV.gimbals.vehicle import circle
from run import machine, write

world,rate = sim_world(),15

def looking_at(position, target):
    north,east,down = np.subtract(target, position)
    return 0., -math.degrees(math.atan2(down, math.hypot(north, east))), math.degrees(math.atan2(east, north))

def hovers(position, attitude): return lambda t: (position, attitude)

def shaking(t):
    "A gimbal that is late by 0.4 s, and sways"
    place = 10.,10.,-40.
    _,pitch,yaw = looking_at(place, (*world.car(t-.4)[:2],0))
    return place,(2*math.sin(t), pitch+1.5*math.sin(2*t), yaw+2*math.sin(1.3*t))

def circling(t):
    "An aircraft that flies its own circle, with a gimbal that is late by 0.3 s"
    north,east,up = circle(radius=40, speed=5, altitude=40)(t)
    return (north,east,-up),looking_at((north,east,-up), (*world.car(t-.3)[:2],0))

cameras = {'beside': (hovers((80,0,-30.), (0,-40,180.)), 50., -4., 14), 'crossing': (hovers((0,0,-30.), (0,-32,0.)), 59.5, -3.5, 12),
           'above': (hovers((30,30,-60.), (0,-80,45.)), 59.5, 6., 14), 'far': (hovers((-60,0,-40.), (0,-18,0.)), 59.5, -4., 12),
           'shaking': (shaking, 35., 0., 14), 'circling': (circling, 50., 0., 16)}     # where, degrees, from when, s

def truth(view, t):
    pixels,depths = view.project(np.concatenate([face for face,_ in world._car_faces(t)]))
    return (*pixels.min(0), *pixels.max(0))

def inside(box): return box[0]>2 and box[1]>2 and box[2]<637 and box[3]<477

def pictures(name):
    "(picture, true rectangle), as long as all of the car is in the picture"
    where,fov,start,seconds = cameras[name]
    found = []
    for n in range(seconds*rate):
        t = start+n/rate
        view = View((640,480), fov, *where(t))
        box = truth(view, t)
        if inside(box): found.append((world.render(view, t), box))
        elif len(found)>20: break
        else: found = []
    return found

def iou(a, b):
    wide,high = min(a[2], b[2])-max(a[0], b[0]),min(a[3], b[3])-max(a[1], b[1])
    shared = max(0, wide)*max(0, high)
    return shared/((a[2]-a[0])*(a[3]-a[1])+(b[2]-b[0])*(b[3]-b[1])-shared)

def mil(image, box):
    tracker = (getattr(cv2.TrackerMIL, 'create', None) or cv2.TrackerMIL_create)()
    tracker.init(image, (*map(int, box[:2]), int(box[2]-box[0]), int(box[3]-box[1])))
    def step(image):
        x,y,width,height = tracker.update(image)[1]
        return x,y,x+width,y+height
    return step

def flow(image, box):
    "Corners inside, there and back; their median, and the change of their distances"
    state = dict(grey=cv2.cvtColor(image, cv2.COLOR_BGR2GRAY), box=np.array(box, float))
    def step(image):
        before,grey = state['grey'],cv2.cvtColor(image, cv2.COLOR_BGR2GRAY)
        state['grey'] = grey
        left,top,right,bottom = state['box']
        mask = np.zeros_like(grey)
        mask[max(0,int(top)):int(bottom)+1,max(0,int(left)):int(right)+1] = 255
        points = cv2.goodFeaturesToTrack(before, 60, .01, 3, mask=mask)
        if points is None: return tuple(state['box'])
        how = dict(winSize=(11,11), maxLevel=3)
        there,ok,_ = cv2.calcOpticalFlowPyrLK(before, grey, points, None, **how)
        back,ok2,_ = cv2.calcOpticalFlowPyrLK(grey, before, there, None, **how)
        good = (ok.ravel()>0) & (ok2.ravel()>0) & (np.linalg.norm(points-back, axis=2).ravel()<1)
        if good.sum()<4: return tuple(state['box'])
        p,q = points[good][:,0],there[good][:,0]
        i,j = np.triu_indices(len(p), 1)
        was,now = np.linalg.norm(p[i]-p[j], axis=1),np.linalg.norm(q[i]-q[j], axis=1)
        growth = np.median(now[was>3]/was[was>3]) if (was>3).any() else 1.
        middle,half = np.array([left+right,top+bottom])/2+np.median(q-p, 0),np.array([right-left,bottom-top])*growth/2
        state['box'] = np.concatenate([middle-half, middle+half])
        return tuple(state['box'])
    return step

def camshift(image, box):
    def likely(image):
        hsv = cv2.cvtColor(image, cv2.COLOR_BGR2HSV)
        return hsv,cv2.inRange(hsv, (0,60,32), (180,255,255))
    left,top,right,bottom = map(int, box)
    hsv,mask = likely(image)
    counts = cv2.calcHist([hsv[top:bottom,left:right]], [0], mask[top:bottom,left:right], [32], [0,180])
    cv2.normalize(counts, counts, 0, 255, cv2.NORM_MINMAX)
    window = [(left,top,right-left,bottom-top)]
    def step(image):
        hsv,mask = likely(image)
        back = cv2.calcBackProject([hsv], [0], counts, [0,180], 1) & mask
        turned,window[0] = cv2.CamShift(back, window[0], (cv2.TERM_CRITERIA_EPS|cv2.TERM_CRITERIA_COUNT, 10, 1))
        points = cv2.boxPoints(turned)
        return (*points.min(0), *points.max(0))
    return step

def ours(image, box, **how):
    follower = Follower(image, box)
    if how.get('shape_only'): follower.fit = lambda image: False
    def step(image):
        follower.follow(image)
        return (0,0,.01,.01) if follower.lost else follower.box
    return step

trackers = {'TrackerMIL':mil, 'optical flow':flow, 'CamShift':camshift, 'correlation filter':lambda i,b: ours(i, b, shape_only=True),
            'filter and colours':ours}

def measure(make, shown):
    step,good,times = make(*shown[0]),[],[]
    for image,box in shown[1:]:
        start = time.thread_time()
        found = step(image)
        times.append(1e3*(time.thread_time()-start))
        good.append(iou(found, box))
    return float(np.mean(good)),float(np.mean(np.array(good)>.5)),float(np.median(times))

if __name__=='__main__':
    cv2.setNumThreads(1)
    results,load = {name:{} for name in trackers},os.getloadavg()
    for camera in cameras:
        shown = pictures(camera)
        for name,make in trackers.items(): results[name][camera] = measure(make, shown)
    print('| tracker |', ' | '.join(cameras), '| found | ms |\n|---|'+'---|'*(len(cameras)+2))
    for name,row in results.items():
        means = [f'{mean:.2f}' for mean,_,_ in row.values()]
        print(f'| {name} |', ' | '.join(means), f'| {np.mean([f for _,f,_ in row.values()]):.0%} | {np.median([ms for *_,ms in row.values()]):.1f} |')
    rows = [dict(tracker=name, camera=camera, overlap=round(mean, 3), found=round(found, 3), ms=round(ms, 2))
            for name,row in results.items() for camera,(mean,found,ms) in row.items()]
    write(pathlib.Path(__file__).with_suffix('.json'), dict(machine=machine(), load_at_start=load, load_at_end=os.getloadavg(), rows=rows))
