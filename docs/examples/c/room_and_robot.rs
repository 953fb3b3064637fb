// SPDX-License-Identifier: MIT
// The same in Rust.
use std::ffi::{c_void, CStr, CString};
use std::os::raw::{c_char, c_int};

#[link(name = "oplus")]
extern "C" {
    fn oplus_message() -> *const c_char;
    fn oplus_free(set: *mut c_void);
    fn oplus_free_text(text: *mut c_char);
    fn oplus_read(text: *const c_char, set: *mut *mut c_void) -> c_int;
    fn oplus_from_doubles(xy: *const f64, lengths: *const usize, kinds: *const c_int, chains: usize,
                          set: *mut *mut c_void) -> c_int;
    fn oplus_reflected(p: *const c_void, set: *mut *mut c_void) -> c_int;
    fn oplus_sum(p: *const c_void, q: *const c_void, boundary: c_int, sum: *mut *mut c_void) -> c_int;
    fn oplus_wkt(set: *const c_void, digits: c_int, text: *mut *mut c_char) -> c_int;
    fn oplus_area(set: *const c_void, nearest: *mut f64, exact: *mut *mut c_char) -> c_int;
}

/// A set, freed at the end.
struct Set(*mut c_void);

impl Drop for Set {
    fn drop(&mut self) {
        unsafe { oplus_free(self.0) }
    }
}

fn check(code: c_int) -> Result<(), String> {
    match code {
        0 => Ok(()),
        _ => Err(unsafe { CStr::from_ptr(oplus_message()) }.to_string_lossy().into_owned()),
    }
}

/// The set that a call puts through a pointer.
fn set(call: impl FnOnce(*mut *mut c_void) -> c_int) -> Result<Set, String> {
    let mut made = std::ptr::null_mut();
    check(call(&mut made))?;
    Ok(Set(made))
}

fn text(call: impl FnOnce(*mut *mut c_char) -> c_int) -> Result<String, String> {
    let mut made = std::ptr::null_mut();
    check(call(&mut made))?;
    let copy = unsafe { CStr::from_ptr(made) }.to_string_lossy().into_owned();
    unsafe { oplus_free_text(made) };
    Ok(copy)
}

fn read(wkt: &str) -> Result<Set, String> {
    let wkt = CString::new(wkt).map_err(|error| error.to_string())?;
    set(|made| unsafe { oplus_read(wkt.as_ptr(), made) })
}

fn polygon(outer: &[[f64; 2]]) -> Result<Set, String> {
    set(|made| unsafe { oplus_from_doubles(outer[0].as_ptr(), &outer.len(), std::ptr::null(), 1, made) })
}

fn main() -> Result<(), String> {
    let room = read("POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,1 3,3 3,3 1,1 1))")?;
    let robot = polygon(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])?;
    let reflected = set(|made| unsafe { oplus_reflected(robot.0, made) })?;
    let blocked = set(|made| unsafe { oplus_sum(room.0, reflected.0, 0, made) })?;
    println!("{}", text(|made| unsafe { oplus_wkt(blocked.0, -1, made) })?);
    println!("area {}", text(|made| unsafe { oplus_area(blocked.0, std::ptr::null_mut(), made) })?);
    if let Err(message) = read("POLYGON((0 0,1 0,0 1))") {
        println!("{}", message);
    }
    Ok(())
}
