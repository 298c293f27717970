package rasterlab.app.polygon.outcome;

import java.util.Arrays;

/** Runs of pixels in the order in which they were filled; hundreds of thousands take some MB. */
public final class Runs {
    private static final int NUMBERS = 4;

    private int[] numbers = new int[NUMBERS * 64];
    private int size;
    private int mostWaiting;

    /**
     * @param to the column after the last one
     * @param waiting places on the method's stack or calls that wait, edges that cross the row
     */
    void add(int y, int from, int to, int waiting) {
        int at = NUMBERS * size;
        if (at == numbers.length) numbers = Arrays.copyOf(numbers, 2 * at);
        numbers[at] = y;
        numbers[at + 1] = from;
        numbers[at + 2] = to;
        numbers[at + 3] = waiting;
        mostWaiting = Math.max(mostWaiting, waiting);
        size++;
    }

    public int size() {
        return size;
    }

    public int y(int run) {
        return numbers[NUMBERS * run];
    }

    public int from(int run) {
        return numbers[NUMBERS * run + 1];
    }

    public int to(int run) {
        return numbers[NUMBERS * run + 2];
    }

    public int waiting(int run) {
        return numbers[NUMBERS * run + 3];
    }

    /** The most that ever waited. */
    public int mostWaiting() {
        return mostWaiting;
    }
}
