"""As absent.py, but with Courier's own steps: places, exchange, turn_, passes(), takeUp(), turnOf().  firmware.py CAMPAIGNS"""
import random, sys
DATA=36; ACK=19; PAT=19; LATE=75; SEC=125; P=4; BOX=14; ATT=8; MOST=32
IDLE,READY=0,1
def run(absent, new, seed, T=60, present=2.0, every=10.0, host=(2,5), more=()):
    R=random.Random(seed); arr=[]
    def flow(p,mean,a):
        t=R.expovariate(1/mean)
        while t<T: arr.append((int(t*SEC),p,a)); t+=R.expovariate(1/mean)
    flow('P',present,1.0)
    for p,m,a in more: flow(p,m,a)
    for i in range(absent): flow('A%d'%i,every*absent,0.0)
    arr.sort(); ai=0; t=0; quiet=100; box=[]; turn=0; answers=set(); waits=[]; lost=0; ends=[]
    ms=[dict(phase=IDLE,to=None) for _ in range(P)]
    def arrive(upto):
        nonlocal ai,lost
        while ai<len(arr) and arr[ai][0]<=upto:
            at,p,a=arr[ai]; ai+=1
            if len(box)>=BOX: lost+=p=='P'
            else: box.append(dict(at=at,to=p,a=a,under=False))
    def ex(k): ms[0],ms[k]=ms[k],ms[0]
    def turn_of(to):
        free=sum(m['phase']==IDLE for m in ms); r=2
        for m in ms:
            if m['to']!=to: continue
            if m['phase']!=IDLE: return 0
            r=1
        return 0 if new and free==1 and to not in answers else r
    def take_up():
        best=0; got=None
        for b in box:
            x=turn_of(b['to'])
            if x>best:
                best=x; got=b
                if x==2: break
        if got is None: return False
        got['under']=True; ms[0]=dict(phase=READY,to=got['to'],b=got,att=0,passed=0,begun=t); return True
    def passes():
        free=None; under=0
        for k,m in enumerate(ms):
            if m['phase']!=IDLE:
                if m['passed']==MOST: return False
                under+=1
            elif free is None: free=k
        if free is None or under==len(box): return False
        ex(free)
        if not take_up(): ex(free); return False
        for m in ms[1:]:
            if m['phase']!=IDLE: m['passed']+=1
        return True
    def next_turn():
        nonlocal turn
        if new and passes(): return True
        for _ in range(P):
            turn=turn+1 if turn+1<P else 1; ex(turn)
            if ms[0]['phase']==READY or take_up(): return True
        return False
    while True:
        arrive(t)
        if not next_turn():
            if ai>=len(arr): break
            quiet+=arr[ai][0]-t; t=arr[ai][0]; continue
        while True:   # contends
            m=ms[0]
            w=0 if m['att']==0 and quiet>=15 else max(0,6-quiet)+R.randrange(16<<min(m['att'],3))
            stop=None
            if new and m['att']:
                for dt in range(w):
                    arrive(t+dt)
                    if passes(): stop=dt; break
            if stop is None: break
            t+=stop; quiet+=stop; ms[0]['begun']=t
        t+=w+DATA; b=m['b']
        if b['a'] and R.random()<b['a']:
            t+=R.randint(*host)+1+ACK; quiet=0; ok=True
        else:
            w=LATE if m['att']>=2 else PAT; t+=w; quiet=w; m['att']+=1; ok=False
        arrive(t)
        if ok or m['att']==ATT:
            (answers.add if ok else answers.discard)(m['to']); box.remove(b); m['phase']=IDLE
            ends.append((b['to'],m['begun'],b['at'],t,ok))
            if b['to']=='P':
                if ok: waits.append((t+2-b['at'])/SEC)
                else: lost+=1
    return waits,lost,ends
if __name__=='__main__':
    n=int(sys.argv[1])
    for absent,goal in ((0,1),(1,3),(3,5),(6,8)):
        for new in (False,True):
            qs=[]; lost=tot=0; meds=[]
            for s in range(n):
                w=[]
                for k in range(6):
                    a,l,_=run(absent,new,s*6+k); w+=a; lost+=l
                w.sort(); tot+=len(w); qs.append(w[-(-99*len(w)//100)-1]); meds.append(w[len(w)//2])
            qs.sort(); meds.sort()
            print(f"{absent} absent, {'new' if new else 'today':5s}: 99 % wait at most {qs[n//2]:5.2f} s in the median campaign, {qs[9*n//10]:5.2f} in 90 of 100, {qs[-1]:5.2f} in the worst; {100*sum(q<=goal for q in qs)/n:.0f} % within {goal} s; median wait {meds[n//2]:.2f} s; not delivered {lost} of {tot+lost}",flush=True)
    for what,absent,present,more in (('1 absent, P each 2 s',1,2,()),('1 absent, P always',1,.5,()),('3 absent, P each 2 s',3,2,()),('3 absent, P always',3,.5,()),('X answers 0.4, P always',0,.5,(('X',5,.4),)),('3 absent, P each 2 s, X answers 0.4',3,2,(('X',10,.4),)),('3 absent, Q each 3 s (8)',3,3,tuple(('Q%d'%i,3*8,1.0) for i in range(8)))):
        for new in (False,True):
            d={}
            for s in range(n//2):
                for to,begun,at,end,ok in run(absent,new,s,present=present,every=30,more=more)[2]: d.setdefault(to[0],[]).append(((end-begun)/SEC,(end-at)/SEC,ok))
            print(f"{what:36s} {'new' if new else 'today':5s} "+'; '.join(f"{k}: under way 90% {sorted(x[0] for x in v)[9*len(v)//10]:.1f} 99% {sorted(x[0] for x in v)[99*len(v)//100]:.1f}, wait 50% {sorted(x[1] for x in v)[len(v)//2]:.1f} 99% {sorted(x[1] for x in v)[99*len(v)//100]:.1f} s, undelivered {sum(not x[2] for x in v)}/{len(v)}" for k,v in sorted(d.items())),flush=True)
