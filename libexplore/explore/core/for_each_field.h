// The fields of a plain struct, one after the other, without a list of them that could miss one.
#pragma once

#include <cstddef>
#include <type_traits>

namespace explore
{
/** How many fields an aggregate has: as many as take an initialiser; at most 21. */
template <class Struct>
constexpr std::size_t fieldCount()
{
	static_assert(std::is_aggregate_v<Struct>,
	              "what has constructors or private members says itself what it is made of");
	// clang-format off
	static_assert(!requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }, "too many fields");
	if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) return 21;
	else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) return 20;
	else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) return 19;
	else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) return 18;
	else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) return 17;
	else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) return 16;
	else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) return 15;
	else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) return 14;
	else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) return 13;
	else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) return 12;
	else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) return 11;
	else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}}; }) return 10;
	else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}, {}}; }) return 9;
	else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}, {}}; }) return 8;
	else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}, {}}; }) return 7;
	else if constexpr (requires { Struct{{}, {}, {}, {}, {}, {}}; }) return 6;
	else if constexpr (requires { Struct{{}, {}, {}, {}, {}}; }) return 5;
	else if constexpr (requires { Struct{{}, {}, {}, {}}; }) return 4;
	else if constexpr (requires { Struct{{}, {}, {}}; }) return 3;
	else if constexpr (requires { Struct{{}, {}}; }) return 2;
	else return 1;
	// clang-format on
}

/** Calls visit(field) for each field in its order. */
template <class Struct, class Visit>
void forEachField(Struct& value, const Visit& visit)
{
	constexpr std::size_t kFields = fieldCount<Struct>();
	const auto each = [&](auto&... fields) { (visit(fields), ...); };
	// clang-format off
	if constexpr (kFields == 1) { auto& [f1] = value; each(f1); }
	else if constexpr (kFields == 2) { auto& [f1, f2] = value; each(f1, f2); }
	else if constexpr (kFields == 3) { auto& [f1, f2, f3] = value; each(f1, f2, f3); }
	else if constexpr (kFields == 4) { auto& [f1, f2, f3, f4] = value; each(f1, f2, f3, f4); }
	else if constexpr (kFields == 5) { auto& [f1, f2, f3, f4, f5] = value; each(f1, f2, f3, f4, f5); }
	else if constexpr (kFields == 6) { auto& [f1, f2, f3, f4, f5, f6] = value; each(f1, f2, f3, f4, f5, f6); }
	else if constexpr (kFields == 7) { auto& [f1, f2, f3, f4, f5, f6, f7] = value; each(f1, f2, f3, f4, f5, f6, f7); }
	else if constexpr (kFields == 8) { auto& [f1, f2, f3, f4, f5, f6, f7, f8] = value; each(f1, f2, f3, f4, f5, f6, f7, f8); }
	else if constexpr (kFields == 9) { auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9] = value; each(f1, f2, f3, f4, f5, f6, f7, f8, f9); }
	else if constexpr (kFields == 10) { auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10] = value; each(f1, f2, f3, f4, f5, f6, f7, f8, f9, f10); }
	else if constexpr (kFields == 11) { auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11] = value; each(f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11); }
	else if constexpr (kFields == 12) { auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12] = value; each(f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12); }
	else if constexpr (kFields == 13) { auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13] = value; each(f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13); }
	else if constexpr (kFields == 14) { auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14] = value; each(f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14); }
	else if constexpr (kFields == 15) { auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15] = value; each(f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15); }
	else if constexpr (kFields == 16) { auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16] = value; each(f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16); }
	else if constexpr (kFields == 17) { auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17] = value; each(f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17); }
	else if constexpr (kFields == 18) { auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18] = value; each(f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18); }
	else if constexpr (kFields == 19) { auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19] = value; each(f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19); }
	else if constexpr (kFields == 20) { auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19, f20] = value; each(f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19, f20); }
	else if constexpr (kFields == 21) { auto& [f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19, f20, f21] = value; each(f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f13, f14, f15, f16, f17, f18, f19, f20, f21); }
	// clang-format on
}
}  // namespace explore
