# Read by ./dev check, whose words it takes: the tests of C++ in builds with the sanitizers of clang, build/asan and
# build/tsan.
short=no kinds=(asan tsan) words=()
for word in "$@"; do
  case $word in
    --short) short=yes ;;
    --asan | --tsan) kinds=("${word#--}") ;;
    -*) die "check: unknown option $word" ;;
    *) words=(-R "$word") ;;
  esac
done
# The short form: modules whose tests reach much code for the time that they take.
short_asan=(base options repair converters_mesh converters_irit stroke)
short_tsan=(base stroke illustrate)
# Minutes under ThreadSanitizer.
long_tsan='^illustrate\.(NothingSilent|Placement)\.'

# Addresses chosen at random in more bits than it knows end ThreadSanitizer of clang 14 at the start.
still=(setarch "$(uname -m)" -R)
"${still[@]}" true 2>/dev/null || still=(env)

for kind in "${kinds[@]}"; do
  if [[ $kind == tsan ]] && ! works thread "${still[@]}"; then
    echo "dev: warning: ThreadSanitizer does not run on this machine (sysctl vm.mmap_rnd_bits=28 may help) and is left" \
         "out" >&2
    continue
  fi
  targets=(all) only=("${words[@]}")
  if [[ $short == yes ]]; then
    declare -n rooms=short_$kind
    targets=("${rooms[@]/#/test_}")
    only=(-R "^($(IFS='|'; echo "${rooms[*]}"))\\.")
    if [[ $kind == tsan ]]; then only+=(-E "$long_tsan"); fi
  fi
  compile "$kind" "${targets[@]}"
  say "$kind: running"
  "${still[@]}" ctest --test-dir "build/$kind" -j2 --output-on-failure --no-tests=error "${only[@]}"
done
