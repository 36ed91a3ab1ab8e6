# SPDX-License-Identifier: MIT
# The library, from this tree: conan create packaging/conan -s compiler.cppstd=20 --build=missing (Conan 2).
from os.path import dirname, join

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, rmdir


class Edgewise(ConanFile):
    name = "edgewise"
    version = "0.1.0"
    license = "MIT"
    description = "Convex collision detection (V-Clip, Enhanced GJK) over interchangeable data layouts"
    settings = "os", "compiler", "build_type", "arch"
    package_type = "static-library"

    def export_sources(self):
        tree = dirname(dirname(self.recipe_folder))
        for part in ("CMakeLists.txt", "LICENSE", "README.md", "cmake/*", "src/*", "layouts/*", "tests/consumer/*",
                     "examples/*", "docs/library.md", "packaging/edgewise.pc.in"):
            copy(self, part, tree, self.export_sources_folder)

    def requirements(self):
        self.requires("eigen/[>=3.4 <4]", transitive_headers=True)
        self.requires("qhull/8.0.2")

    def validate(self):
        check_min_cppstd(self, 20)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        dependencies = CMakeDeps(self)
        dependencies.set_property("qhull::libqhull", "cmake_target_name", "Qhull::qhull_r")  # a static one has another name
        dependencies.generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["EDGEWISE_TOOL"] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, join(self.package_folder, "licenses"))
        CMake(self).install()
        rmdir(self, join(self.package_folder, "lib", "cmake"))  # Conan writes its own
        rmdir(self, join(self.package_folder, "lib", "pkgconfig"))

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "edgewise")
        self.cpp_info.set_property("cmake_target_name", "edgewise::edgewise")
        self.cpp_info.libs = ["edgewise"]
        self.cpp_info.cxxflags = ["-ffp-contract=off"]
        self.cpp_info.defines = ["EDGEWISE_CONTRACTION_KNOWN"]
