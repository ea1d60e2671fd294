// SPDX-License-Identifier: Apache-2.0
#include "render/animation/movie.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <utility>

#include "core/error.h"
#include "core/file_aside.h"
#include "render/animation/gif_palette.h"

namespace frana::render {
namespace {

enum class Kind { mp4, gif };

Kind kind_of(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    if (ending == ".mp4") return Kind::mp4;
    if (ending == ".gif") return Kind::gif;
    throw Error(ErrorKind::input, Problem{"unknown kind of animation", path, ending, ".mp4 or .gif", ""});
}

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

}  // namespace

class MovieWriter::Encoder {
  public:
    Encoder(std::string path, int width, int height, double frames_per_second)
        : kind_(kind_of(path)), file_(std::move(path)), source_width_(width), source_height_(height) {
        if (width < 2 || height < 2 || !(frames_per_second > 0) || frames_per_second > 1000) {
            throw Error(ErrorKind::input,
                        Problem{"an animation's size or rate is out of range", file_.path(),
                                std::to_string(width) + " x " + std::to_string(height) + " at " +
                                    std::to_string(frames_per_second) + " frames per second",
                                "at least 2 x 2 pixels, over 0 and up to 1000 frames per second", ""});
        }
        av_log_set_level(AV_LOG_QUIET);  // its errors are returned as codes; its messages would go to the terminal
        open_codec(frames_per_second);
        open_file();
    }

    void add(const Image& image, int frames) {
        if (image.width != source_width_ || image.height != source_height_) {
            throw Error(ErrorKind::input,
                        Problem{"an animation's pictures must all have its size", file_.path(),
                                std::to_string(image.width) + " x " + std::to_string(image.height),
                                std::to_string(source_width_) + " x " + std::to_string(source_height_), ""});
        }
        check(av_frame_make_writable(frame_.get()), "an animation's frame cannot be filled");
        if (kind_ == Kind::mp4) {
            fill_yuv(image);
        } else {
            fill_indexed(image);
        }
        for (int k = 0; k < frames; ++k) {
            frame_->pts = n_frames_++;
            check(avcodec_send_frame(codec_.get(), frame_.get()), "an animation's frame cannot be encoded");
            write_packets();
        }
    }

    void finish() {
        if (n_frames_ == 0) {
            throw Error(ErrorKind::environment,
                        Problem{"an animation without pictures is not written", file_.path(), "", "", ""});
        }
        check(avcodec_send_frame(codec_.get(), nullptr), "an animation cannot be completed");
        write_packets();
        check(av_write_trailer(format_.get()), "an animation cannot be completed");
        check(avio_closep(&format_->pb), "an animation cannot be written completely");
        file_.rename_into_place();
    }

  private:
    void check(int code, const char* what) const {
        if (code >= 0) return;
        std::array<char, AV_ERROR_MAX_STRING_SIZE> words{};
        av_strerror(code, words.data(), words.size());
        throw Error(ErrorKind::environment, Problem{what, file_.path(), words.data(), "",
                                                    "check the folder, its permissions and the free space"});
    }

    template <class Handle, class T>
    void own(Handle& handle, T* object) const {
        handle.reset(object);
        if (!handle) check(AVERROR(ENOMEM), "an animation cannot be started");
    }

