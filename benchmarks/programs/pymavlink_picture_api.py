"""`examples/picture_api.py`, written with pymavlink."""
import sys, tempfile, threading
from contextlib import asynccontextmanager
from pathlib import Path

from fastapi import FastAPI, HTTPException, Response
from pymavlink_station import Refused, Station, mav


def service(connection):
    @asynccontextmanager
    async def running(app):
        with Station(connection) as app.state.station: yield

    app, lock = FastAPI(lifespan=running), threading.Lock()         # one reader at a time

    @app.post('/picture')
    def picture(name: str = ''):
        station = app.state.station
        with lock, tempfile.TemporaryDirectory() as folder:
            try:
                cameras = [to for to in station.find(mav.MAV_TYPE_CAMERA, 1, 5) if name in station.name(to)]
                if not cameras: raise HTTPException(504, f'no camera {name}')
                shot = station.shoot(cameras[0])
                file = station.fetch(cameras[0], shot, Path(folder))
            except Refused as e: raise HTTPException(409, str(e))
            except TimeoutError as e: raise HTTPException(504, str(e))
            except RuntimeError as e: raise HTTPException(502, str(e))
            place = f'{shot.lat/1e7:.7f},{shot.lon/1e7:.7f}' if shot.lat or shot.lon else ''
            return Response(file.read_bytes(), media_type='image/jpeg', headers={'X-Picture': str(shot.image_index), 'X-Place': place})

    return app


def main(connection='udpin:127.0.0.1:14550', port='8000'):
    import uvicorn
    uvicorn.run(service(connection), port=int(port))


if __name__ == '__main__': main(*sys.argv[1:])
