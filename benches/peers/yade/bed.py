# W1, W5: a bed in a box (width=). W4: plate= is where a plate starts that comes down at 0.5 m/s.
# W6: periodic=1 with lx=, ly=, height=.
exec(open('inputs/loop.py').read())
material = glass()
skin = float(given['skin'])
if given.get('periodic') == '1':
    lx, ly, height = (float(given[key]) for key in ('lx', 'ly', 'height'))
    shift = 0.5 * height
    O.periodic = True
    O.cell.setBox(lx, ly, 3 * height)
    placed = grains(material, shift)
    # the floor: fixed boxes side by side, since one as large as the cell loses most of its contacts in YADE 2023.02
    tile = 0.025
    for i in range(round(lx / tile)):
        for j in range(round(ly / tile)):
            centre = ((i + 0.5) * tile, (j + 0.5) * tile, shift - 0.005)
            O.bodies.append(box(centre, (tile / 2, tile / 2, 0.005), fixed=True, material=material))
else:
    shift, width = 0.0, float(given['width'])
    placed = grains(material)
    for axis, place, sense in ((0, 0, 1), (0, width, -1), (1, 0, 1), (1, width, -1), (2, 0, 1)):
        O.bodies.append(wall(place, axis, sense=sense, material=material))
if 'plate' in given:
    top = O.bodies.append(wall(float(given['plate']), 2, sense=-1, material=material))
    O.bodies[top].state.vel = (0, 0, -0.5)
O.engines = [ForceResetter(),
             InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb(), Bo1_Box_Aabb()],
                                   verletDist=skin / 2),
             hertz_mindlin(Ig2_Wall_Sphere_ScGeom(), Ig2_Box_Sphere_ScGeom()),
             NewtonIntegrator(gravity=(0, 0, -9.81), damping=0, exactAsphericalRot=False)]
run(placed, shift)
