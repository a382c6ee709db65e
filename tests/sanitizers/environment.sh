# Read by ./dev check and ./dev fuzz: what the sanitizers are to do, and what this machine (its container, mostly) does
# not let them do, which an empty program finds out.
supp=$root/tests/sanitizers
export UBSAN_OPTIONS=print_stacktrace=1
export ASAN_OPTIONS=detect_stack_use_after_return=1:strict_string_checks=1
export LSAN_OPTIONS=suppressions=$supp/leak.supp:print_suppressions=0
# A crash inside OCCT becomes an exception by a jump out of its signal handler (converters/cad/README.md, "Crashes"), which
# ThreadSanitizer does not see end: all that the thread does from then on would be told as unsafe in a handler.
export TSAN_OPTIONS=halt_on_error=1:report_signal_unsafe=0:second_deadlock_stack=1:suppressions=$supp/race.supp

# works SANITIZER COMMAND...: whether an empty program with it runs by the command.
works() {
  local probe status=0
  probe=$(mktemp -d)
  echo 'int main() { return 0; }' >"$probe/empty.cpp"
  clang++ "-fsanitize=$1" "$probe/empty.cpp" -o "$probe/empty" && "${@:2}" "$probe/empty" >/dev/null 2>&1 || status=1
  rm -r "$probe"
  return "$status"
}

if ! works address env; then
  echo "dev: warning: no leaks are looked for: this machine does not let a program be traced" >&2
  ASAN_OPTIONS+=:detect_leaks=0
fi
