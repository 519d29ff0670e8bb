"""What a recording costs the processor beside its encoding: `python benchmarks/recording.py [--rounds 7] [--quick]`.

The same 20 s of encoded pictures (1280×720, 15 a second, 1.9 Mbit/s) are written by each, in turn, in one process:

* plain: PyAV's own MP4 muxer in a loop, fragmented as ours: the floor
* mp4: our recorder, of pictures of which nothing is known, so without subtitles
* mp4+srt: with metadata, so with a cue for each
* ts+srt: MPEG-TS with a KLV set and a cue for each

µs of the processor (user and system, all threads) a picture, the size of all files, and the ratios to `plain`; `encode` is what
libx264 takes for one of these pictures. The results go to benchmarks/recording.json."""
import argparse, tempfile, time
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import av, numpy as np
from run import in_turn, machine, write
from trees import HERE

SIZE,RATE,SECONDS = (1280,720),15,20

def encoded(seconds):
    "Units of a moving picture, and the µs of the processor that each took"
    from UAV.video.units import Codec, sensible_bitrate, VideoFormat
    noise = np.random.default_rng(1).integers(0, 255, (SIZE[1]//8,SIZE[0]//8+600,3), np.uint8).repeat(8, 0).repeat(8, 1)
    codec = Codec('libx264', VideoFormat('h264', *SIZE, RATE, sensible_bitrate(*SIZE, RATE)))
    frames = [SimpleNamespace(image=np.ascontiguousarray(noise[:,4*n:4*n+SIZE[0]]), number=n, time_utc=1.7e9+n/RATE) for n in range(seconds*RATE)]
    begun = time.process_time()
    units = [unit for n,frame in enumerate(frames) for unit in codec.encode(frame, n/RATE, key=n%RATE==0)]
    return units,(time.process_time()-begun)/len(units)*1e6

def flown(units):
    "The same, with what a camera knows"
    from UAV.utils.pose import Pose
    from UAV.video.klv import FrameMetadata
    start = Pose(-35.3632, 149.1652, 614., 30., 0., -45., 90.)
    return [replace(u, metadata=FrameMetadata.seen(start.moved(east=u.number/3), u.time_utc, (60.,36.)), tags=dict(ExposureTime=.002, ISOSpeedRatings=100))
            for u in units]

def plain(units, path):
    from UAV.video.recorder import _MP4File
    from UAV.video.senders import _add_video, _as_packet
    with av.open(str(path), 'w', options=dict(movflags=_MP4File.flags, frag_duration='250000')) as film:
        stream = _add_video(film, units[0])
        for n,unit in enumerate(units): film.mux(_as_packet(unit, stream, n*6000, n*6000, 6000))

def ours(units, path):
    from UAV.video.recorder import Recorder
    with Recorder(lambda n: path) as recorder:
        for unit in units:
            while len(recorder._queue)>200: time.sleep(.001)
            recorder.put(unit)
    assert recorder.fault is None and recorder.dropped==0, recorder

def measured(kind):
    write_it,units,suffix = kind
    with tempfile.TemporaryDirectory() as folder:
        begun = time.process_time()
        write_it(units, Path(folder)/f'film.{suffix}')
        spent = (time.process_time()-begun)/len(units)*1e6
        return dict(us=spent, kB=sum(file.stat().st_size for file in Path(folder).iterdir())/1e3)

def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--rounds', type=int, default=7)
    parser.add_argument('--quick', action='store_true', help='two rounds of 4 s, to see that it works; nothing is written')
    typed = parser.parse_args()
    units,encoding = encoded(4 if typed.quick else SECONDS)
    unknown,known = [replace(unit, time_utc=0.) for unit in units],flown(units)
    _ = [unit.metadata.data for unit in known]      # made once for all who send it: `klv` below
    kinds = {'plain':(plain, unknown, 'mp4'), 'mp4':(ours, unknown, 'mp4'), 'mp4+srt':(ours, known, 'mp4'), 'ts+srt':(ours, known, 'ts')}
    rounds = in_turn(kinds, 2 if typed.quick else typed.rounds, measured)
    begun = time.process_time()
    for unit in known: unit.metadata.encode()
    klv = (time.process_time()-begun)/len(known)*1e6
    found = {}
    for name,results in rounds.items():
        us,kB = (float(np.median([one[what] for one in results])) for what in ('us','kB'))
        times = float(np.median([one['us']/floor['us'] for one,floor in zip(results, rounds['plain'])]))
        found[name] = dict(us=round(us, 1), times_plain=round(times, 2), of_encoding=round(us/encoding, 4), kB=round(kB, 1))
        print(f'{name:8} {us:7.1f} µs a picture, {times:5.2f} times plain, {us/encoding:6.2%} of encoding, {kB:.0f} kB')
    print(f'encode   {encoding:7.1f} µs a picture; a KLV set {klv:.1f} µs')
    if not typed.quick: write(HERE/'recording.json', dict(machine=machine(), encode=round(encoding, 1), klv=round(klv, 1), recording=found))

if __name__ == '__main__': main()
