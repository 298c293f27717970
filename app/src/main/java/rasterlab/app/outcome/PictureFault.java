package rasterlab.app.outcome;

import java.io.EOFException;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/**
 * What is wrong with a picture, in words of our own: Java's readers say it in theirs, in English
 * and for programmers.
 */
final class PictureFault {
    static final String EMPTY = "the file is empty";
    static final String CUT = "the picture is cut off: the file ends too early";
    static final String DAMAGED = "the picture is damaged";

    /** Bytes at a file's end within which its mark of the end is, with a few that may follow. */
    private static final int TAIL = 16;

    private PictureFault() {}

    /**
     * @param thrown by what has read the file
     */
    static String of(Path file, Throwable thrown) {
        for (Throwable each = thrown; each != null; each = each.getCause())
            if (each instanceof EOFException) return CUT;
        return lacksEnd(file) ? CUT : DAMAGED;
    }

    /** Whether the mark is missing with which a PNG, JPEG or GIF ends; a BMP has none. */
    private static boolean lacksEnd(Path file) {
        try (var bytes = new RandomAccessFile(file.toFile(), "r")) {
            String begin = part(bytes, 0);
            String end = part(bytes, Math.max(0, bytes.length() - TAIL));
            if (begin.startsWith("\u0089PNG")) return !end.contains("IEND");
            if (begin.startsWith("\u00FF\u00D8")) return !end.contains("\u00FF\u00D9");
            return begin.startsWith("GIF") && !end.contains(";");
        } catch (IOException gone) {
            return false;
        }
    }

    private static String part(RandomAccessFile bytes, long from) throws IOException {
        bytes.seek(from);
        var part = new byte[(int) Math.min(TAIL, bytes.length() - from)];
        bytes.readFully(part);
        return new String(part, StandardCharsets.ISO_8859_1);
    }
}
