# cmake -DBURIN=COMMAND -DFOLDER=FOLDER -P self_description.cmake: what the command prints about itself, as installed files: manual pages in
# FOLDER/man1, completions of shells in FOLDER/share. Plug-ins of whoever builds are no part of it.
function(describe file)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env BURIN_PLUGIN_PATH= XDG_DATA_HOME=${FOLDER}/none ${BURIN} options ${ARGN}
    OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  file(WRITE ${FOLDER}/${file} "${text}")
endfunction()

file(REMOVE_RECURSE ${FOLDER})
describe(man1/burin.1 --manual burin)
file(STRINGS ${FOLDER}/man1/burin.1 commands REGEX "^\\.BR burin")
foreach(command IN LISTS commands)
  string(REGEX REPLACE "^\\.BR burin\\\\-([^ ]+) .*" "\\1" command "${command}")
  describe(man1/burin-${command}.1 --manual ${command})
endforeach()
file(GLOB pages ${FOLDER}/man1/*.1)
execute_process(COMMAND gzip -9nf ${pages} COMMAND_ERROR_IS_FATAL ANY)
describe(share/bash-completion/completions/burin --completion bash)
describe(share/zsh/vendor-completions/_burin --completion zsh)
describe(share/fish/vendor_completions.d/burin.fish --completion fish)
file(TOUCH ${FOLDER}/done)
