#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/frame_rate.h"

namespace taut {

/// How many frames a film of that many seconds has. Throws BadRequest when it is none, or more than a frame's
/// name has digits for.
int frame_count(double duration, const FrameRate& rate);

/// When frame n, counted from 1, is: (n − 1)/fps seconds.
double frame_time(int frame, const FrameRate& rate);

/// The frames that a text such as "1-100:2,150" means (from 1 to 100, every second one, and 150), in rising
/// order, each once. Throws BadRequest when it is not of that form or goes beyond `count`.
std::vector<int> select_frames(std::string_view text, int count);

/// The frames 1 to count.
std::vector<int> all_frames(int count);

/// The rate at which a film of some frames plays as fast as one of all of them: of every n-th, an n-th of it.
/// Where frames lie unevenly the shortest step counts, and longer ones are cuts.
FrameRate rate_of_selection(const std::vector<int>& frames, const FrameRate& rate);

/// The shortest text for rising numbers in which neighbours are joined: 1,2,3,5 gives "1-3,5".
std::string selection_text(const std::vector<int>& frames);

}  // namespace taut
