# SPDX-License-Identifier: GPL-3.0-or-later
# Every package setae builds with; ./setup installs them. The same file serves the installed package.
find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(Boost 1.74 REQUIRED)
find_package(fmt REQUIRED)
pkg_check_modules(FFTW REQUIRED IMPORTED_TARGET fftw3 fftw3f)
find_path(RANDOM123_INCLUDE Random123/philox.h REQUIRED)
if(NOT TARGET setae_random123)
  add_library(setae_random123 INTERFACE IMPORTED)
  target_include_directories(setae_random123 SYSTEM INTERFACE ${RANDOM123_INCLUDE})
endif()

find_package(Ceres REQUIRED)
find_package(OpenSSL 3 REQUIRED COMPONENTS Crypto)
find_package(cereal REQUIRED)
find_package(pugixml REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
pkg_check_modules(TOMLPLUSPLUS REQUIRED IMPORTED_TARGET tomlplusplus)
pkg_check_modules(LIBZIP REQUIRED IMPORTED_TARGET libzip)
# find_package(HDF5) needs the language C, which a project that uses setae may not have
pkg_search_module(HDF5 REQUIRED IMPORTED_TARGET hdf5-serial hdf5)
# shared, it loads curl and with that Kerberos, LDAP, SSH and TLS, of which no file has need
find_library(HDF5_ARCHIVE NAMES libhdf5_serial.a libhdf5.a HINTS ${HDF5_LIBRARY_DIRS})
find_library(SZIP_LIBRARY NAMES libsz.a sz)
find_library(AEC_LIBRARY NAMES libaec.a aec)
if(HDF5_ARCHIVE AND SZIP_LIBRARY AND AEC_LIBRARY)
  set_target_properties(PkgConfig::HDF5 PROPERTIES INTERFACE_LINK_LIBRARIES
                        "${HDF5_ARCHIVE};${SZIP_LIBRARY};${AEC_LIBRARY};z;${CMAKE_DL_LIBS};m" INTERFACE_LINK_OPTIONS "")
endif()
find_package(PNG REQUIRED)
find_package(JPEG REQUIRED)
pkg_check_modules(TIFF REQUIRED IMPORTED_TARGET libtiff-4>=4.5)
pkg_check_modules(ZSTD REQUIRED IMPORTED_TARGET libzstd)
find_package(ZLIB REQUIRED)
pkg_check_modules(MUPARSER REQUIRED IMPORTED_TARGET muparser)

# Debian's own OpenCVConfig.cmake asks for every part of OpenCV; two are needed. Shared, core loads X11 for windows.
find_path(OPENCV_INCLUDE opencv2/imgproc.hpp PATH_SUFFIXES opencv4 REQUIRED)
set(opencv_links "")
foreach(name libopencv_imgproc.a libopencv_core.a tbb lapack blas z)
  find_library(OPENCV_LINKS_${name} ${name})
  list(APPEND opencv_links ${OPENCV_LINKS_${name}})
endforeach()
if(opencv_links MATCHES "NOTFOUND")
  set(opencv_links opencv_imgproc opencv_core)
else()
  # what nothing calls goes, but for the look for OpenGL's functions when a window is opened
  list(APPEND opencv_links ${CMAKE_DL_LIBS} -Wl,--gc-sections -Wl,--defsym=glXGetProcAddressARB=0)
endif()
if(NOT TARGET setae_opencv)
  add_library(setae_opencv INTERFACE IMPORTED)
  target_include_directories(setae_opencv SYSTEM INTERFACE ${OPENCV_INCLUDE})
  target_link_libraries(setae_opencv INTERFACE ${opencv_links})
endif()

# labels of scale bars: its library is loaded when one is read
pkg_check_modules(TESSERACT REQUIRED tesseract>=5)
find_package(OpenMP REQUIRED COMPONENTS CXX) # its threads are held back
if(NOT TARGET setae_tesseract)
  add_library(setae_tesseract INTERFACE IMPORTED)
  target_include_directories(setae_tesseract SYSTEM INTERFACE ${TESSERACT_INCLUDE_DIRS})
  target_link_libraries(setae_tesseract INTERFACE ${OpenMP_gomp_LIBRARY} ${OpenMP_omp_LIBRARY} ${CMAKE_DL_LIBS}) # GCC's or clang's
endif()

# surfaces larger than one machine's memory: built where MPI and FFTW's part for it are there
find_package(MPI QUIET COMPONENTS C)
find_library(FFTW_MPI_LIBRARY fftw3_mpi)
if(MPI_C_FOUND AND FFTW_MPI_LIBRARY)
  set(SETAE_MPI_FOUND ON)
else()
  set(SETAE_MPI_FOUND OFF)
endif()