    void open_codec(double frames_per_second) {
        const bool mp4 = kind_ == Kind::mp4;
        const AVCodec* encoder = mp4 ? avcodec_find_encoder_by_name("libx264") : avcodec_find_encoder(AV_CODEC_ID_GIF);
        if (encoder == nullptr) {
            throw Error(ErrorKind::environment, Problem{"an animation's encoder is missing", file_.path(),
                                                        mp4 ? "libx264" : "gif", "", "install Debian's libavcodec59"});
        }
        own(codec_, avcodec_alloc_context3(encoder));
        codec_->width = mp4 ? source_width_ / 2 * 2 : source_width_;
        codec_->height = mp4 ? source_height_ / 2 * 2 : source_height_;
        codec_->pix_fmt = mp4 ? AV_PIX_FMT_YUV420P : AV_PIX_FMT_PAL8;
        codec_->framerate = av_d2q(frames_per_second, 100000);
        codec_->time_base = av_inv_q(codec_->framerate);
        if (mp4) {
            codec_->gop_size = std::max(1, static_cast<int>(std::lround(2 * frames_per_second)));  // two seconds
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
        check(avformat_alloc_output_context2(&format, nullptr, kind_ == Kind::mp4 ? "mp4" : "gif",
                                             file_.partial_path().c_str()),
              "an animation cannot be started");
        format_.reset(format);
        format_->flags |= AVFMT_FLAG_BITEXACT;  // no date, no version: same frames, same bytes
        stream_ = avformat_new_stream(format_.get(), nullptr);
        check(stream_ != nullptr ? 0 : AVERROR(ENOMEM), "an animation cannot be started");
        stream_->time_base = codec_->time_base;
        stream_->avg_frame_rate = codec_->framerate;
        check(avcodec_parameters_from_context(stream_->codecpar, codec_.get()), "an animation cannot be started");
        check(avio_open(&format_->pb, file_.partial_path().c_str(), AVIO_FLAG_WRITE), "an animation cannot be written");
        AVDictionary* options = nullptr;
        if (kind_ == Kind::mp4) av_dict_set(&options, "movflags", "+faststart", 0);
        const int code = avformat_write_header(format_.get(), &options);
        av_dict_free(&options);
        check(code, "an animation cannot be started");
    }

    // The scaler reads slightly beyond the end of every row: the picture is copied to a frame with room for it.
    void fill_yuv(const Image& image) {
        for (int row = 0; row < codec_->height; ++row) {
            std::memcpy(picture_->data[0] + static_cast<std::ptrdiff_t>(row) * picture_->linesize[0],
                        image.pixel(0, row), 3 * static_cast<std::size_t>(codec_->width));
        }
        check(sws_scale(scaler_.get(), picture_->data, picture_->linesize, 0, codec_->height, frame_->data,
                        frame_->linesize),
              "an animation's colours cannot be converted");
    }

    void fill_indexed(const Image& image) {
        const IndexedImage reduced = reduce_colours(image);
        // An unused entry remains transparent: the encoder needs one for unchanged pixels.
        std::array<std::uint32_t, 256> colours{};
        for (std::size_t i = 0; i < reduced.colours.size(); ++i) {
            const Rgb c = reduced.colours[i];
            colours[i] = 0xFF000000U | std::uint32_t{c.r} << 16U | std::uint32_t{c.g} << 8U | c.b;
        }
        std::memcpy(frame_->data[1], colours.data(), sizeof colours);
        for (int row = 0; row < image.height; ++row) {
            std::memcpy(frame_->data[0] + static_cast<std::ptrdiff_t>(row) * frame_->linesize[0],
                        reduced.indices.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width),
                        static_cast<std::size_t>(image.width));
        }
    }

    void write_packets() {
        for (;;) {
            const int code = avcodec_receive_packet(codec_.get(), packet_.get());
            if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
            check(code, "an animation's frame cannot be encoded");
            packet_->stream_index = stream_->index;
            packet_->duration = 1;
            av_packet_rescale_ts(packet_.get(), codec_->time_base, stream_->time_base);
            check(av_interleaved_write_frame(format_.get(), packet_.get()), "an animation's frame cannot be written");
        }
    }

    Kind kind_;
    FileAside file_;
    int source_width_, source_height_;
    std::int64_t n_frames_ = 0;
    Codec codec_;
    Frame frame_, picture_;  // encoded; its colours as drawn
    Packet packet_;
    std::unique_ptr<SwsContext, FreeScaler> scaler_;
    std::unique_ptr<AVFormatContext, FreeFormat> format_;
    AVStream* stream_ = nullptr;  ///< owned by format_
};

MovieWriter::MovieWriter(std::string path, int width, int height, double frames_per_second)
    : encoder_(std::make_unique<Encoder>(std::move(path), width, height, frames_per_second)) {}
MovieWriter::~MovieWriter() = default;

void MovieWriter::add(const Image& image, int frames) {
    encoder_->add(image, frames);
}

void MovieWriter::finish() {
    encoder_->finish();
}

}  // namespace frana::render
