// SPDX-License-Identifier: Apache-2.0
#include "render/animation/movie.h"

#include <gtest/gtest.h>

#include <sched.h>

#include <fstream>
#include <thread>

#include "core/error.h"
#include "scenes.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libswscale/swscale.h>
}

namespace frana::render {
namespace {

struct Animation {
    std::string codec, pixels;
    double rate = 0, seconds = 0;
    std::vector<double> times;  ///< at which its frames begin [s]
    std::vector<Image> frames;
};

/// Decodes an animation completely, with libav's decoder and not with the writer's code.
Animation decoded(const std::string& path) {
    Animation animation;
    AVFormatContext* format = nullptr;
    if (avformat_open_input(&format, path.c_str(), nullptr, nullptr) < 0) return animation;
    avformat_find_stream_info(format, nullptr);
    AVStream* stream = format->streams[0];
    const AVCodec* decoder = avcodec_find_decoder(stream->codecpar->codec_id);
    AVCodecContext* codec = avcodec_alloc_context3(decoder);
    avcodec_parameters_to_context(codec, stream->codecpar);
    avcodec_open2(codec, decoder, nullptr);
    animation.codec = avcodec_get_name(stream->codecpar->codec_id);
    animation.rate = av_q2d(stream->avg_frame_rate);
    AVPacket* packet = av_packet_alloc();
    AVFrame* frame = av_frame_alloc();
    const auto receive = [&] {
        while (avcodec_receive_frame(codec, frame) == 0) {
            animation.pixels = std::to_string(frame->format);
            Image image(frame->width, frame->height);
            SwsContext* scaler = sws_getContext(
                frame->width, frame->height, static_cast<AVPixelFormat>(frame->format), frame->width, frame->height,
                AV_PIX_FMT_RGB24, SWS_BILINEAR | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT, nullptr, nullptr, nullptr);
            const int* rec709 = sws_getCoefficients(SWS_CS_ITU709);
            sws_setColorspaceDetails(scaler, rec709, 0, rec709, 1, 0, 1 << 16, 1 << 16);
            std::uint8_t* to[1] = {image.rgb.data()};
            const int line[1] = {3 * image.width};
            sws_scale(scaler, frame->data, frame->linesize, 0, frame->height, to, line);
            sws_freeContext(scaler);
            animation.frames.push_back(std::move(image));
            animation.times.push_back(static_cast<double>(frame->best_effort_timestamp) * av_q2d(stream->time_base));
        }
    };
    animation.seconds = static_cast<double>(format->duration) / AV_TIME_BASE;
    while (av_read_frame(format, packet) >= 0) {
        avcodec_send_packet(codec, packet);
        receive();
        av_packet_unref(packet);
    }
    avcodec_send_packet(codec, nullptr);
    receive();
    av_frame_free(&frame);
    av_packet_free(&packet);
    avcodec_free_context(&codec);
    avformat_close_input(&format);
    return animation;
}

/// Upper half in one colour that changes with the frame, lower half in another.
Image picture(int width, int height, int k) {
    Image image(width, height, {static_cast<std::uint8_t>(40 + 15 * k), 120, 60});
    for (int row = height / 2; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            image.pixel(column, row)[0] = 30;
            image.pixel(column, row)[1] = 40;
            image.pixel(column, row)[2] = 200;
        }
    }
    return image;
}

TEST(Movie, Mp4HasItsFramesInOrderWithSizeRateAndColours) {
    const test::Folder folder("mp4");
    MovieWriter movie(folder.file("a.mp4"), 160, 120, 12.5);
    constexpr int k_frames = 11;
    for (int k = 0; k < k_frames; ++k) movie.add(picture(160, 120, k));
    EXPECT_FALSE(std::filesystem::exists(folder.file("a.mp4")));
    movie.finish();
    EXPECT_EQ(folder.count(), 1U);

    const Animation animation = decoded(folder.file("a.mp4"));
    EXPECT_EQ(animation.codec, "h264");
    EXPECT_EQ(animation.pixels, std::to_string(AV_PIX_FMT_YUV420P));
    EXPECT_NEAR(animation.rate, 12.5, 1e-6);
    ASSERT_EQ(animation.frames.size(), static_cast<std::size_t>(k_frames));
    for (int k = 0; k < k_frames; ++k) {
        const Image& frame = animation.frames[static_cast<std::size_t>(k)];
        ASSERT_EQ(frame.width, 160);
        ASSERT_EQ(frame.height, 120);
        // The codec changes colours slightly; BT.601 read as BT.709 would change them by thirty.
        EXPECT_TRUE(test::near(frame.colour(80, 30), {static_cast<std::uint8_t>(40 + 15 * k), 120, 60}, 8)) << k;
        EXPECT_TRUE(test::near(frame.colour(80, 90), {30, 40, 200}, 8)) << k;
    }
}

/// Returns the bytes of an animation made with the given number of processors.
std::string animation_on(int processors, const std::string& file) {
    cpu_set_t all, some;
    CPU_ZERO(&some);
    sched_getaffinity(0, sizeof all, &all);
    for (int cpu = 0; cpu < CPU_SETSIZE && CPU_COUNT(&some) < processors; ++cpu)
        if (CPU_ISSET(cpu, &all)) CPU_SET(cpu, &some);
    sched_setaffinity(0, sizeof some, &some);
    MovieWriter movie(file, 320, 240, 25);
    for (int k = 0; k < 30; ++k) movie.add(picture(320, 240, k % 12));
    movie.finish();
    sched_setaffinity(0, sizeof all, &all);
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Movie, AnMp4HasTheSameBytesOnAnyNumberOfProcessors) {
    if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "needs two processors";
    const test::Folder folder("processors");
    EXPECT_EQ(animation_on(1, folder.file("one.mp4")), animation_on(CPU_SETSIZE, folder.file("all.mp4")));
}

// A picture that is shown for long is stored once.
TEST(Movie, PicturesHaveTheirDurations) {
    const test::Folder folder("durations");
    for (const std::string name : {"a.mp4", "a.gif"}) {
        MovieWriter movie(folder.file(name), 64, 64, 25);
        for (const int frames : {1, 10, 4, 25}) movie.add(picture(64, 64, frames % 7), frames);
        movie.finish();
        const Animation animation = decoded(folder.file(name));
        ASSERT_EQ(animation.times.size(), 4U) << name;
        constexpr double k_starts[] = {0, 0.04, 0.44, 0.6};
        for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(animation.times[k], k_starts[k], 1e-6) << name << k;
        EXPECT_NEAR(animation.seconds, 1.6, 0.011) << name;
    }
}

TEST(Movie, TheIndexOfAnMp4IsInFront) {
    const test::Folder folder("faststart");
    MovieWriter movie(folder.file("a.mp4"), 64, 64, 10);
    movie.add(Image(64, 64));
    movie.finish();
    std::ifstream stream(folder.file("a.mp4"), std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
    EXPECT_LT(bytes.find("moov"), bytes.find("mdat"));
}

TEST(Movie, OddSizesLoseAColumnOrARow) {
    const test::Folder folder("odd");
    MovieWriter movie(folder.file("a.mp4"), 101, 75, 10);
    movie.add(picture(101, 75, 3));
    movie.finish();
    const Animation animation = decoded(folder.file("a.mp4"));
    ASSERT_EQ(animation.frames.size(), 1U);
    EXPECT_EQ(animation.frames[0].width, 100);
    EXPECT_EQ(animation.frames[0].height, 74);
}

TEST(Movie, GifKeepsFewColoursExactly) {
    const test::Folder folder("gif");
    MovieWriter movie(folder.file("a.gif"), 81, 61, 5);
    for (int k = 0; k < 4; ++k) movie.add(picture(81, 61, k));
    movie.finish();
    const Animation animation = decoded(folder.file("a.gif"));
    EXPECT_EQ(animation.codec, "gif");
    ASSERT_EQ(animation.frames.size(), 4U);
    for (int k = 0; k < 4; ++k) {
        const Image& frame = animation.frames[static_cast<std::size_t>(k)];
        EXPECT_EQ(frame.width, 81);
        EXPECT_EQ(frame.colour(40, 10), (Rgb{static_cast<std::uint8_t>(40 + 15 * k), 120, 60})) << k;
        EXPECT_EQ(frame.colour(40, 50), (Rgb{30, 40, 200})) << k;
    }
}

TEST(Movie, ErrorsAreOfTheRightKindAndSilent) {
    const test::Folder folder("errors");
    testing::internal::CaptureStderr();
    const auto kind = [](const auto& action) {
        try {
            action();
        } catch (const Error& error) {
            return error.kind();
        }
        ADD_FAILURE() << "accepted";
        return ErrorKind::numerical;
    };
    EXPECT_EQ(kind([&] { MovieWriter(folder.file("no/such/a.mp4"), 64, 64, 10); }), ErrorKind::environment);
    EXPECT_EQ(kind([&] { MovieWriter(folder.file("a.avi"), 64, 64, 10); }), ErrorKind::input);
    EXPECT_EQ(kind([&] { MovieWriter(folder.file("a.mp4"), 64, 64, 0); }), ErrorKind::input);
    MovieWriter movie(folder.file("a.mp4"), 64, 64, 10);
    EXPECT_EQ(kind([&] { movie.add(Image(32, 64)); }), ErrorKind::input);
    EXPECT_EQ(kind([&] { movie.finish(); }), ErrorKind::environment);  // no frame yet
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Movie, UnfinishedLeavesNothingAndKeepsTheOldFile) {
    const test::Folder folder("unfinished");
    std::ofstream(folder.file("a.mp4")) << "old";
    {
        MovieWriter movie(folder.file("a.mp4"), 64, 64, 10);
        movie.add(Image(64, 64));
    }
    EXPECT_EQ(folder.count(), 1U);
    EXPECT_EQ(std::filesystem::file_size(folder.file("a.mp4")), 3U);
}

}  // namespace
}  // namespace frana::render
