"""A second opinion on the models: explores them in real time, with zones, and shares no code with our checker.

usage: zone_checker.py FILE.xml...

Beside each stands its FILE.q. Exits with 1 when a verdict is not the expected one. It reads what README.md calls the
subset, and does not look for mistakes in it: that is our checker's part.
"""
import re
import sys
import time
import xml.etree.ElementTree as xml

from collections import namedtuple

NAME = r'[A-Za-z_]\w*'


def python(text):
    """An expression as Python has it; those in parentheses are put aside first."""
    aside = []

    def level(part):
        if '?' in part:
            condition, rest = part.split('?', 1)
            yes, no = rest.split(':', 1)
            return f'(({level(yes)}) if ({level(condition)}) else ({level(no)}))'
        if ' imply ' in part:
            left, right = part.split(' imply ')
            return f'(not ({level(left)}) or ({level(right)}))'
        part = re.sub(r'(!(?!=)|\bnot\b)\s*([\w.]+(\[[^]]*\])?|\0\d+\0)', r'(1-bool(\2))', part)
        return part.replace('&&', ' and ').replace('||', ' or ').replace('/', '//')

    def put(match):
        aside.append(f'({level(match[1])})')
        return f'\0{len(aside) - 1}\0'

    while '(' in text:
        text = re.sub(r'\(([^()]*)\)', put, text)
    text = level(text)
    while '\0' in text:
        text = re.sub('\0(\\d+)\0', lambda match: aside[int(match[1])], text)
    return text



Edge = namedtuple('Edge', 'source target guard bounds channel sends updates resets')


