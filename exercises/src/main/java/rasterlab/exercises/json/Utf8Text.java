package rasterlab.exercises.json;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CharsetDecoder;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;
import rasterlab.engine.format.InvalidInput;

/**
 * A text in UTF-8 before it is read as JSON, whose parser takes what is no UTF-8 for the text's end
 * and takes characters that are written with more bytes than they need.
 *
 * @param bytes of which the first {@code length} count
 */
record Utf8Text(byte[] bytes, int length) {
    private static final int AT_ONCE = 8 * 1024;

    /**
     * Passes if all bytes are UTF-8, or the text is in UTF-16 or UTF-32, which the parser reads
     * too.
     *
     * @throws InvalidInput with the first byte that is neither, and its place
     */
    void require() {
        int broken = isWide() ? length : firstBroken();
        if (broken < length)
            throw new InvalidInput(
                    place(broken),
                    "not UTF-8: byte %02X after %d bytes".formatted(bytes[broken], broken));
    }

    /** Whether it begins with the mark of UTF-16 or UTF-32, or with a 0 among its two bytes. */
    private boolean isWide() {
        if (length < 2) return false;
        int first = bytes[0] & 0xFF;
        int second = bytes[1] & 0xFF;
        return first == 0
                || second == 0
                || first == 0xFE && second == 0xFF
                || first == 0xFF && second == 0xFE;
    }

    private int firstBroken() {
        CharsetDecoder decoder = StandardCharsets.UTF_8.newDecoder();
        ByteBuffer rest = ByteBuffer.wrap(bytes, 0, length);
        CharBuffer unread = CharBuffer.allocate(AT_ONCE);
        CoderResult read;
        do {
            unread.clear();
            read = decoder.decode(rest, unread, true);
        } while (read.isOverflow());
        return read.isError() ? rest.position() : length;
    }

    /** The place of a byte, as the parser counts: in lines and, within one, in bytes. */
    private String place(int offset) {
        int line = 1;
        int start = 0;
        for (int i = 0; i < offset; i++)
            if (bytes[i] == '\n' || bytes[i] == '\r' && bytes[i + 1] != '\n') {
                line++;
                start = i + 1;
            }
        return JsonMistake.place(line, offset - start + 1);
    }
}
