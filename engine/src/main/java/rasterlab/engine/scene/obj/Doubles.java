package rasterlab.engine.scene.obj;

import java.util.Arrays;

/** Numbers in the order they come. */
final class Doubles {
    private double[] values = new double[64];
    private int size;

    void add(double value) {
        if (size == values.length) values = Arrays.copyOf(values, 2 * size);
        values[size++] = value;
    }

    double get(int i) {
        return values[i];
    }

    int size() {
        return size;
    }

    void clear() {
        size = 0;
    }

    double[] all() {
        return Arrays.copyOf(values, size);
    }
}
