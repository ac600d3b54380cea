"""Relays: M as SPEC 7.5 has it, and D, to which each address has a distance."""
from air import SLOT, MS
NOTHING, COPY, ANSWER = range(3)
PARALLEL, DOWN, UP = range(3)


class Entry:
    def __init__(self, m):
        self.m, self.due, self.timer = m, NOTHING, None
        self.hops = self.answer_hops = self.answers = self.spent = self.quiet = self.age = 0
        self.sending = self.reserve = self.from_reserve = self.trusted = self.repeated = self.copied = False
        self.late = self.handed_on = self.prompt = self.answered = self.answer_handed_on = False


class M:
    MOST = 4000 * MS
    ENTRIES, PAIRS = 4, 32

    def __init__(self, air, board):
        self.air, self.board, self.entries, self.doubts, self.cfg = air, board, [], {}, air.cfg
        self.store, self.store_at = self.MOST, 0

    def learn(self, p): pass
    def own_extra(self, m): return None
    def extra(self, e): return None
    def random(self, n): return self.air.random.randrange(n)
    def spread(self, turn): return self.random(8) + (45 if turn and self.random(2) else 0)
    def place(self, hops, own): return (hops - own) % 3
    def slots_since(self, e): return (self.air.quiet(self.board) - e.quiet) // SLOT
    def is_idle(self, e): return e.due == NOTHING and not e.sending
    def pair(self, m): return (min(m.origin, m.to), max(m.origin, m.to))
    def doubt(self, m): return self.doubts.get(self.pair(m), 1)

    def set_doubt(self, m, value):
        self.doubts.pop(self.pair(m), None)
        self.doubts[self.pair(m)] = value
        if len(self.doubts) > self.PAIRS: del self.doubts[next(iter(self.doubts))]

    def credit(self):
        self.store = min(self.MOST, self.store + (self.air.now - self.store_at) / 10)
        self.store_at = self.air.now
        return self.store

    def wait(self, e, due, first, left):
        self.stop(e)
        e.due = due
        e.timer = self.air.wait(self.board, first, left, self.send, e)

    def stop(self, e):
        self.air.cancel(e.timer)
        e.due, e.timer = NOTHING, None

    # packets
    def packet(self, p):
        m = p.message
        e = next((x for x in self.entries if x.m is m), None)
        if e and self.again(e, p): return
        late = e is not None
        if e: self.stop(e); self.entries.remove(e)
        if self.credit() < (self.air.length['D'] if self.doubt(m) == 0 else self.MOST / 2): return
        if len(self.entries) == self.ENTRIES:
            free = [x for x in self.entries if self.is_idle(x)]
            if not free: return
            self.entries.remove(min(free, key=lambda x: x.age))
        e = Entry(m)
        e.late = late
        self.entries.append(e)
        self.begin(e, p, False)

    def begin(self, e, p, from_reserve):
        e.hops = p.hops + 1
        doubt = self.doubt(e.m)
        e.trusted, e.from_reserve = doubt == 0, from_reserve
        e.reserve = not from_reserve and self.is_reserved(e, p, doubt)
        e.repeated = not e.trusted or from_reserve
        e.handed_on = e.prompt = e.answered = e.answer_handed_on = False
        e.answers = 0
        e.quiet, e.age = self.air.quiet(self.board), self.air.now
        if not e.reserve:
            first, left = self.first_wait(e)
            self.wait(e, COPY, first, left + (45 if from_reserve else 0))

    def is_reserved(self, e, p, doubt): return doubt == 3
    def first_wait(self, e): return 8, self.random(8)
    def begins_late(self, e, p): return not e.reserve
    def least_age(self, e): return 200 if e.copied else 10 ** 9

    def again(self, e, p):
        """Returns whether nothing begins anew."""
        if not e.answered:
            self.copy_heard(e, p)
            return True
        if not self.is_idle(e) or self.place(p.hops, e.hops) == DOWN \
                or self.air.now - e.age <= self.least_age(e) * MS: return True
        if e.answers >= 4: return False
        self.wait(e, ANSWER, 6, self.spread(True))
        return True

    def copy_heard(self, e, p):
        where = self.place(p.hops, e.hops)
        if self.is_idle(e) and self.air.now - e.age > 1500 * MS and self.begins_late(e, p):
            e.late = True
            self.begin(e, p, False)
        elif where == DOWN:
            if e.copied and self.slots_since(e) < 24: e.prompt = True
            e.handed_on = True
            self.stop(e)
            e.age = self.air.now
        elif where == PARALLEL:
            if e.copied or e.due == NOTHING or self.insists(e): return
            self.stop(e)
            e.age = self.air.now
        elif e.reserve:
            if self.slots_since(e) >= 18: self.begin(e, p, True)
            e.quiet = self.air.quiet(self.board)
        elif p.hops == 0 and e.hops == 1 and not e.sending and (e.copied or e.due == NOTHING):
            self.wait(e, COPY, 6, self.spread(not e.handed_on))

    def insists(self, e): return False

    # acknowledgements
    def answer(self, p):
        for e in self.entries:
            if e.m is not p.message: continue
            if e.answered: self.answer_again(e, p)
            else: self.first_answer(e, p)
            e.age = self.air.now

    def answer_again(self, e, p):
        where = self.place(p.hops, e.answer_hops)
        if where == DOWN: e.answer_handed_on = True
        if where != UP: self.stop(e)

    def first_answer(self, e, p):
        doubt, direct = self.doubt(e.m), not p.copy
        self.stop(e)
        e.reserve, e.answered, e.answer_hops, e.real = False, True, p.hops + 1, p.real
        self.store = min(self.MOST, self.credit() + e.spent)
        e.spent = 0
        if direct and e.copied and self.slots_since(e) < 24: e.prompt = True
        if not e.copied: self.set_doubt(e.m, min(3, doubt + 1))
        elif e.prompt: self.set_doubt(e.m, 2 if e.from_reserve else 0)
        elif direct: self.set_doubt(e.m, 3)
        if e.copied and self.carries(e, p, doubt): self.wait(e, ANSWER, 1, self.random(4))

    def carries(self, e, p, doubt): return e.handed_on or e.prompt or (p.copy and (doubt == 0 or e.late))

    # sending
    def send(self, board, e):
        air, m = self.air, e.m
        if board.sending: return
        due, e.due = e.due, NOTHING
        if due == COPY:
            cost = air.length['D']
            if self.credit() < cost: return
            self.store -= cost
            e.spent += cost
            e.copied = True
        else: e.answers += 1
        e.sending = True
        air.send(board, 'D' if due == COPY else 'A', m, e.hops if due == COPY else e.answer_hops, lambda: self.sent(e), self.extra(e), True, due == COPY or e.real)

    def sent(self, e):
        e.sending, e.age = False, self.air.now
        if e.answered:
            if e.hops != 1 and not e.answer_handed_on and e.answers <= 2: self.wait(e, ANSWER, 6, 14 + self.random(8))
            return
        e.quiet = self.air.quiet(self.board)
        if e.repeated or e.handed_on: return
        e.repeated = True
        self.wait(e, COPY, 2, 20 + self.spread(True))


