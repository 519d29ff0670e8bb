"""Take a picture with each of three cameras, fetch them, and write a map of where they were taken: `pictures/map.geojson`.

In one terminal:  for n in 100 101 102; do uav-camera-server --component $n --folder camera$n --rtsp 0 & done; wait
In another one:   python map_pictures.py            (then drop the file on geojson.io, or open it in QGIS)
"""
import asyncio, json
from pathlib import Path

from UAV.mavlink import MAVCom
from UAV.mavlink.camera_client import Picture, RemoteCamera
from UAV.script import run

FOLDER = Path('pictures')


def feature(camera: RemoteCamera, picture: Picture) -> dict:
    "A point of GeoJSON, which has the longitude first"
    facts = dict(camera=camera.name, component=camera.component, file=str(picture.path), time=str(picture.time))
    place = dict(type='Point', coordinates=[picture.lon, picture.lat, picture.alt])
    return dict(type='Feature', geometry=place, properties=facts)


async def main(connection: str = 'udpin:127.0.0.1:14550', count: str = '3') -> None:
    with MAVCom(connection, source_system=255) as ground:
        cameras = await ground.find_cameras(count=int(count), timeout=10)
        print(f'found {len(cameras)} cameras of {count}')
        shots = (camera.take_picture(to=FOLDER/str(camera.component)) for camera in cameras)
        results = await asyncio.gather(*shots, return_exceptions=True)
        features = []
        for camera, picture in zip(cameras, results):
            print(f'{camera.component}: {picture}')
            if isinstance(picture, Picture) and picture.lat is not None: features.append(feature(camera, picture))
        (FOLDER/'map.geojson').write_text(json.dumps(dict(type='FeatureCollection', features=features), indent=1))
        print(f'{len(features)} places are in {FOLDER/"map.geojson"}')


if __name__ == '__main__': run(main)
