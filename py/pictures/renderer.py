"""Drawing off-screen: the process that does it, with a screen in memory of its own (Xvfb), so that no display and no graphics card are needed."""
from __future__ import annotations

import os
import pickle
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from contextlib import suppress
from typing import Any, NoReturn, Self

from numpy.typing import NDArray

PROGRAM = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'renderprocess.py')
SCREEN = ('Xvfb', '-screen', '0', '64x64x24', '-nolisten', 'tcp', '-noreset')
GRACE = 10  # s that a process has to end, before it is made to
HINT = 'install python3-pyvista, python3-pil, xvfb, util-linux and libgl1-mesa-dri, or start with tools/env --with view'


def missing() -> str | None:
    """What there is not, but is needed for drawing, in one sentence; None where all is there."""
    from importlib.util import find_spec
    lacking = [name for name in ('pyvista', 'PIL') if not find_spec(name)] + [name for name in ('Xvfb', 'setpriv') if not shutil.which(name)]
    return f'pictures of particles need {", ".join(lacking)}: {HINT}' if lacking else None


class Renderer:
    """`with Renderer() as renderer: renderer.draw(pieces, camera, size)`.

    Drawing is done by a process of its own: VTK and OpenGL stay out of YADE's, which links a VTK itself and may have a 3D view open, and a crash
    there costs a picture, not a computation. The screen in memory has the same software OpenGL everywhere, so pictures are too.

    :raises ImportError: a package is missing (see `missing`)
    """

    def __enter__(self) -> Self:
        problem = missing()
        if problem:
            raise ImportError(problem)
        self._screen: subprocess.Popen[bytes] | None = None
        self._process: Any = None
        self._errors = tempfile.TemporaryFile()
        try:
            self._start(self._openScreen())
        except BaseException:  # Ctrl-C too: nothing stays behind
            self.__exit__()
            raise
        return self

    def _openScreen(self) -> Any:
        """Start the X server; its display's number."""
        reading, writing = os.pipe()
        with os.fdopen(reading) as answer:
            try:
                # It ends with this process however that ends, and Ctrl-C is for this process alone.
                self._screen = subprocess.Popen(['setpriv', '--pdeathsig', 'KILL', *SCREEN, '-displayfd', str(writing)], pass_fds=(writing,),
                                                start_new_session=True, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=self._errors)
            finally:
                os.close(writing)
            number = answer.readline().strip()
        if not number:
            self._fail('Xvfb did not start')
        return number

    def _start(self, number: Any) -> None:
        """Start the drawing process on the display of that number."""
        environment = {**os.environ, 'DISPLAY': f':{number}', 'LIBGL_ALWAYS_SOFTWARE': '1'}
        for name in ('WAYLAND_DISPLAY', 'PYTHONPATH', 'XAUTHORITY'):
            environment.pop(name, None)
        # -P: this folder's modules are no modules of that process.
        self._process = subprocess.Popen([sys.executable, '-P', PROGRAM], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self._errors,
                                         env=environment, start_new_session=True)

    def __exit__(self, *_: Any) -> None:
        for process in (self._process, self._screen):
            if process is not None:
                process.terminate()
                _wait(process)
        if self._process is not None:
            self._process.stdout.close()
            with suppress(BrokenPipeError):  # half a job may still stand in its buffer
                self._process.stdin.close()
        self._errors.close()

    def draw(self, pieces: Sequence[dict[str, Any]], camera: Mapping[str, Any], size: tuple[int, int], background: str = 'white') -> NDArray[Any]:
        """The picture as an array (height, width, 3) of bytes.

        :param pieces: list of dicts: points (N, 3) [m] with triangles (M, 3) and normals (N, 3), or with lines (M, 2) and radii (N,) [m] of
            tubes; colours (N, 3) bytes, or one colour; opacity, specular; keep: (point, normal) of a plane, what lies behind it goes
        :param camera: dict: centre (3,) [m] of what is seen, direction of the view, up, height [m] of what is seen
        :param size: (width, height) in pixels
        :raises RuntimeError: the drawing process failed, with its last words
        """
        try:
            pickle.dump(dict(pieces=pieces, camera=camera, size=list(size), background=background), self._process.stdin, protocol=5)
            self._process.stdin.flush()
            return pickle.load(self._process.stdout)
        except (EOFError, BrokenPipeError, pickle.UnpicklingError):
            _wait(self._process)
            self._fail(f'the drawing process ended with status {self._process.returncode}')

    def _fail(self, what: str) -> NoReturn:
        self._errors.seek(0)
        raise RuntimeError(f'{what}: {self._errors.read().decode(errors="replace")[-2000:]}')


def _wait(process: Any) -> None:
    """Until the process, which is about to end, has ended; one that does not is killed."""
    try:
        process.wait(GRACE)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
