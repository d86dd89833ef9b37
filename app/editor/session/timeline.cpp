#include "app/editor/session/timeline.h"

#include <cmath>

#include "app/recipe/key_edit.h"

namespace burl {

ClockStep clock_after(const KeyedAnimation& animation, double seconds, double dt) {
    const double then = seconds + dt;
    if (then < animation.seconds) return {then, false};
    if (animation.loop) return {std::fmod(then, animation.seconds), false};
    return {animation.seconds, true};
}

void toggle_playing(EditTimeline& timeline, EditSession& session) {
    const KeyedAnimation& animation = session.recipe().animation;
    timeline.playing = !timeline.playing;
    if (!timeline.playing)
        session.set_time(nearest_frame(animation, session.time()));
    else if (!animation.loop && session.time() >= animation.seconds)
        session.set_time(0.0);
}

void advance(EditTimeline& timeline, EditSession& session, double dt) {
    const KeyedAnimation& animation = session.recipe().animation;
    if (session.time() > animation.seconds) session.set_time(animation.seconds);
    if (!timeline.playing) return;
    const ClockStep step = clock_after(animation, session.time(), dt);
    session.set_time(step.seconds);
    if (step.ended) timeline.playing = false;
}

}  // namespace burl
