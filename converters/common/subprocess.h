#pragma once
// Programs that converters start.

#include <burin/base/subprocess.h>
