# What the scripts for YADE share: arguments (lines key=value in PEERS), grains, material, the timed loop, the grains at its end.
import math, os, sys, time

given = dict(word.split('=', 1) for word in os.environ['PEERS'].split('\n'))
nrelax, nrun, dt = int(given['nrelax']), int(given['nrun']), float(given['dt'])


def grains(material, shift=0.0):
    """One line a grain: id type diameter density x y z vx vy vz wx wy wz. Type 2 is fixed."""
    bodies, ids = [], []
    for line in open(given['data']):
        r = [float(word) for word in line.split()]
        body = sphere((r[4], r[5], r[6] + shift), r[2] / 2, material=material, fixed=(r[1] == 2))
        body.state.vel, body.state.angVel = r[7:10], r[10:13]
        bodies.append(body)
        ids.append((int(r[0]), int(r[1])))
    return list(zip(O.bodies.append(bodies), ids))


def glass():
    return O.materials.append(FrictMat(young=5e7, poisson=0.3, density=2500, frictionAngle=math.atan(0.5)))


def hertz_mindlin(*geometry):
    return InteractionLoop([Ig2_Sphere_Sphere_ScGeom()] + list(geometry),
                           [Ip2_FrictMat_FrictMat_MindlinPhys(en=0.5)], [Law2_ScGeom_MindlinPhys_Mindlin()])


def run(placed, shift=0.0):
    O.dt = dt
    if nrelax > 0:
        O.run(nrelax, True)  # O.run(0) runs for ever
    wall, cpu, first = time.time(), time.process_time(), O.iter
    O.run(nrun, True)
    wall, cpu = time.time() - wall, time.process_time() - cpu
    print('PEERS loop %.6f cpu %.6f steps %d grains %d' % (wall, cpu, O.iter - first, len(placed)))
    sys.stdout.flush()
    if given.get('dumpto'):
        with open(given['dumpto'], 'w') as out:
            out.write('ITEM: ATOMS id type diameter x y z vx vy vz omegax omegay omegaz\n')
            for body, (number, kind) in placed:
                b = O.bodies[body]
                p = O.cell.wrap(b.state.pos) if O.periodic else b.state.pos
                values = (2 * b.shape.radius, p[0], p[1], p[2] - shift) + tuple(b.state.vel) + tuple(b.state.angVel)
                out.write('%d %d ' % (number, kind) + ' '.join('%.12g' % v for v in values) + '\n')
