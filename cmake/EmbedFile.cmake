file(READ "${INPUT}" hex HEX)
string(REGEX REPLACE "(................................)" "\\1\n" hex "${hex}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
file(WRITE "${HEADER}" "#pragma once\n#include <string>\nnamespace mien {\nstd::string ${NAME}();\n}\n")
file(WRITE "${SOURCE}" "#include \"${NAME}.h\"\nstd::string mien::${NAME}() {\n  static const unsigned char bytes[] = {\n${bytes}\n};\n"
  "  return std::string(reinterpret_cast<const char*>(bytes), sizeof bytes);\n}\n")
