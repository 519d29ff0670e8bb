"""`examples/map_pictures.py`, written with pymavlink: one camera after the other."""
import json, sys
from datetime import datetime, timezone
from pathlib import Path

from pymavlink_station import Station, mav

FOLDER = Path('pictures')


def feature(name, to, shot, file):
    facts = dict(camera=name, component=to[1], file=str(file), time=str(datetime.fromtimestamp(shot.time_utc/1e6, timezone.utc)))
    return dict(type='Feature', geometry=dict(type='Point', coordinates=[shot.lon/1e7, shot.lat/1e7, shot.alt/1e3]), properties=facts)


def main(connection='udpin:127.0.0.1:14550', count='3'):
    with Station(connection) as station:
        cameras, features = station.find(mav.MAV_TYPE_CAMERA, int(count)), []
        print(f'found {len(cameras)} cameras of {count}')
        for to in cameras:
            try:
                name, shot = station.name(to), station.shoot(to)
                file = station.fetch(to, shot, FOLDER/str(to[1]))
            except (RuntimeError, TimeoutError) as e: print(f'{to[1]}: {e}'); continue
            print(f'{to[1]}: {file}')
            if shot.lat or shot.lon: features.append(feature(name, to, shot, file))
        (FOLDER/'map.geojson').write_text(json.dumps(dict(type='FeatureCollection', features=features), indent=1))
        print(f'{len(features)} places are in {FOLDER/"map.geojson"}')


if __name__ == '__main__': main(*sys.argv[1:])
