package rasterlab.app.outcome;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The bytes that pictures begin with, whatever their files are called.
 *
 * <p>Sources: PNG, W3C 2003, 5.2; JPEG File Interchange Format 1.02, 1992; GIF89a, 1990, 17; WebP,
 * RFC 9649, 2.4.
 */
enum PictureSign {
    PNG("\u0089PNG\r\n\u001a\n"),
    JPEG("\u00ff\u00d8\u00ff"),
    GIF("GIF8"),
    WEBP("RIFF....WEBP");

    /** How many bytes tell. */
    static final int LENGTH = 12;

    private final String sign;

    /**
     * @param sign a byte for each sign; a dot for any
     */
    PictureSign(String sign) {
        this.sign = sign;
    }

    /** The kind of picture that these bytes begin; empty where they begin none. */
    static Optional<PictureSign> in(byte[] bytes) {
        var begin =
                new String(bytes, 0, Math.min(LENGTH, bytes.length), StandardCharsets.ISO_8859_1);
        return Stream.of(values()).filter(kind -> kind.begins(begin)).findFirst();
    }

    private boolean begins(String begin) {
        if (begin.length() < sign.length()) return false;
        for (int i = 0; i < sign.length(); i++)
            if (sign.charAt(i) != '.' && sign.charAt(i) != begin.charAt(i)) return false;
        return true;
    }

    /** Why a file with that beginning is not what it should be. */
    String obstacle(FileKind kind) {
        String said = "looks like a %s picture, not %s".formatted(this, kind);
        return kind == FileKind.SCENE || kind == FileKind.MODEL
                ? said + "; a picture for faces is opened in the lab's tab Hidden surfaces"
                : said;
    }
}
