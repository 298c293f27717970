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
record ExactAnswer<O>(O exact, long items, boolean cut, int limit) {

    static <C, I, O> ExactAnswer<O> to(Topic<C, I, O> topic, I input) {
        O exact = topic.exactPart(input, topic.mostItems() + 1);
        long items = topic.compare(input, exact, exact).of();
        if (items <= topic.mostItems())
            return new ExactAnswer<>(exact, items, false, (int) topic.mostBeforeEndless(items));
        return new ExactAnswer<>(
                topic.exactPart(input, topic.mostItems()),
                topic.mostItems(),
                true,
                topic.mostItems());
    }
}
