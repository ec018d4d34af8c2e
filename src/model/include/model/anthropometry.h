#pragma once

namespace taut {

/// A segment of the human body. Winter, Biomechanics and Motor Control of Human Movement, table 4.1 and
/// figure 4.1.
struct Segment {
  double mass;    ///< share of the body's mass, of one of a pair
  double length;  ///< share of the body's height
  double centre;  ///< where the centre of mass lies, as a share of the length from the near end
};

/// Winter's table: shares of body mass and of height.
namespace winter {
inline constexpr Segment upper_arm{0.028, 0.186, 0.436};
inline constexpr Segment forearm{0.016, 0.146, 0.430};
inline constexpr Segment hand{0.006, 0.108, 0.506};
inline constexpr Segment thigh{0.100, 0.245, 0.433};
inline constexpr Segment shank{0.0465, 0.246, 0.433};
inline constexpr Segment foot{0.0145, 0.152, 0.500};
inline constexpr Segment trunk{0.497, 0.288, 0.500};        ///< from hips to shoulders
inline constexpr Segment head_and_neck{0.081, 0.117, 1.0};  ///< from the shoulders' height to the ears'
inline constexpr double hip_height = 0.530;
inline constexpr double shoulder_height = 0.818;
inline constexpr double shoulder_width = 0.259;
inline constexpr double hip_width = 0.191;
inline constexpr double ankle_height = 0.039;
}  // namespace winter

}  // namespace taut
