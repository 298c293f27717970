package rasterlab.exercises;

/** The encoding that a text which is not UTF-8 probably has, told from its bytes. */
public enum SourceEncoding {
    /** UTF-16, with a byte order mark or with a zero in every second byte. */
    UTF_16,
    /** Most bytes beyond ASCII are letters of Cyrillic words. */
    WINDOWS_1251,
    OTHER;

    /** The advice for a file that is not UTF-8, in the editors that students have. */
    public static final String HOW_TO_SAVE =
            "save it as UTF-8: in VS Code click the encoding at the lower right and choose"
                    + " 'Save with Encoding', in IntelliJ IDEA click it and choose 'Convert',"
                    + " in Notepad choose 'Save as' and the encoding UTF-8";

    /** Bytes beyond ASCII, of ten, that stand in words; signs and one-letter words are few. */
    private static final int IN_WORDS_OF_TEN = 7;

    public static SourceEncoding of(byte[] bytes) {
        if (isWide(bytes)) return UTF_16;
        int beyond = 0;
        int inWords = 0;
        for (int i = 0; i < bytes.length; i++) {
            if (bytes[i] >= 0) continue;
            beyond++;
            if (isLetter(bytes, i) && (isLetter(bytes, i - 1) || isLetter(bytes, i + 1))) inWords++;
        }
        return beyond > 0 && 10L * inWords >= (long) IN_WORDS_OF_TEN * beyond
                ? WINDOWS_1251
                : OTHER;
    }

    private static boolean isWide(byte[] bytes) {
        if (bytes.length < 2) return false;
        int mark = (bytes[0] & 0xFF) << 8 | bytes[1] & 0xFF;
        if (mark == 0xFEFF || mark == 0xFFFE) return true;
        int zeros = 0;
        for (byte one : bytes) if (one == 0) zeros++;
        return 3L * zeros >= bytes.length;
    }

    /** Whether a Russian letter stands there; other languages rarely have two side by side. */
    private static boolean isLetter(byte[] bytes, int at) {
        if (at < 0 || at >= bytes.length) return false;
        int code = bytes[at] & 0xFF;
        return code >= 0xC0 || code == 0xA8 || code == 0xB8;
    }
}
