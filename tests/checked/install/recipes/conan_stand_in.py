#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""conan_stand_in.py RECIPE ARCHIVE WORK: what Conan 2 does with a recipe, of what that of oplus uses: source, generate,
build, package into WORK/package. Prints what a compiler is told of the package."""

import hashlib
import importlib.util
import shutil
import subprocess
import sys
import types
from pathlib import Path

RECIPE, ARCHIVE, WORK = (Path(argument).resolve() for argument in sys.argv[1:])
PACKAGE = WORK / "package"
# What Conan's own packages say of themselves, where Debian has them installed for the compiler.
LIBRARIES = {"gmp::gmpxx": ["gmpxx"], "gmp::libgmp": ["gmp"], "boost::headers": [], "rapidjson::rapidjson": []}


class InvalidConfiguration(Exception):
    pass


class Strict:
    """Has the attributes it is made with, and takes no others."""

    def __init__(self, **values):
        object.__setattr__(self, "values", values)

    def __getattr__(self, name):
        return self.values[name]

    def __setattr__(self, name, value):
        assert name in self.values, name
        self.values[name] = value

    def get_safe(self, name):
        return self.values.get(name)


class ConanFile:
    def __init__(self):
        self.required, self.tools, self.properties = [], [], {}
        self.settings = Strict(os="Linux", arch="x86_64", build_type="Release",
                               compiler=Strict(libcxx="libstdc++11", cppstd="20"))
        assert set(type(self).settings) <= {"os", "arch", "compiler", "build_type"}, type(self).settings
        assert set(type(self).default_options) == set(type(self).options)
        self.source_folder, self.build_folder, self.package_folder = WORK / "src", WORK / "src/build/release", PACKAGE
        self.cpp_info = Strict(libs=[], requires=[], system_libs=[], set_property=self.properties.__setitem__)

    def requires(self, reference, transitive_headers=False, transitive_libs=False, options=None):
        self.required.append(reference)

    def tool_requires(self, reference):
        self.tools.append(reference)


class Toolchain:
    """Remembers the cache variables for CMake, as the toolchain's preset does."""

    def __init__(self, recipe, generator=None):
        self.recipe, self.generator, self.cache_variables = recipe, generator, {}

    def generate(self):
        self.recipe.toolchain = self


class Deps:
    def __init__(self, recipe):
        self.recipe = recipe

    def generate(self):
        self.recipe.has_deps = True


class CMake:
    def __init__(self, recipe):
        self.recipe = recipe

    @staticmethod
    def run(*command):
        subprocess.run(["cmake", *command], check=True, stdout=subprocess.DEVNULL)

    def configure(self):
        assert self.recipe.has_deps
        toolchain = self.recipe.toolchain
        self.run("-S", self.recipe.source_folder, "-B", self.recipe.build_folder, "-G", toolchain.generator,
                 "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_INSTALL_PREFIX={PACKAGE}", "-DCMAKE_INSTALL_LIBDIR=lib",
                 *(f"-D{name}={'ON' if value is True else 'OFF' if value is False else value}"
                   for name, value in toolchain.cache_variables.items()))

    def build(self):
        self.run("--build", self.recipe.build_folder)

    def install(self):
        self.run("--install", self.recipe.build_folder)


def get(recipe, url, sha256, strip_root):
    assert url.startswith("https://") and url.endswith("/" + ARCHIVE.name), url
    assert hashlib.sha256(ARCHIVE.read_bytes()).hexdigest() == sha256, "the recipe is of another archive"
    recipe.source_folder.mkdir(parents=True)
    assert strip_root
    subprocess.run(["tar", "-x", "-f", ARCHIVE, "-C", recipe.source_folder, "--strip-components=1"], check=True)


def copy(recipe, pattern, src, dst):
    Path(dst).mkdir(parents=True)
    found = list(Path(src).glob(pattern))
    assert found, f"there is no {src}/{pattern}"
    for file in found:
        shutil.copy(file, dst)


def check_min_cppstd(recipe, standard):
    assert int(recipe.settings.compiler.cppstd) >= standard


def module(name, **contents):
    sys.modules[name] = types.ModuleType(name)
    sys.modules[name].__dict__.update(contents)


module("conan", ConanFile=ConanFile)
module("conan.errors", ConanInvalidConfiguration=InvalidConfiguration)
module("conan.tools")
module("conan.tools.build", check_min_cppstd=check_min_cppstd)
module("conan.tools.cmake", CMake=CMake, CMakeDeps=Deps, CMakeToolchain=Toolchain,
       cmake_layout=lambda recipe, src_folder: None)
module("conan.tools.files", copy=copy, get=get, rmdir=lambda recipe, folder: shutil.rmtree(folder))

specification = importlib.util.spec_from_file_location("conanfile", RECIPE)
conanfile = importlib.util.module_from_spec(specification)
specification.loader.exec_module(conanfile)
[kind] = [value for value in vars(conanfile).values() if isinstance(value, type) and issubclass(value, ConanFile)
          and value is not ConanFile]
recipe = kind()
recipe.layout()
recipe.requirements()
recipe.build_requirements()
recipe.validate()
# What it refuses.
for wrong in ({"os": "Windows"}, {"compiler": Strict(libcxx="libc++", cppstd="20")}):
    other = kind()
    other.settings.values.update(wrong)
    try:
        other.validate()
    except InvalidConfiguration:
        continue
    sys.exit(f"{RECIPE.name} accepts {wrong}")
recipe.source()
recipe.generate()
recipe.build()
recipe.package()
recipe.package_info()

info = recipe.cpp_info
assert (PACKAGE / "licenses/MIT.txt").is_file()
assert not list(PACKAGE.rglob("*.cmake")) and not list(PACKAGE.rglob("*.pc"))
assert recipe.properties["cmake_target_name"] == "oplus::oplus"
assert {reference.split("/")[0] for reference in recipe.required} == {name.split("::")[0] for name in info.requires}
for library in info.libs:
    assert (PACKAGE / f"lib/lib{library}.a").is_file(), library
libraries = info.libs + [one for name in info.requires for one in LIBRARIES[name]] + info.system_libs
print(f"-I{PACKAGE}/include -L{PACKAGE}/lib", *(f"-l{one}" for one in libraries))
