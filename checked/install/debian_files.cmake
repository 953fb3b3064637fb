# SPDX-License-Identifier: MIT
# Run by cpack on what it has installed: what Debian's policy has in a package and no other installation
# needs.
set(usr ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr)
set(doc ${usr}/share/doc/${CPACK_PACKAGE_NAME})
if(CPACK_OPLUS_PYTHON_FROM)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env --unset=DESTDIR
                          ${CMAKE_COMMAND} --install ${CPACK_OPLUS_PYTHON_FROM} --component python --strip
                          --prefix ${usr}/lib/python3/dist-packages
                  COMMAND_ERROR_IS_FATAL ANY)
endif()
file(MAKE_DIRECTORY ${doc})
file(COPY_FILE ${CMAKE_CURRENT_LIST_DIR}/copyright ${doc}/copyright)
file(COPY_FILE ${CMAKE_CURRENT_LIST_DIR}/../../CHANGELOG.md ${doc}/changelog)
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${doc}/changelog.Debian
"${CPACK_PACKAGE_NAME} (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * Built from the sources of version ${CPACK_PACKAGE_VERSION}.

 -- ${CPACK_PACKAGE_CONTACT}  ${now}
")
file(GLOB pages ${usr}/share/man/man1/*)
execute_process(COMMAND gzip --best --no-name ${doc}/changelog ${doc}/changelog.Debian ${pages}
                COMMAND_ERROR_IS_FATAL ANY)
