package rasterlab.engine.study;

/** How large an error a topic takes for exact: the rounding that no method in doubles avoids. */
public final class ExactBound {
    private static final int HALVINGS = 60;

    private ExactBound() {}

    /**
     * The largest error that still counts as exact, in the topic's unit, to six digits; 0 where
     * none does, or where it is not the distance that decides.
     */
    public static double of(Topic<?, ?, ?> topic) {
        double low = Math.log(1e-30);
        double high = Math.log(1e6);
        if (!isExact(topic, low) || isExact(topic, high)) return 0;
        for (int i = 0; i < HALVINGS; i++) {
            double middle = (low + high) / 2;
            if (isExact(topic, middle)) low = middle;
            else high = middle;
        }
        return Math.exp(low);
    }

    private static boolean isExact(Topic<?, ?, ?> topic, double logarithm) {
        return topic.correct(new Deviation(Math.exp(logarithm), 0, 0, 1, ""));
    }
}
