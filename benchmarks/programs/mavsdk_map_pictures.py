"""`examples/map_pictures.py`, written with MAVSDK."""
import json, sys
from concurrent.futures import ThreadPoolExecutor
from datetime import datetime, timezone
from pathlib import Path

from mavsdk_station import Station

FOLDER = Path('pictures')


def feature(camera, shot, file):
    facts = dict(camera=f'{camera.vendor_name} {camera.model_name}', component=camera.component_id, file=str(file),
                 time=str(datetime.fromtimestamp(shot.time_utc_us/1e6, timezone.utc)))
    at = shot.position
    return dict(type='Feature', properties=facts,
                geometry=dict(type='Point', coordinates=[at.longitude_deg, at.latitude_deg, at.absolute_altitude_m]))


def main(connection='udpin://127.0.0.1:14550', count='3'):
    with Station(connection) as station, ThreadPoolExecutor() as pool:
        cameras, features = station.cameras(int(count)), []
        print(f'found {len(cameras)} cameras of {count}')
        asked = [pool.submit(station.shoot, camera.component_id) for camera in cameras]
        for camera, future in zip(cameras, asked):
            try:
                shot = future.result()
                file = station.fetch(camera.component_id, shot, FOLDER/str(camera.component_id))
            except Exception as e: print(f'{camera.component_id}: {e}'); continue
            print(f'{camera.component_id}: {file}')
            features.append(feature(camera, shot, file))
        (FOLDER/'map.geojson').write_text(json.dumps(dict(type='FeatureCollection', features=features), indent=1))
        print(f'{len(features)} places are in {FOLDER/"map.geojson"}')


if __name__ == '__main__': main(*sys.argv[1:])
