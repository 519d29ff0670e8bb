"""A web service: `POST /picture` takes a picture with a camera of the vehicle, and answers with the JPEG.

pip install fastapi uvicorn
In one terminal:  uav-camera-server
In another one:   python picture_api.py;  in a third one:  curl -X POST -o picture.jpg localhost:8000/picture
"""
from contextlib import asynccontextmanager
from collections.abc import AsyncIterator

from fastapi import FastAPI, HTTPException, Response
from UAV import CommandError, MAVError, NoAnswer
from UAV.blocking import MAVCom


def service(connection: str) -> FastAPI:
    "A web service for the camera on this link, which is open as long as the service runs"
    @asynccontextmanager
    async def running(app: FastAPI) -> AsyncIterator[None]:
        with MAVCom(connection, source_system=255) as app.state.ground: yield

    app = FastAPI(lifespan=running)

    @app.post('/picture')
    def picture(name: str | None = None) -> Response:       # `def`: FastAPI runs it in a thread, and here we may wait
        try: taken = app.state.ground.find_camera(name=name).take_picture()
        except NoAnswer as e: raise HTTPException(504, str(e))
        except CommandError as e: raise HTTPException(409, str(e))
        except MAVError as e: raise HTTPException(502, str(e))
        place = '' if taken.lat is None else f'{taken.lat:.7f},{taken.lon:.7f}'
        return Response(taken.data, media_type='image/jpeg', headers={'X-Picture': str(taken.index), 'X-Place': place})

    return app


def main(connection: str = 'udpin:127.0.0.1:14550', port: str = '8000') -> None:
    import uvicorn
    uvicorn.run(service(connection), port=int(port))


if __name__ == '__main__':
    from UAV.script import run
    run(main)
