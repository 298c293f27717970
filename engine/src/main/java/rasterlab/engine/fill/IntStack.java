package rasterlab.engine.fill;

import java.util.Arrays;

/** Whole numbers, the last one first, on the heap: as deep as memory allows. */
final class IntStack {
    private int[] values = new int[64];
    private int size;

    void push(int value) {
        if (size == values.length) values = Arrays.copyOf(values, 2 * size);
        values[size++] = value;
    }

    int pop() {
        return values[--size];
    }

    int size() {
        return size;
    }
}
