package rasterlab.engine.study;

/** A method produced more items than it was allowed to; what it produced until then is kept. */
public final class LimitReached extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final transient Object recorded;

    /**
     * @param limit the number of items that was allowed
     * @param recorded the output so far, of the topic's output type
     */
    public LimitReached(int limit, Object recorded) {
        super("stopped after " + limit + " items");
        this.recorded = recorded;
    }

    public Object recorded() {
        return recorded;
    }
}
