// How glint-render ends; part of its interface.
#pragma once

namespace glint {

enum class ExitCode {
    Done = 0,
    Usage = 1,          ///< the command line is wrong
    Scene = 2,          ///< the scene or one of its files is wrong
    Output = 3,         ///< the picture or the statistics cannot be written
    Different = 4,      ///< --verify: other bits, or another scene
    Interrupted = 130,  ///< by Ctrl-C; what there was has been written
};

}  // namespace glint
