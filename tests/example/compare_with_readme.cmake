# Fails unless the file EXAMPLE stands in README word for word.
file(READ ${README} readme)
file(READ ${EXAMPLE} example)
string(FIND "${readme}" "${example}" place)
if(place EQUAL -1)
  message(FATAL_ERROR "${EXAMPLE} does not stand in ${README} as it is")
endif()
