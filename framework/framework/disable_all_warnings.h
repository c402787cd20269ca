#pragma once
// Third-party headers are system includes here, so there is nothing to silence: course files may keep the macros.
#define DISABLE_WARNINGS_PUSH()
#define DISABLE_WARNINGS_POP()
