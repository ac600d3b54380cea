"""The air, and senders and receivers of SPEC 7.3 and 7.4. Times in bits of 0.5 ms; a slot is 16 bits."""
import heapq, math, random
SLOT, MS = 16, 2
HEARD = 12                       # bits until a carrier is heard


def bits(payload): return 84 + 12 * payload


def share_right(length, rate, mended=3):
    """Of packets without collision, that a receiver takes: at most so many symbols wrong."""
    n, q = length // 6, 1 - (1 - rate) ** 6
    return sum(math.comb(n, k) * q ** k * (1 - q) ** (n - k) for k in range(mended + 1))


class Timer:
    """first quiet slots without a break, then left further ones (in bits); patience has no first ones."""
    __slots__ = ('board', 'first', 'left', 'call', 'arg', 'version', 'on', 'since', 'answer', 'bitwise')


class Message:
    def __init__(self, number, origin, to, time):
        self.number, self.origin, self.to, self.time = number, origin, to, time
        self.got = self.done = self.failed = None
        self.sent = self.packets = self.air = self.copies = self.answers = self.late = 0


class Board:
    def __init__(self, number):
        self.number, self.busy, self.quiet_since, self.quiet_sum = number, 0, 0, 0
        self.timers, self.sending, self.receiving = [], None, []
        self.window, self.queue, self.current = 16.0, [], None
        self.taken, self.answering, self.relay = {}, {}, None
        self.hidden = self.rest = self.quiet_before = 0


class Packet:
    __slots__ = ('board', 'kind', 'message', 'hops', 'extra', 'after', 'heard', 'copy', 'real')


