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
        REQUIRED("read", "refused"),
        /** Numbers that are cut to the range. */
        CUT("read", "cut to it"),
        /** Names and numbers of things. */
        READ("read", ""),
        /** The keyword is left out, with a note. */
        PASSED_OVER("passed over", ""),
        /** Means nothing to a picture, so its absence is not told. */
        UNTOLD("passed over without a note", "");

        private final String done;
        private final String beyond;

        Treatment(String done, String beyond) {
            this.done = done;
            this.beyond = beyond;
        }
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

    /** Columns of the table that people read: keyword, words, what is done, beyond, instead. */
    String row() {
        boolean ranged = treatment == Treatment.REQUIRED || treatment == Treatment.CUT;
        String beyond =
                ranged
                        ? "beyond %s to %s: %s"
                                .formatted(typed(least), typed(most), treatment.beyond)
                        : "";
        return "| `%s` | %s | %s | %s | %s |"
                .formatted(keyword, words, treatment.done, beyond, instead)
                .replaceAll(" +", " ");
    }

    /** The number as one types it in a file. */
    private static String typed(double value) {
        return number(value).replaceFirst("\\.0E", "e");
    }

    /** Shortest decimal, a whole number without its point. */
    static String number(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e10
                ? Long.toString((long) value)
                : Double.toString(value);
    }
}
