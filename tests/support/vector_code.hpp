#pragma once

// First include of a test that compiles vector code itself: g++ 12 takes the undefined
// pass-through operands of its own AVX-512 headers for faults (GCC bug 105593).
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
