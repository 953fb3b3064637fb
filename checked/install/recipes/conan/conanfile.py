# SPDX-License-Identifier: MIT
from conan import ConanFile
from conan.errors import ConanInvalidConfiguration
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, get, rmdir


class Oplus(ConanFile):
    name = "oplus"
    version = "@version@"
    description = "Planar Minkowski sums, no-fit and inner-fit polygons of polygons with holes, exactly"
    homepage = "@homepage@"
    license = "MIT"
    topics = ("geometry", "minkowski-sum", "no-fit-polygon", "nesting", "offset")
    package_type = "static-library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"fPIC": [True, False]}
    default_options = {"fPIC": True}

    def layout(self):
        cmake_layout(self, src_folder="src")

    def requirements(self):
        self.requires("gmp/6.3.0", transitive_headers=True, transitive_libs=True)
        self.requires("boost/1.83.0", options={"header_only": True})
        self.requires("rapidjson/cci.20230929")

    def build_requirements(self):
        self.tool_requires("cmake/[>=3.25]")
        self.tool_requires("ninja/[>=1.11]")

    def validate(self):
        check_min_cppstd(self, 20)
        if self.settings.os != "Linux" or self.settings.compiler.get_safe("libcxx") == "libc++":
            raise ConanInvalidConfiguration("oplus is built on Linux with libstdc++ only")

    def source(self):
        get(self, "@archive@", sha256="@sha256@", strip_root=True)

    def generate(self):
        toolchain = CMakeToolchain(self, generator="Ninja")
        toolchain.cache_variables["OPLUS_ENGINES"] = False
        toolchain.cache_variables["OPLUS_TESTS"] = False
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "MIT.txt", src=f"{self.source_folder}/LICENSES", dst=f"{self.package_folder}/licenses")
        CMake(self).install()
        for folder in ("lib/cmake", "lib/pkgconfig"):
            rmdir(self, f"{self.package_folder}/{folder}")

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "oplus")
        self.cpp_info.set_property("cmake_target_name", "oplus::oplus")
        self.cpp_info.set_property("pkg_config_name", "oplus")
        self.cpp_info.libs = ["oplus_core"]
        self.cpp_info.requires = ["gmp::gmpxx", "gmp::libgmp", "boost::headers", "rapidjson::rapidjson"]
        self.cpp_info.system_libs = ["pthread"]
