// SPDX-License-Identifier: MIT
//
// Packed data of the page unpack to the original text, by zlib and by hand.
#include "edgewise/reports/page/html.hpp"

#include <gmock/gmock.h>
#include <zlib.h>

namespace edgewise::reports {
namespace {

std::string gunzipped(std::string packed, std::size_t size) {
    std::string text(size, '\0');
    z_stream stream{};
    EXPECT_EQ(inflateInit2(&stream, 15 + 16), Z_OK);
    stream.next_in = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(text.data());
    stream.avail_out = static_cast<uInt>(text.size());
    EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
    EXPECT_EQ(stream.total_out, size);
    inflateEnd(&stream);
    return text;
}

TEST(Packing, GzipUnpacksToTheSameTextAndIsTheSameBytes) {
    std::string text;
    for (int i = 0; i < 5000; ++i) text += "row " + std::to_string(i % 77) + "\n";
    const std::string packed = gzipped(text);
    EXPECT_LT(packed.size(), text.size() / 20);
    EXPECT_EQ(gunzipped(packed, text.size()), text);
    EXPECT_EQ(gzipped(text), packed);
    EXPECT_EQ(gunzipped(gzipped(""), 0), "");
}

/// The examples of RFC 4648, section 10.
TEST(Packing, Base64) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

/// The digest of the empty text.
TEST(Packing, ScriptsAreKnownByTheirHash) {
    EXPECT_EQ(script_hash("e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"),
              "sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=");
}

TEST(SafeSvg, SlimPicturesHaveOneLabelAndShortNumbers) {
    EXPECT_EQ(slim_svg(R"(<svg width="1"><path aria-label="a: 1.25" role="x" d="M1.2345,10.06L3,4"/></svg>)",
                       "A & B"),
              R"(<svg role="img" aria-label="A &amp; B" width="1"><path d="M1.2,10.0L3,4"/></svg>)");
    const std::string text = R"(<text>0.25, an aria-label of a class="b</text></svg>)";
    EXPECT_EQ(slim_svg("<svg x=\"1.25\">" + text, "A"),
              "<svg role=\"img\" aria-label=\"A\" x=\"1.2\">" + text)
        << "text is no coordinate and no attribute";
}

}  // namespace
}  // namespace edgewise::reports
