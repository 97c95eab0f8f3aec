#include "first_contact/bvh/kernels/walk.inc"

namespace first_contact::bvh {
const Walker portable_walker{begin, next, resume, visit_node, visit_leaf, features_in_time};
}
