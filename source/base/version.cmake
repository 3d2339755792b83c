# Writes FILE: the version, and the commit where SOURCE_DIR is a checkout ("-dirty": with changes that are not committed).
execute_process(COMMAND git describe --always --dirty --exclude=* WORKING_DIRECTORY ${SOURCE_DIR}
                OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
file(CONFIGURE OUTPUT ${FILE} CONTENT "#include <amontons/base/version.h>

const char *const Amontons::version = \"${VERSION}\";
const char *const Amontons::commit  = \"${commit}\";
" @ONLY)
