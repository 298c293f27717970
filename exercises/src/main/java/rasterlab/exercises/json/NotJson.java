package rasterlab.exercises.json;

import com.fasterxml.jackson.core.JacksonException;
import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.exc.StreamConstraintsException;
import com.fasterxml.jackson.core.io.JsonEOFException;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;
import rasterlab.engine.format.Misfit;

/**
 * Says where a text stops being JSON, in words that need no knowledge of the library that reads it.
 *
 * @param text UTF-8, of which the first {@code length} bytes count
 */
record NotJson(byte[] text, int length) {
    /** Bytes quoted on each side of the place. */
    private static final int NEAR = 15;

    /**
     * @param reached where the reader stands; an exception about a limit has no place of its own
     */
    Misfit misfit(JacksonException e, JsonLocation reached) {
        JsonLocation at = e.getLocation() == null ? reached : e.getLocation();
        return new Misfit(place(at), reason(e, at));
    }

    private String reason(JacksonException e, JsonLocation at) {
        if (e instanceof StreamConstraintsException)
            return "a name, text or number of more than "
                    + StrictJson.LONGEST_TOKEN
                    + " characters";
        int broken = firstNotUtf8();
        if (broken < length)
            return "not UTF-8: byte %02X after %d bytes".formatted(text[broken], broken);
        boolean ended = e instanceof JsonEOFException || at.getByteOffset() >= length;
        return "not JSON" + (ended ? ": the text ends before the object does" : near(at));
    }

    /**
     * The offset of the first byte that is no UTF-8, which the parser takes for the text's end;
     * {@code length} where there is none, or where the text is in UTF-16 or UTF-32.
     */
    private int firstNotUtf8() {
        boolean wide = length > 1 && (text[0] == 0 || text[1] == 0 || (text[0] & 0xFE) == 0xFE);
        if (wide) return length;
        ByteBuffer bytes = ByteBuffer.wrap(text, 0, length);
        CharBuffer unread = CharBuffer.allocate(length);
        CoderResult read = StandardCharsets.UTF_8.newDecoder().decode(bytes, unread, true);
        return read.isMalformed() ? bytes.position() : length;
    }

    static String place(JsonLocation at) {
        return "line " + at.getLineNr() + ", column " + at.getColumnNr();
    }

    /**
     * What stands around the place; nothing for an encoding whose bytes the reader lost count of.
     */
    private String near(JsonLocation at) {
        int offset = (int) at.getByteOffset();
        if (offset < 0) return "";
        int from = Math.max(0, offset - NEAR);
        int to = Math.min(length, offset + NEAR);
        while (from > 0 && continues(text[from])) from--;
        while (to < length && continues(text[to])) to++;
        return " near '" + new String(text, from, to - from, StandardCharsets.UTF_8).strip() + "'";
    }

    /** Whether the byte belongs to the character that an earlier byte of the UTF-8 began. */
    private static boolean continues(byte value) {
        return (value & 0xC0) == 0x80;
    }
}
