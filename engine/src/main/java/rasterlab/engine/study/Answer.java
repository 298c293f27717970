package rasterlab.engine.study;

/**
 * The exact answer to one input, to hold every method's output against.
 *
 * @param exact the answer, or its first {@link #limit} items where it is cut
 * @param items number of items in {@code exact}
 * @param cut whether the whole answer is longer
 * @param limit the most items a method may produce: those of a cut answer, otherwise as {@link
 *     Topic#mostBeforeEndless} says
 */
record Answer<O>(O exact, long items, boolean cut, int limit) {
    private static final int MOST_ITEMS = 20_000;

    static <C, I, O> Answer<O> to(Topic<C, I, O> topic, I input) {
        O exact = topic.exact(input, MOST_ITEMS + 1);
        long items = topic.compare(input, exact, exact).of();
        if (items <= MOST_ITEMS)
            return new Answer<>(exact, items, false, (int) topic.mostBeforeEndless(items));
        return new Answer<>(topic.exact(input, MOST_ITEMS), MOST_ITEMS, true, MOST_ITEMS);
    }
}
