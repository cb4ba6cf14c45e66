# Regenerates a recorded log (program RECORD, into MADE) and compares it with the one that is kept (KEPT).
execute_process(COMMAND ${RECORD} ${MADE} RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "${RECORD} failed")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${MADE} ${KEPT} RESULT_VARIABLE differ)
if(differ)
  message(FATAL_ERROR "${KEPT} is not what ${RECORD} writes now: regenerate it, and say why in rawlogs/README.md")
endif()
