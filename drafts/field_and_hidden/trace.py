import sys; from field import *
a=run(sys.argv[1],sys.argv[2],int(sys.argv[3]),log=(L:=[]))
import inspect
D=[hops(a.neighbours,i) for i in range(len(a.neighbours))]
for m in a.messages: print(m.number,m.origin,'->',m.to,'hops',D[m.origin][m.to],'t %.1f got %s done %s'%(m.time/2000,m.got and '%.1f'%((m.got-m.time)/2000),m.done and '%.1f'%((m.done-m.time)/2000)),'sent',m.sent,'packets',m.packets)
if len(sys.argv)>4:
    k=int(sys.argv[4]); m=a.messages[k]
    for t,b,kind,n,h,c in L:
        if n==k: print('%.3f'%((t-m.time)/2000),'board',b,'(from o %d, to d %d)'%(D[m.origin][b],D[m.to][b]),kind,h)