class D(M):
    """A copy says how many hops are behind it, and how many its sender believes to be ahead (extra).
    For each of 32 addresses a relay keeps that distance, how often in a row a greater one was heard, and the score."""
    ADDRESSES = 32
    OFF = ()                    # what is left out, to see what it is good for

    def __init__(self, air, board):
        M.__init__(self, air, board)
        self.far, self.off = {}, self.cfg.get('off', ())

    def keep(self, who, distance, count, doubt):
        self.far.pop(who, None)
        self.far[who] = (distance, count, doubt)
        if len(self.far) > self.ADDRESSES: del self.far[next(iter(self.far))]

    def known(self, who): return self.far.get(who, (None, 0, 1))
    def distance(self, m): return self.known(m.to)[0]
    def doubt(self, m): return self.known(m.to)[2]
    def set_doubt(self, m, value): self.keep(m.to, *self.known(m.to)[:2], value)

    def learn(self, p):
        who, d = p.message.origin if p.kind == 'D' else p.message.to, p.hops + 1
        if who == self.board.number: return
        old, count, doubt = self.known(who)
        if old and d > old and count < 3: self.keep(who, old, count + 1, doubt)
        else: self.keep(who, d, 0, doubt)

    def own_extra(self, m):
        d = self.distance(m)
        return d if m.sent == 1 and 'own' not in self.off and not (d == 1 and 'near' in self.off) else None
    def extra(self, e): return e.hops if e.answered else None if e.late else self.distance(e.m)
    def place(self, hops, own): return DOWN if hops > own else PARALLEL if hops == own else UP

    def begin(self, e, p, from_reserve):
        if e.late and not from_reserve and 'drop' not in self.off: self.keep(e.m.to, None, 0, self.doubt(e.m))
        M.begin(self, e, p, from_reserve)

    def is_reserved(self, e, p, doubt):
        d = self.distance(e.m)
        return doubt == 3 or not e.late and p.extra is not None and (d is None or d >= p.extra)

    def first_wait(self, e):
        if e.trusted or (self.distance(e.m) is not None and not e.late): return 8, self.random(8)
        return self.cfg.get('wait', 30), self.random(self.cfg.get('spread', 96))

    def begins_late(self, e, p):
        return not (e.reserve and self.doubt(e.m) == 3) and (not e.copied or p.hops < e.hops or 'rings' in self.off)

    def least_age(self, e): return 200 if e.copied else 1500 if 'uncopied' not in self.off else 10 ** 9
    def insists(self, e): return e.late and 'insist' not in self.off

    def carries(self, e, p, doubt):
        if 'back' in self.off: return M.carries(self, e, p, doubt)
        return p.extra > e.hops if p.copy else e.prompt

    def answer_again(self, e, p):
        if 'back' in self.off: return M.answer_again(self, e, p)
        if not p.copy: return
        if p.extra < e.hops: e.answer_handed_on = True
        if p.extra <= e.hops: self.stop(e)


class Liar(M):
    """Sends each new packet on at once, as if it were nearest to all, and carries nothing back; or answers it itself."""
    def packet(self, p):
        if self.board.sending or p.message in self.doubts: return
        if self.cfg.get('lie') != 'forge': self.doubts[p.message] = 1
        e = Entry(p.message)
        e.hops = p.hops + (self.cfg['lie'] if self.cfg.get('lie') in (0, 1, 2) else 1)
        self.air.wait(self.board, 2, 0, self.tell, e)

    def tell(self, board, e):
        if board.sending: return
        if self.cfg.get('lie') == 'forge': self.air.send(board, 'A', e.m, 0, real=False)
        else: self.air.send(board, 'D', e.m, e.hops, None, 0, True)

    def answer(self, p): pass
