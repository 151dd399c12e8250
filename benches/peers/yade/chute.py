# W2, a chute at 26 degrees; reduced units: d = 1, m = 1, g = 1.
exec(open('inputs/loop.py').read())
# ViscElMat puts the springs and dashpots of two materials in series; gamma_n = 50 with m_eff = 1/2 is a dashpot of 25
material = O.materials.append(ViscElMat(kn=4000, ks=2 * 571.42857, cn=50, cs=0.0, density=6 / math.pi,
                                        frictionAngle=math.atan(0.5)))
shift = 5.0
O.periodic = True
O.cell.setBox(40, 20, 2 * float(given['height']))
placed = grains(material, shift)
slope = math.radians(26)
O.engines = [ForceResetter(),
             InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=0.05),
             InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_ViscElMat_ViscElMat_ViscElPhys()],
                             [Law2_ScGeom_ViscElPhys_Basic()]),
             NewtonIntegrator(gravity=(math.sin(slope), 0, -math.cos(slope)), damping=0, exactAsphericalRot=False)]
run(placed, shift)
