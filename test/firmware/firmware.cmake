# FIRMWARE, its folder, and FIRMWARE_SOURCES: what of it runs on a PC, which is all but the Arduino core's and the AVR's own.
get_filename_component(FIRMWARE ${CMAKE_CURRENT_LIST_DIR}/../../javino-firmware/src ABSOLUTE)
file(GLOB FIRMWARE_SOURCES CONFIGURE_DEPENDS ${FIRMWARE}/*/*.cpp)
list(FILTER FIRMWARE_SOURCES EXCLUDE REGEX "/arduino/|Avr\\.cpp$")
