# SPDX-License-Identifier: MIT
#
# A Spack recipe (spack.readthedocs.io): copy it into a repository of your own as packages/edgewise/package.py, and set
# `git` to where your Edgewise is.
from spack.package import *


class Edgewise(CMakePackage):
    """Memory and cache profiling of convex collision detection: V-Clip and Enhanced GJK over interchangeable
    data layouts, every answer checked against exact arithmetic."""

    git = "file:///path/to/edgewise"
    version("main", branch="main")
    license("MIT")
    variant("tool", default=True, description="The program that measures, beside the library")

    depends_on("cmake@3.25:", type="build")
    depends_on("eigen@3.4:")
    depends_on("qhull")
    for package in ("assimp", "gmp +cxx", "sqlite", "nlohmann-json", "cli11", "fmt", "intel-oneapi-tbb"):
        depends_on(package, when="+tool")

    def cmake_args(self):
        return [self.define_from_variant("EDGEWISE_TOOL", "tool"), self.define("EDGEWISE_TESTS", False)]
