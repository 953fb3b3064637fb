-- SPDX-License-Identifier: MIT
-- The same in Lua, by LuaJIT's ffi.
local ffi = require("ffi")
ffi.cdef [[
typedef struct oplus_set oplus_set;
const char* oplus_message(void);
void oplus_free(oplus_set* set);
void oplus_free_text(char* text);
int oplus_read(const char* text, oplus_set** set);
int oplus_from_doubles(const double* xy, const size_t* lengths, const int* kinds, size_t chains, oplus_set** set);
int oplus_reflected(const oplus_set* p, oplus_set** set);
int oplus_sum(const oplus_set* p, const oplus_set* q, int boundary, oplus_set** sum);
int oplus_wkt(const oplus_set* set, int digits, char** text);
int oplus_area(const oplus_set* p, double* nearest, char** exact);
]]
local oplus = ffi.load("liboplus.so.1")

local function check(code)
  if code ~= 0 then error(ffi.string(oplus.oplus_message()), 0) end
end

-- The set that a function of the library makes; the garbage collector frees it.
local function set(make, ...)
  local made, arguments = ffi.new("oplus_set*[1]"), {...}
  arguments[#arguments + 1] = made
  check(make(unpack(arguments)))
  return ffi.gc(made[0], oplus.oplus_free)
end

local function text(write, ...)
  local made, arguments = ffi.new("char*[1]"), {...}
  arguments[#arguments + 1] = made
  check(write(unpack(arguments)))
  local copy = ffi.string(made[0])
  oplus.oplus_free_text(made[0])
  return copy
end

local room = set(oplus.oplus_read, "POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,1 3,3 3,3 1,1 1))")
local corners, vertices = ffi.new("double[8]", {0, 0, 1, 0, 1, 1, 0, 1}), ffi.new("size_t[1]", 4)
local robot = set(oplus.oplus_from_doubles, corners, vertices, ffi.cast("int*", 0), 1)
local blocked = set(oplus.oplus_sum, room, set(oplus.oplus_reflected, robot), 0)
print(text(oplus.oplus_wkt, blocked, -1))
print("area " .. text(oplus.oplus_area, blocked, ffi.cast("double*", 0)))
local _, message = pcall(set, oplus.oplus_read, "POLYGON((0 0,1 0,0 1))")
print(message)
