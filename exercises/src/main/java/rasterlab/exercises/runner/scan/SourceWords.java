package rasterlab.exercises.runner.scan;

/**
 * Reads a Java source from word to word: the identifiers and keywords outside comments, strings and
 * characters.
 *
 * <p>Each character is looked at once, whatever the source looks like, and nothing is kept of what
 * was passed, so time grows with the length of the source and memory does not. A source that is no
 * Java is read as far as it goes: a string ends with its line, a comment with the source.
 *
 * <p>Lines are counted as the compiler counts them, and Unicode escapes are what they stand for.
 * Source: the Java Language Specification, Java SE 17 edition (2021), sections 3.2 to 3.10.
 */
public final class SourceWords {
    private static final int END = -1;
    private static final String BLOCK_QUOTES = "\"\"\"";

    private final String source;

    /** The character that is looked at, or END. */
    private int current;

    /** Where it stands, from 0. */
    private int at;

    /** How many characters of the source it takes: 1, or those of a Unicode escape. */
    private int width;

    /** Backslashes directly before it; one is no escape's beginning after an odd number of them. */
    private int backslashes;

    private int line = 1;
    private int lineStart;
    private final StringBuilder word = new StringBuilder();
    private int wordLine;
    private int wordColumn;

    public SourceWords(String source) {
        this.source = source;
        look();
    }

    /** Goes on to the next word; false when there is none. */
    public boolean next() {
        while (current != END) {
            if (isPart(current)) {
                boolean number = isDigit(current);
                take();
                if (!number) return true;
            } else if (current == '/') comment();
            else if (current == '"') string();
            else if (current == '\'') quoted('\'');
            else step();
        }
        return false;
    }

    /** Whether the word is this one. */
    public boolean is(String other) {
        return word.length() == other.length() && other.contentEquals(word);
    }

    /** Line of the word's first character, from 1. */
    public int line() {
        return wordLine;
    }

    /** Column of the word's first character, from 1. */
    public int column() {
        return wordColumn;
    }

    /** The next character that is no white space, without going there; a zero at the end. */
    public char following() {
        int ahead = at;
        while (ahead < source.length() && Character.isWhitespace(source.charAt(ahead))) ahead++;
        return ahead < source.length() ? source.charAt(ahead) : 0;
    }

    private void take() {
        word.setLength(0);
        wordLine = line;
        wordColumn = at - lineStart + 1;
        for (; isPart(current); step()) word.append((char) current);
    }

    /**
     * Halves of a character count as letters: beyond strings and comments there is no other use.
     */
    private static boolean isPart(int character) {
        return character != END
                && (Character.isJavaIdentifierPart(character)
                                && !Character.isIdentifierIgnorable(character)
                        || Character.isSurrogate((char) character));
    }

    private static boolean isDigit(int character) {
        return character >= '0' && character <= '9';
    }

    private void comment() {
        step();
        if (current == '/') while (current != END && !endsLine()) step();
        else if (current == '*') {
            step();
            boolean star = false;
            while (current != END && !(star && current == '/')) {
                star = current == '*';
                step();
            }
            step();
        }
    }

    private void string() {
        if (!source.startsWith(BLOCK_QUOTES, at)) {
            quoted('"');
            return;
        }
        for (int i = 0; i < BLOCK_QUOTES.length(); i++) step();
        while (current != END && !source.startsWith(BLOCK_QUOTES, at)) {
            if (current == '\\') step();
            step();
        }
        for (int i = 0; i < BLOCK_QUOTES.length(); i++) step();
    }

    private void quoted(char quote) {
        step();
        while (current != END && current != quote && !endsLine()) {
            if (current == '\\') step();
            if (!endsLine()) step();
        }
        if (current == quote) step();
    }

    private boolean endsLine() {
        return current == '\n' || current == '\r';
    }

    private void step() {
        if (current == END) return;
        backslashes = width == 1 && current == '\\' ? backslashes + 1 : 0;
        boolean lineEnds =
                width == 1
                        && (current == '\n'
                                || current == '\r'
                                        && !(at + 1 < source.length()
                                                && source.charAt(at + 1) == '\n'));
        at += width;
        if (lineEnds) {
            line++;
            lineStart = at;
        }
        look();
    }

    private void look() {
        width = 1;
        current = at < source.length() ? source.charAt(at) : END;
        if (current == '\\' && backslashes % 2 == 0) unescape();
    }

    /** Reads a backslash, one u or more, and four hexadecimal digits. */
    private void unescape() {
        int digits = at + 1;
        while (digits < source.length() && source.charAt(digits) == 'u') digits++;
        if (digits == at + 1 || digits + 4 > source.length()) return;
        int code = 0;
        for (int i = digits; i < digits + 4; i++) {
            int digit = Character.digit(source.charAt(i), 16);
            if (digit < 0) return;
            code = 16 * code + digit;
        }
        current = code;
        width = digits + 4 - at;
    }
}
