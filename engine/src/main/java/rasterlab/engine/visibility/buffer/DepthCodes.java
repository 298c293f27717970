package rasterlab.engine.visibility.buffer;

/** How a depth buffer stores nearness: the nearer of two surfaces has the smaller code. */
interface DepthCodes {
    /** The content of an empty pixel: no surface has it. */
    int EMPTY = Integer.MAX_VALUE;

    /**
     * Computes the codes along a row, on which pixel x has the nearness {@code base + x·perColumn}.
     *
     * @param codes filled from its beginning, {@code to − from} long or longer
     */
    void row(double base, double perColumn, int from, int to, int[] codes);

    /** The depth that a code stands for, as the buffer is said to store it. */
    double depth(int code);

    /** Whether the larger of two such depths is the nearer one. */
    boolean largerIsNearer();

    /** Makes ready what depends on the range only. */
    @FunctionalInterface
    interface DepthCodesFactory {
        DepthCodes over(NearnessRange range);
    }
}
