"""Opens a snapshot with yt and prints what yt sees: N, time, then x y z rho mass h by id (SI)."""
import sys

import numpy as np
import yt

yt.set_log_level("error")
ds = yt.load(sys.argv[1])
data = ds.all_data()
ids = np.asarray(data["PartType0", "ParticleIDs"]).astype(int)
order = np.argsort(ids)
x = data["PartType0", "particle_position"].to("m").value[order]
low = ds.parameters["header"]["CoordinatesOffset"]
columns = [
    *(x + low).T,
    data["gas", "density"].to("kg/m**3").value[order],
    data["gas", "mass"].to("kg").value[order],
    data["gas", "smoothing_length"].to("m").value[order],
]
print(type(ds).__name__, len(ids), repr(float(ds.current_time.to("s"))))
for row in zip(ids[order], *columns):
    print(*(repr(value.item()) for value in row))
