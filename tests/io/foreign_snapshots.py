"""Copies of a sound snapshot that reach for other files or for memory, each sealed as eerie does.

Usage: foreign_snapshots.py SOUND.hdf5 FOLDER; FOLDER/NAME.hdf5 for each name that it prints.
"""
import hashlib
import shutil
import sys

import h5py
import numpy

sound, folder = sys.argv[1], sys.argv[2]
seal_length = len("eerie-sha256:") + 64 + 1


def moved(file, name):
    """What stands under the name, which is free now."""
    values = file[name][...]
    del file[name]
    return values


def external_link(file):
    del file["State/Coordinates"]
    file["State/Coordinates"] = h5py.ExternalLink("other.hdf5", "/State/Coordinates")


def external_group(file):
    del file["State"]
    file["State"] = h5py.ExternalLink("other.hdf5", "/State")


def soft_link(file):
    file["elsewhere"] = h5py.ExternalLink("other.hdf5", "/State/Coordinates")
    del file["State/Coordinates"]
    file["State/Coordinates"] = h5py.SoftLink("/elsewhere")


def external_storage(file):
    values = moved(file, "State/Coordinates")
    values.tofile(folder + "/other.raw")
    file.create_dataset("State/Coordinates", shape=values.shape, dtype=values.dtype,
                        external=[(folder + "/other.raw", 0, values.nbytes)])


def virtual_dataset(file):
    values = moved(file, "State/Coordinates")
    layout = h5py.VirtualLayout(shape=values.shape, dtype=values.dtype)
    layout[...] = h5py.VirtualSource(folder + "/other.hdf5", "/State/Coordinates",
                                     shape=values.shape)
    file.create_virtual_dataset("State/Coordinates", layout)


def many_ids(file):
    """4e12 bytes of identities, of which the file holds none."""
    del file["State/ParticleIDs"]
    file.create_dataset("State/ParticleIDs", shape=(10**12,), dtype="u4", chunks=(1024,))


def overflowing_ids(file):
    """2^62 identities: their bytes are no more than 2^64, which is 0."""
    del file["State/ParticleIDs"]
    file.create_dataset("State/ParticleIDs", shape=(2**62,), dtype="u4", chunks=(1024,))


def compressed_ids(file):
    """Identities that deflate packs well, and no other array as long: the others cost 60 times."""
    del file["State/ParticleIDs"]
    file.create_dataset("State/ParticleIDs", data=numpy.zeros(20_000_000, "u4"),
                        compression="gzip", chunks=(1_000_000,))


def large_chunks(file):
    values = moved(file, "State/Coordinates")
    data = file.create_dataset("State/Coordinates", shape=values.shape, maxshape=(None, 3),
                               chunks=(100_000_000, 3), dtype=values.dtype, compression="gzip")
    data.id.write_direct_chunk((0, 0), b"no deflated stream")


for make in (external_link, external_group, soft_link, external_storage, virtual_dataset, many_ids,
             overflowing_ids, compressed_ids, large_chunks):
    path = f"{folder}/{make.__name__}.hdf5"
    with open(sound, "rb") as whole, open(path, "wb") as copy:
        copy.write(whole.read()[:-seal_length])
    with h5py.File(path, "r+", libver="latest") as file:
        make(file)
    with open(path, "rb") as file:
        digest = hashlib.sha256(file.read()).hexdigest()
    with open(path, "a") as file:
        file.write(f"eerie-sha256:{digest}\n")
    print(make.__name__)
shutil.copy(sound, folder + "/other.hdf5")
