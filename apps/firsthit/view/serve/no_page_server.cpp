// no_page_server.cpp - what `firsthit view --serve` says where it was built without a server.
#include "view/serve/page_server.h"

#include <firsthit/error.h>

namespace firsthit::cli::view {

int serve_page(const ViewOptions&)
{
    throw DeviceError("this firsthit was built without a server of pages: install libboost-dev "
                      "(apt-get install libboost-dev) and build it again; firsthit render makes "
                      "pictures without one");
}

} // namespace firsthit::cli::view
