package rasterlab.engine.format;

import java.util.Arrays;

/** Numbers of which it shows only at the end how many there are. */
public final class GrowingDoubles {
    private double[] values = new double[64];
    private int size;

    public void add(double value) {
        if (size == values.length) values = Arrays.copyOf(values, 2 * size);
        values[size++] = value;
    }

    public int size() {
        return size;
    }

    public double get(int index) {
        return values[index];
    }

    public double[] toArray() {
        return Arrays.copyOf(values, size);
    }
}
