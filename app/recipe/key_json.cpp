#include "app/recipe/key_json.h"

#include <nlohmann/json.hpp>

namespace burl {

namespace {

KeyTrack track_from_json(const Json& json) {
    KeyTrack track;
    track.path = json["path"].get<std::string>();
    if (json.value("ease", "linear") == "smooth") track.ease = KeyEase::smooth;
    for (const Json& key : json["keys"])
        track.keys.push_back({key[0].get<double>(), key[1].get<double>()});
    return track;
}

Json track_to_json(const KeyTrack& track) {
    Json keys = Json::array();
    for (const KeyPoint& key : track.keys) keys.push_back({key.seconds, key.value});
    return {{"path", track.path},
            {"ease", track.ease == KeyEase::smooth ? "smooth" : "linear"},
            {"keys", std::move(keys)}};
}

}  // namespace

KeyedAnimation animation_from_json(const Json& json) {
    KeyedAnimation animation;
    animation.seconds = json.value("seconds", animation.seconds);
    animation.rate = int(json.value("rate", double(animation.rate)));
    animation.loop = json.value("end", "stop") == "loop";
    if (json.contains("tracks"))
        for (const Json& track : json["tracks"]) animation.tracks.push_back(track_from_json(track));
    return animation;
}

Json animation_to_json(const KeyedAnimation& animation) {
    Json tracks = Json::array();
    for (const KeyTrack& track : animation.tracks) tracks.push_back(track_to_json(track));
    return {{"seconds", animation.seconds},
            {"rate", animation.rate},
            {"end", animation.loop ? "loop" : "stop"},
            {"tracks", std::move(tracks)}};
}

}  // namespace burl
