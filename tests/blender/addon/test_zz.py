import time, unittest, bpy, meshes, numpy as np
from craze_blender import process, runs, work as w, mesh_in, cracked
LIGHT = """
mesh.edge = "keep"
material = { criterion = "strength", scatter = 0.15 }
layer.relative_spacing = 0.3
evolution.max_load = 1.5
post = { gap = 0.1 }
"""
class T(unittest.TestCase):
    def test(self):
        meshes.empty()
        thing = meshes.link(meshes.grid(317))
        for k in range(2): thing.vertex_groups.new(name=f"g{k}").add(range(len(thing.data.vertices)), 0.5, "REPLACE")
        b=time.perf_counter(); snap = mesh_in.snapshot(bpy.context, thing); print("snapshot", time.perf_counter()-b)
        order = runs.Order(mesh=snap, groups=[g.name for g in thing.vertex_groups], stretch=np.eye(3), recipe=LIGHT, is_text=True)
        g = runs.crack(process.engine(), order, "made")
        req=None; n=0
        while True:
            if req is not None and req.state=="running": time.sleep(0.005); continue
            b=time.perf_counter(); c=time.thread_time()
            try: req = next(g)
            except StopIteration as e: print("end",time.perf_counter()-b); break
            dt=time.perf_counter()-b; ct=time.thread_time()-c
            f=g
            loc=[]
            while f is not None:
                loc.append(f"{f.gi_code.co_name}:{f.gi_frame.f_lineno if f.gi_frame else 0}"); f=f.gi_yieldfrom if hasattr(f.gi_yieldfrom,'gi_code') else None
            if ct>0.01: print(f"step {n} {dt*1e3:.1f} ms cpu {ct*1e3:.1f}", loc)
            n+=1
        print(n,"steps")
