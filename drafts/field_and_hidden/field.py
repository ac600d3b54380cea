"""The campaign's cases: python3 field.py RULES CASES SEEDS. A run is 400 s from a cold start."""
import math, random, sys
from air import *
import rules
PLACES = [(171.4,217.3),(172.7,222.0),(90.4,100.5),(210.6,214.3),(72.6,211.0),(98.4,127.0),(161.2,108.4),(270.3,59.0),(58.0,105.6),(109.6,61.0),(14.0,152.9),(110.5,95.9),(265.7,214.7),(152.3,179.7),(3.4,87.3),(251.5,175.0),(77.4,99.4),(256.2,101.2),(80.9,3.1),(261.6,64.7)]
TO = [11,8,7,15,16,7,8,16,14,12,7,9,4,14,4,12,7,10,5,10]


def near(places, metres=100):
    return [[j for j, q in enumerate(places) if j != i and math.dist(p, q) <= metres] for i, p in enumerate(places)]


def hops(nb, i):
    d = [99] * len(nb); d[i] = 0; q = [i]
    for u in q:
        for v in nb[u]:
            if d[v] == 99: d[v] = d[u] + 1; q.append(v)
    return d


def field(seed, metres=290, most=4):
    """The campaign's own field is number 0; others are drawn as it was."""
    if seed == 0: return near(PLACES), list(enumerate(TO))
    r = random.Random(seed)
    while True:
        places = [(r.random() * metres, r.random() * metres) for _ in range(20)]
        nb = near(places)
        if max(max(hops(nb, i)) for i in range(20)) == most:
            return nb, [(i, (i + 1 + r.randrange(19)) % 20) for i in range(20)]


def line(n): return near([(80 * i, 0) for i in range(n)])
def pair(n, apart=0): return near([(-60, 0), (60, 0)] + [(0, 0 if n == 1 else apart * (k - .5)) for k in range(n)])


CASES = dict(
    line=lambda s: (line(5), {1, 2, 3}, [(0, 4)], 12, 9),
    one=lambda s: (pair(1), {2}, [(0, 1)], 10, 4),
    near=lambda s: (pair(2, 0), {2, 3}, [(0, 1)], 10, 4),
    hidden=lambda s: (pair(2, 110), {2, 3}, [(0, 1)], 10, 4),
    alone=lambda s: (near([(0, 0)] * 10), set(), [(i, (i + 1) % 9) for i in range(9)], 2, 1),
    idle=lambda s: (near([(0, 0)] * 10), {9}, [(i, (i + 1) % 9) for i in range(9)], 2, 1),
    field=lambda s: (field(0)[0], set(range(20)), field(0)[1], 20, 1),
    fields=lambda s: (field(s)[0], set(range(20)), field(s)[1], 20, 1),
    weak=lambda s: (field(s)[0], set(range(20)), field(s)[1], 20, 1),
    moved=lambda s: (field(s)[0], set(range(20)), field(s)[1], 20, 1),
    absent=lambda s: (field(s)[0] + [[]], set(range(20)), [(i, 20) for i in range(20)], 60, 1),
    lied=lambda s: (field(s)[0], set(range(20)), field(s)[1], 20, 1),
    liedpair=lambda s: (pair(2, 0), {2, 3}, [(0, 1)], 10, 1),
    liedline=lambda s: (near([(80 * i, 0) for i in range(5)] + [(160, 30)]), {1, 2, 3, 5}, [(0, 4)], 12, 1),
    dense=lambda s: (field(s, 200, 3)[0], set(range(20)), field(s, 200, 3)[1], 20, 1),
    busy=lambda s: (field(s)[0], set(range(20)), field(s)[1], 5, 1),
    alone50=lambda s: (near([(0, 0)] * 10), set(), [(i, (i + 1) % 9) for i in range(9)], .87, 1),
    idle50=lambda s: (near([(0, 0)] * 10), {9}, [(i, (i + 1) % 9) for i in range(9)], .87, 1),
    warm=lambda s: (field(s)[0], set(range(20)), field(s)[1], 20, 1),
)


def move(air):
    """All boards exchange places at once."""
    n = len(air.neighbours)
    place = [(7 * i + 3) % n for i in range(n)]
    new = [None] * n
    for i in range(n): new[place[i]] = [place[j] for j in air.neighbours[i]]
    air.neighbours[:] = new


def poison(air, liar):
    """Those in range hear forged packets from everybody, as if these were near (their air is not counted)."""
    for j in air.neighbours[liar.number]:
        relay = air.boards[j].relay
        if hasattr(relay, 'far'):
            for i in range(len(air.boards)):
                if i != j:
                    x = relay.far.get(i, (None, 0, 1))
                    relay.far[i] = (1, 0, x[2])


def run(rule, case, seed, seconds=400, rate=1e-3, log=None):
    relay, cfg = rules.RULES[rule]
    nb, relays, flows, mean, _ = CASES[case](seed)
    if case == 'warm': seconds = 4000
    air = cfg.get('kind', Air)(nb, relay, relays, cfg, rate, seed * 7919 + 13, mended=1 if case == 'weak' else 3)
    if case == 'moved': air.at(400000, move, air)
    if case.startswith('lied'):
        liar = air.boards[dict(lied=16, liedpair=3, liedline=5)[case]]
        liar.relay = rules.Liar(air, liar)
        if cfg.get('poison'):
            for t in range(0, 800000, 10000): air.at(t, poison, air, liar)
    r = random.Random(seed + 99)
    for o, d in flows:
        t = r.expovariate(1 / (mean * len(flows)))
        while t < seconds:
            air.at(int(t * 2000), air.offer, o, d)
            t += r.expovariate(1 / (mean * len(flows)))
    air.log = log
    air.run()
    return air


def row(rule, case, seeds):
    shares, packets, airtime, waits, n, kinds, sent = [], [], [], [], 0, {}, 0
    for s in seeds:
        a = run(rule, case, s)
        ok = [m for m in a.messages if m.done is not None]
        if not a.messages: continue
        n += len(a.messages)
        shares.append((len(ok), len(a.messages)))
        packets.append(a.packets); airtime.append(a.air / 2000)
        waits += [(m.done - m.time) / 2000 for m in ok]
        sent += sum(m.sent for m in a.messages)
        for k, v in a.kinds.items(): kinds[k] = kinds.get(k, 0) + v
    waits.sort()
    if not waits: return print(rule, case, n, 'none delivered, packets each %.1f air %.1f' % (sum(packets) / n, sum(airtime) / n))
    d = max(1, len(waits))
    each = sorted(p / max(1, o) for p, (o, _) in zip(packets, shares))
    part = sorted(100 * o / x for o, x in shares)
    print(f"{rule:10s} {case:7s} n={n:5d} ok={100*d/n:6.2f}% ({part[0]:.0f}..{part[-1]:.0f}) packets {sum(packets)/d:5.1f} ({each[0]:.0f}..{each[-1]:.0f}) "
          f"air {sum(airtime)/d:6.3f} s wait {waits[d//2]:.2f} 95% {waits[int(.95*d)]:.1f} attempts {sent/n:.2f} | "
          + ' '.join(f"{k} {v/n:.1f}" for k, v in sorted(kinds.items())), flush=True)


if __name__ == '__main__':
    a, b = (sys.argv[3] + '-').split('-')[:2]
    for case in sys.argv[2].split(','):
        for rule in sys.argv[1].split(','):
            row(rule, case, range(int(a), int(b or a) + 1))
