# A thin front: CMake does the work, in build/<preset>. The two to know: make demo, make test.

.PHONY: help demo build test python deb deb-check docs bench lint format asan tsan clang fuzz clean

help:
	@echo "make demo    build hodt and run it on real terrain; results in demo/"
	@echo "make test    build and run all tests"
	@echo "make build   build the command: build/release/hodt"
	@echo "make python  build a wheel and go through it in a fresh virtual environment"
	@echo "make deb     build Debian packages: build/deb/packages"
	@echo "make deb-check  install and use the packages in a minimal Debian root; needs to be root"
	@echo "make docs    build the site of the documentation: build/docs/html/index.html"
	@echo "make bench   build and run the benchmarks"
	@echo "make lint    check the layers, the format and clang-tidy's rules"
	@echo "make format  format all sources"
	@echo "make asan    the tests with address and undefined behaviour sanitizers"
	@echo "make tsan    the tests with the thread sanitizer"
	@echo "make clang   build the library and the command with clang"
	@echo "make fuzz    every reader, the command and all objectives on made-up input, FUZZ_SECONDS each (3600)"

# Each goal says whether it wants tests: the cache of an earlier one must not decide.
demo:
	@scripts/dependencies.sh build
	cmake --preset release -DHODT_BUILD_TESTS=OFF
	cmake --build --preset release --target hodt_program hodt_demo
	build/release/hodt_demo demo

build:
	@scripts/dependencies.sh build
	cmake --preset release -DHODT_BUILD_TESTS=OFF
	cmake --build --preset release --target hodt_program

test:
	@scripts/dependencies.sh test
	@scripts/python_venv.sh
	cmake --preset release -DHODT_BUILD_TESTS=ON -DHODT_BUILD_PYTHON=AUTO -DHODT_PRECOMPILE=ON
	cmake --build --preset release
	ctest --test-dir build/release --output-on-failure -j2

python:
	@scripts/dependencies.sh python
	scripts/python_wheel.sh

deb:
	@scripts/dependencies.sh deb
	@scripts/python_venv.sh
	cmake --preset deb
	cmake --build --preset deb
	cpack --config build/deb/CPackConfig.cmake
	lintian --fail-on error,warning --display-info build/deb/packages/*.deb

deb-check: deb
	scripts/deb_check.sh build/deb/packages

docs:
	@scripts/dependencies.sh docs
	cmake --preset release -DHODT_BUILD_TESTS=OFF
	cmake --build --preset release --target hodt_manual_pages
	scripts/docs.sh build/release/manual/command.md

bench:
	@scripts/dependencies.sh bench
	cmake --preset bench
	cmake --build --preset bench
	@for program in build/bench/bench/*_bench build/bench/bench/*_vs_*; do echo "$$program"; "$$program" || exit 1; done

asan:
	@scripts/dependencies.sh test
	cmake --preset asan -DHODT_BUILD_TESTS=ON
	cmake --build --preset asan
	ctest --test-dir build/asan --output-on-failure -j2

tsan:
	@scripts/dependencies.sh test
	cmake --preset tsan -DHODT_BUILD_TESTS=ON
	cmake --build --preset tsan
	ctest --test-dir build/tsan --output-on-failure -j2

clang:
	@scripts/dependencies.sh clang
	cmake --preset clang
	cmake --build --preset clang --target hodt_program

fuzz:
	@scripts/dependencies.sh fuzz
	cmake --preset fuzz
	cmake --build --preset fuzz --target hodt_fuzz
	scripts/fuzz.sh

lint:
	scripts/lint.sh

format:
	scripts/sources.sh | xargs clang-format -i

clean:
	rm -rf build
