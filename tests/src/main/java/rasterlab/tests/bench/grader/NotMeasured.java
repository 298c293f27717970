package rasterlab.tests.bench.grader;

import rasterlab.tests.bench.language.BenchWords;

/** This machine lacks what a part of the benchmark needs. */
final class NotMeasured extends Exception {
    private static final long serialVersionUID = 1;

    private final String key;
    private final String said;

    /**
     * @param key of the words that say what is missing
     * @param said what the system says of it
     */
    NotMeasured(String key, String said) {
        super(key + ": " + said);
        this.key = key;
        this.said = said;
    }

    String in(BenchWords words) {
        return words.text(key, said);
    }
}
