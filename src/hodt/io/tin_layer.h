// A TIN as features: a polygon a triangle.
// Tested by tests/io/tin_layer_test.cpp.
#pragma once

#include "hodt/io/feature_layer.h"
#include "hodt/tin/tin.h"

namespace hodt {

/// Triangle i is feature i, with the fields "order" and "changed" (0 or 1), where the TIN tells the
/// orders, and with heights "slope" and "aspect" (see tin/slope.h). The layer refers to the TIN.
FeatureLayer triangle_layer(const Tin& tin);

}  // namespace hodt
