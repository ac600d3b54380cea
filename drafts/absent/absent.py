"""One sender, its places and turns (SPEC 7.2 to 7.4); a present partner and absent ones, as in the campaign's Absent.
Time in slots of 8 ms.  absent.py SEEDS: figures as the campaign gives them, of so many campaigns."""
import random, sys
DATA=36; ACK=19; PAT=19; LATE=75; SEC=125; PLACES=4; QUEUE=14; ATT=8
class M: pass
def run(absent, rule, seed, T=60, present=2.0, every=10.0, host=(2,5), bad=None, more=()):
    """rule: dict. bad: (partner, share of its attempts that are answered). more: further (partner, mean seconds) that answer"""
    R=random.Random(seed); arr=[]
    def flow(p, mean, answers):
        t=R.expovariate(1/mean)
        while t<T: arr.append((int(t*SEC),p,answers)); t+=R.expovariate(1/mean)
    flow('P',present,1.0)
    for p,m,a in more: flow(p,m,a)
    for i in range(absent): flow('A%d'%i, every*absent, 0.0)
    arr.sort(); ai=0; t=0
    places=[None]*PLACES; last=[None]*PLACES; turn=0; box=[]; waits=[]; refused=0; ends=[]; answering=set(); row=0; lost=0
    def arrive(upto):
        nonlocal ai, refused
        while ai<len(arr) and arr[ai][0]<=upto:
            at,p,a=arr[ai]; ai+=1
            if len(box)+sum(x is not None for x in places)>=QUEUE:
                refused+=(p=='P'); continue
            m=M(); m.at=at; m.p=p; m.a=a; m.att=0; m.passed=0; m.not_before=0; m.begun=None; box.append(m)
    def candidate():
        free=[i for i in range(PLACES) if places[i] is None]
        if not free: return None
        under={x.p for x in places if x is not None}; best=None
        for m in box:
            if m.p in under or any(b.p==m.p and b is not m for b in box[:box.index(m)]): continue
            if rule.get('reserve') and len(free)<=rule['reserve'] and m.p not in answering: continue
            first=m.p not in [last[i] for i in free]
            if first or rule.get('oldest'): return m
            if best is None: best=m
        return best
    def take(m):
        free=[i for i in range(PLACES) if places[i] is None]
        # the place whose turn is next
        i=min(free,key=lambda i:(i-turn-1)%PLACES); places[i]=m; last[i]=m.p; box.remove(m); return i
    def choose():
        """The place that has the next turn, or None."""
        nonlocal row, turn
        order=[(turn+1+k)%PLACES for k in range(PLACES)]
        k=rule.get('new')          # new messages go first, at most k in a row while a retry waits
        retry=[i for i in order if places[i] is not None and places[i].not_before<=t]
        if k is None:
            for i in order:
                if places[i] is not None:
                    if places[i].not_before<=t: turn=i; return i
                else:
                    m=candidate()
                    if m: turn=i; return take_at(i,m)
            return None
        m=candidate()
        if k is not None and 'budget' in rule:
            if m is not None and all(x is None or x.passed<rule['budget'] for x in places):
                for x in places:
                    if x is not None: x.passed+=1
                return take(m)
            for i in order:
                if places[i] is not None: turn=i; return i
                if m is not None: turn=i; return take_at(i,m)
            return None
        if m is not None and not (retry and row>=k):
            row=row+1 if retry else 0
            return take(m)
        if retry: turn=retry[0]; return turn
        row=0
        if m is not None: return take(m)
        return None
    def take_at(i,m): places[i]=m; last[i]=m.p; box.remove(m); return i
    quiet=100; quietsince=0
    while True:
        arrive(t); i=choose()
        if i is None:
            nxt=[x.not_before for x in places if x is not None and x.not_before>t]
            if ai<len(arr): nxt.append(arr[ai][0])
            if not nxt: break
            n=min(nxt); quiet+=n-t; t=n; continue
        m=places[i]
        if m.begun is None: m.begun=t
        if m.att==0: w=0 if quiet>=15 else max(0,6-quiet)+R.randrange(16)
        else: w=max(0,6-quiet)+R.randrange(min(256,16<<min(m.att,3)))
        if rule.get('preempt') and m.att>0:
            # a new message that comes meanwhile takes the turn
            stop=None
            for dt in range(w):
                arrive(t+dt)
                if candidate() is not None and (all(x is None or x.passed<rule['budget'] for x in places) if 'budget' in rule else row<rule['new']): stop=dt; break
            if stop is not None: t+=stop; quiet+=stop; continue
        if m.att: row=0
        t+=w+DATA
        if m.a and R.random()<m.a:
            t+=R.randint(*host)+1+ACK; quiet=0; arrive(t)
            ends.append((m.p,m.begun,t+2,True)); answering.add(m.p)
            if m.p=='P': waits.append((t+2-m.at)/SEC)
            places[i]=None
        else:
            late=m.att>=2
            if late and rule.get('release'): wait=PAT; m.not_before=t+LATE
            else: wait=LATE if late else PAT
            if late and rule.get('cutlate'):
                wait=0
                for r in range(4):
                    wait+=19 if r<3 else 18; arrive(t+wait); row_ok=row<rule['new']
                    if row_ok and (candidate() is not None): break
            t+=wait; quiet=wait; arrive(t); m.att+=1
            if m.att==ATT:
                places[i]=None; answering.discard(m.p); ends.append((m.p,m.begun,t,False)); lost+=m.p=='P'
            elif rule.get('flag') and m.att>=rule['flag']: answering.discard(m.p)
    return waits,refused+lost,ends
