# SPDX-License-Identifier: MIT
# Run by cpack on what it has installed, a folder for each component: what Debian's policy has in a package and no
# other installation needs.
find_program(has_help2man help2man)
find_program(has_shlibdeps dpkg-shlibdeps)
if(NOT has_help2man OR NOT has_shlibdeps)
  message(FATAL_ERROR "packages are made with Debian's help2man and dpkg-dev, which are not installed")
endif()
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} variable)
  set(package ${CPACK_DEBIAN_${variable}_PACKAGE_NAME})
  set(usr ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${component}/usr)
  set(doc ${usr}/share/doc/${package})
  file(MAKE_DIRECTORY ${doc})
  if(component STREQUAL python)
    file(MAKE_DIRECTORY ${usr}/lib/python3/dist-packages)
    file(RENAME ${usr}/oplus ${usr}/lib/python3/dist-packages/oplus)
  endif()
  file(COPY_FILE ${CMAKE_CURRENT_LIST_DIR}/copyright ${doc}/copyright)
  file(COPY_FILE ${CMAKE_CURRENT_LIST_DIR}/../../CHANGELOG.md ${doc}/changelog)
  file(WRITE ${doc}/changelog.Debian
"oplus (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * Built from the sources of version ${CPACK_PACKAGE_VERSION}.

 -- ${CPACK_PACKAGE_CONTACT}  ${now}
")
  file(GLOB pages ${usr}/share/man/man1/*)
  execute_process(COMMAND gzip --best --no-name ${doc}/changelog ${doc}/changelog.Debian ${pages}
                  COMMAND_ERROR_IS_FATAL ANY)
endforeach()