class Air:
    def __init__(self, neighbours, relay=None, relays=(), cfg=None, rate=0.0, seed=1, payload=40, mended=3):
        self.random, self.now, self.events, self.count = random.Random(seed), 0, [], 0
        self.cfg = dict(cfg or {})
        self.neighbours = neighbours
        self.boards = [Board(i) for i in range(len(neighbours))]
        payload = self.cfg.get('payload', payload)
        self.length = {'D': bits(payload), 'A': bits(18)}
        self.right = {k: share_right(n, rate, mended) for k, n in self.length.items()}
        self.messages, self.packets, self.air, self.collisions = [], 0, 0, 0
        self.kinds = {}
        self.log = None
        for i in relays: self.boards[i].relay = relay(self, self.boards[i])

    # time
    def at(self, time, call, *args):
        self.count += 1
        heapq.heappush(self.events, (time, self.count, call, args))

    def run(self):
        while self.events:
            self.now, _, call, args = heapq.heappop(self.events)
            call(*args)

    def wait(self, board, first, left, call, arg=None, answer=False, bitwise=False):
        t = Timer()
        t.board, t.first, t.left, t.call, t.arg, t.version, t.on = board, first, left, call, arg, 0, True
        t.answer, t.bitwise = answer, bitwise
        board.timers.append(t)
        if not board.busy: self.schedule(t)
        return t

    def schedule(self, t):
        q = t.board.quiet_since
        if t.bitwise:
            t.since = self.now
            end = self.now + t.left
        else:
            done = -((q - self.now) // SLOT) if self.now > q else 0
            t.since = max(t.first, done)
            end = max(self.now, q + (t.since + t.left) * SLOT)
        self.at(end, self.fire, t, t.version)

    def fire(self, t, version):
        if not t.on or version != t.version: return
        t.on = False
        t.board.timers.remove(t)
        t.call(t.board, t.arg)

    def cancel(self, t):
        if t is not None and t.on:
            t.on = False
            t.board.timers.remove(t)

    def begin_busy(self, b, begun):
        b.busy += 1
        if b.busy > 1: return
        quiet = self.now - b.quiet_since
        b.quiet_sum += quiet
        slots = b.quiet_before = quiet // SLOT
        if begun and slots >= 6:
            b.window = min(256, b.window * 1.125) if slots - 6 < 3 else max(16, b.window * 0.875)
        for t in b.timers:
            t.version += 1
            if t.bitwise: t.left -= self.now - t.since
            elif t.answer: t.first = 2 + self.random.randrange(4)
            elif slots > t.since: t.left = max(0, t.left - (slots - t.since))

    def end_busy(self, b):
        b.busy -= 1
        if b.busy == 0:
            b.quiet_since = self.now
            for t in b.timers: self.schedule(t)

    def quiet(self, b):
        """Bits of quiet air since ever."""
        return b.quiet_sum + (0 if b.busy else self.now - b.quiet_since)

    # packets
    def send(self, b, kind, m, hops=0, after=None, extra=None, copy=False, real=True):
        n = self.length[kind] + (self.cfg.get('outer', 0) if copy or extra is not None else 0)
        self.packets += 1; self.air += n; m.packets += 1; m.air += n
        what = ('copy' if copy else 'own') + kind + ('' if (m.got is None if kind == 'D' else m.done is None) else ' needless')
        self.kinds[what] = self.kinds.get(what, 0) + 1
        if self.log is not None: self.log.append((self.now, b.number, kind, m.number, hops, copy))
        p = Packet()
        p.board, p.kind, p.message, p.hops, p.extra, p.after, p.heard, p.copy = b, kind, m, hops, extra, after, [], copy
        p.real = real
        b.sending = p
        for r in b.receiving: r[1] = False
        self.begin_busy(b, True)
        for j in self.neighbours[b.number]:
            o = self.boards[j]
            r = [p, o.sending is None]
            if o.receiving:
                r[1] = False
                self.collisions += 1
                for x in o.receiving: x[1] = False
            o.receiving.append(r)
            p.heard.append((o, r))
        self.at(self.now + HEARD, self.carrier, p)
        self.at(self.now + n, self.end, p)

    def carrier(self, p):
        for o, _ in p.heard: self.begin_busy(o, True)

    def end(self, p):
        p.board.sending = None
        good = []
        for o, r in p.heard:
            o.receiving.remove(r)
            if r[1] and self.random.random() < self.right[p.kind]: good.append(o)
        for o in good: self.hear(o, p)
        for o, _ in p.heard: self.end_busy(o)
        self.end_busy(p.board)
        if p.after: p.after()

    def hear(self, b, p):
        m = p.message
        if b.relay: b.relay.learn(p)
        if p.kind == 'D':
            if b.number == m.origin: self.own_copy(b, p)
            elif b.number == m.to: self.arrived(b, m)
            elif b.relay: b.relay.packet(p)
        elif b.number == m.origin:
            if p.real: self.acknowledged(b, m)
        elif b.number != m.to:
            self.others_answer(b, p)
            if b.relay: b.relay.answer(p)

    # sender
    def offer(self, origin, to):
        m = Message(len(self.messages), origin, to, self.now)
        self.messages.append(m)
        b = self.boards[origin]
        b.queue.append(m)
        if b.current is None: self.next(b)

    def next(self, b):
        b.current = None
        if b.queue:
            b.current = b.queue.pop(0)
            b.attempt, b.state = 0, 'contends'
            self.contend(b)

    def contend(self, b):
        b.state = 'contends'
        quiet = (self.now - b.quiet_since) // SLOT if not b.busy else 0
        w = self.window(b)
        b.timer = self.wait(b, 6, 0 if b.attempt == 0 and quiet >= 15 else int(self.random.random() * w), self.transmit)

    def window(self, b): return min(256, int(b.window) << min(b.attempt, 3))

    def transmit(self, b, _):
        m = b.current
        b.state = 'sends'
        m.sent += 1
        extra = b.relay.own_extra(m) if b.relay else None
        self.send(b, 'D', m, 0, lambda: self.sent(b, m), extra)

    def sent(self, b, m):
        if b.current is not m or b.state != 'sends': return
        self.hold(b, 150 * MS if b.attempt < 2 else self.cfg.get('late', 600) * MS)

    def hold(self, b, time):
        b.state = 'waits'
        b.timer = self.wait(b, 0, time, self.attempt_failed, bitwise=True)

    def attempt_failed(self, b, _):
        b.attempt += 1
        if b.attempt == self.cfg.get('attempts', 8):
            b.current.failed = self.now
            self.next(b)
        else: self.contend(b)

    def own_copy(self, b, p):
        m = p.message
        if b.current is not m or b.state == 'sends' or (b.state == 'contends' and b.attempt == 0): return
        self.cancel(b.timer)
        if b.state == 'contends': b.attempt -= 1
        self.hold(b, self.cfg.get('patience', 3000) * MS)

    def acknowledged(self, b, m):
        if m.done is None and b.current is m:
            m.done = self.now
            self.cancel(b.timer)
            self.next(b)

    def others_answer(self, b, p): pass

    # receiver
    def arrived(self, b, m):
        if m not in b.taken:
            m.got = self.now
            b.taken[m] = False
            self.at(self.now + self.random.randrange(*(x * MS for x in self.cfg.get('host', (10, 50)))), self.host_takes, b, m)
        elif b.taken[m]: self.due(b, m)

    def host_takes(self, b, m):
        b.taken[m] = True
        self.due(b, m)

    def due(self, b, m):
        if m in b.answering: return
        t = self.wait(b, 2 + self.random.randrange(4) if b.busy else 1, 0, self.answer_now, m, answer=True)
        b.answering[m] = t

    def answer_now(self, b, m):
        del b.answering[m]
        self.send(b, 'A', m, 0)
