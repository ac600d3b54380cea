"""Two boards that do not hear each other, one between: python3 hidden.py RULES LOADS SEEDS [CASES].
A run is 60 s, as in the campaign's Load; what a full queue refuses counts as offered."""
import random, sys
from air import *


class Today(Air):
    def offer(self, origin, to):
        self.offered = getattr(self, 'offered', 0) + 1
        b = self.boards[origin]
        if len(b.queue) + (b.current is not None) < self.cfg.get('queue', 8): Air.offer(self, origin, to)


class Window(Today):
    """Other windows: fixed, or one that grows by a factor for each failed attempt."""
    def window(self, b):
        c = self.cfg
        return c['fixed'] if 'fixed' in c else min(c['most'], int(b.window) * c['factor'] ** b.attempt)


class Reserve(Today):
    """A short question before each message, which the receiver answers; others who hear that leave it the air."""
    def __init__(self, *a, **k):
        Today.__init__(self, *a, **k)
        self.length.update(R=bits(10), C=bits(10))
        self.right.update(R=1, C=1)

    def transmit(self, b, _):
        m = b.current
        b.state = 'asks'
        self.send(b, 'R', m, 0, lambda: self.asked(b, m))

    def asked(self, b, m):
        if b.current is m and b.state == 'asks': self.hold(b, 5 * SLOT)

    def hear(self, b, p):
        m = p.message
        if p.kind == 'R':
            if b.number == m.to: self.wait(b, 1, 0, lambda *_: self.send(b, 'C', m))
        elif p.kind == 'C':
            if b.number != m.origin:
                self.begin_busy(b, False)
                self.at(self.now + SLOT + self.length['D'] + 8 * SLOT + self.length['A'], self.end_busy, b)
            elif b.current is m and b.state == 'waits':
                self.cancel(b.timer)
                b.timer = self.wait(b, 1, 0, lambda *_: Today.transmit(self, b, None))
        else: Today.hear(self, b, p)


class Turns(Today):
    """Who hears an acknowledgement behind long quiet, but not its packet, knows of a hidden sender, and takes turns with it."""
    def others_answer(self, b, p):
        if b.quiet_before >= 24: b.hidden = 8
        if not b.hidden: return
        b.rest = 0
        if b.current and b.state == 'contends':
            self.cancel(b.timer)
            b.timer = self.wait(b, 6, self.random.randrange(8), self.transmit)

    def acknowledged(self, b, m):
        if m.done is None and b.current is m and (b.hidden or b.attempt >= self.cfg.get('after', 2)):
            b.hidden = max(0, b.hidden - 1)
            b.rest = self.quiet(b) + self.cfg.get('rest', 80) * SLOT
        Today.acknowledged(self, b, m)

    def contend(self, b):
        Today.contend(self, b)
        if b.attempt == 0 and b.rest > self.quiet(b):
            self.cancel(b.timer)
            left = (b.rest - self.quiet(b)) // SLOT + int(self.random.random() * self.window(b))
            b.timer = self.wait(b, 6, left, self.transmit)

    def window(self, b):
        if not b.hidden or not self.cfg.get('grow'): return Today.window(self, b)
        return min(256, int(b.window) * self.cfg['grow'] ** b.attempt)


RULES = dict(today=(Today, {}), patient=(Today, dict(attempts=16)), reserve=(Reserve, {}), turns=(Turns, {}), turns4=(Turns, dict(grow=4)))
for w in (64, 128, 256, 512): RULES['fixed%d' % w] = (Window, dict(fixed=w))
for f in (4, 8, 16):
    for most in (256, 512, 1024): RULES['x%d/%d' % (f, most)] = (Window, dict(factor=f, most=most))
for name in ('today', 'reserve', 'x4/256', 'x8/512', 'turns', 'turns4'):
    kind, cfg = RULES[name]
    for other, change in dict(long=dict(payload=77), short=dict(payload=28), slow=dict(host=(100, 200)), q4=dict(queue=4), q14=dict(queue=14)).items():
        RULES[name + '-' + other] = kind, dict(cfg, **change)
for r in (32, 48, 64, 100): RULES['turns4r%d' % r] = (Turns, dict(grow=4, rest=r))
for a in (1, 3, 9): RULES['turns4a%d' % a] = (Turns, dict(grow=4, after=a))


def star(*groups):
    """Groups of boards that hear each other, all to board 0."""
    n, nb, flows = 1, [[]], []
    for g in groups:
        mine = list(range(n, n + g))
        n += g
        for i in mine:
            nb.append([0] + [j for j in mine if j != i])
            flows.append((i, 0))
            nb[0].append(i)
    return nb, flows


def ring(n): return [[j for j in range(n) if j != i] for i in range(n)], [(i, (i + 1) % n) for i in range(n)]


CASES = {'star%s' % ''.join(map(str, g)): star(*g) for g in ((1, 1), (1, 1, 1), (1,) * 4, (2, 2), (3, 1), (5, 5))}
CASES.update({'ring%d' % n: ring(n) for n in (2, 5, 10, 20, 40)},
             chain=([[1], [0, 2], [1, 3], [2, 4], [3]], [(0, 1), (2, 1), (2, 3), (4, 3)]),
             both=([[1], [0, 2], [1]], [(0, 1), (2, 1), (1, 0), (1, 2)]))


def run(rule, load, seed, case='star11', seconds=60):
    kind, cfg = RULES[rule]
    neighbours, flows = CASES[case]
    air = kind([list(n) for n in neighbours], cfg=cfg, seed=seed * 7919 + 13)
    exchange = (air.length['D'] + air.length['A']) / 2000
    r = random.Random(seed + 99)
    for o, d in flows:
        t = r.expovariate(load / (exchange * len(flows)))
        while t < seconds:
            air.at(int(t * 2000), air.offer, o, d)
            t += r.expovariate(load / (exchange * len(flows)))
    air.run()
    return air


def row(rule, load, seeds, case):
    ok = n = sent = refused = failed = 0
    each, waits = [], []
    for s in seeds:
        a = run(rule, load, s, case)
        done = [m for m in a.messages if m.done is not None]
        each.append(100 * len(done) / a.offered)
        ok += len(done); n += a.offered; sent += a.packets; refused += a.offered - len(a.messages)
        failed += sum(m.done is None for m in a.messages)
        waits += [(m.done - m.time) / 2000 for m in done]
    waits.sort()
    each.sort()
    print(f"{case:8s} {rule:12s} load {load:.2f} n={n:5d} ok={100*ok/n:6.2f}% (runs {each[0]:.0f}..{each[-1]:.0f}) refused {100*refused/n:4.1f} "
          f"failed {100*failed/n:4.1f} packets {sent/n:.2f} wait {waits[len(waits)//2]:.2f} 95% {waits[int(.95*len(waits))]:.1f}", flush=True)


if __name__ == '__main__':
    a, b = (sys.argv[3] + '-').split('-')[:2]
    for case in (sys.argv[4] if len(sys.argv) > 4 else 'star11').split(','):
        for load in sys.argv[2].split(','):
            for rule in sys.argv[1].split(','):
                row(rule, float(load), range(int(a), int(b or a) + 1), case)
