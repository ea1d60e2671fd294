// SPDX-License-Identifier: Apache-2.0
#include "core/module.h"
#include "render/libav/functions.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <utility>

namespace frana::render {
namespace {

template <class T, void (*release)(T**)>
struct Release {
    void operator()(T* object) const { release(&object); }
};
using Codec = std::unique_ptr<AVCodecContext, Release<AVCodecContext, avcodec_free_context>>;
using Frame = std::unique_ptr<AVFrame, Release<AVFrame, av_frame_free>>;
using Packet = std::unique_ptr<AVPacket, Release<AVPacket, av_packet_free>>;
struct FreeScaler {
    void operator()(SwsContext* scaler) const { sws_freeContext(scaler); }
};
struct FreeFormat {
    void operator()(AVFormatContext* format) const {
        if (format->pb != nullptr) avio_closep(&format->pb);
        avformat_free_context(format);
    }
};

class LibavEncoder : public MovieEncoder {
  public:
    explicit LibavEncoder(MovieFile movie) : movie_(std::move(movie)) {
        av_log_set_level(AV_LOG_QUIET);  // its errors are returned as codes; its messages would go to the terminal
        open_codec();
        open_file();
    }

    void add(const std::vector<std::uint8_t>& rgb, int frames) override {
        check(av_frame_make_writable(frame_.get()), "an animation's frame cannot be filled");
        fill_yuv(rgb);
        encode(frames);
    }

    void add(const std::vector<Rgb>& colours, const std::vector<std::uint8_t>& indices, int frames) override {
        check(av_frame_make_writable(frame_.get()), "an animation's frame cannot be filled");
        fill_indexed(colours, indices);
        encode(frames);
    }

    void finish() override {
        if (n_frames_ == 0)
            throw ModuleFailure({"an animation without pictures is not written", movie_.name, "", "", ""});
        check(avcodec_send_frame(codec_.get(), nullptr), "an animation cannot be completed");
        write_packets();
        if (movie_.gif) {  // which takes the last picture's duration from this alone
            const double hundredths = 100 * frames_of_.rbegin()->second / movie_.frames_per_second;
            check(av_opt_set_int(format_->priv_data, "final_delay", std::lround(hundredths), 0),
                  "an animation cannot be completed");
        }
        check(av_write_trailer(format_.get()), "an animation cannot be completed");
        check(avio_closep(&format_->pb), "an animation cannot be written completely");
    }

  private:
    void check(int code, const char* what) const {
        if (code >= 0) return;
        std::array<char, AV_ERROR_MAX_STRING_SIZE> words{};
        av_strerror(code, words.data(), words.size());
        throw ModuleFailure(
            {what, movie_.name, words.data(), "", "check the folder, its permissions and the free space"});
    }

    template <class Handle, class T>
    void own(Handle& handle, T* object) const {
        handle.reset(object);
        if (!handle) check(AVERROR(ENOMEM), "an animation cannot be started");
    }

    void open_codec() {
        const bool mp4 = !movie_.gif;
        const AVCodec* encoder = mp4 ? avcodec_find_encoder_by_name("libx264") : avcodec_find_encoder(AV_CODEC_ID_GIF);
        if (encoder == nullptr) {
            throw ModuleFailure({"an animation's encoder is missing", movie_.name, mp4 ? "libx264" : "gif", "",
                                 "install Debian's libavcodec59"});
        }
        own(codec_, avcodec_alloc_context3(encoder));
        codec_->width = mp4 ? movie_.width / 2 * 2 : movie_.width;
        codec_->height = mp4 ? movie_.height / 2 * 2 : movie_.height;
        codec_->pix_fmt = mp4 ? AV_PIX_FMT_YUV420P : AV_PIX_FMT_PAL8;
        codec_->framerate = av_d2q(movie_.frames_per_second, 100000);
        codec_->time_base = av_inv_q(codec_->framerate);
        if (mp4) {
            codec_->gop_size = std::max(1, static_cast<int>(std::lround(2 * movie_.frames_per_second)));  // two seconds
            codec_->colorspace = AVCOL_SPC_BT709;
            codec_->color_primaries = AVCOL_PRI_BT709;
            codec_->color_trc = AVCOL_TRC_BT709;
            codec_->color_range = AVCOL_RANGE_MPEG;
            codec_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
            // As many threads as processors would produce different bytes on each machine.
            codec_->thread_count = 1;
            // "animation" suits flat colours with sharp edges; at quality 20 letters have no visible blur.
            check(av_opt_set(codec_->priv_data, "preset", "veryfast", 0), "an animation's encoder refuses an option");
            check(av_opt_set(codec_->priv_data, "tune", "animation", 0), "an animation's encoder refuses an option");
            // Without long look-ahead it needs a fifth of the memory, and flat pictures are as good.
            check(av_opt_set(codec_->priv_data, "x264-params",
                             "rc-lookahead=3:sync-lookahead=0:bframes=1:ref=2:cpu-independent=1", 0),
                  "an animation's encoder refuses an option");
            check(av_opt_set(codec_->priv_data, "crf", "20", 0), "an animation's encoder refuses an option");
        }
        check(avcodec_open2(codec_.get(), encoder, nullptr), "an animation's encoder cannot be started");

        make_frame(frame_, codec_->pix_fmt);
        frame_->colorspace = codec_->colorspace;
        frame_->color_range = codec_->color_range;
        own(packet_, av_packet_alloc());
        if (mp4) {
            make_frame(picture_, AV_PIX_FMT_RGB24);
            own(scaler_,
                sws_getContext(codec_->width, codec_->height, AV_PIX_FMT_RGB24, codec_->width, codec_->height,
                               AV_PIX_FMT_YUV420P, SWS_BILINEAR | SWS_ACCURATE_RND, nullptr, nullptr, nullptr));
            const int* rec709 = sws_getCoefficients(SWS_CS_ITU709);
            constexpr int k_one = 1 << 16;
            sws_setColorspaceDetails(scaler_.get(), rec709, 1, rec709, 0, 0, k_one, k_one);
        }
    }

