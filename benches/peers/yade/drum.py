# W3, a drum of facets about y with closed ends, all turning at 3 rad/s.
exec(open('inputs/loop.py').read())
material = glass()
placed = grains(material)
SEGMENTS, RINGS, LENGTH = 96, 8, 0.19
radius = 0.1 / math.cos(math.pi / SEGMENTS)


def rim(i, y):
    angle = 2 * math.pi * i / SEGMENTS
    return Vector3(radius * math.cos(angle), y, radius * math.sin(angle))


facets = []
for i in range(SEGMENTS):
    for j in range(RINGS):
        y0, y1 = LENGTH * j / RINGS, LENGTH * (j + 1) / RINGS
        facets.append(facet((rim(i, y0), rim(i + 1, y0), rim(i + 1, y1)), material=material))
        facets.append(facet((rim(i, y0), rim(i + 1, y1), rim(i, y1)), material=material))
    for y in (0, LENGTH):
        facets.append(facet((Vector3(0, y, 0), rim(i, y), rim(i + 1, y)), material=material))
drum = O.bodies.append(facets)
O.engines = [ForceResetter(),
             InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Facet_Aabb()], verletDist=0.00025),
             hertz_mindlin(Ig2_Facet_Sphere_ScGeom()),
             RotationEngine(ids=drum, angularVelocity=3.0, rotationAxis=(0, 1, 0), zeroPoint=(0, 0, 0),
                            rotateAroundZero=True),
             NewtonIntegrator(gravity=(0, 0, -9.81), damping=0, exactAsphericalRot=False)]
run(placed)
