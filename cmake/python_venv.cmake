# HODT_BUILD_PYTHON=AUTO: ON with the Python of build/venv, if scripts/python_venv.sh made that.
set(HODT_VENV_PYTHON ${PROJECT_SOURCE_DIR}/build/venv/bin/python)
set(HODT_BUILD_PYTHON OFF)
execute_process(COMMAND ${HODT_VENV_PYTHON} -c "import nanobind, numpy, pytest" RESULT_VARIABLE missing
                OUTPUT_QUIET ERROR_QUIET)
if(NOT missing)
  set(HODT_BUILD_PYTHON ON)
  set(Python_EXECUTABLE ${HODT_VENV_PYTHON})
else()
  message(STATUS "Without build/venv (scripts/python_venv.sh) the Python package is not built and not tested")
endif()
