#!/usr/bin/env bash
# test.sh SOURCE BUILD PYTHON_FOLDER: installs the build into a folder of its own, moves that, and uses what is there.
# PYTHON_FOLDER is empty where the Python module is not built.
set -euo pipefail
source=$1 build=$2 python_folder=${3:-}
scratch=$(mktemp -d "$build/install-test.XXXXXX")
trap 'rm -rf "$scratch"' EXIT
fail() { printf 'install test: %s\n' "$*" >&2; exit 1; }

# ./dev build builds this target, whose commands make all that is installed.
ninja -C "$build" -t commands burin_installed >"$scratch/commands"
for file in cmake/self_description.cmake $(grep -rhoE --include=cmake_install.cmake "\"$build/(bin|lib|python)/[^\"]+" "$build" | sed "s#^\"$build/##" | sort -u); do
  [[ -L $build/$file ]] || grep -qF "$file" "$scratch/commands" || fail "./dev build does not make $file"
done
cmake --install "$build" --prefix "$scratch/first" >"$scratch/log" || { cat "$scratch/log"; fail "cmake --install failed"; }
# Nothing may depend on where it was installed.
mv "$scratch/first" "$scratch/moved"
prefix=$scratch/moved

"$prefix/bin/burin" --version | grep -q '^burin ' || fail "the command does not start"
for model in spindle.stl coupling.step; do
  "$prefix/bin/burin" draw "$source/samples/$model" -o "$scratch/a.svg" --quiet --style outline || fail "the command does not draw $model"
  "$prefix/bin/burin" draw "$source/samples/$model" -o "$scratch/a.pdf" --quiet || fail "the command writes no PDF"
  grep -q '<path' "$scratch/a.svg" || fail "the drawing of $model is empty"
done
# The evaluator of trees is found wherever the libraries are.
printf 'difference() {\n\tcube(size = [4, 4, 4], center = true);\n\tsphere($fn = 32, $fa = 12, $fs = 2, r = 2.4);\n}\n' >"$scratch/a.csg"
"$prefix/bin/burin" draw "$scratch/a.csg" -o "$scratch/a.svg" --quiet --csg burin || fail "the command does not evaluate a tree"
[[ -s $prefix/share/burin/openscad/burin.scad ]] || fail "burin.scad is not installed"
while read -r file; do
  if readelf -d "$file" | grep -E 'R(UN)?PATH' | grep -qF "$build"; then fail "$file looks for libraries in the build"; fi
done < <(find "$prefix" -name '*.so*' -type f; echo "$prefix/bin/burin")

if [[ -n $python_folder ]]; then
  cd "$scratch"
  cp "$source/samples/spindle.stl" a.stl
  PYTHONPATH=$prefix/$python_folder /usr/bin/python3 -c "import burin; burin.draw('a.stl').save('a.svg')" || fail "the Python module does not draw"
  PYTHONPATH=$prefix/$python_folder /usr/bin/python3 - "$source/samples/coupling.step" "$prefix" <<'PY' || fail "the Python module does not draw a CAD part"
import sys, burin
assert burin.__file__.startswith(sys.argv[2]), burin.__file__
assert len(burin.draw(sys.argv[1], style="outline").arrays()["part"]) > 50
maps = open("/proc/self/maps").read()
libraries = {line.split()[-1] for line in maps.splitlines() if "libburin" in line}
assert len(libraries) == 3 and all(l.startswith(sys.argv[2]) for l in libraries), libraries
PY
fi

if [[ -n $python_folder ]] && /usr/bin/python3 -m pip --version >/dev/null 2>&1; then
  /usr/bin/python3 -m pip install --quiet --no-deps --no-index --target "$scratch/pip" --config-settings "build-dir=$build" "$source" ||
    fail "pip does not install the module"
  PYTHONPATH=$scratch/pip /usr/bin/python3 - "$source/samples/coupling.step" "$scratch/pip" <<'PY' || fail "the module that pip installed does not draw"
import sys, burin
assert burin.__file__.startswith(sys.argv[2]), burin.__file__
assert len(burin.draw(sys.argv[1], style="outline").arrays()["part"]) > 50
libraries = {line.split()[-1] for line in open("/proc/self/maps") if "libburin" in line}
assert len(libraries) == 3 and all(l.startswith(sys.argv[2]) for l in libraries), libraries
PY
fi
if [[ -x $scratch/pip/bin/burin ]]; then
  # Nothing of the build, and no command that is on PATH.
  (
    cd "$scratch"
    export PYTHONPATH=$scratch/pip PATH=/usr/bin:/bin
    for command in pip/bin/burin "/usr/bin/python3 -m burin"; do
      rm -f pip.svg
      $command draw "$source/samples/spindle.stl" -o pip.svg --quiet && grep -q '<path' pip.svg || fail "$command does not draw"
    done
    status=0
    pip/bin/burin draw nothing.stl -o pip.svg 2>pip.txt || status=$?
    [[ $status == 3 ]] || fail "the command that pip installed hands no status on: $status"
    pip/bin/burin batch --help | grep -q 'usage: burin batch' || fail "the command that pip installed finds no burin batch"
  ) || exit 1
