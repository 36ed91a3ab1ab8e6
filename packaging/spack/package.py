# SPDX-License-Identifier: MIT
#
# A recipe for Spack 1 (spack.readthedocs.io): copy it into a repository of your own as
# packages/edgewise/package.py, and set `git` to the address of your Edgewise.
from spack_repo.builtin.build_systems.cmake import CMakePackage

from spack.package import *


class Edgewise(CMakePackage):
    """Memory and cache profiling of convex collision detection: V-Clip and Enhanced GJK over
    interchangeable data layouts, every answer checked against exact arithmetic."""

    git = "file:///path/to/edgewise"
    version("main", branch="main")
    license("MIT")
    variant("tool", default=True, description="The program that measures, beside the library")

    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("eigen@3.4")  # 5 is taken too, but was not tried here
    depends_on("qhull")
    for package in ("assimp", "gmp +cxx", "sqlite", "nlohmann-json", "cli11", "fmt", "tbb"):
        depends_on(package, when="+tool")

    def cmake_args(self):
        return [
            self.define_from_variant("EDGEWISE_TOOL", "tool"),
            self.define("EDGEWISE_TESTS", False),
        ]

    @run_after("install", when="+tool")
    def install_program(self):  # left out otherwise: it is for this machine
        self.spec["cmake"].command("--install", self.build_directory, "--component", "tool")
