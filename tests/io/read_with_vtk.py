"""Opens a snapshot with VTK's vtkHDFReader and prints N, cells, then x y z rho by id (SI)."""
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOHDF import vtkHDFReader

reader = vtkHDFReader()
if not reader.CanReadFile(sys.argv[1]):
    sys.exit("vtkHDFReader does not accept the file")
reader.SetFileName(sys.argv[1])
reader.Update()
grid = reader.GetOutput()
point_data = grid.GetPointData()
x = vtk_to_numpy(grid.GetPoints().GetData())
ids = vtk_to_numpy(point_data.GetArray("ParticleIDs"))
rho = vtk_to_numpy(point_data.GetArray("Densities"))
stress = vtk_to_numpy(point_data.GetArray("DeviatoricStresses"))
assert stress.shape == (len(ids), 6)
print("vtk", len(ids), grid.GetNumberOfCells())
for i in np.argsort(ids):
    print(ids[i], *(repr(value.item()) for value in (*x[i], rho[i])))
