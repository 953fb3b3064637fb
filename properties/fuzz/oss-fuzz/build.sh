#!/bin/bash -eu
# SPDX-License-Identifier: GPL-3.0-or-later
# Called by OSS-Fuzz with SRC, OUT, WORK, CC, CXX, CFLAGS, CXXFLAGS and LIB_FUZZING_ENGINE.
# GMP's C++ library is the distribution's, hence libstdc++.
flags="${CXXFLAGS/-stdlib=libc++/} -fno-sanitize=vptr,null,alignment,object-size"
cmake -S "$SRC/oplus" -B "$WORK/build" -G Ninja -DOPLUS_FUZZ=ON -DOPLUS_CONTRACTS=ON \
  -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="$flags" \
  -DOPLUS_FUZZ_FLAGS= -DOPLUS_FUZZ_ENGINE="$LIB_FUZZING_ENGINE" \
  -DCMAKE_EXE_LINKER_FLAGS="-Wl,-rpath,'\$ORIGIN/lib'" -DCMAKE_BUILD_WITH_INSTALL_RPATH=ON
cmake --build "$WORK/build"

# The machines that fuzz have none of the distribution's libraries.
mkdir -p "$OUT/lib"
for program in "$WORK"/build/bin/oplus-fuzz-*; do
  name=$(basename "$program")
  target=${name#oplus-fuzz-}
  cp "$program" "$OUT/"
  ldd "$program" | awk '/lib(gmp|gmpxx|mpfr|stdc\+\+)\./ {print $3}' |
    xargs -r cp -L -t "$OUT/lib"
  cp "$SRC/oplus/properties/fuzz/dictionaries/$target.dict" "$OUT/$name.dict"
  rm -f "$OUT/${name}_seed_corpus.zip"
  (cd "$SRC/oplus/properties/fuzz/seeds/$target" && zip -q -r "$OUT/${name}_seed_corpus.zip" .)
  printf '[libfuzzer]\nmax_len = %s\n' "$([ "$target" = slide ] && echo 256 || echo 2048)" \
    >"$OUT/$name.options"
done
