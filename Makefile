# eerie: `make run` does the main job, `make test` proves the build.
# Both first install the Debian packages that are missing (.ci/packages).
BUILD ?= build
JOBS  ?= $(shell env -u OMP_NUM_THREADS nproc)

.PHONY: help run build test validate reference gallery bench scale settled results test-faults sanitize odr fuzz format tidy install deb test-deb test-container clean packages-run packages-test packages-fuzz packages-deb
FUZZ_SECONDS ?= 600
PREFIX ?= /usr/local

help:   ## this list
	@sed -nE 's/^([a-z-]+):[^#]*## (.*)/make \1\t\2/p' $(MAKEFILE_LIST) | expand -t 24

run: build  ## run the first sweep: 15 impacts, a table of outcomes, the b/a map
	@mkdir -p results
	@$(BUILD)/eerie run sweeps/first-light.json --db results/first-light.sqlite

build: packages-run $(BUILD)/build.ninja  ## build the program, optimised for this machine
	@cmake --build $(BUILD) -j $(JOBS) --target eerie -- --quiet

test: packages-test  ## build and run the tests (under 30 minutes on 2 cores)
	@cmake -S . -B $(BUILD) -G Ninja -DEERIE_TESTS=ON
	@cmake --build $(BUILD) -j $(JOBS)
	@ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS) -LE long

validate: packages-test  ## run the long physics (up to an hour) and write two pages of docs/notebook
	@cmake -S . -B $(BUILD) -G Ninja -DEERIE_TESTS=ON
	@cmake --build $(BUILD) -j $(JOBS) --target eerie_long eerie_report
	@rm -rf $(BUILD)/records
	@status=0; EERIE_REPORT=$(abspath $(BUILD))/records \
	  ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS) -L long || status=$$?; \
	  $(BUILD)/tests/eerie_report $(BUILD)/records docs/notebook && exit $$status

reference: build  ## write the tables of docs/reference anew, from the program and the schema
	@docs/reference/make.py $(BUILD)/eerie

gallery: build  ## draw every kind of figure anew (five minutes): docs/gallery.md
	@docs/gallery/make.py $(BUILD)/eerie $(BUILD)/gallery

bench: packages-test  ## time steps and stages (5 minutes); BASELINE=FILE: ratios to an earlier bench.json
	@cmake -S . -B $(BUILD) -G Ninja -DEERIE_BENCHMARKS=ON
	@cmake --build $(BUILD) -j $(JOBS) --target eerie_bench
	@$(BUILD)/tests/bench/eerie_bench --benchmark_out=$(BUILD)/bench.json.new --benchmark_out_format=json \
	  $(if $(BASELINE),--baseline $(BASELINE)) && mv $(BUILD)/bench.json.new $(BUILD)/bench.json

scale: packages-test  ## measure a campaign of 1,000 to 100,000 jobs (10 minutes): docs/notebook/scale
	@cmake -S . -B $(BUILD) -G Ninja -DEERIE_TESTS=ON -DEERIE_BENCHMARKS=ON > /dev/null
	@cmake --build $(BUILD) -j $(JOBS) --target eerie eerie_scale
	@OMP_NUM_THREADS=1 $(BUILD)/tests/bench/eerie_scale docs/notebook/scale

settled: packages-test  ## what the settled stop would have done to runs to 1e5 s (30 minutes): docs/notebook/accuracy
	@cmake -S . -B $(BUILD) -G Ninja -DEERIE_TESTS=ON -DEERIE_BENCHMARKS=ON > /dev/null
	@cmake --build $(BUILD) -j $(JOBS) --target eerie eerie_settled eerie_settled_figure
	@mkdir -p $(BUILD)/settled
	@$(BUILD)/eerie converge sweeps/studies/settled.json --db $(BUILD)/settled/settled.sqlite -o $(BUILD)/settled > /dev/null
	@$(BUILD)/tests/bench/eerie_settled $(BUILD)/settled/settled.sqlite.jobs docs/notebook/accuracy/settled.csv 4000 0.0015 0.02 0.005
	@$(BUILD)/tests/bench/eerie_settled $(BUILD)/settled/settled.sqlite.jobs docs/notebook/accuracy/settled-survey.csv 4000 0.003 0.05 0.02
	@$(BUILD)/tests/bench/eerie_settled_figure docs/notebook/accuracy/settled.csv docs/notebook/accuracy/settled-survey.csv docs/notebook/accuracy/settled.svg

results: build  ## draw the campaign of the paper anew from its database, without a run: docs/results
	@EERIE=$(BUILD)/eerie docs/results/make.sh

test-faults: packages-test  ## kill, damage and starve campaigns (30 minutes): 1,000 kills, 400 power cuts, every named point
	@cmake -S . -B $(BUILD) -G Ninja -DEERIE_TESTS=ON > /dev/null
	@cmake --build $(BUILD) -j $(JOBS) --target eerie eerie_fault
	@EERIE_FAULT_KILLS=1000 EERIE_FAULT_POWER_CUTS=400 EERIE_FAULT_PASSINGS=3 EERIE_FAULT_ROUNDS=20 \
	  ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS) -L fault

