"""Statistics over seeds, as a table: mean and standard error of each number."""

import numpy as np

import craze

mesh = craze.shape("plate?n=30&jitter=0.3")
seeds = range(3)
rows = []
for seed in seeds:
    cracks = craze.crack(mesh, "mud", seed=seed).report["cracks"]
    rows.append([cracks["events"], cracks["length"], cracks["fragments"]])

table = np.array(rows, float)
error = table.std(axis=0, ddof=1) / np.sqrt(len(table))
print(f"{'seed':>6} {'cracks':>8} {'length':>8} {'pieces':>8}")
for seed, row in zip(seeds, table):
    print(f"{seed:6d} {row[0]:8.0f} {row[1]:8.2f} {row[2]:8.0f}")
print(f"{'mean':>6} " + " ".join(f"{value:8.2f}" for value in table.mean(axis=0)))
print(f"{'error':>6} " + " ".join(f"{value:8.2f}" for value in error))
