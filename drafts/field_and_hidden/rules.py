from relays import *
import hidden
b = dict(outer=12)
def of(**k): return D, dict(b, **k)
RULES = dict(M=(M, {}), D=of(), Dt=of(kind=hidden.Turns, grow=4), Mt=(M, dict(kind=hidden.Turns, grow=4)))
for off in ('own', 'drop', 'rings', 'uncopied', 'insist', 'back', 'near'): RULES['D-' + off] = of(off=(off,))
for w in (8, 20, 40): RULES['Dw%d' % w] = of(wait=w)
for s in (8, 32, 64, 128): RULES['Ds%d' % s] = of(spread=s)
RULES['Dw8s8'] = of(wait=8, spread=8)
for x in (0, 1, 2, 'forge'):
    RULES['M.%s' % x] = (M, dict(lie=x))
    RULES['D.%s' % x] = of(lie=x)
    RULES['D-uncopied.%s' % x] = of(lie=x, off=('uncopied',))
RULES['D.poison'] = of(poison=1)