def campaign(absent, rule, seed, **kw):
    w=[];r=0
    for k in range(6):
        a,b,_=run(absent,rule,seed*6+k,**kw); w+=a; r+=b
    w.sort(); return w[-(-99*len(w)//100)-1], w[len(w)//2], w[-1], r, len(w)
P=dict(preempt=1,reserve=1,oldest=1)
RULES=[('today',{})]+[('before each at most %d'%k,dict(reserve=1,new=99,preempt=1,budget=k)) for k in (12,16,24,32,48)]+[('at most 24, no preempt',dict(reserve=1,new=99,budget=24))]
def table(n):
    for absent,goal in ((1,3),(3,5),(6,8)):
        for name,rule in RULES:
            c=[campaign(absent,rule,s) for s in range(n)]
            q=sorted(x[0] for x in c)
            print(f"{absent} absent {name:34s} 99%: median {q[n//2]:5.2f} 90 of 100 {q[9*n//10]:5.2f} worst {q[-1]:5.2f}, within {goal} s: {100*sum(x<=goal for x in q)/n:5.1f} % of campaigns, median wait {sorted(x[1] for x in c)[n//2]:.2f}, not delivered {sum(x[3] for x in c)} of {sum(x[4]+x[3] for x in c)}",flush=True)
def fair(n):
    """How long a message waits that gets no answer 8 times, and one to a partner in bad reception"""
    for what,absent,present,more in (('absent beside P/2s',1,2.0,()),('absent beside P always',1,.5,()),('3 absent beside P always',3,.5,()),('P always, X answers 0.4',0,.5,(('X',5.0,.4),)),('3 absent, P/2s, X answers 0.4 each 10 s',3,2.0,(('X',10.0,.4),)),('3 absent beside 5 each 1 s',3,1.0,tuple(('Q%d'%i,1.0,1.0) for i in range(4))),('3 absent, P, Q each 2 s',3,2.0,(('Q',2.0,1.0),)),):
        for name,rule in RULES:
            w={}; un={}; late=[]
            for s in range(n):
                _,_,ends=run(absent,rule,s,present=present,more=more,every=30.0)
                for p,at,end,ok in ends:
                    k=p[0]; w.setdefault(k,[]).append((end-at)/SEC); un[k]=un.get(k,0)+(not ok)
            print(f"{what:40s} {name:28s} "+'; '.join(f"{k}: median {sorted(v)[len(v)//2]:.1f} 90% {sorted(v)[9*len(v)//10]:.1f} 99% {sorted(v)[99*len(v)//100]:.1f} s, undelivered {un[k]}/{len(v)}" for k,v in sorted(w.items())),flush=True)
if __name__=='__main__':
    (fair if len(sys.argv)>2 else table)(int(sys.argv[1]))
