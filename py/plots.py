"""Pictures with matplotlib, without a display: the force over time, and the bed from the side."""
import numpy as np

from .snapshot import gauge

ELEVATION = np.radians(14)            # of the camera above the horizontal
LIGHT = np.array([-0.45, -0.65, 0.62])  # direction to the light
PARTICLE = np.array([0.86, 0.70, 0.42])
IMPACTOR = np.array([0.52, 0.57, 0.66])


def forcePicture(path, record, pulse, staticForce, bare=None, title=''):
    """Force on the base over time, as PNG.

    :param record: (times [s], forces [N]) with the bed, times from the start of the record
    :param pulse: `impact.Pulse` of the same; :param staticForce: what the base bore before [N]
    :param bare: (times, forces) of the impact on the bare base, moved in time to the first touch
    """
    figure, axes = _figure(8, 4.8)
    times, forces = 1e3 * np.asarray(record[0]), 1e-3 * (np.asarray(record[1]) - staticForce)
    start, end = 1e3 * pulse.start, 1e3 * pulse.end
    axes.axvspan(start, end, color='#f6e9d0', lw=0, zorder=0, label=f'duration {end - start:.2f} ms')
    if bare is not None:
        bareForces = 1e-3 * np.asarray(bare[1])
        shifted = 1e3 * np.asarray(bare[0]) + start
        touching = np.flatnonzero(bareForces > 0)
        shifted -= shifted[touching[0]] - start if len(touching) else 0
        keep = slice(max(touching[0] - 1, 0), touching[-1] + 2) if len(touching) else slice(0)
        axes.plot(shifted[keep], bareForces[keep], color='#888888', lw=1.2,
                  label=f'without a bed, $P_0$ = {bareForces.max():.2f} kN')
    axes.plot(times, forces, color='#b03a2e', lw=1.6, label='with the bed')
    peakTime, peak = 1e3 * pulse.peakTime, 1e-3 * pulse.peak
    axes.plot([peakTime], [peak], 'o', color='#b03a2e', ms=5)
    axes.annotate(f'$P$ = {peak:.3f} kN', (peakTime, peak), xytext=(8, 4), textcoords='offset points', color='#b03a2e')
    axes.axhline(0, color='black', lw=0.6)
    axes.set(xlabel='time [ms]', ylabel='force on the base, less the bed\'s weight on it [kN]', title=title,
             xlim=(max(times[0], start - 0.5 * (end - start)), min(times[-1], end + 2 * (end - start))))
    axes.legend(loc='upper right', framealpha=1, edgecolor='white')
    axes.spines[['top', 'right']].set_visible(False)
    _save(figure, path)


def bedPicture(path, views, container, title=''):
    """The bed from the side, its front half taken away, one panel per view, as PNG.

    :param views: list of (caption, `Snapshot`, impactor as (centre [m], radius [m]) or None)
    """
    figure, panels = _figure(6.2 * len(views), 4.4, len(views))
    top = max(_top(snapshot, impactor) for _, snapshot, impactor in views)
    for axes, (caption, snapshot, impactor) in zip(np.atleast_1d(panels), views):
        _drawContainer(axes, container, top)
        _drawQuads(axes, *_sceneQuads(snapshot, impactor))
        axes.set(aspect='equal', title=caption)
        axes.axis('off')
        axes.autoscale_view()
    figure.suptitle(title)
    _save(figure, path)


def _figure(width, height, columns=1):
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure
    figure = Figure(figsize=(width, height), layout='constrained')
    FigureCanvasAgg(figure)
    return figure, figure.subplots(1, columns)


def _save(figure, path):
    figure.savefig(path, dpi=150, metadata={'Software': None})


def _top(snapshot, impactor):
    heights = [snapshot.positions[:, 2].max() + snapshot.extents.max()] if len(snapshot) else [0.0]
    return max(heights + ([impactor[0][2] + impactor[1]] if impactor else []))


