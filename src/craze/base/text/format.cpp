#include "craze/base/text/format.h"

FMT_BEGIN_NAMESPACE
namespace detail {
template void vformat_to(buffer<char>&, basic_string_view<char>,
                         basic_format_args<FMT_BUFFER_CONTEXT(char)>, locale_ref);
}
FMT_END_NAMESPACE
