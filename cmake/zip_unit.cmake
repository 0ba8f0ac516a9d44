# Fills a unit's folder, which has its binaries already, and zips it:
#   cmake -DFOLDER=<folder> -DFILES=<list of file=place> -DOUTPUT=<file> -P zip_unit.cmake
include(${CMAKE_CURRENT_LIST_DIR}/glob.cmake)
tdmf_slip_glob(old ${FOLDER} *)
list(FILTER old EXCLUDE REGEX "/binaries$")
if(old)
    file(REMOVE_RECURSE ${old})
endif()
file(STRINGS ${FILES} files ENCODING UTF-8)
foreach(pair IN LISTS files)
    string(REGEX MATCH "^(.+)=(.+)$" pair "${pair}")
    configure_file(${CMAKE_MATCH_1} ${FOLDER}/${CMAKE_MATCH_2} COPYONLY)
endforeach()
tdmf_slip_glob(parts ${FOLDER} * RELATIVE ${FOLDER})
execute_process(COMMAND ${CMAKE_COMMAND} -E tar cf ${OUTPUT} --format=zip ${parts}
                WORKING_DIRECTORY ${FOLDER} RESULT_VARIABLE result)
if(result)
    message(FATAL_ERROR "${OUTPUT} could not be written")
endif()