    void make_frame(Frame& frame, AVPixelFormat format) {
        own(frame, av_frame_alloc());
        frame->format = format;
        frame->width = codec_->width;
        frame->height = codec_->height;
        check(av_frame_get_buffer(frame.get(), 0), "an animation's frame cannot be made");
    }

    void open_file() {
        AVFormatContext* format = nullptr;
        check(avformat_alloc_output_context2(&format, nullptr, movie_.gif ? "gif" : "mp4", movie_.file.c_str()),
              "an animation cannot be started");
        format_.reset(format);
        format_->flags |= AVFMT_FLAG_BITEXACT;  // no date, no version: same frames, same bytes
        stream_ = avformat_new_stream(format_.get(), nullptr);
        check(stream_ != nullptr ? 0 : AVERROR(ENOMEM), "an animation cannot be started");
        stream_->time_base = codec_->time_base;
        stream_->avg_frame_rate = codec_->framerate;
        check(avcodec_parameters_from_context(stream_->codecpar, codec_.get()), "an animation cannot be started");
        check(avio_open(&format_->pb, movie_.file.c_str(), AVIO_FLAG_WRITE), "an animation cannot be written");
        AVDictionary* options = nullptr;
        if (!movie_.gif) av_dict_set(&options, "movflags", "+faststart", 0);
        const int code = avformat_write_header(format_.get(), &options);
        av_dict_free(&options);
        check(code, "an animation cannot be started");
    }

    // The scaler reads slightly beyond the end of every row: the picture is copied to a frame with room for it.
    void fill_yuv(const std::vector<std::uint8_t>& rgb) {
        const std::size_t line = 3 * static_cast<std::size_t>(movie_.width);
        for (int row = 0; row < codec_->height; ++row) {
            std::memcpy(picture_->data[0] + static_cast<std::ptrdiff_t>(row) * picture_->linesize[0],
                        rgb.data() + static_cast<std::size_t>(row) * line, 3 * static_cast<std::size_t>(codec_->width));
        }
        check(sws_scale(scaler_.get(), picture_->data, picture_->linesize, 0, codec_->height, frame_->data,
                        frame_->linesize),
              "an animation's colours cannot be converted");
    }

    void fill_indexed(const std::vector<Rgb>& palette, const std::vector<std::uint8_t>& indices) {
        // An unused entry remains transparent: the encoder needs one for unchanged pixels.
        std::array<std::uint32_t, 256> colours{};
        for (std::size_t i = 0; i < palette.size(); ++i) {
            const Rgb c = palette[i];
            colours[i] = 0xFF000000U | std::uint32_t{c.r} << 16U | std::uint32_t{c.g} << 8U | c.b;
        }
        std::memcpy(frame_->data[1], colours.data(), sizeof colours);
        const auto line = static_cast<std::size_t>(movie_.width);
        for (int row = 0; row < movie_.height; ++row) {
            std::memcpy(frame_->data[0] + static_cast<std::ptrdiff_t>(row) * frame_->linesize[0],
                        indices.data() + static_cast<std::size_t>(row) * line, line);
        }
    }

    /// Encodes a picture once, to be shown as long as this many frames.
    void encode(int frames) {
        frame_->pts = n_frames_;
        n_frames_ += frames;
        frames_of_[frame_->pts] = frames;
        check(avcodec_send_frame(codec_.get(), frame_.get()), "an animation's frame cannot be encoded");
        write_packets();
    }

    void write_packets() {
        for (;;) {
            const int code = avcodec_receive_packet(codec_.get(), packet_.get());
            if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
            check(code, "an animation's frame cannot be encoded");
            packet_->stream_index = stream_->index;
            packet_->duration = frames_of_.at(packet_->pts);
            av_packet_rescale_ts(packet_.get(), codec_->time_base, stream_->time_base);
            check(av_interleaved_write_frame(format_.get(), packet_.get()), "an animation's frame cannot be written");
        }
    }

    MovieFile movie_;
    std::int64_t n_frames_ = 0;
    std::map<std::int64_t, int> frames_of_;  ///< of each picture, by the first
    Codec codec_;
    Frame frame_, picture_;  // encoded; its colours as drawn
    Packet packet_;
    std::unique_ptr<SwsContext, FreeScaler> scaler_;
    std::unique_ptr<AVFormatContext, FreeFormat> format_;
    AVStream* stream_ = nullptr;  ///< owned by format_
};

/// See LibavFunctions.
std::unique_ptr<MovieEncoder> encoder(const MovieFile& movie) {
    return std::make_unique<LibavEncoder>(movie);
}

}  // namespace

}  // namespace frana::render

FRANA_MODULE(frana::render::LibavFunctions, {.encoder = frana::render::encoder})