elif [[ -d $scratch/pip ]]; then
  fail "pip installs no command"
fi
for page in man/man1/burin.1.gz man/man1/burin-draw.1.gz bash-completion/completions/burin zsh/vendor-completions/_burin fish/vendor_completions.d/burin.fish; do
  [[ -s $prefix/share/$page ]] || fail "$page is not installed"
done

addon=$prefix/share/freecad/Mod/Burin
if [[ -n $python_folder && -d $addon ]]; then
  for file in package.xml LICENSE freecad/burin_wb/init_gui.py freecad/burin_wb/resources/icons/burin.svg; do
    [[ -s $addon/$file ]] || fail "the add-on lacks $file"
  done
  "$source/tests/install/addon.sh" "$addon" "$scratch" "$prefix" || fail "the installed add-on does not draw in FreeCAD"
  # A user's Mod folder: the installed folder copied there, with a kernel that Python finds by itself ...
  mkdir -p "$scratch/copied/Mod"
  cp -r "$addon" "$scratch/copied/Mod/Burin"
  BURIN_KERNEL_FOLDER=$prefix/$python_folder \
    "$source/tests/install/addon.sh" "$scratch/copied/Mod/Burin" "$scratch" "$prefix" "$scratch/copied" || fail "the copied add-on does not draw"
  # ... the archive, which has its kernel in it; unpacked by a program that knows no links ...
  mkdir -p "$scratch/unpacked/Mod"
  cmake --build "$build" --target burin_addon >"$scratch/log" 2>&1 || { cat "$scratch/log"; fail "the archive of the add-on is not made"; }
  /usr/bin/python3 -m zipfile -e "$build"/burin-workbench-*-this-system.zip "$scratch/unpacked/Mod" || fail "the archive of the add-on does not unpack"
  "$source/tests/install/addon.sh" "$scratch/unpacked/Mod/Burin" "$scratch" "$scratch/unpacked/Mod/Burin/freecad/burin_wb/native" "$scratch/unpacked" ||
    fail "the unpacked add-on does not draw"
  # ... and the repository as the Addon Manager clones it, with its package.xml at the root.
  mkdir -p "$scratch/cloned/Mod/burin"
  cp -r "$source/package.xml" "$source/freecad_wb" "$scratch/cloned/Mod/burin"
  BURIN_KERNEL_FOLDER=$prefix/$python_folder \
    "$source/tests/install/addon.sh" "$scratch/cloned/Mod/burin/freecad_wb" "$scratch" "$prefix" "$scratch/cloned" || fail "the cloned add-on does not draw"
fi

# Every header that is installed compiles; the program is the one that the page shows.
(cd "$prefix/include" && find burin -name '*.h' | sort | sed 's/.*/#include <&>/') >"$scratch/headers.cpp"
sed -n '/^```cpp$/,/^```$/p' "$source/kernel/docs/cpp.md" | sed '1d;$d' | cmp - "$source/tests/install/consumer/consumer.cpp" ||
  fail "kernel/docs/cpp.md does not show tests/install/consumer/consumer.cpp"
cmake -G Ninja -S "$source/tests/install/consumer" -B "$scratch/consumer" -DCMAKE_PREFIX_PATH="$prefix" -DHEADERS="$scratch/headers.cpp" >"$scratch/log" 2>&1 &&
  cmake --build "$scratch/consumer" >>"$scratch/log" 2>&1 || { cat "$scratch/log"; fail "a program does not build on the installed libraries"; }
"$source/tests/install/plugins.sh" "$prefix" "$source" "$scratch" || fail "plug-ins do not build on the installed package"
"$scratch/consumer/kernel_consumer" >"$scratch/log" || fail "the program on the installed kernel does not run"
# It draws what the command does: the same bytes.
pump=$source/samples/gear_pump.step
"$scratch/consumer/consumer" "$pump" "$scratch" >"$scratch/log" || { cat "$scratch/log"; fail "the program on the installed libraries does not run"; }
grep -q dowel "$scratch/log" || fail "the program is not told which parts stay whole"
"$prefix/bin/burin" draw "$pump" --explode auto --callouts --style outline --quiet -o "$scratch/apart.command.svg" -o "$scratch/apart.command.pdf"
"$prefix/bin/burin" draw "$pump" --view front --section y --callouts --quiet -o "$scratch/cut.command.svg" -o "$scratch/cut.command.pdf"
for name in apart.svg apart.pdf cut.svg cut.pdf; do
  cmp "$scratch/$name" "$scratch/${name/./.command.}" || fail "the program draws $name otherwise than the command"
done
grep -q 'class="callout callout_11' "$scratch/apart.svg" || fail "the items of $pump have no numbers"
if "$scratch/consumer/consumer" "$source/README.md" "$scratch" 2>"$scratch/log"; then fail "the program draws a text"; fi
grep -q 'consumer: .*README.md' "$scratch/log" || fail "the program does not say which file it cannot read"
echo "installed, moved and used"
