"""How long a run takes to be seen in PyVista, and how fast its frames follow each other: off screen.

    pip install -r tests/python/requirements.txt
    python benches/viewer/look.py FOLDER
"""

import sys
import time
from pathlib import Path

import pyvista

folder = Path(sys.argv[1])
begun = time.perf_counter()
reader = pyvista.get_reader(str(folder / "grains.pvd"))
times = reader.time_values


def grains(k):
    reader.set_active_time_point(k)
    return reader.read()[0]


plotter = pyvista.Plotter(off_screen=True, window_size=(1100, 650))
mesh = grains(0)
sphere = pyvista.Sphere(radius=1.0, theta_resolution=8, phi_resolution=8)
actor = plotter.add_mesh(mesh.glyph(geom=sphere, scale="radius", orient=False), scalars="coordination")
plotter.screenshot()
print(f"spheres: first picture after {time.perf_counter() - begun:.2f} s, {mesh.n_points} grains")
plotter.close()

begun = time.perf_counter()
plotter = pyvista.Plotter(off_screen=True, window_size=(1100, 650))
mesh = grains(0)
drawn = plotter.add_mesh(mesh, style="points_gaussian", render_points_as_spheres=True, emissive=False, scalars="radius")
drawn.mapper.scale_array, drawn.mapper.scale_factor = "radius", 1.0
plotter.screenshot()
print(f"points as spheres: first picture after {time.perf_counter() - begun:.2f} s")
begun = time.perf_counter()
for k in range(1, min(len(times), 11)):
    mesh.copy_from(grains(k))
    plotter.render()
    plotter.screenshot()
print(f"points as spheres: {(min(len(times), 11) - 1) / (time.perf_counter() - begun):.2f} frames per second, read and drawn")
if len(sys.argv) > 2:
    plotter.screenshot(sys.argv[2])
plotter.close()
