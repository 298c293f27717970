package rasterlab.engine.scene.obj;

import java.io.IOException;
import java.io.Reader;

/**
 * The lines of a text, each with the number of its first physical line.
 *
 * <p>Lines end with LF, CR or both; a backslash before the end joins the next line on. A physical
 * line whose first sign that is no blank is # is a comment and left out. Elsewhere # may belong to
 * a name, so it stays; after a blank it may as well begin a comment, so behind it a backslash joins
 * nothing on. A byte order mark at the beginning is passed over. At most {@value #LONGEST}
 * characters make a line.
 */
final class TextLines {
    static final int LONGEST = 1 << 20;
    private static final int END = -1;
    private static final char BYTE_ORDER_MARK = '\uFEFF';

    private final String file;
    private final Reader reader;
    private final char[] buffer = new char[1 << 15];
    private final StringBuilder text = new StringBuilder();
    private int filled;
    private int next;
    private int physical;
    private int number;

    TextLines(String file, Reader reader) throws IOException {
        this.file = file;
        this.reader = reader;
        if (peek() == BYTE_ORDER_MARK) next++;
    }

    /**
     * Goes to the next line.
     *
     * @return false after the last
     */
    boolean advance() throws IOException, BrokenFileException {
        if (peek() == END) return false;
        text.setLength(0);
        number = physical + 1;
        boolean joined = true;
        while (joined && peek() != END) joined = readPhysical();
        return true;
    }

    /** The line, blanks at its ends included. */
    CharSequence text() {
        return text;
    }

    /** The number of its first physical line, from 1. */
    int number() {
        return number;
    }

    BrokenFileException broken(String problem) {
        return new BrokenFileException(file, number, problem);
    }

    String file() {
        return file;
    }

    /** Appends a physical line; true if it ends with a backslash, which is left out. */
    private boolean readPhysical() throws IOException, BrokenFileException {
        physical++;
        int c = read();
        while (c == ' ' || c == '\t') c = append(c);
        if (c == '#') {
            while (!endsLine(c)) c = read();
            return false;
        }
        boolean comment = false;
        while (!endsLine(c)) {
            int before = c;
            c = append(c);
            comment |= c == '#' && before <= ' ';
        }
        int last = text.length() - 1;
        boolean joined = !comment && last >= 0 && text.charAt(last) == '\\';
        if (joined) text.setCharAt(last, ' ');
        return joined;
    }

    private static boolean endsLine(int c) {
        return c == END || c == '\n' || c == '\r';
    }

    /** Adds a character to the line and gives the next. */
    private int append(int c) throws IOException, BrokenFileException {
        if (text.length() == LONGEST)
            throw broken("the line is longer than the " + LONGEST + " characters allowed");
        text.append((char) c);
        return read();
    }

    /** The next character; CR and LF together are one LF. */
    private int read() throws IOException {
        int c = peek();
        if (c == END) return END;
        next++;
        if (c == '\r' && peek() == '\n') next++;
        return c;
    }

    private int peek() throws IOException {
        if (next == filled) {
            next = 0;
            filled = 0;
            int count = reader.read(buffer);
            if (count <= 0) return END;
            filled = count;
        }
        return buffer[next];
    }
}
