# FIRMWARE, its folder, and FIRMWARE_SOURCES: what of it runs on a PC without the Arduino core, which is all
# but the core's, the AVR's own, and the driver of serial modules.
get_filename_component(FIRMWARE ${CMAKE_CURRENT_LIST_DIR}/../../javino-firmware/src ABSOLUTE)
file(GLOB FIRMWARE_SOURCES CONFIGURE_DEPENDS ${FIRMWARE}/*/*.cpp)
list(FILTER FIRMWARE_SOURCES EXCLUDE REGEX "/arduino/|/serialradio/|Avr\\.cpp$")
