// Lets one loop be compiled for wider vectors too and picks the version that the processor can run.
#pragma once

/** Defines `name` with `parameters`, which calls the always_inline function `body` with `arguments`. Both versions give
 *  the same bits: fused multiply-add, which rounds once instead of twice, stays off. */
#if defined(__x86_64__) && defined(__GNUC__)
#define EXPLORE_VECTOR_CODE(name, body, parameters, arguments)       \
	[[gnu::target("avx2")]] void name##Avx2 parameters               \
	{                                                                \
		body arguments;                                              \
	}                                                                \
	void name##Plain parameters                                      \
	{                                                                \
		body arguments;                                              \
	}                                                                \
	void name parameters                                             \
	{                                                                \
		static const bool has_avx2 = __builtin_cpu_supports("avx2"); \
		if (has_avx2)                                                \
			name##Avx2 arguments;                                    \
		else                                                         \
			name##Plain arguments;                                   \
	}
#else
#define EXPLORE_VECTOR_CODE(name, body, parameters, arguments) \
	void name parameters                                       \
	{                                                          \
		body arguments;                                        \
	}
#endif
