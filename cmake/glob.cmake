# tdmf_slip_glob(<variable> <folder> <pattern> [<option of file(GLOB)>...]): file(GLOB), in which brackets, stars and
# question marks in the path of the folder stand for themselves.
function(tdmf_slip_glob variable folder pattern)
    string(REGEX REPLACE "[][*?]" "[\\0]" escaped "${folder}")
    file(GLOB found ${ARGN} "${escaped}/${pattern}")
    set(${variable} ${found} PARENT_SCOPE)
endfunction()