class Network:
    """The instances of a file: their locations are the first numbers of a state, then come the variables."""

    def __init__(self, file):
        root = xml.parse(file).getroot()
        system = re.sub(r'//.*', '', root.findtext('system'))
        templates = {each.findtext('name').strip(): each for each in root.findall('template')}
        made = {name: made for name, *made in re.findall(rf'({NAME})\s*=\s*({NAME})\s*\(([^;]*)\)\s*;', system)}
        self.names = [name.strip() for name in re.search(r'\bsystem\b([^;]*);', system)[1].split(',')]
        self.initial, self.ranges = [0] * len(self.names), [None] * len(self.names)
        self.clocks, self.globals, self.members, self.locations, self.edges = 0, {'true': 1, 'false': 0}, {}, [], []
        self.declare(root.findtext('declaration', ''), self.globals)
        for place, name in enumerate(self.names):
            template, arguments = made.get(name, (name, ''))
            self.instantiate(place, name, templates[template], arguments)
        self.limits = [self.limits_of(*pair) for pair in zip(self.locations, self.edges)]

    def declare(self, text, scope):
        for statement in re.sub(r'//[^\n]*|/\*.*?\*/', '', text, flags=re.S).split(';'):
            match = re.match(r'\s*((?:(?:const|urgent|broadcast)\s+)*)(int|bool|clock|chan)\s*'
                             r'(?:\[([^],]*),([^]]*)\])?\s*(.*)', statement, re.S)
            if match:
                words, kind, low, high, names = match.groups()
                low, high = (self.constant(low, scope), self.constant(high, scope)) if low else (
                    (0, 1) if kind == 'bool' else (-32768, 32767))
                for name, size, value in re.findall(rf'({NAME})\s*(?:\[([^]]*)\])?\s*(?:=\s*(\{{.*?\}}|[^,]*))?', names):
                    keys = [f'{name}[{i}]' for i in range(self.constant(size, scope))] if size else [name]
                    values = value.strip('{} ').split(',') if value else ['0'] * len(keys)
                    for key, first in zip(keys, values):
                        scope[key] = self.symbol(words, kind, key, (low, high), self.constant(first, scope))

    def symbol(self, words, kind, key, limits, first):
        if 'const' in words:
            return first
        if kind == 'chan':
            return 'chan', key, 'broadcast' in words, 'urgent' in words
        if kind == 'clock':
            self.clocks += 1
            return 'clock', self.clocks
        self.initial.append(first)
        self.ranges.append(limits)
        return 's', len(self.initial) - 1

    def instantiate(self, place, name, template, arguments):
        scope = dict(self.globals)
        parameters = re.findall(rf'({NAME})\s*(?:,|$)', re.sub(r'\[.*?\]', '', template.findtext('parameter', '')))
        values = [self.constant(value, self.globals) for value in arguments.split(',')] if parameters else []
        scope.update(zip(parameters, values))
        outside = set(scope)
        self.declare(template.findtext('declaration', ''), scope)
        ids = [location.get('id') for location in template.findall('location')]
        self.initial[place] = ids.index(template.find('init').get('ref'))
        self.members[name] = {key: value for key, value in scope.items() if key not in outside
                              or value is not self.globals.get(key)}
        self.locations.append([])
        for index, location in enumerate(template.findall('location')):
            self.members[name][location.findtext('name', ids[index]).strip()] = ('at', place, index)
            invariant = self.condition(label(location, 'invariant'), scope)
            self.locations[place].append((*invariant, location.find('committed') is not None,
                                          location.find('urgent') is not None))
        self.edges.append([[] for _ in ids])
        for each in template.findall('transition'):
            source, target = (ids.index(each.find(end).get('ref')) for end in ('source', 'target'))
            sync = label(each, 'synchronisation').strip()
            channel = scope[self.key(sync[:-1], scope)] if sync else None
            updates = [self.update(one, scope) for one in label(each, 'assignment').split(',') if one.strip()]
            self.edges[place][source].append(Edge(
                source, target, *self.condition(label(each, 'guard'), scope), channel, sync.endswith('!'),
                [one for one in updates if one[0] == 's'], {one[1] for one in updates if one[0] == 'clock'}))

    def key(self, text, scope):
        name, index = re.fullmatch(rf'\s*({NAME})\s*(?:\[(.*)\])?\s*', text).groups()
        return name if index is None else f'{name}[{self.constant(index, scope)}]'

    def update(self, text, scope):
        name, step, value = re.fullmatch(r'\s*(\w+(?:\[.*?\])?)\s*(?::?=|(\+\+|--))(.*)', re.sub(
            r'//[^\n]*', '', text).strip(), re.S).groups()
        kind, place = scope[self.key(name, scope)][:2]
        return kind, place, self.function(f'{name} {step[0]} 1' if step else value, scope)

    def condition(self, text, scope):
        """What is said of variables, and of clocks: (clock, operator, limit)."""
        bounds = []

        def bound(match):
            found = scope.get(self.key(match[1], scope))
            if not isinstance(found, tuple) or found[0] != 'clock':
                return match[0]
            bounds.append((found[1], match[2], self.function(match[3], scope)))
            return 'true'
        text = re.sub(rf'\b({NAME}(?:\[[^]]*\])?)\s*(<=|>=|==)\s*((?:[^&|()]|\([^()]*\))+)', bound, text)
        return self.function(text.strip() or 'true', scope), bounds

    def resolve(self, text, scope):
        """All names replaced by what they stand for: numbers, and places s[i] of a state."""
        def one(match):
            if match[0] in ('and', 'or', 'not', 'if', 'else', 'bool', 'deadlock'):
                return match[0]
            names = self.members[match[1]] if match[1] else scope
            found = names[match[2] if match[3] is None else f'{match[2]}[{self.constant(match[3], scope)}]']
            if not isinstance(found, tuple):
                return str(found)
            return f's[{found[1]}]' if found[0] == 's' else f'(s[{found[1]}]=={found[2]})'
        return re.sub(rf'(?:({NAME})\.)?\b({NAME})(?:\[([^]]*)\])?', one, text)

    def constant(self, text, scope):
        return int(eval(self.resolve(python(text), scope)))

    def function(self, text, scope):
        return eval(f'lambda s, deadlock=False: {self.resolve(python(text), scope)}')

    def limits_of(self, locations, edges):
        """How far each clock matters at each location: the greatest number that it is compared with from there on."""
        highest, lowest = ([each[end] if each else 0 for each in self.ranges] for end in (1, 0))
        limits = [[-1] * (self.clocks + 1) for _ in locations]
        for at, location in enumerate(locations):
            for clock, _, limit in location[1] + [bound for edge in edges[at] for bound in edge.bounds]:
                limits[at][clock] = max(limits[at][clock], limit(highest), limit(lowest))
        grows = True
        while grows:
            before = [list(each) for each in limits]
            for edge in (edge for leaving in edges for edge in leaving):
                for clock in set(range(1, self.clocks + 1)) - edge.resets:
                    limits[edge.source][clock] = max(limits[edge.source][clock], limits[edge.target][clock])
            grows = before != limits
        return limits


