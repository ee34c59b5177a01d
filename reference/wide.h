// SPDX-License-Identifier: Apache-2.0
#pragma once
// Loops over 16 lanes, compiled for the registers of the machine they run on.

// A function cloned for wider registers, chosen when the program starts: 16 lanes are one AVX-512 register. By what the
// processor can do: the name of a model, such as skylake-avx512, would leave every later one with the default.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define UMBRAMETER_WIDE __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define UMBRAMETER_WIDE
#endif
// Parts of a cloned function must be inside it to be cloned with it.
#define UMBRAMETER_LANES [[gnu::always_inline]] inline
