package rasterlab.app.outcome;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import rasterlab.exercises.SourceEncoding;

/**
 * Ways in which people's programs write text, told by its bytes.
 *
 * <p>UTF-16 is told by its mark, or by zeros in every other byte: the keywords and numbers of files
 * take two bytes each, one of them 0. UTF-8 is what its decoder takes. What it refuses is taken for
 * Windows-1251, in which every byte is a sign, so that names that differ stay different.
 */
public enum TextEncoding {
    UTF_8("UTF-8", StandardCharsets.UTF_8),
    UTF_16LE("UTF-16", StandardCharsets.UTF_16LE),
    UTF_16BE("UTF-16", StandardCharsets.UTF_16BE),
    WINDOWS_1251("Windows-1251", Charset.forName("windows-1251"));

    /** How many bytes tell UTF-16. */
    public static final int HEAD = 1024;

    private final String words;
    private final Charset charset;

    TextEncoding(String words, Charset charset) {
        this.words = words;
        this.charset = charset;
    }

    /** The name that editors have for it. */
    @Override
    public String toString() {
        return words;
    }

    public Charset charset() {
        return charset;
    }

    /**
     * UTF-16, where a text begins so.
     *
     * @param head the text's first {@link #HEAD} bytes, or all of them
     */
    public static Optional<TextEncoding> utf16(byte[] head) {
        if (head.length < 2) return Optional.empty();
        int mark = (head[0] & 255) << 8 | head[1] & 255;
        if (mark == 0xFFFE) return Optional.of(UTF_16LE);
        if (mark == 0xFEFF) return Optional.of(UTF_16BE);
        int pairs = Math.min(HEAD, head.length) / 2;
        int[] zeros = new int[2];
        for (int i = 0; i < 2 * pairs; i++) if (head[i] == 0) zeros[i % 2]++;
        if (zeros[1] > pairs / 2 && zeros[0] == 0) return Optional.of(UTF_16LE);
        if (zeros[0] > pairs / 2 && zeros[1] == 0) return Optional.of(UTF_16BE);
        return Optional.empty();
    }

    /** How a whole text is written. */
    public static TextEncoding of(byte[] text) {
        return utf16(text).orElse(isUtf8(text) ? UTF_8 : WINDOWS_1251);
    }

    private static boolean isUtf8(byte[] text) {
        try {
            StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(text));
            return true;
        } catch (CharacterCodingException e) {
            return false;
        }
    }

    /**
     * Why a text that should be UTF-8 is not; empty where it is.
     *
     * @param text all of it
     */
    public static Optional<String> obstacle(byte[] text) {
        return switch (of(text)) {
            case UTF_8 -> Optional.empty();
            case UTF_16LE, UTF_16BE -> Optional.of("is UTF-16 text; " + SourceEncoding.HOW_TO_SAVE);
            case WINDOWS_1251 ->
                    Optional.of(
                            readsAsRussian(text)
                                    ? "looks like Windows-1251 text; " + SourceEncoding.HOW_TO_SAVE
                                    : "is not UTF-8 text");
        };
    }

    /**
     * Whether what is beyond ASCII is mostly letters, a few at least, and there are no control
     * signs.
     */
    private static boolean readsAsRussian(byte[] text) {
        int letters = 0;
        int others = 0;
        for (byte b : text) {
            if (b >= 0 && b < ' ' && b != '\n' && b != '\r' && b != '\t') return false;
            int sign = b & 255;
            if (sign >= 0xC0 || sign == 0xA8 || sign == 0xB8) letters++;
            else if (sign >= 0x80) others++;
        }
        return letters >= 3 && letters > 2 * others;
    }
}
