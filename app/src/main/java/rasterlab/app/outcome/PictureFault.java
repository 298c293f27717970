package rasterlab.app.outcome;

import java.io.EOFException;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/**
 * Says in our own words what is wrong with a picture: Java's readers say it in English and for
 * programmers.
 */
final class PictureFault {
    static final String EMPTY = "the file is empty";
    static final String CUT = "the picture is cut off: the file ends too early";
    static final String DAMAGED = "the picture is damaged";

    /** The most bytes at a file's beginning that tell its kind. */
    private static final int HEAD = 8;

    /** Bytes at a file's end within which its mark of the end is, with what may follow. */
    private static final int TAIL = 1 << 16;

    private static final String JPEG_SCAN = "\u00FF\u00DA";
    private static final String JPEG_END = "\u00FF\u00D9";

    private PictureFault() {}

    /**
     * @param thrown by what has read the file
     */
    static String of(Path file, Throwable thrown) {
        for (Throwable each = thrown; each != null; each = each.getCause())
            if (each instanceof EOFException) return CUT;
        return lacksEnd(file) ? CUT : DAMAGED;
    }

    /**
     * Whether the mark is missing with which a PNG, JPEG or GIF ends; a BMP has none. A JPEG's
     * small picture of itself ends with the same mark, before the scan of the large one.
     */
    private static boolean lacksEnd(Path file) {
        try (var bytes = new RandomAccessFile(file.toFile(), "r")) {
            String begin = part(bytes, 0, HEAD);
            String end = part(bytes, Math.max(0, bytes.length() - TAIL), TAIL);
            if (begin.startsWith("\u0089PNG")) return !end.contains("IEND");
            if (begin.startsWith("\u00FF\u00D8"))
                return end.lastIndexOf(JPEG_END) <= end.lastIndexOf(JPEG_SCAN);
            return begin.startsWith("GIF") && !withoutZeros(end).endsWith(";");
        } catch (IOException gone) {
            return false;
        }
    }

    /** The bytes without zeros at the end, which some programs fill a file up with. */
    private static String withoutZeros(String bytes) {
        int length = bytes.length();
        while (length > 0 && bytes.charAt(length - 1) == 0) length--;
        return bytes.substring(0, length);
    }

    private static String part(RandomAccessFile bytes, long from, int most) throws IOException {
        bytes.seek(from);
        var part = new byte[(int) Math.min(most, bytes.length() - from)];
        bytes.readFully(part);
        return new String(part, StandardCharsets.ISO_8859_1);
    }
}
