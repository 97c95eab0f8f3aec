#pragma once
#include <array>
#include <cstdint>
#include <string_view>

/// \file
/// The colours of all figures: Okabe and Ito's, safe for the colour-blind and distinct in grey, and a few
/// quiet ones. The same meaning has the same colour in all chapters: the mover is orange, the obstacle blue,
/// a motion red, a normal ink, what is offset or hidden grey, what is right green, what is as printed pink.

namespace first_contact::figure {

/// One colour as a gnuplot variable, with its value for a light page and for a dark one, as 0xRRGGBB.
struct Colour {
  std::string_view name;  ///< in scripts
  std::uint32_t light;    ///< on a light page
  std::uint32_t dark;     ///< on a dark page
};

/// The palette.
namespace colour {
/// One colour of the palette.
///@{
inline constexpr Colour paper{"PAPER", 0xFFFFFF, 0x15191C};
inline constexpr Colour ink{"INK", 0x222222, 0xDDE3E3};
inline constexpr Colour grey{"GREY", 0x8A8A8A, 0x9AA4A4};
inline constexpr Colour pale{"PALE", 0xD9D9D9, 0x3A4347};
inline constexpr Colour blue{"BLUE", 0x0072B2, 0x58ACE6};
inline constexpr Colour sky{"SKY", 0x56B4E9, 0x7CC6F0};
inline constexpr Colour green{"GREEN", 0x009E73, 0x35C79B};
inline constexpr Colour red{"RED", 0xD55E00, 0xFF8A3D};
inline constexpr Colour orange{"ORANGE", 0xE69F00, 0xF4B942};
inline constexpr Colour amber{"AMBER", 0xF4B942, 0xE3AB3C};
inline constexpr Colour pink{"PINK", 0xCC79A7, 0xE59BC3};
inline constexpr Colour yellow{"YELLOW", 0xF0E442, 0xE5DA4A};
inline constexpr Colour floor{"FLOOR", 0xCFE3F1, 0x22394A};
inline constexpr Colour shadow{"SHADOW", 0xB3CADB, 0x16262F};
inline constexpr Colour mist{"MIST", 0xEEF3F6, 0x1D2429};
///@}
/// All of them.
inline constexpr std::array all{paper,  ink,   grey, pale,   blue,  sky,    green, red,
                                orange, amber, pink, yellow, floor, shadow, mist};
}  // namespace colour

}  // namespace first_contact::figure
