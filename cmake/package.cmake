# A Debian package: `cpack -G DEB` in the build folder. What it depends on is read off the program.
# Of what is built: neither it nor `cmake --install` starts to build.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME knotspan)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_VENDOR "The Knotspan authors")
set(CPACK_PACKAGE_CONTACT "The Knotspan authors <knotspan@users.noreply.github.com>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "modeller of free-form surfaces that shows the exact NURBS")
set(CPACK_PACKAGE_DESCRIPTION "Knotspan shapes ship hulls, car bodies, castings, characters: open a model,
pull its control points, see the exact surface answer at once. The graphics
card evaluates the NURBS itself, with no mesh of triangles in between.
It reads STEP, IGES, BREP and OBJ, and writes meshes that are nowhere further
from the surface than asked. Every command works without a window, too.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Loaded while it runs, so not to be read off: Qt's way to the display, and a driver.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "qt6-qpa-plugins")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "mesa-vulkan-drivers | vulkan-icd, qt6-wayland")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
include(CPack)
