# SPDX-License-Identifier: MIT
class Oplus < Formula
  desc "Planar Minkowski sums, no-fit and inner-fit polygons, exactly"
  homepage "@homepage@"
  url "@archive@"
  sha256 "@sha256@"
  license "MIT"

  depends_on "boost" => :build
  depends_on "cmake" => :build
  depends_on "ninja" => :build
  depends_on "python@3.13" => :build
  depends_on "rapidjson" => :build
  depends_on "gmp"
  depends_on :linux

  def install
    system "cmake", "-S", ".", "-B", "build/release", "-G", "Ninja",
                    "-DOPLUS_ENGINES=OFF", "-DOPLUS_TESTS=OFF", *std_cmake_args
    system "cmake", "--build", "build/release"
    system "cmake", "--install", "build/release"
  end

  test do
    (testpath/"test.cpp").write <<~CPP
      #include <oplus/oplus.hpp>
      int main() {
        auto square = oplus::polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
        return area(oplus::minkowski_sum(square, square)) == 4 ? 0 : 1;
      }
    CPP
    system ENV.cxx, "-std=c++20", "test.cpp", "-I#{include}", "-L#{lib}", "-loplus_core", "-lgmpxx", "-lgmp",
                    "-pthread", "-o", "test"
    system "./test"
  end
end
