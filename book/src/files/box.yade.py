from yade import pack, plot
import math
O.materials.append(FrictMat(young=5e6, poisson=0.3, density=2500, frictionAngle=math.atan(0.5)))
sp = pack.SpherePack()
sp.makeCloud((0, 0, 0), (0.05, 0.05, 0.06), rMean=0.0025, num=300, seed=1)
sp.toSimulation()
for axis, at, side in ((0, 0, 1), (0, 0.05, -1), (1, 0, 1), (1, 0.05, -1), (2, 0, 1)):
    O.bodies.append(wall(at, axis=axis, sense=side))
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()],
        [Ip2_FrictMat_FrictMat_MindlinPhys(en=0.5)],
        [Law2_ScGeom_MindlinPhys_Mindlin()]),
    NewtonIntegrator(gravity=(0, 0, -9.81), damping=0),
    VTKRecorder(fileName="out-", recorders=["spheres"], iterPeriod=1000),
]
O.dt = 1e-5
O.run(30000, True)