def label(element, kind):
    return next((each.text or '' for each in element.findall('label') if each.get('kind') == kind), '')


class Zone:
    """A difference bound matrix: above[i][j] bounds clock i less clock j, as 2 n + 1 for <= n and 2 n for < n."""

    ZERO, NONE = 1, 1 << 60

    def __init__(self, above):
        self.above, self.empty = above, False

    def copy(self):
        zone = Zone([list(row) for row in self.above])
        zone.empty = self.empty
        return zone

    @staticmethod
    def sum(a, b):
        return Zone.NONE if Zone.NONE in (a, b) else a + b - ((a | b) & 1)

    def constrain(self, i, j, bound):
        above, size = self.above, range(len(self.above))
        if bound < above[i][j] and not self.empty:
            self.empty = Zone.sum(above[j][i], bound) < Zone.ZERO
            for p in size:
                first = Zone.sum(above[p][i], bound)
                for q in size:
                    above[p][q] = min(above[p][q], Zone.sum(first, above[j][q]))
        return self

    def future(self):
        for row in self.above[1:]:
            row[0] = Zone.NONE

    def past(self):
        for j in range(1, len(self.above)):
            self.above[0][j] = min([Zone.ZERO] + [row[j] for row in self.above[1:]])

    def reset(self, clock):
        self.above[clock] = list(self.above[0])
        for row in self.above:
            row[clock] = row[0]


def within(zone, bounds, s, but=()):
    """The part of a zone where what is said of clocks is true."""
    part = zone.copy()
    for clock, operator, limit in bounds:
        if clock not in but:
            if operator != '>=':
                part.constrain(clock, 0, 2 * limit(s) + 1)
            if operator != '<=':
                part.constrain(0, clock, -2 * limit(s) + 1)
    return part


def without(zone, others):
    """What is left of a zone, in pieces."""
    pieces = [zone]
    for other in others:
        pieces = [piece for each in pieces for piece in cut(each, other)]
    return pieces


def cut(zone, other):
    rest = zone.copy()
    for i, row in enumerate(other.above):
        for j, bound in enumerate(row):
            if bound < rest.above[i][j] and not rest.empty and not other.empty:
                piece = rest.copy().constrain(j, i, 1 - bound)
                if not piece.empty:
                    yield piece
                rest.constrain(i, j, bound)
    if other.empty:
        yield rest


