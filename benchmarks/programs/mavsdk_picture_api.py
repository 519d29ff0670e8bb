"""`examples/picture_api.py`, written with MAVSDK."""
import queue, sys, tempfile, threading
from contextlib import asynccontextmanager
from pathlib import Path

from fastapi import FastAPI, HTTPException, Response
from mavsdk.plugins.camera import CameraError
from mavsdk_station import Station


def service(connection):
    @asynccontextmanager
    async def running(app):
        with Station(connection) as app.state.station: yield

    app, lock = FastAPI(lifespan=running), threading.Lock()         # MAVSDK fetches one file at a time

    @app.post('/picture')
    def picture(name: str = ''):
        station = app.state.station
        with lock, tempfile.TemporaryDirectory() as folder:
            cameras = [c for c in station.cameras(1, 5) if name in f'{c.vendor_name} {c.model_name}']
            if not cameras: raise HTTPException(504, f'no camera {name}')
            try:
                shot = station.shoot(cameras[0].component_id)
                file = station.fetch(cameras[0].component_id, shot, Path(folder))
            except CameraError as e: raise HTTPException(409, str(e))
            except (RuntimeError, queue.Empty) as e: raise HTTPException(502, str(e) or 'no notice')
            place = f'{shot.position.latitude_deg:.7f},{shot.position.longitude_deg:.7f}'
            return Response(file.read_bytes(), media_type='image/jpeg', headers={'X-Picture': str(shot.index), 'X-Place': place})

    return app


def main(connection='udpin://127.0.0.1:14550', port='8000'):
    import uvicorn
    uvicorn.run(service(connection), port=int(port))


if __name__ == '__main__': main(*sys.argv[1:])
