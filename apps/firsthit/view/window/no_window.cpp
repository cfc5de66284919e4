// no_window.cpp - what `firsthit view` says where it was built without a window.
#include "view/window/window.h"

#include <firsthit/error.h>

namespace firsthit::cli::view {

int show_window(const ViewOptions&, ScriptPlayer*)
{
    throw DeviceError(
        "this firsthit was built without a window: install libglfw3-dev, libimgui-dev and "
        "libepoxy-dev (apt-get install libglfw3-dev libimgui-dev libepoxy-dev) and build it again; "
        "firsthit render makes pictures without one, and view --serve shows the scene in a page "
        "for a browser");
}

} // namespace firsthit::cli::view
