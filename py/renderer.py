"""Drawing off-screen: the process that does it, with a screen in memory of its own (Xvfb), so that no display and no graphics card are needed."""
import os
import pickle
import shutil
import subprocess
import sys
import tempfile

PROGRAM = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'renderprocess.py')
SCREEN = ('Xvfb', '-screen', '0', '64x64x24', '-nolisten', 'tcp', '-noreset')
HINT = 'install python3-pyvista, python3-pil, xvfb and libgl1-mesa-dri, or start with tools/env --with view'


def missing():
    """What there is not, but is needed for drawing, in one sentence; None where all is there."""
    from importlib.util import find_spec
    lacking = [name for name, found in (('pyvista', find_spec('pyvista')), ('PIL', find_spec('PIL')), ('Xvfb', shutil.which('Xvfb'))) if not found]
    return f'pictures of particles need {", ".join(lacking)}: {HINT}' if lacking else None


class Renderer:
    """`with Renderer() as renderer: renderer.draw(pieces, camera, size)`.

    Drawing is done by a process of its own: VTK and OpenGL stay out of YADE's, which links a VTK itself and may have a 3D view open, and a crash
    there costs a picture, not a computation. The screen in memory has the same software OpenGL everywhere, so pictures are too.

    :raises ImportError: a package is missing (see `missing`)
    """

    def __enter__(self):
        problem = missing()
        if problem:
            raise ImportError(problem)
        self._errors = tempfile.TemporaryFile()
        reading, writing = os.pipe()
        # It ends with this process however that ends, and Ctrl-C is for this process alone.
        self._screen = subprocess.Popen(['setpriv', '--pdeathsig', 'KILL', *SCREEN, '-displayfd', str(writing)], pass_fds=(writing,),
                                        start_new_session=True, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=self._errors)
        os.close(writing)
        with os.fdopen(reading) as answer:
            number = answer.readline().strip()
        if not number:
            self._fail('Xvfb did not start')
        environment = {**os.environ, 'DISPLAY': f':{number}', 'LIBGL_ALWAYS_SOFTWARE': '1'}
        for name in ('WAYLAND_DISPLAY', 'PYTHONPATH', 'XAUTHORITY'):
            environment.pop(name, None)
        # -P: this folder's modules are no modules of that process.
        self._process = subprocess.Popen([sys.executable, '-P', PROGRAM], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self._errors,
                                         env=environment, start_new_session=True)
        return self

    def __exit__(self, *_):
        for process in (getattr(self, '_process', None), self._screen):
            if process is not None:
                process.terminate()
                process.wait()
        self._errors.close()

    def draw(self, pieces, camera, size, background='white'):
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
            self._process.wait()
            self._fail(f'the drawing process ended with status {self._process.returncode}')

    def _fail(self, what):
        self._errors.seek(0)
        raise RuntimeError(f'{what}: {self._errors.read().decode(errors="replace")[-2000:]}')
