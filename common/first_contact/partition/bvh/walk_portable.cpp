#include "first_contact/partition/bvh/walk.inc"

namespace first_contact::bvh {
const Walker portable_walker{begin, next, step, features_in_time};
}