sanitize: packages-test  ## unit and fault tests under ASan and UBSan, those of threads under TSan (two more builds)
	@cmake -S . -B $(BUILD)-asan -G Ninja -DEERIE_SANITIZE=address,undefined > /dev/null
	@cmake --build $(BUILD)-asan -j $(JOBS) --target eerie eerie_unit eerie_fault
	@LSAN_OPTIONS=suppressions=$(abspath tests/leaks-of-others.supp):print_suppressions=0 \
	  ctest --test-dir $(BUILD)-asan --output-on-failure -j $(JOBS) -L '^(unit|fault)$$'
	@cmake -S . -B $(BUILD)-tsan -G Ninja -DEERIE_SANITIZE=thread > /dev/null
	@cmake --build $(BUILD)-tsan -j $(JOBS) --target eerie_threaded
	@# TSan does not see how libgomp's threads wait for each other: one each.
	@OMP_THREAD_LIMIT=1 OMP_NUM_THREADS=1 $(BUILD)-tsan/tests/eerie_threaded --gtest_brief=1

odr: packages-test  ## build the program as a whole (-flto -Wodr); two definitions of one type stop it (one more build)
	@cmake -S . -B $(BUILD)-odr -G Ninja -DEERIE_TESTS=OFF -DCMAKE_BUILD_TYPE=None \
	  -DCMAKE_CXX_FLAGS="-flto -Wodr -Werror=odr -Werror=lto-type-mismatch" > /dev/null
	@cmake --build $(BUILD)-odr -j $(JOBS) --target eerie -- --quiet

fuzz: packages-fuzz  ## throw mutated files at every reader, FUZZ_SECONDS (600) each, JOBS at a time; needs clang
	@cmake -S . -B $(BUILD)-fuzz -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DEERIE_FUZZERS=ON > /dev/null
	@cmake --build $(BUILD)-fuzz -j $(JOBS)
	@grep -oh '"[A-Za-z_0-9.-]*"' solver/scene/scene.schema.json campaign/sweeps/sweep.schema.json | sort -u > $(BUILD)-fuzz/words.dict
	@printf '%s\n' sweep scene result checkpoint catalogue | xargs -n 1 -P $(JOBS) tests/fuzz/run.sh $(BUILD)-fuzz $(FUZZ_SECONDS)

install: build  ## install program, man pages, completions, sweeps and documentation below PREFIX (/usr/local)
	@cmake --build $(BUILD) -j $(JOBS) --target eerie_manual -- --quiet
	@cmake --install $(BUILD) --prefix $(PREFIX) --component program > /dev/null

deb: packages-deb  ## build Debian packages, eerie and python3-eerie, for x86-64 machines since 2013: build-deb/packages
	@cmake -S . -B $(BUILD)-deb -G Ninja -DEERIE_TESTS=OFF -DEERIE_NATIVE=OFF -DEERIE_ARCH=x86-64-v3 \
	  -DEERIE_PYTHON=ON -DCMAKE_INSTALL_PREFIX=/usr -DCMAKE_SKIP_RPATH=ON > /dev/null
	@cmake --build $(BUILD)-deb -j $(JOBS) -- --quiet
	@cpack --config $(BUILD)-deb/CPackConfig.cmake -B $(BUILD)-deb/packages > $(BUILD)-deb/cpack.log || { cat $(BUILD)-deb/cpack.log; exit 1; }
	@rm -rf $(BUILD)-deb/packages/_CPack_Packages && ls $(BUILD)-deb/packages/*.deb

test-deb: deb  ## install, run, upgrade and remove the packages in a fresh Debian 12 root (as root; needs a mirror)
	@.ci/packages deb-test
	@cpack --config $(BUILD)-deb/CPackConfig.cmake -B $(BUILD)-deb/newer -D CPACK_DEBIAN_PACKAGE_RELEASE=2 > $(BUILD)-deb/cpack.log
	@.ci/deb/test $(BUILD)-deb/packages $(BUILD)-deb/newer

test-container:  ## build the container, run a sweep in it (podman, docker or buildah; CONTAINER_PACKAGES=FOLDER: of these packages)
	@.ci/test-container $(CONTAINER_PACKAGES)

format:  ## lay out the sources with clang-format
	@git ls-files '*.cpp' '*.hpp' | xargs clang-format -i

tidy:  ## check the sources with clang-tidy (slow; needs clang-tidy)
	@cmake -S . -B $(BUILD)-tidy -G Ninja -DEERIE_TESTS=OFF -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON > /dev/null
	@cmake --build $(BUILD)-tidy --target eerie_commit > /dev/null
	@git ls-files '*.cpp' | grep -v ^tests/ | xargs -n 1 -P $(JOBS) clang-tidy -p $(BUILD)-tidy --quiet

clean:  ## remove what was built; results stay
	@rm -rf $(BUILD) $(BUILD)-asan $(BUILD)-tsan $(BUILD)-odr $(BUILD)-fuzz $(BUILD)-deb

$(BUILD)/build.ninja:
	@cmake -S . -B $(BUILD) -G Ninja -DEERIE_TESTS=OFF > /dev/null

packages-run packages-test packages-fuzz packages-deb:
	@.ci/packages $(@:packages-%=%)
