"""Draws triangles and tubes off-screen, in a process of its own: run by `render.Renderer`, needs nothing of YADE.

Jobs come in by standard input, pickled one after the other, pictures go out by standard output: arrays (height, width, 3) of bytes. A failure of the
graphics library so never takes a computation with it.
"""
from __future__ import annotations

import os
import pickle
import sys
from collections.abc import Mapping
from typing import Any

import numpy as np
import pyvista

# Direction seen from the camera (right, up, towards it), and strength.
LIGHTS = (((-0.5, 0.55, 1.0), 0.85), ((0.9, 0.1, 0.6), 0.28), ((0.0, -0.6, 0.4), 0.12))


def draw(job: Mapping[str, Any]) -> Any:
    """The picture of a job: {'size', 'camera', 'background', 'pieces'}, see `render`."""
    plotter = pyvista.Plotter(off_screen=True, window_size=job['size'], lighting='none')
    plotter.background_color = job['background']
    for piece in job['pieces']:
        plotter.add_mesh(_mesh(piece), **_colour(piece), opacity=piece.get('opacity', 1.0), smooth_shading=True, ambient=0.3, diffuse=0.8,
                         specular=piece.get('specular', 0.15), specular_power=25, show_scalar_bar=False)
    _look(plotter, **job['camera'])
    plotter.enable_anti_aliasing('ssaa')
    if any(piece.get('opacity', 1.0) < 1 for piece in job['pieces']):
        plotter.enable_depth_peeling(6)
    picture = plotter.screenshot(return_img=True)
    plotter.close()
    return np.ascontiguousarray(picture[..., :3])


def _mesh(piece: Mapping[str, Any]) -> Any:
    """PolyData of triangles with their normals, or of tubes of their own radius each."""
    corners = piece['triangles'] if 'triangles' in piece else piece['lines']
    cells = np.insert(corners, 0, corners.shape[1], axis=1).ravel()
    if 'triangles' in piece:
        mesh = pyvista.PolyData(np.asarray(piece['points'], dtype='f4'), faces=cells)
        mesh.point_data['Normals'] = np.asarray(piece['normals'], dtype='f4')
        mesh.GetPointData().SetActiveNormals('Normals')
        point, normal = piece.get('keep', (None, None))
        return _coloured(mesh if normal is None else mesh.clip(normal=normal, origin=point, invert=False), piece)
    mesh = _coloured(pyvista.PolyData(np.asarray(piece['points'], dtype='f4'), lines=cells), piece)
    mesh.point_data['radius'] = np.asarray(piece['radii'], dtype='f4')
    return mesh.tube(scalars='radius', absolute=True, n_sides=12, capping=True)


def _coloured(mesh: Any, piece: Mapping[str, Any]) -> Any:
    if 'colours' in piece:
        mesh.point_data['colour'] = piece['colours']
    return mesh


def _colour(piece: Mapping[str, Any]) -> dict[str, Any]:
    return dict(scalars='colour', rgb=True) if 'colours' in piece else dict(color=piece['colour'])


def _look(plotter: Any, centre: Any, direction: Any, up: Any, height: float) -> None:
    """A camera without perspective that looks along `direction` at the `centre`, of which it sees so much height [m]; lights go with it."""
    direction, up = np.asarray(direction) / np.linalg.norm(direction), np.asarray(up)
    camera = plotter.camera
    camera.focal_point, camera.position, camera.up = centre, np.asarray(centre) - 10 * height * direction, up
    camera.parallel_projection, camera.parallel_scale = True, height / 2
    right = np.cross(direction, up)
    right /= np.linalg.norm(right)
    frame = np.array([right, np.cross(right, direction), -direction])
    for place, strength in LIGHTS:
        plotter.add_light(pyvista.Light(position=tuple(np.asarray(centre) + 10 * height * np.asarray(place) @ frame), focal_point=tuple(centre),
                                        intensity=strength, light_type='scene light'))
    plotter.renderer.reset_camera_clipping_range()


def main() -> None:
    # What the libraries print must not get between the pictures.
    answers = os.fdopen(os.dup(1), 'wb')
    os.dup2(2, 1)
    while True:
        try:
            job = pickle.load(sys.stdin.buffer)
        except EOFError:
            return
        pickle.dump(draw(job), answers)
        answers.flush()


if __name__ == '__main__':
    main()
