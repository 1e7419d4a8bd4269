import h5py, numpy

random = numpy.random.default_rng(1)
with h5py.File("mine.hdf5", "w") as file:
    for k in range(10):
        A = random.standard_normal((20, 20))
        problem = file.create_group(f"mine/{k:04}")
        problem["M"] = A @ A.T
        problem["q"] = random.standard_normal(20)
