package rasterlab.exercises.score;

/**
 * A text that somebody else made, such as a student's exception message, with nothing in it that
 * acts on a terminal or hides on a page: each character that has no shape of its own is written as
 * its escape.
 */
final class VisibleText {
    /** Characters that are kept. */
    static final int MOST = 2000;

    private VisibleText() {}

    /** The text over several lines as it is; its beginning where it is long. */
    static String lines(String text) {
        return lines(text, MOST);
    }

    /** The text of at most so many characters. */
    static String lines(String text, int most) {
        var visible = new StringBuilder();
        text.replace("\r\n", "\n")
                .codePoints()
                .limit(most)
                .forEach(
                        c -> {
                            if (c == '\n' || c == '\t' || hasShape(c)) visible.appendCodePoint(c);
                            else visible.append(escape(c));
                        });
        return text.codePointCount(0, text.length()) <= most ? visible.toString() : visible + "…";
    }

    /** The text in one line. */
    static String line(String text) {
        return lines(text).replace("\n", "\\n").replace("\t", "\\t");
    }

    private static boolean hasShape(int c) {
        return switch (Character.getType(c)) {
            case Character.CONTROL,
                    Character.FORMAT,
                    Character.SURROGATE,
                    Character.PRIVATE_USE,
                    Character.UNASSIGNED,
                    Character.LINE_SEPARATOR,
                    Character.PARAGRAPH_SEPARATOR ->
                    false;
            default -> true;
        };
    }

    private static String escape(int c) {
        return c > 0xFFFF ? String.format("\\u{%X}", c) : String.format("\\u%04X", c);
    }
}
