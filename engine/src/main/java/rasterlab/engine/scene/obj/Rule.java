package rasterlab.engine.scene.obj;

/**
 * Says what becomes of a keyword of a file, or of some of the words behind it.
 *
 * @param keyword as files have it
 * @param words what stands behind it
 * @param treatment what is done with them
 * @param least the smallest number that is taken as it is
 * @param most the largest
 * @param instead what stands for what is missing or cannot be read; "" where nothing does
 */
record Rule(
        String keyword,
        String words,
        Treatment treatment,
        double least,
        double most,
        String instead) {
    enum Treatment {
        /** Numbers without which there is no model: what is not in the range is refused. */
        REQUIRED,
        /** Numbers that are cut to the range. */
        CUT,
        /** Names and numbers of things. */
        READ,
        /** The keyword is left out, with a note. */
        PASSED_OVER,
        /** Means nothing to a picture, so its absence is not told. */
        UNTOLD
    }

    static Rule required(String keyword, String words, double most) {
        return new Rule(keyword, words, Treatment.REQUIRED, -most, most, "the file is refused");
    }

    static Rule cut(String keyword, String words, double least, double most, double instead) {
        return cut(keyword, words, least, most, number(instead));
    }

    static Rule cut(String keyword, String words, double least, double most, String instead) {
        return new Rule(keyword, words, Treatment.CUT, least, most, instead);
    }

    static Rule read(String keyword, String words, String instead) {
        return new Rule(keyword, words, Treatment.READ, 0, 0, instead);
    }

    static Rule passedOver(String keyword, String words) {
        return new Rule(keyword, words, Treatment.PASSED_OVER, 0, 0, "");
    }

    static Rule untold(String keyword, String words) {
        return new Rule(keyword, words, Treatment.UNTOLD, 0, 0, "");
    }

    boolean passesOver() {
        return treatment == Treatment.PASSED_OVER || treatment == Treatment.UNTOLD;
    }

    /** The number that stands for one that cannot be read. */
    double numberInstead() {
        return Double.parseDouble(instead);
    }

    /** Shortest decimal, a whole number without its point. */
    static String number(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e10
                ? Long.toString((long) value)
                : Double.toString(value);
    }
}