class Exploration:
    """All that can be reached. A node is a state and a zone; some runs may end there, and in some it is a deadlock."""

    def __init__(self, network):
        self.network = network
        self.numbers, self.nodes, self.follows, self.ends, self.deadlocks = {}, [], [], [], []
        self.reach(tuple(network.initial), Zone([[Zone.ZERO] * (network.clocks + 1) for _ in range(network.clocks + 1)]))
        for number, (state, zone, waits) in enumerate(self.nodes):
            moves = list(self.moves(state, zone))
            enabled = [each[1] for each in moves]
            for each in enabled if waits else ():
                each.past()
            stuck = bool(without(zone, enabled))
            self.ends.append(stuck or waits and all(row[0] == Zone.NONE for row in zone.above[1:]))
            self.deadlocks.append({True} if not moves else {False, stuck})
            self.follows.append([self.reach(target, after) for _, _, target, after in moves])
            self.nodes[number] = state, None, waits

    def reach(self, state, zone):
        places = [locations[at] for locations, at in zip(self.network.locations, state)]
        waits = not any(committed or urgent for _, _, committed, urgent in places) and not any(
            part.channel and part.channel[3] for part, _, _, _ in self.moves(state, zone))
        if waits:
            zone.future()
            zone = within(zone, [bound for place in places for bound in place[1]], state)
        limits = [0] + [max(each[at][clock] for each, at in zip(self.network.limits, state))
                        for clock in range(1, self.network.clocks + 1)]
        normal = Zone([[Zone.ZERO if i in (0, j) else Zone.NONE for j in range(len(limits))] for i in range(len(limits))])
        for i, row in enumerate(zone.above):
            for j, bound in enumerate(row):
                if min(limits[i], limits[j]) >= 0 and bound >> 1 <= limits[i]:
                    normal.constrain(i, j, max(bound, -2 * limits[j]))
        number = self.numbers.setdefault((state, *map(tuple, normal.above)), len(self.nodes))
        if number == len(self.nodes):
            self.nodes.append((state, normal, waits))
        return number

    def moves(self, state, zone):
        """The steps from a zone: the first edge, where in the zone it is possible, the next state and its zone."""
        hurry = any(locations[at][2] for locations, at in zip(self.network.locations, state))
        for place, edges in enumerate(self.network.edges):
            for edge in edges[state[place]]:
                if (edge.sends or not edge.channel) and edge.guard(state):
                    for parts, part in self.together([(place, edge)], state, within(zone, edge.bounds, state)):
                        if not part.empty and (not hurry or any(
                                self.network.locations[each][state[each]][2] for each, _ in parts)):
                            yield from self.perform(parts, state, part)

    def together(self, first, state, zone):
        """All ways in which others can join the first: whoever can hear a broadcast must, where it can."""
        (place, edge), = first
        hearing = [[(other, each) for each in edges[state[other]]
                    if each.channel == edge.channel and not each.sends and each.guard(state)]
                   for other, edges in enumerate(self.network.edges) if edge.channel and other != place]
        if not edge.channel or not edge.channel[2]:
            return [(first + [other], within(zone, other[1].bounds, state)) for each in hearing for other in each] \
                if edge.channel else [(first, zone)]
        ways = [(first, zone)]
        for choices in hearing:
            ways = [way for parts, part in ways for way in (
                [(parts + [other], within(part, other[1].bounds, state)) for other in choices]
                + [(parts, piece) for piece in without(part, [within(part, other[1].bounds, state) for other in choices])])]
        return ways

    def perform(self, parts, state, zone):
        target = list(state)
        for place, edge in parts:
            target[place] = edge.target
            for _, slot, value in edge.updates:
                target[slot] = int(value(target))
                low, high = self.network.ranges[slot]
                if not low <= target[slot] <= high:
                    raise ValueError(f'{target[slot]} leaves [{low},{high}] on {edge}')
        resets = {clock for _, edge in parts for clock in edge.resets}
        bounds = []
        for locations, at in zip(self.network.locations, target):
            if not locations[at][0](target):
                return
            bounds += locations[at][1]
        enabled = within(zone, bounds, target, resets)
        after = enabled.copy()
        for clock in resets:
            after.reset(clock)
        if not enabled.empty:
            yield parts[0][1], enabled, tuple(target), after

    def holds(self, text):
        text = text.strip()
        if '-->' in text:
            before, goal = (self.truth(part) for part in text.split('-->'))
            return self.lost(goal).isdisjoint(each for each, begins in enumerate(before) if begins)
        truth = self.truth(text[3:])
        if text.startswith('A<>'):
            return 0 not in self.lost(truth)
        return all(truth) if text.startswith('A[]') else self.some(text[3:])

    def truth(self, text):
        asked = self.network.function(text, self.network.globals)
        return [all(asked(state, deadlock) for deadlock in dead)
                for (state, _, _), dead in zip(self.nodes, self.deadlocks)]

    def some(self, text):
        asked = self.network.function(text, self.network.globals)
        return any(asked(state, deadlock) for (state, _, _), dead in zip(self.nodes, self.deadlocks)
                   for deadlock in dead)

    def lost(self, goal):
        """The nodes from which a run need not come to the goal."""
        lost = {number for number, reached in enumerate(goal) if not reached}
        while True:
            saved = {each for each in lost if not self.ends[each] and lost.isdisjoint(self.follows[each])}
            if not saved:
                return lost
            lost -= saved


def queries(file):
    text = re.sub(r'\\\n', ' ', open(file).read())
    return re.findall(r'/\*\s*(\w+) (holds|fails):.*?\*/\s*\n(.+)', text)


def main(files):
    wrong = 0
    for file in files:
        began = time.time()
        found = Exploration(Network(file))
        states = len({state for state, _, _ in found.nodes})
        print(f'{file}: {states} states of locations and variables, {len(found.nodes)} with zones, '
              f'{time.time() - began:.0f} s')
        for name, expected, text in queries(file[:-3] + 'q'):
            verdict = 'holds' if found.holds(text) else 'fails'
            wrong += verdict != expected
            print(f'  {name} {verdict}' + ('' if verdict == expected else f', but {expected} was expected'), flush=True)
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
