#pragma once
// Loops over 16 lanes, compiled for the registers of the machine they run on.

// A function cloned for wider registers, chosen when the program starts: 16 lanes are one AVX-512 register.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define UMBRAMETER_WIDE __attribute__((target_clones("arch=skylake-avx512", "arch=haswell", "default")))
#else
#define UMBRAMETER_WIDE
#endif
// Parts of a cloned function must be inside it to be cloned with it.
#define UMBRAMETER_LANES [[gnu::always_inline]] inline