def directions(cells):
    """Quads (6 cells^2, 4, 3) of unit vectors over the sphere: the faces of a cube, cut into squares."""
    edges = np.tan(np.linspace(-np.pi / 4, np.pi / 4, cells + 1))
    u, v = np.meshgrid(edges, edges, indexing='ij')
    square = np.stack([np.stack([u[i:i + cells, j:j + cells], v[i:i + cells, j:j + cells]], axis=-1).reshape(-1, 2)
                       for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))], axis=1)
    faces = []
    for axis in range(3):
        for sign in (-1, 1):
            faces.append(np.insert(square if sign > 0 else square[:, ::-1], axis, sign, axis=2))
            if axis == 1:
                faces[-1] = faces[-1][:, ::-1]
    quads = np.concatenate(faces)
    return quads / np.linalg.norm(quads, axis=2, keepdims=True)


def surfaceQuads(extents, exponents, cells):
    """Quads (M, 4, 3) [m] on the surface of a superquadric, in its own axes, outward orientation."""
    scaled = directions(cells) * extents
    return scaled / gauge(scaled, extents, exponents)[..., None]


def _sceneQuads(snapshot, impactor):
    """Corners (M, 4, 3) and colours (M, 3) of all that is seen."""
    cells = 7 if len(snapshot) < 1500 else 5
    cache, corners, colours = {}, [], []
    for i in np.flatnonzero(snapshot.positions[:, 1] > 0):
        key = (*snapshot.extents[i], *snapshot.exponents[i])
        if key not in cache:
            cache[key] = surfaceQuads(snapshot.extents[i], snapshot.exponents[i], cells)
        corners.append(cache[key] @ snapshot.rotations[i].T + snapshot.positions[i])
        tint = 0.80 + 0.20 * ((int(snapshot.ids[i]) * 0.618034) % 1)
        colours.append(np.tile(tint * PARTICLE, (len(corners[-1]), 1)))
    if impactor is not None:
        centre, radius = impactor
        corners.append(radius * directions(20) + np.asarray(centre))
        colours.append(np.tile(IMPACTOR, (len(corners[-1]), 1)))
    return (np.concatenate(corners), np.concatenate(colours)) if corners else (np.empty((0, 4, 3)), np.empty((0, 3)))


def _project(points):
    """Screen coordinates (..., 2) and depth (...,) of points in space; the camera looks along +y and a little down."""
    x, y, z = np.moveaxis(points, -1, 0)
    sine, cosine = np.sin(ELEVATION), np.cos(ELEVATION)
    return np.stack([x, z * cosine + y * sine], axis=-1), y * cosine - z * sine


def _drawQuads(axes, corners, colours):
    from matplotlib.collections import PolyCollection
    normals = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True) + 1e-300
    facing = normals @ np.array([0, np.cos(ELEVATION), -np.sin(ELEVATION)]) < 0
    corners, colours, normals = corners[facing], colours[facing], normals[facing]
    screen, depth = _project(corners)
    order = np.argsort(-depth.mean(axis=1))
    light = 0.42 + 0.58 * np.clip(normals @ LIGHT / np.linalg.norm(LIGHT), 0, 1)
    shaded = np.clip(colours * light[:, None], 0, 1)[order]
    axes.add_collection(PolyCollection(screen[order], facecolors=shaded, edgecolors=shaded, linewidths=0.25,
                                       rasterized=True))


def _drawContainer(axes, container, top):
    """The back half of the container: base, wall up to `top`, cut edges."""
    if container.radius is not None:
        angle = np.linspace(0, np.pi, 90)
        back = container.radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    else:
        x, y = container.width / 2, container.depth / 2
        back = np.array([(x, 0), (x, y), (-x, y), (-x, 0)])
    low = _project(np.insert(back, 2, 0.0, axis=1))[0]
    high = _project(np.insert(back, 2, min(1.05 * top, container.height), axis=1))[0]
    axes.fill(*np.concatenate([low, high[::-1]]).T, color='#eef1f4', lw=0)
    axes.fill(*low.T, color='#dfe4e9', lw=0)
    axes.plot(*np.array([high[0], low[0], low[-1], high[-1]]).T, color='#4a4f57', lw=1.4, solid_joinstyle='round')
